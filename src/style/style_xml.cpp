// SPDX-License-Identifier: MIT
#include "style/style_xml.h"

#include <algorithm>
#include <iterator>
#include <sstream>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "base/nearest_name.h"
#include "style/style_sheet.h"
#include "style/value.h"

namespace edaha {
namespace {

// Bases of bases are rare; a long chain is a mistake that would be hard to follow by hand.
constexpr std::size_t kMostBases = 16;

struct SheetWithOrigin {
    StyleSheet sheet;
    std::string origin;
};

std::optional<std::string> wrong_base(const std::vector<SheetWithOrigin>& chain,
                                      const SourceText& base) {
    const bool circle = std::ranges::count(chain, base.origin, &SheetWithOrigin::origin) > 0;
    if (circle) return in_quotes(chain.back().sheet.extends) + " extends this style itself";
    if (chain.size() > kMostBases) return fmt::format("more than {} bases deep", kMostBases);
    return std::nullopt;
}

// The source, what it extends, what that extends … with problems for what can't be found.
std::vector<SheetWithOrigin> read_chain(const SourceText& first, const Catalogue& catalogue) {
    std::vector<SheetWithOrigin> chain;
    SourceText source = first;
    while (true) {
        chain.push_back({read_style_sheet(source, catalogue), source.origin});
        StyleSheet& sheet = chain.back().sheet;
        if (sheet.extends.empty()) return chain;
        std::optional<std::string> wrong;
        try {
            source = catalogue.find_style(sheet.extends, source.folder);
            wrong = wrong_base(chain, source);
        } catch (const std::runtime_error& error) {
            wrong = error.what();
        }
        if (wrong) {
            sheet.problems.push_back({sheet.extends_place, "tree.extends: " + *wrong});
            return chain;
        }
    }
}

void throw_problems(const std::vector<SheetWithOrigin>& chain) {
    std::vector<Problem> problems;
    for (const SheetWithOrigin& link : chain) {
        std::vector<Problem> own = link.sheet.problems;
        std::ranges::stable_sort(own, {}, [](const Problem& problem) {
            return std::pair(problem.place.line, problem.place.column);
        });
        std::ranges::move(own, std::back_inserter(problems));
    }
    if (!problems.empty()) throw InputError(std::move(problems));
}

void apply(Style& style, const std::vector<StyleSheet::Value>& values) {
    for (const StyleSheet::Value& value : values)
        assign(style, *value.parameter, value.text);
}

// A list is all of what the last file that has any of it says.
void apply_lists(Style& style, const StyleSheet& sheet) {
    for (const ParameterList& list : parameter_lists()) {
        const auto is_of_list = [&](const StyleSheet::Item& item) { return item.list == &list; };
        if (std::ranges::none_of(sheet.items, is_of_list)) continue;
        list.resize(style, 0);
        for (const StyleSheet::Item& item : sheet.items) {
            if (!is_of_list(item)) continue;
            list.resize(style, list.size(style) + 1);
            apply(style, item.values);
            for (const Parameter& parameter : list.parameters)  // as make_canonical() below
                assign(style, parameter, value_text(style, parameter));
        }
    }
    if (sheet.rules) style.surface.rules = *sheet.rules;
}

// Starts from what the palette of that name is so far, or else from the main one.
void apply_palette(Style& style, const StyleSheet::PaletteSheet& sheet) {
    auto named = std::ranges::find(style.palettes, sheet.name, &NamedPalette::name);
    if (named == style.palettes.end()) {
        style.palettes.push_back({sheet.name, style.palette});
        named = style.palettes.end() - 1;
    }
    const Palette main = style.palette;
    style.palette = named->palette;
    apply(style, sheet.colours);
    named->palette = style.palette;
    style.palette = main;
}

// Angles as a style file would give them, so that a style and its canonical text draw the same.
void make_canonical(Style& style) {
    for (const Parameter& parameter : parameters())
        assign(style, parameter, value_text(style, parameter));
}

bool is_default(const Style& style, const ParameterGroup& group) {
    static const Style plain;
    return std::ranges::all_of(group.parameters, [&](const Parameter& parameter) {
        return value_text(style, parameter) == value_text(plain, parameter);
    });
}

void write_list(pugi::xml_node tree, const Style& style, const ParameterList& list) {
    for (std::size_t i = 0; i < list.size(style); ++i) {
        Style part;
        part.surface = style.surface;
        list.resize(part, i + 1);
        pugi::xml_node node = tree.append_child(list.name.c_str());
        for (const Parameter& parameter : list.parameters) {
            const std::string text = value_text(part, parameter);
            if (!text.empty()) node.append_attribute(parameter.name.c_str()) = text.c_str();
        }
    }
}

void write_palette(pugi::xml_node tree, const Style& style, const NamedPalette& named) {
    pugi::xml_node node = tree.append_child("palette");
    node.append_attribute("name") = named.name.c_str();
    Style other;
    other.palette = named.palette;
    for (const Parameter& parameter : find_group("palette")->parameters) {
        const std::string text = value_text(other, parameter);
        if (text == value_text(style, parameter)) continue;
        node.append_attribute(parameter.name.c_str()) = text.c_str();
    }
}

std::optional<std::string> set_parameter(Style& style, const std::string& assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos) {
        return in_quotes(assignment) + " is not an assignment (expected group.name=value)";
    }
    const std::string key = assignment.substr(0, equals);
    const Parameter* const parameter = find_parameter(key);
    if (parameter == nullptr && find_list(key.substr(0, key.find('.'))) != nullptr)
        return key + ": only style files can set it: there may be many";
    if (parameter == nullptr) return unknown_parameter(key);
    const auto wrong = assign(style, *parameter, std::string_view(assignment).substr(equals + 1));
    return wrong ? std::optional(key + ": " + *wrong) : std::nullopt;
}

}  // namespace

Style read_style(const SourceText& source, const Catalogue& catalogue) {
    const std::vector<SheetWithOrigin> chain = read_chain(source, catalogue);
    throw_problems(chain);
    Style style;
    style.name = chain.front().sheet.name;
    style.title = chain.front().sheet.title;
    style.description = chain.front().sheet.description;
    for (auto link = chain.rbegin(); link != chain.rend(); ++link) {
        if (!link->sheet.models.empty()) style.models = link->sheet.models;
        apply(style, link->sheet.values);
        apply_lists(style, link->sheet);
    }
    make_canonical(style);
    for (auto link = chain.rbegin(); link != chain.rend(); ++link) {
        for (const StyleSheet::PaletteSheet& palette : link->sheet.palettes)
            apply_palette(style, palette);
    }
    return style;
}

std::string to_xml(const Style& style) {
    pugi::xml_document document;
    pugi::xml_node tree = document.append_child("tree");
    tree.append_attribute("name") = style.name.c_str();
    tree.append_attribute("title") = style.title.c_str();
    tree.append_attribute("description") = style.description.c_str();
    if (style.models != Style().models)
        tree.append_attribute("models") = models_text(style.models).c_str();
    for (const ParameterGroup& group : parameter_groups()) {
        if (group.of_model && is_default(style, group)) continue;
        pugi::xml_node node = tree.append_child(group.name.c_str());
        for (const Parameter& parameter : group.parameters) {
            node.append_attribute(parameter.name.c_str()) = value_text(style, parameter).c_str();
        }
    }
    for (const ParameterList& list : parameter_lists())
        write_list(tree, style, list);
    if (!style.surface.rules.empty())
        tree.append_child(kRulesElement).text() = style.surface.rules.c_str();
    for (const NamedPalette& palette : style.palettes)
        write_palette(tree, style, palette);
    std::ostringstream out;
    document.save(out, "  ", pugi::format_default | pugi::format_no_declaration,
                  pugi::encoding_utf8);
    return out.str();
}

void set_parameters(Style& style, std::span<const std::string> assignments,
                    const std::string& where) {
    Style changed = style;
    std::vector<Problem> problems;
    for (const std::string& assignment : assignments) {
        if (auto wrong = set_parameter(changed, assignment)) {
            problems.push_back({{where, 0, 0}, std::move(*wrong)});
        }
    }
    if (!problems.empty()) throw InputError(std::move(problems));
    style = std::move(changed);
}

void choose_palette(Style& style, const std::string& name) {
    const auto found = std::ranges::find(style.palettes, name, &NamedPalette::name);
    if (found != style.palettes.end()) {
        style.palette = found->palette;
        return;
    }
    std::vector<std::string> names;
    std::ranges::transform(style.palettes, std::back_inserter(names), &NamedPalette::name);
    std::string message = fmt::format("'{}' has no palette {}", style.name, in_quotes(name));
    if (const auto nearest = nearest_name(name, names)) {
        message += " (did you mean '" + *nearest + "'?)";
    } else if (names.empty()) {
        message += " (it has none but its own)";
    } else {
        message += fmt::format(" (it has {})", fmt::join(names, ", "));
    }
    throw InputError(std::vector<Problem>{Problem{Place{}, std::move(message)}});
}

}  // namespace edaha
