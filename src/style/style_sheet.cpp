// SPDX-License-Identifier: MIT
#include "style/style_sheet.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>
#include <span>

#include <fmt/core.h>
#include <pugixml.hpp>

#include "base/locate.h"
#include "base/nearest_name.h"
#include "base/syntax_error.h"
#include "style/rules_text.h"
#include "style/value.h"
#include "style/xml_syntax.h"
#include "style/xml_text.h"

namespace edaha {
namespace {

constexpr std::size_t kMostPalettes = 100;
constexpr std::size_t kMostItems = 10000;  // of all lists together

class SheetReader {
  public:
    SheetReader(const SourceText& source, const Catalogue& catalogue)
        : source_(source), text_(source.text), catalogue_(catalogue) {}

    StyleSheet read() {
        if (const auto bad = first_byte_not_xml(text_)) {
            const auto byte = static_cast<unsigned char>(text_[*bad]);
            say(*bad, fmt::format("byte 0x{:02X} is not XML text in UTF-8", byte));
        } else {
            read_document();
        }
        sort_problems();
        return std::move(sheet_);
    }

  private:
    struct Found {
        std::size_t offset;
        std::string message;
    };

    void say(std::size_t offset, std::string message) {
        found_.push_back({offset, std::move(message)});
    }

    void sort_problems() {
        std::ranges::stable_sort(found_, {}, &Found::offset);
        for (const Found& found : found_) {
            const Place place = place_of_offset(text_, found.offset, source_.origin);
            if (sheet_.problems.size() == kMostProblems) {
                sheet_.problems.push_back({place, "and more from here on"});
                return;
            }
            sheet_.problems.push_back({place, found.message});
        }
    }

    static std::size_t offset_of(pugi::xml_node node) {
        return static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0));
    }

    std::size_t offset_of(pugi::xml_node node, pugi::xml_attribute attribute) const {
        return attribute_offset(text_, offset_of(node), attribute.name());
    }

    void read_document() {
        pugi::xml_document document;
        const pugi::xml_parse_result result =
            document.load_buffer(text_.data(), text_.size(), kParseAllXml, pugi::encoding_utf8);
        if (!result) {
            say(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)),
                fmt::format("malformed XML: {}", xml_syntax_error(result.status)));
            return;
        }
        pugi::xml_node tree;
        for (const pugi::xml_node node : document.children()) {
            if (node.type() == pugi::node_declaration) {
                check_encoding(node);
            } else if (node.type() != pugi::node_element) {
                refuse_text(node);
            } else if (tree) {
                say(offset_of(node),
                    fmt::format("{} stands behind the end of the style", in_quotes(node.name())));
            } else {
                tree = node;
            }
        }
        if (!tree) {
            say(0, "there is no <tree> in this file");
        } else if (std::string_view(tree.name()) != "tree") {
            say(offset_of(tree),
                fmt::format("the root element is {} (expected tree)", in_quotes(tree.name())));
        } else {
            read_tree(tree);
        }
    }

    void check_encoding(pugi::xml_node declaration) {
        const pugi::xml_attribute encoding = declaration.attribute("encoding");
        if (!encoding || is_utf8(encoding.value())) return;
        say(offset_of(declaration), fmt::format("the encoding {} is not read (expected UTF-8)",
                                                in_quotes(encoding.value())));
    }

    // For anything between elements that isn't a comment or a processing instruction.
    void refuse_text(pugi::xml_node node) {
        const pugi::xml_node_type type = node.type();
        if (type == pugi::node_comment || type == pugi::node_pi) return;
        const std::size_t begin = text_.find_first_not_of(" \t\r\n", offset_of(node));
        const std::size_t offset = std::min(begin, text_.size());
        if (type == pugi::node_doctype) {
            say(offset, "a document type has no place in a style");
        } else {
            say(offset, fmt::format("text {} has no place here", in_quotes(trim(node.value()))));
        }
    }

    // True for the first attribute of its name in a tag; the others are problems.
    bool is_first(pugi::xml_node node, pugi::xml_attribute attribute, const std::string& key) {
        const std::string_view name = attribute.name();
        if (node.attribute(attribute.name()) == attribute) return true;
        const std::size_t value = attribute_value_offset(text_, offset_of(node), name);
        const std::size_t quote = std::min(text_.find(text_[value - 1], value), text_.size());
        say(attribute_offset(text_, quote, name), key + ": is given twice");
        return false;
    }

    void read_tree(pugi::xml_node tree) {
        for (const pugi::xml_attribute attribute : tree.attributes())
            read_tree_attribute(tree, attribute);
        if (!tree.attribute("name")) say(offset_of(tree), "tree.name: is missing");
        if (sheet_.title.empty()) sheet_.title = sheet_.name;
        std::vector<std::string> seen;
        for (const pugi::xml_node node : tree.children()) {
            if (node.type() != pugi::node_element) {
                refuse_text(node);
            } else {
                read_element(node, seen);
            }
        }
    }

    void read_tree_attribute(pugi::xml_node tree, pugi::xml_attribute attribute) {
        const std::string name = attribute.name();
        const std::string value = attribute.value();
        const std::size_t offset = offset_of(tree, attribute);
        if (!is_first(tree, attribute, "tree." + name)) return;
        if (first_byte_not_xml(value)) {  // from a reference such as &#1;
            say(offset, fmt::format("tree.{}: {} is not XML text", name, in_quotes(value)));
        }
        if (name == "name") {
            sheet_.name = value;
            if (!is_name(value)) say(offset, "tree.name: " + not_a_name(value));
        } else if (name == "title") {
            sheet_.title = value;
        } else if (name == "description") {
            sheet_.description = value;
        } else if (name == "extends") {
            sheet_.extends = value;
            sheet_.extends_place = place_of_offset(text_, offset, source_.origin);
            if (value.empty()) say(offset, "tree.extends: is empty (expected a style)");
        } else if (name == "models") {
            read_models(offset, value);
        } else if (name != "xmlns:xsi" && name != "xsi:noNamespaceSchemaLocation") {
            say(offset, fmt::format("tree.{}: no such attribute{}", name,
                                    did_you_mean(name, {"name", "title", "description", "extends",
                                                        "models"})));
        }
    }

    static std::string not_a_name(std::string_view value) {
        return in_quotes(value) + " is not a name (expected small letters, digits and hyphens)";
    }

    // Where in the value it is wrong is not told: it is short, and may hold references.
    void read_models(std::size_t offset, std::string_view value) {
        try {
            sheet_.models = parse_models(value);
        } catch (const SyntaxError& error) {
            say(offset, std::string("tree.models: ") + error.what());
        }
    }

    void read_element(pugi::xml_node node, std::vector<std::string>& seen) {
        const std::string name = node.name();
        if (name == kRulesElement) return read_rules(node, seen);
        if (const ParameterList* list = find_list(name)) return read_item(node, *list);
        const ParameterGroup* const group = find_group(name);
        if (group == nullptr) {
            std::vector<std::string> names;
            std::ranges::transform(parameter_groups(), std::back_inserter(names),
                                   &ParameterGroup::name);
            std::ranges::transform(parameter_lists(), std::back_inserter(names),
                                   &ParameterList::name);
            names.emplace_back(kRulesElement);
            say(offset_of(node),
                fmt::format("{}: no such group{}", name, did_you_mean(name, names)));
            return;
        }
        refuse_children(node);
        if (name == "palette" && node.attribute("name")) {
            read_named_palette(node, *group);
            return;
        }
        if (std::ranges::count(seen, name) > 0) {
            say(offset_of(node), name + ": is given twice");
        }
        seen.push_back(name);
        for (const pugi::xml_attribute attribute : node.attributes())
            read_value(node, attribute, name, group->parameters, sheet_.values);
    }

    void read_item(pugi::xml_node node, const ParameterList& list) {
        refuse_children(node);
        if (sheet_.items.size() == kMostItems) {
            say(offset_of(node), fmt::format("{}: more than {} elements", list.name, kMostItems));
        }
        if (sheet_.items.size() >= kMostItems) return;
        StyleSheet::Item item{&list, {}};
        const std::size_t problems = found_.size();
        for (const pugi::xml_attribute attribute : node.attributes())
            read_value(node, attribute, list.name, list.parameters, item.values);
        if (found_.size() == problems) check_together(node, item);
        sheet_.items.push_back(std::move(item));
    }

    void check_together(pugi::xml_node node, const StyleSheet::Item& item) {
        item.list->resize(scratch_, 0);
        item.list->resize(scratch_, 1);
        for (const StyleSheet::Value& value : item.values)
            assign(scratch_, *value.parameter, value.text);
        if (const auto fault = item.list->fault(scratch_))
            say(offset_of(node), item.list->name + ": " + *fault);
    }

    void read_rules(pugi::xml_node node, std::vector<std::string>& seen) {
        const std::string name = kRulesElement;
        if (std::ranges::count(seen, name) > 0) say(offset_of(node), name + ": is given twice");
        seen.push_back(name);
        for (const pugi::xml_attribute attribute : node.attributes())
            say(offset_of(node, attribute), name + '.' + attribute.name() + ": no such attribute");
        RulesText rules;
        for (const pugi::xml_node child : node.children()) {
            const pugi::xml_node_type type = child.type();
            if (type == pugi::node_pcdata || type == pugi::node_cdata) {
                rules.add(text_, offset_of(child), child.value(), type == pugi::node_cdata);
            } else if (type == pugi::node_element) {
                say(offset_of(child),
                    fmt::format("{} has no place in {}", in_quotes(child.name()), in_quotes(name)));
            } else {
                refuse_text(child);
            }
        }
        for (const RulesText::Wrong& wrong : rules.problems())
            say(wrong.offset, name + ": " + wrong.message);
        sheet_.rules = trim(rules.text());
    }

    void refuse_children(pugi::xml_node node) {
        for (const pugi::xml_node child : node.children()) {
            if (child.type() == pugi::node_element) {
                say(offset_of(child), fmt::format("{} has no place in {}", in_quotes(child.name()),
                                                  in_quotes(node.name())));
            } else {
                refuse_text(child);
            }
        }
    }

    void read_named_palette(pugi::xml_node node, const ParameterGroup& group) {
        const pugi::xml_attribute name = node.attribute("name");
        const std::string value = name.value();
        if (!is_name(value)) say(offset_of(node, name), "palette.name: " + not_a_name(value));
        if (std::ranges::count(sheet_.palettes, value, &StyleSheet::PaletteSheet::name) > 0) {
            say(offset_of(node, name), fmt::format("palette {}: is given twice", in_quotes(value)));
        }
        if (sheet_.palettes.size() == kMostPalettes) {
            say(offset_of(node), fmt::format("more than {} palettes", kMostPalettes));
        }
        if (sheet_.palettes.size() >= kMostPalettes) return;
        StyleSheet::PaletteSheet palette{value, {}};
        for (const pugi::xml_attribute attribute : node.attributes()) {
            if (std::string_view(attribute.name()) != "name") {
                read_value(node, attribute, group.name, group.parameters, palette.colours);
            } else {
                is_first(node, attribute, "palette.name");
            }
        }
        sheet_.palettes.push_back(std::move(palette));
    }

    void read_value(pugi::xml_node node, pugi::xml_attribute attribute, const std::string& group,
                    std::span<const Parameter> parameters, std::vector<StyleSheet::Value>& values) {
        const auto found = std::ranges::find(parameters, attribute.name(), &Parameter::name);
        if (found == parameters.end()) {
            std::vector<std::string> names;
            std::ranges::transform(parameters, std::back_inserter(names), &Parameter::name);
            say(offset_of(node, attribute),
                fmt::format("{}.{}: no such parameter{}", group, attribute.name(),
                            did_you_mean(attribute.name(), names)));
            return;
        }
        const std::string key = found->key();
        if (!is_first(node, attribute, key)) return;
        std::string text = attribute.value();
        if (const auto wrong = take(*found, text)) {
            say(offset_of(node, attribute), key + ": " + *wrong);
        } else {
            values.push_back({&*found, std::move(text)});
        }
    }

    // A reference becomes one from the working folder.
    std::optional<std::string> take(const Parameter& parameter, std::string& text) {
        if (auto wrong = assign(scratch_, parameter, text)) return wrong;
        if (std::holds_alternative<MeshReference>(parameter.field)) {
            const std::string written = value_text(scratch_, parameter);
            if (written.empty()) return std::nullopt;
            const std::filesystem::path path = source_.folder / written;
            text = path.generic_string();
            std::error_code ignored;
            if (std::filesystem::is_regular_file(path, ignored)) return std::nullopt;
            return fmt::format("there is no file {}", in_quotes(written));
        }
        if (!std::holds_alternative<Reference>(parameter.field)) return std::nullopt;
        const std::string written = value_text(scratch_, parameter);
        text = resolve_leaf(written, source_.folder);
        if (text.empty() || catalogue_.has_leaf(text)) return std::nullopt;
        return fmt::format("there is no leaf {}{}", in_quotes(written),
                           did_you_mean(written, catalogue_.leaf_names()));
    }

    const SourceText& source_;
    std::string_view text_;
    const Catalogue& catalogue_;
    Style scratch_;
    StyleSheet sheet_;
    std::vector<Found> found_;
};

}  // namespace

StyleSheet read_style_sheet(const SourceText& source, const Catalogue& catalogue) {
    return SheetReader(source, catalogue).read();
}

}  // namespace edaha
