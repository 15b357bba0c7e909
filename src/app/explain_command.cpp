// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <ostream>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "base/nearest_name.h"
#include "style/parameter.h"
#include "style/reference_page.h"
#include "style/samples.h"
#include "style/schema.h"
#include "style/value.h"

namespace edaha {
namespace {

using Json = nlohmann::ordered_json;

// The parameters of a topic: one, a group, or all of them.
std::vector<const Parameter*> choose(const std::string& topic) {
    std::vector<const Parameter*> chosen;
    for (const Parameter& parameter : parameters()) {
        if (topic.empty() || topic == parameter.group || topic == parameter.key()) {
            chosen.push_back(&parameter);
        }
    }
    if (!chosen.empty()) return chosen;
    if (topic.find('.') != std::string::npos) throw UsageError(unknown_parameter(topic));
    std::vector<std::string> groups;
    std::ranges::transform(parameter_groups(), std::back_inserter(groups), &ParameterGroup::name);
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

std::string in_short(std::span<const Parameter* const> chosen) {
    std::string text;
    std::string group;
    for (const Parameter* parameter : chosen) {
        if (parameter->group != group) {
            group = parameter->group;
            text +=
                fmt::format("{}{}: {}\n", text.empty() ? "" : "\n", group, find_group(group)->help);
        }
        text += fmt::format("  {:<22} {:<12} {}\n", parameter->key(),
                            value_text(Style(), *parameter), parameter->help);
    }
    return text;
}

}  // namespace

int explain(const Options& options, Console& console) {
    if (options.json + options.markdown + options.schema > 1) {
        throw UsageError("only one of --json, --markdown and --schema can be had at a time");
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
