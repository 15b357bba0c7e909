// SPDX-License-Identifier: MIT
#include "write/svg_metadata.h"

#include <charconv>
#include <string>

#include <pugixml.hpp>

#include "write/gzip.h"
#include "write/xml_writer.h"

namespace edaha {
namespace {

constexpr const char* kNamespace = "urn:edaha:tree:1";

// Dublin Core, as Inkscape shows it under "Document properties".
void write_work(XmlWriter& rdf, const Metadata& metadata) {
    rdf.open("cc:Work");
    rdf.attribute("rdf:about", "");
    rdf.text_element("dc:format", "image/svg+xml");
    rdf.open("dc:type");
    rdf.attribute("rdf:resource", "http://purl.org/dc/dcmitype/StillImage");
    rdf.close();
    rdf.text_element("dc:title", metadata.title);
    rdf.text_element("dc:description", metadata.description);
    rdf.text_element("dc:source", metadata.command);
    rdf.close();
}

// A node of the same RDF: elements outside it make Inkscape complain.
void write_tree(XmlWriter& rdf, const Metadata& metadata) {
    rdf.open("edaha:tree");
    rdf.attribute("xmlns:edaha", kNamespace);
    rdf.attribute("rdf:about", "");
    rdf.attribute("edaha:version", metadata.version);
    rdf.attribute("edaha:seed", std::to_string(metadata.seed));
    if (!metadata.recipe.empty()) rdf.attribute("edaha:recipe", metadata.recipe);
    rdf.text_element("edaha:command", metadata.command);
    rdf.text_element("edaha:style", metadata.style_xml);
    rdf.close();
}

std::string_view local_name(std::string_view name) {
    return name.substr(name.find(':') + 1);
}

// The nearest declaration of the namespace that the element's name is in.
std::string_view namespace_of(pugi::xml_node element) {
    const std::string_view name = element.name();
    const std::size_t colon = name.find(':');
    std::string attribute = "xmlns";
    if (colon != std::string_view::npos) attribute += ':' + std::string(name.substr(0, colon));
    for (; element; element = element.parent()) {
        if (const auto declared = element.attribute(attribute.c_str())) return declared.value();
    }
    return "";
}

// The node after this one in the document's order. Not by recursion: files may nest deeply.
pugi::xml_node next_node(pugi::xml_node node) {
    if (node.first_child()) return node.first_child();
    while (node && !node.next_sibling())
        node = node.parent();
    return node.next_sibling();
}

pugi::xml_node find_tree(const pugi::xml_document& document) {
    pugi::xml_node node = document.first_child();
    while (node && !(local_name(node.name()) == "tree" && namespace_of(node) == kNamespace)) {
        node = next_node(node);
    }
    return node;
}

pugi::xml_node child_named(pugi::xml_node parent, std::string_view name) {
    return parent.find_child(
        [&](pugi::xml_node child) { return local_name(child.name()) == name; });
}

std::string_view attribute_named(pugi::xml_node node, std::string_view name) {
    return node
        .find_attribute(
            [&](pugi::xml_attribute attribute) { return local_name(attribute.name()) == name; })
        .value();
}

std::string child_text(pugi::xml_node parent, std::string_view name) {
    std::string text;
    for (const pugi::xml_node part : child_named(parent, name))
        text += part.value();
    return text;
}

}  // namespace

void write_metadata(XmlWriter& svg, const Metadata& metadata) {
    svg.text_element("title", metadata.title);
    svg.text_element("desc", metadata.description);
    const bool anonymous =
        metadata.command.empty() && metadata.style_xml.empty() && metadata.version.empty();
    if (anonymous && metadata.title.empty()) return;
    svg.open("metadata");
    svg.open("rdf:RDF");
    svg.attribute("xmlns:rdf", "http://www.w3.org/1999/02/22-rdf-syntax-ns#");
    svg.attribute("xmlns:cc", "http://creativecommons.org/ns#");
    svg.attribute("xmlns:dc", "http://purl.org/dc/elements/1.1/");
    write_work(svg, metadata);
    if (!anonymous) write_tree(svg, metadata);
    svg.close();
    svg.close();
}

std::optional<Metadata> read_svg_metadata(std::string_view svg, std::size_t max_bytes) {
    std::string unpacked;
    if (is_gzip(svg)) {
        unpacked = gunzip(svg, max_bytes);
        svg = unpacked;
    }
    pugi::xml_document document;
    constexpr unsigned kParse = pugi::parse_default | pugi::parse_ws_pcdata_single;
    if (!document.load_buffer(svg.data(), svg.size(), kParse)) return std::nullopt;
    const pugi::xml_node tree = find_tree(document);
    if (!tree) return std::nullopt;
    Metadata metadata;
    metadata.title = child_text(document.document_element(), "title");
    metadata.description = child_text(document.document_element(), "desc");
    metadata.command = child_text(tree, "command");
    metadata.style_xml = child_text(tree, "style");
    metadata.version = attribute_named(tree, "version");
    metadata.recipe = attribute_named(tree, "recipe");
    const std::string_view seed = attribute_named(tree, "seed");
    const auto read = std::from_chars(seed.data(), seed.data() + seed.size(), metadata.seed);
    if (read.ec != std::errc{} || read.ptr != seed.data() + seed.size()) return std::nullopt;
    return metadata;
}

}  // namespace edaha
