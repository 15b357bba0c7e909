// SPDX-License-Identifier: MIT
#include "app/gallery/tree_reader.h"

#include <algorithm>
#include <array>

#include <fmt/core.h>

#include "base/error.h"
#include "style/parameter.h"
#include "style/style_xml.h"
#include "style/value.h"

namespace edaha {
namespace {

// Attributes that the command line has options for too, in the order of its commands.
struct Shortcut {
    const char* attribute;
    const char* option;
    const char* key;
};
constexpr std::array<Shortcut, 4> kShortcuts{{{"seed", "--seed", "variant.seed"},
                                              {"family", "--family", "variant.family"},
                                              {"vary", "--vary", "variant.vary"},
                                              {"look", "--look", "look.wood"}}};

void put(std::vector<Setting>& settings, const Shortcut& shortcut, const std::string& value) {
    const auto known = std::ranges::find(settings, shortcut.key, &Setting::key);
    if (known != settings.end()) {
        known->value = value;
    } else {
        settings.push_back({shortcut.option, shortcut.key, value});
    }
}

void put(std::vector<std::string>& assignments, const std::string& key, const std::string& value) {
    const auto known = std::ranges::find_if(assignments, [&](const std::string& assignment) {
        return assignment.starts_with(key + '=');
    });
    if (known != assignments.end()) {
        *known = key + '=' + value;
    } else {
        assignments.push_back(key + '=' + value);
    }
}

}  // namespace

std::vector<std::string> TreeReader::attributes() {
    std::vector<std::string> names{"style", "palette", "size", "background"};
    for (const Shortcut& shortcut : kShortcuts)
        names.emplace_back(shortcut.attribute);
    return names;
}

TreeWords TreeReader::read(const XmlElement& element, TreeWords outer) {
    TreeWords words = std::move(outer);
    for (const XmlAttribute& attribute : element.attributes)
        read_attribute(attribute, words);
    for (const XmlElement& child : element.children) {
        if (child.name == "set") read_set(child, words);
    }
    return words;
}

void TreeReader::read_attribute(const XmlAttribute& attribute, TreeWords& words) {
    const auto shortcut = std::ranges::find(kShortcuts, attribute.name, &Shortcut::attribute);
    if (shortcut != kShortcuts.end()) {
        Style scratch;
        if (const auto wrong = assign(scratch, *find_parameter(shortcut->key), attribute.value)) {
            problems_.say(attribute.offset, attribute.name + ": " + *wrong);
        } else {
            put(words.options.settings, *shortcut, attribute.value);
        }
    } else if (attribute.name == "style") {
        words.options.style = attribute.value;
        words.style_offset = attribute.offset;
    } else if (attribute.name == "palette") {
        words.options.palette = attribute.value;
        words.palette_offset = attribute.offset;
    } else if (attribute.name == "size") {
        try {
            parse_length_mm("size", attribute.value);
            words.options.size = attribute.value;
        } catch (const UsageError& error) {
            problems_.say(attribute.offset, error.what());
        }
    } else if (attribute.name == "background") {
        words.options.background = attribute.value == "yes";
        if (attribute.value != "yes" && attribute.value != "no") {
            problems_.say(attribute.offset,
                          fmt::format("background: {} is not known (expected yes or no)",
                                      in_quotes(attribute.value)));
        }
    }
}

void TreeReader::read_set(const XmlElement& set_element, TreeWords& words) {
    const auto value_of = [&](const char* name) {
        return std::ranges::find(set_element.attributes, name, &XmlAttribute::name);
    };
    const auto name = value_of("name"), value = value_of("value"),
               none = set_element.attributes.end();
    if (!set_element.children.empty() || !trim(set_element.text).empty()) {
        problems_.say(set_element.offset, "set: nothing has a place in it");
    }
    if (name != none && value != none && set_element.attributes.size() == 2) {
        set(words, name->value, value->value, value->offset);
        return;
    }
    if (set_element.attributes.empty()) {
        problems_.say(set_element.offset, "set: sets nothing (expected group.name=\"value\")");
    }
    for (const XmlAttribute& attribute : set_element.attributes)
        set(words, attribute.name, attribute.value, attribute.offset);
}

void TreeReader::set(TreeWords& words, const std::string& key, const std::string& value,
                     std::size_t offset) {
    const Parameter* const parameter = find_parameter(key);
    if (parameter == nullptr) {
        problems_.say(offset, unknown_parameter(key));
        return;
    }
    Style scratch;
    if (const auto wrong = assign(scratch, *parameter, value)) {
        problems_.say(offset, key + ": " + *wrong);
        return;
    }
    const auto shortcut = std::ranges::find(kShortcuts, key, &Shortcut::key);
    if (shortcut != kShortcuts.end()) {
        put(words.options.settings, *shortcut, std::string(trim(value)));
    } else {
        put(words.options.assignments, key, std::string(trim(value)));
    }
}

std::optional<TreeStyle> TreeReader::tree(const TreeWords& words) {
    std::optional<TreeStyle> tree = base(words);
    if (!tree) return std::nullopt;
    try {
        tree = change_style(std::move(*tree), words.options);
    } catch (const UsageError& error) {  // of the palette: the rest was good when it was read
        problems_.say(words.palette_offset, error.what());
        return std::nullopt;
    }
    if (!has_leaves(tree->style, words.style_offset)) return std::nullopt;
    return tree;
}

const std::optional<TreeStyle>& TreeReader::base(const TreeWords& words) {
    const std::string& name = words.options.style;
    const auto [known, is_new] = bases_.try_emplace(name);
    if (!is_new && known->second) return known->second;
    try {
        known->second = read_style_beside(name, folder_, catalogue_);
    } catch (const std::runtime_error& error) {
        take_error(error, words.style_offset);
    }
    return known->second;
}

bool TreeReader::has_leaves(const Style& style, std::size_t offset) {
    for (const OrnamentParams* ornament : {&style.leaf, &style.blossom, &style.fruit}) {
        if (ornament->shape.empty()) continue;
        try {
            leaves_.leaf(ornament->shape);
        } catch (const std::runtime_error& error) {
            take_error(error, offset);
            return false;
        }
    }
    if (style.flatten.bark_tile.empty()) return true;
    try {
        leaves_.bark(style.flatten.bark_tile);
    } catch (const std::runtime_error& error) {
        take_error(error, offset);
        return false;
    }
    return true;
}

void TreeReader::take_error(const std::exception& error, std::size_t offset) {
    const auto* input = dynamic_cast<const InputError*>(&error);
    if (input == nullptr || input->problems().front().place.file.empty()) {
        problems_.say(offset, error.what());
    } else {  // at places of its own
        problems_.add(input->problems());
    }
}

}  // namespace edaha
