// SPDX-License-Identifier: MIT
#include "style/xml_tree.h"

#include <algorithm>

#include <fmt/core.h>

#include "base/locate.h"
#include "style/value.h"
#include "style/xml_syntax.h"
#include "style/xml_text.h"

namespace edaha {
namespace {

// Each level takes a call of ours.
constexpr int kMostLevels = 100;

std::size_t offset_of(pugi::xml_node node) {
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0));
}

bool is_remark(pugi::xml_node node) {
    return node.type() == pugi::node_comment || node.type() == pugi::node_pi;
}

bool is_text(pugi::xml_node node) {
    return node.type() == pugi::node_pcdata || node.type() == pugi::node_cdata;
}

class TreeReader {
  public:
    TreeReader(std::string_view text, XmlProblems& problems) : text_(text), problems_(problems) {}

    XmlElement read_root(pugi::xml_node document, const std::string& root) {
        pugi::xml_node found;
        for (const pugi::xml_node node : document.children()) {
            if (node.type() == pugi::node_declaration) {
                check_encoding(node);
            } else if (node.type() == pugi::node_element && !found) {
                found = node;
            } else if (!is_remark(node)) {
                problems_.say(first_ink(node), "nothing but <" + root + "> has a place here");
            }
        }
        if (found && root == found.name()) return read(found, 0);
        if (found) {
            problems_.say(offset_of(found), fmt::format("the root element is {} (expected {})",
                                                        in_quotes(found.name()), root));
        } else {
            problems_.say(0, "there is no <" + root + "> in this file");
        }
        return {};
    }

  private:
    // Where a text begins to be more than white space.
    std::size_t first_ink(pugi::xml_node node) const {
        return std::min(text_.find_first_not_of(" \t\r\n", offset_of(node)), text_.size());
    }

    void check_encoding(pugi::xml_node declaration) {
        const pugi::xml_attribute encoding = declaration.attribute("encoding");
        if (!encoding || is_utf8(encoding.value())) return;
        problems_.say(offset_of(declaration),
                      fmt::format("the text must be UTF-8, not {}", in_quotes(encoding.value())));
    }

    XmlElement read(pugi::xml_node node, int level) {
        XmlElement element{node.name(), offset_of(node), {}, {}, {}};
        if (level > kMostLevels) {
            problems_.say(element.offset, fmt::format("more than {} levels deep", kMostLevels));
            return element;
        }
        for (const pugi::xml_attribute attribute : node.attributes())
            read_attribute(attribute, element);
        const auto is_element = [](pugi::xml_node child) {
            return child.type() == pugi::node_element;
        };
        const bool has_elements = std::ranges::any_of(node.children(), is_element);
        for (const pugi::xml_node child : node.children()) {
            if (is_element(child)) {
                element.children.push_back(read(child, level + 1));
            } else if (is_text(child) && has_elements) {
                problems_.say(first_ink(child), fmt::format("text {} has no place beside elements",
                                                            in_quotes(trim(child.value()))));
            } else if (is_text(child)) {
                element.text += child.value();
            }
        }
        if (first_byte_not_xml(element.text))
            problems_.say(element.offset, fmt::format("{}: holds what is no text", element.name));
        return element;
    }

    void read_attribute(pugi::xml_attribute attribute, XmlElement& element) {
        const std::string name = attribute.name();
        const std::size_t offset = attribute_offset(text_, element.offset, name);
        if (std::ranges::count(element.attributes, name, &XmlAttribute::name) > 0) {
            problems_.say(offset, fmt::format("{}: is given twice", name));
        } else if (first_byte_not_xml(attribute.value())) {  // from a reference such as &#1;
            problems_.say(
                offset, fmt::format("{}: {} is not XML text", name, in_quotes(attribute.value())));
        } else {
            element.attributes.push_back({name, attribute.value(), offset});
        }
    }

    std::string_view text_;
    XmlProblems& problems_;
};

}  // namespace

std::vector<Problem> XmlProblems::sorted() const {
    std::vector<Found> found = found_;
    std::ranges::stable_sort(found, {}, &Found::offset);
    std::vector<Problem> problems;
    const auto add = [&](const Problem& problem) {
        const std::string line = to_string(problem);
        const auto is_same = [&](const Problem& other) { return to_string(other) == line; };
        if (std::ranges::none_of(problems, is_same)) problems.push_back(problem);
    };
    for (const Found& each : found)
        add({place_of_offset(text_, each.offset, origin_), each.message});
    std::ranges::for_each(others_, add);
    return problems;
}

XmlElement read_xml(std::string_view text, const std::string& root, XmlProblems& problems) {
    if (const auto bad = first_byte_not_xml(text)) {
        const auto byte = static_cast<unsigned char>(text[*bad]);
        problems.say(*bad, fmt::format("byte 0x{:02X} is no UTF-8 text", byte));
        return {};
    }
    pugi::xml_document document;
    const pugi::xml_parse_result result =
        document.load_buffer(text.data(), text.size(), kParseAllXml, pugi::encoding_utf8);
    if (result) return TreeReader(text, problems).read_root(document, root);
    problems.say(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)),
                 fmt::format("malformed XML: {}", xml_syntax_error(result.status)));
    return {};
}

}  // namespace edaha
