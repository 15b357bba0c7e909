// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <ostream>
#include <span>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "base/nearest_name.h"
#include "style/parameter.h"
#include "style/reference_page.h"
#include "style/samples.h"
#include "style/schema.h"
#include "style/value.h"
#include "surface/rule_words.h"

namespace edaha {
namespace {

using Json = nlohmann::ordered_json;

// The parameters of a topic: one, a group or a list, or all of them.
std::vector<const Parameter*> choose(const std::string& topic) {
    std::vector<const Parameter*> chosen;
    const auto choose_from = [&](std::span<const Parameter> parameters) {
        for (const Parameter& parameter : parameters) {
            if (topic.empty() || topic == parameter.group || topic == parameter.key())
                chosen.push_back(&parameter);
        }
    };
    choose_from(parameters());
    for (const ParameterList& list : parameter_lists())
        choose_from(list.parameters);
    if (!chosen.empty()) return chosen;
    if (topic.find('.') != std::string::npos) throw UsageError(unknown_parameter(topic));
    std::vector<std::string> groups;
    std::ranges::transform(parameter_groups(), std::back_inserter(groups), &ParameterGroup::name);
    std::ranges::transform(parameter_lists(), std::back_inserter(groups), &ParameterList::name);
    groups.emplace_back(kRulesElement);
    const auto nearest = nearest_name(topic, groups);
    throw UsageError(fmt::format("{}: no such group{}", topic,
                                 nearest ? " (did you mean '" + *nearest + "'?)" : ""));
}

Json to_json(const Parameter& parameter) {
    constexpr const char* kUnits[] = {"", "mm", "degrees"};
    Json json;
    json["parameter"] = parameter.key();
    json["kind"] = kind_text(parameter);
    if (parameter.limits.least < parameter.limits.most) {
        json["least"] = parameter.limits.least;
        json["most"] = parameter.limits.most;
        json["unit"] = kUnits[static_cast<std::size_t>(parameter.limits.unit)];
    }
    const Range usual = usual_range(parameter);
    if (usual.low < usual.high) {
        json["usual_least"] = usual.low;
        json["usual_most"] = usual.high;
    }
    if (const auto* choice = std::get_if<Choice>(&parameter.field)) json["choices"] = choice->names;
    json["default"] = value_text(Style(), parameter);
    json["samples"] = samples(parameter);
    json["help"] = parameter.help;
    json["source"] = parameter.source;
    return json;
}

std::string in_full(const Parameter& parameter) {
    const std::string value = value_text(Style(), parameter);
    return fmt::format(
        "{0}: {1}\n"
        "  value    {2}: {3}\n"
        "  default  {4}\n"
        "  source   {5}\n",
        parameter.key(), parameter.help, kind_text(parameter), expected_text(parameter),
        value.empty() ? "(empty)" : value, parameter.source);
}

// Of a group, or of a list.
const std::string& help_of(const std::string& group) {
    const ParameterList* const list = find_list(group);
    return list != nullptr ? list->help : find_group(group)->help;
}

std::string in_short(std::span<const Parameter* const> chosen) {
    std::string text;
    std::string group;
    for (const Parameter* parameter : chosen) {
        if (parameter->group != group) {
            group = parameter->group;
            text += fmt::format("{}{}: {}\n", text.empty() ? "" : "\n", group, help_of(group));
        }
        text += fmt::format("  {:<22} {:<12} {}\n", parameter->key(),
                            value_text(Style(), *parameter), parameter->help);
    }
    return text;
}

// The language of <rules>.
std::string rules_page() {
    std::string text =
        "rules: the L-system that leads the apices of surface growth, as text of <rules>\n"
        "  size = 40                                    a constant\n"
        "  axiom: A(0)                                  what the first apex is\n"
        "  A(t) : t > 5 : 0.3 -> +(20) A(t + 1)         condition (* for any) and weight, if any\n"
        "  A(t) -> bud(50, 137.5 * t, 10)[B(0)] A(t + 1)\n"
        "  # begins a comment; ; ends a line, too\n"
        "\nWhat an apex is told:\n";
    for (const OrderWord& word : kOrderWords)
        text += fmt::format("  {:<9} {}\n", word.name, word.help);
    text += "\nFunctions:\n";
    for (const RuleFunctionWord& word : kRuleFunctionWords)
        text += fmt::format("  {:<9} {}\n", word.name, word.help);
    text += "\nNumbers that are known:\n";
    for (const RuleVariableWord& word : kRuleVariableWords)
        text += fmt::format("  {:<9} {}\n", word.name, word.help);
    return text;
}

}  // namespace

int explain(const Options& options, Console& console) {
    if (options.json + options.markdown + options.schema > 1) {
        throw UsageError("only one of --json, --markdown and --schema can be had at a time");
    }
    if (options.topic == kRulesElement && options.json + options.markdown + options.schema == 0) {
        console.out << rules_page();
        return 0;
    }
    const std::vector<const Parameter*> chosen = choose(options.topic);
    if (options.schema) {
        console.out << style_schema();
    } else if (options.markdown) {
        console.out << reference_page();
    } else if (options.json) {
        Json all = Json::array();
        for (const Parameter* parameter : chosen)
            all.push_back(to_json(*parameter));
        console.out << all.dump(2) << '\n';
    } else {
        console.out << (chosen.size() == 1 ? in_full(*chosen.front()) : in_short(chosen));
    }
    return 0;
}

}  // namespace edaha
