// SPDX-License-Identifier: MIT
#include "app/gallery/manual_reader.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/core.h>

#include "base/nearest_name.h"
#include "style/samples.h"
#include "style/value.h"

namespace edaha {
namespace {

// The trees of a strip stand for one another: they need not be large.
constexpr double kTallest_mm = 32;

class ManualReader {
  public:
    ManualReader(const XmlElement& element, const ManualReading& reading)
        : element_(element), reading_(reading) {}

    std::vector<ManualGroup> read() {
        reading_.elements.check_attributes(element_, with_tree({"groups", "height"}));
        reading_.elements.read_children(element_,
                                        {{"for", [&](const XmlElement& child) { read_for(child); }},
                                         {"set", ElementReader::nothing}});
        tallest_mm_ = reading_.elements.length_mm(element_, "height", kTallest_mm);
        common_ = reading_.trees.read(element_);
        std::vector<ManualGroup> groups;
        for (const ParameterGroup* group : wanted_groups()) {
            groups.push_back({group, {}});
            for (const Parameter& parameter : group->parameters)
                groups.back().entries.push_back(entry(parameter));
        }
        return groups;
    }

  private:
    // How a parameter, or those of a group, are shown.
    struct Circumstances {
        std::string scope;
        const XmlElement* element;
    };

    void read_for(const XmlElement& child) {
        reading_.elements.check_attributes(child, with_tree({"parameter", "values"}));
        reading_.elements.read_children(child, {{"set", ElementReader::nothing}});
        const std::string scope = reading_.elements.required(child, "parameter");
        if (scope.empty()) return;
        if (find_group(scope) == nullptr && find_parameter(scope) == nullptr) {
            reading_.problems.say(place_of(child, "parameter"), unknown_parameter(scope));
        }
        circumstances_.push_back({scope, &child});
    }

    std::vector<const ParameterGroup*> wanted_groups() {
        std::vector<const ParameterGroup*> groups;
        for (const std::string& name :
             split(reading_.elements.required(element_, "groups"), kBlanks)) {
            groups.push_back(find_group(name));
            if (groups.back() != nullptr) continue;
            groups.pop_back();
            std::vector<std::string> names;
            std::ranges::transform(parameter_groups(), std::back_inserter(names),
                                   &ParameterGroup::name);
            reading_.problems.say(place_of(element_, "groups"),
                                  fmt::format("groups: there is no group {}{}", in_quotes(name),
                                              did_you_mean(name, names)));
        }
        return groups;
    }

    ManualEntry entry(const Parameter& parameter) {
        ManualEntry entry{&parameter, {}, {}};
        TreeWords words = common_;
        std::vector<std::string> values = samples(parameter);
        std::size_t place = element_.offset;
        for (const std::string& scope : {parameter.group, parameter.key()}) {
            for (const Circumstances& each : circumstances_) {
                if (each.scope != scope) continue;
                words = reading_.trees.read(*each.element, std::move(words));
                add_texts(reading_.trees.read(*each.element), entry.circumstances);
                if (const std::string* own = find_attribute(*each.element, "values")) {
                    values = split(*own, "|");
                    place = place_of(*each.element, "values");
                }
            }
        }
        if (!values.empty()) entry.plate = reading_.keep(strip_of(parameter, words, values, place));
        return entry;
    }

    // What a <for> alone says, as a person would set it.
    static void add_texts(const TreeWords& words, std::vector<std::string>& texts) {
        const TreeOptions& options = words.options;
        if (!options.style.empty()) texts.push_back("edaha draw " + options.style);
        for (const Setting& setting : options.settings)
            texts.push_back(setting.key + '=' + setting.value);
        texts.insert(texts.end(), options.assignments.begin(), options.assignments.end());
        if (!options.palette.empty()) texts.push_back("--palette " + options.palette);
    }

    Plate strip_of(const Parameter& parameter, const TreeWords& words,
                   const std::vector<std::string>& values, std::size_t place) {
        Plate plate;
        plate.name = parameter.group + '-' + parameter.name;
        plate.caption = {{Words::Kind::code, parameter.key()}};
        plate.keywords = parameter.help;
        StripParams params;
        params.tallest_mm = tallest_mm_;
        plate.arrangement = params;
        if (words.options.style.empty()) {
            reading_.problems.say(element_.offset, "parameters: style is missing");
            return plate;
        }
        for (const std::string& value : values) {
            TreeWords each = words;
            reading_.trees.set(each, parameter.key(), value, place);
            if (auto tree = reading_.trees.tree(each))
                plate.trees.push_back({std::move(*tree), value});
        }
        return plate;
    }

    const XmlElement& element_;
    const ManualReading& reading_;
    double tallest_mm_ = kTallest_mm;
    TreeWords common_;
    std::vector<Circumstances> circumstances_;
};

}  // namespace

std::vector<ManualGroup> read_manual(const XmlElement& element, const ManualReading& reading) {
    return ManualReader(element, reading).read();
}

}  // namespace edaha
