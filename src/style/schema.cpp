// SPDX-License-Identifier: MIT
#include "style/schema.h"

#include <sstream>

#include <fmt/core.h>
#include <pugixml.hpp>

#include "style/parameter.h"
#include "style/value.h"

namespace edaha {
namespace {

using pugi::xml_node;

constexpr const char* kNamePattern = "[a-z0-9]([a-z0-9\\-]*[a-z0-9])?";
constexpr const char* kNumberPattern = "[+\\-]?([0-9]+(\\.[0-9]*)?|\\.[0-9]+)([eE][+\\-]?[0-9]+)?";

xml_node append(xml_node parent, const char* element, const char* attribute = nullptr,
                const std::string& value = {}) {
    xml_node node = parent.append_child(element);
    if (attribute != nullptr) node.append_attribute(attribute) = value.c_str();
    return node;
}

void document(xml_node parent, const std::string& text) {
    append(append(parent, "xs:annotation"), "xs:documentation").text() = text.c_str();
}

xml_node restrict(xml_node parent, const char* base) {
    return append(append(parent, "xs:simpleType"), "xs:restriction", "base", base);
}

void restrict_to(xml_node parent, const std::vector<std::string>& names) {
    const xml_node restriction = restrict(parent, "xs:token");
    for (const std::string& name : names)
        append(restriction, "xs:enumeration", "value", name);
}

void restrict_to_pattern(xml_node parent, const std::string& pattern) {
    append(restrict(parent, "xs:token"), "xs:pattern", "value", pattern);
}

void limit(xml_node restriction, const Limits& limits) {
    append(restriction, "xs:minInclusive", "value", shortest_text(limits.least));
    append(restriction, "xs:maxInclusive", "value", shortest_text(limits.most));
}

// The type of one attribute, by the kind of its parameter.
struct TypeWriter {
    xml_node attribute;
    const Limits& limits;

    void operator()(const Number&) const { limit(restrict(attribute, "xs:double"), limits); }
    void operator()(const Integer&) const {
        // Written out: an xs:integer has no exponent.
        const xml_node restriction = restrict(attribute, "xs:integer");
        append(restriction, "xs:minInclusive", "value", fmt::format("{:.0f}", limits.least));
        append(restriction, "xs:maxInclusive", "value", fmt::format("{:.0f}", limits.most));
    }
    void operator()(const Flag&) const { restrict_to(attribute, {"yes", "no"}); }
    void operator()(const Choice& choice) const { restrict_to(attribute, choice.names); }
    void operator()(const Interval&) const {
        restrict_to_pattern(attribute,
                            fmt::format("{0}((\\s+|\\s*\\.\\.\\s*){0})?", kNumberPattern));
    }
    void operator()(const ByOrder&) const {
        const xml_node list = append(append(attribute, "xs:simpleType"), "xs:list");
        limit(restrict(list, "xs:double"), limits);
    }
    void operator()(const Tint&) const { restrict_to_pattern(attribute, "#[0-9a-fA-F]{6}"); }
    void operator()(const Reference&) const { restrict(attribute, "xs:string"); }
    void operator()(const MeshReference&) const { restrict(attribute, "xs:string"); }
    void operator()(const Spot&) const {
        restrict_to_pattern(attribute, fmt::format("({0}\\s+){{2}}{0}", kNumberPattern));
    }
};

void append_parameter(xml_node type, const Parameter& parameter) {
    const xml_node attribute = append(type, "xs:attribute", "name", parameter.name);
    document(attribute, fmt::format("{}. {}; default '{}'. Source: {}.", parameter.help,
                                    expected_text(parameter), value_text(Style(), parameter),
                                    parameter.source));
    std::visit(TypeWriter{attribute, parameter.limits}, parameter.field);
}

void append_group(xml_node schema, const ParameterGroup& group) {
    const xml_node type = append(schema, "xs:complexType", "name", group.name);
    document(type, group.help);
    if (group.name == "palette") {
        const xml_node name = append(type, "xs:attribute", "name", "name");
        document(name, "for another palette than the style's own; it changes some of its colours");
        restrict_to_pattern(name, kNamePattern);
    }
    for (const Parameter& parameter : group.parameters)
        append_parameter(type, parameter);
}

void append_list(xml_node schema, const ParameterList& list) {
    const xml_node type = append(schema, "xs:complexType", "name", list.name);
    document(type, list.help);
    for (const Parameter& parameter : list.parameters)
        append_parameter(type, parameter);
}

void append_tree(xml_node schema) {
    const xml_node tree = append(schema, "xs:element", "name", "tree");
    const xml_node type = append(tree, "xs:complexType");
    xml_node groups = append(type, "xs:choice", "minOccurs", "0");
    groups.append_attribute("maxOccurs") = "unbounded";
    for (const ParameterGroup& group : parameter_groups()) {
        xml_node element = append(groups, "xs:element", "name", group.name);
        element.append_attribute("type") = group.name.c_str();
    }
    for (const ParameterList& list : parameter_lists()) {
        xml_node element = append(groups, "xs:element", "name", list.name);
        element.append_attribute("type") = list.name.c_str();
    }
    xml_node rules = append(groups, "xs:element", "name", kRulesElement);
    rules.append_attribute("type") = "xs:string";
    xml_node name = append(type, "xs:attribute", "name", "name");
    name.append_attribute("use") = "required";
    restrict_to_pattern(name, kNamePattern);
    for (const char* text : {"title", "description", "extends"}) {
        append(type, "xs:attribute", "name", text).append_attribute("type") = "xs:string";
    }
    const xml_node models = append(append(type, "xs:attribute", "name", "models"), "xs:simpleType");
    const xml_node list = append(append(models, "xs:restriction"), "xs:simpleType");
    restrict_to(append(list, "xs:list"), {std::begin(kModelNames), std::end(kModelNames)});
    append(models.first_child(), "xs:minLength", "value", "1");
    const xml_node unique = append(tree, "xs:unique", "name", "palette-names");
    append(unique, "xs:selector", "xpath", "palette");
    append(unique, "xs:field", "xpath", "@name");
}

}  // namespace

std::string style_schema() {
    pugi::xml_document file;
    xml_node declaration = file.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    declaration.append_attribute("encoding") = "UTF-8";
    const xml_node schema =
        append(file, "xs:schema", "xmlns:xs", "http://www.w3.org/2001/XMLSchema");
    document(schema, "Style files of edaha. Written by: edaha explain --schema");
    append_tree(schema);
    for (const ParameterGroup& group : parameter_groups())
        append_group(schema, group);
    for (const ParameterList& list : parameter_lists())
        append_list(schema, list);
    std::ostringstream out;
    file.save(out, "  ", pugi::format_default, pugi::encoding_utf8);
    return out.str();
}

}  // namespace edaha
