// SPDX-License-Identifier: MIT
#include "app/gallery/element_reader.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "app/gallery/tree_reader.h"
#include "base/nearest_name.h"
#include "base/number_text.h"
#include "style/catalogue.h"
#include "style/value.h"

namespace edaha {

void ElementReader::check_attributes(const XmlElement& element,
                                     const std::vector<std::string>& known) {
    for (const XmlAttribute& attribute : element.attributes) {
        if (std::ranges::count(known, attribute.name) > 0) continue;
        problems_.say(attribute.offset,
                      fmt::format("{}.{}: no such attribute{}", element.name, attribute.name,
                                  did_you_mean(attribute.name, known)));
    }
}

void ElementReader::read_children(const XmlElement& element, const Readers& readers) {
    if (const std::string_view text = trim(element.text); !text.empty()) {
        problems_.say(element.offset,
                      fmt::format("{}: text {} has no place in it", element.name, in_quotes(text)));
    }
    std::vector<std::string> known;
    for (const auto& [name, reader] : readers)
        known.push_back(name);
    for (const XmlElement& child : element.children) {
        const auto reader = readers.find(child.name);
        if (reader != readers.end()) {
            reader->second(child);
        } else {
            problems_.say(child.offset,
                          fmt::format("{} has no place in {}{}", in_quotes(child.name),
                                      in_quotes(element.name), did_you_mean(child.name, known)));
        }
    }
}

std::string ElementReader::required(const XmlElement& element, const char* name) {
    const std::string* const value = find_attribute(element, name);
    if (value != nullptr && !trim(*value).empty()) return *value;
    problems_.say(element.offset, fmt::format("{}: {} is missing", element.name, name));
    return "";
}

std::string ElementReader::file_name(const XmlElement& element) {
    std::string name = required(element, "name");
    if (!name.empty() && !is_name(name)) {
        problems_.say(place_of(element, "name"),
                      fmt::format("{}.name: {} is not a name (expected small letters, digits and "
                                  "hyphens)",
                                  element.name, in_quotes(name)));
    }
    return name;
}

double ElementReader::length_mm(const XmlElement& element, const char* name, double otherwise) {
    const std::string* const text = find_attribute(element, name);
    if (text == nullptr) return otherwise;
    try {
        return parse_length_mm(name, *text);
    } catch (const UsageError& error) {
        problems_.say(place_of(element, name), error.what());
        return otherwise;
    }
}

int ElementReader::count(const XmlElement& element, const char* name, int otherwise, int most) {
    const std::string* const text = find_attribute(element, name);
    if (text == nullptr) return otherwise;
    const auto number = parse_number(*text);
    if (number && *number >= 1 && *number <= most && *number == std::floor(*number)) {
        return static_cast<int>(*number);
    }
    problems_.say(place_of(element, name), fmt::format("{}: {} is not a whole number of 1 … {}",
                                                       name, in_quotes(*text), most));
    return otherwise;
}

bool ElementReader::flag(const XmlElement& element, const char* name) {
    const std::string* const text = find_attribute(element, name);
    if (text == nullptr || *text == "no") return false;
    if (*text == "yes") return true;
    problems_.say(place_of(element, name),
                  fmt::format("{}: {} is not known (expected yes or no)", name, in_quotes(*text)));
    return false;
}

Line ElementReader::line(const std::string& text, std::size_t offset) {
    Line line = read_line(text);
    check_addresses(line, offset);
    return line;
}

Line ElementReader::caption(const XmlElement& element) {
    const std::string* const text = find_attribute(element, "caption");
    return text == nullptr ? Line{} : line(*text, place_of(element, "caption"));
}

void ElementReader::check_addresses(const Line& line, std::size_t offset) {
    const std::string address = unsafe_address(line);
    if (address.empty()) return;
    problems_.say(offset,
                  fmt::format("no page links to {} (expected http, https, mailto or a path)",
                              in_quotes(address)));
}

const std::string* find_attribute(const XmlElement& element, const char* name) {
    const auto found = std::ranges::find(element.attributes, name, &XmlAttribute::name);
    return found == element.attributes.end() ? nullptr : &found->value;
}

std::size_t place_of(const XmlElement& element, const char* name) {
    const auto found = std::ranges::find(element.attributes, name, &XmlAttribute::name);
    return found == element.attributes.end() ? element.offset : found->offset;
}

std::vector<std::string> with_tree(std::vector<std::string> names) {
    for (std::string& name : TreeReader::attributes())
        names.push_back(std::move(name));
    return names;
}

std::vector<std::string> split(std::string_view text, std::string_view ends) {
    std::vector<std::string> pieces;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of(ends), text.size());
        const std::string_view piece = trim(text.substr(0, end));
        if (!piece.empty()) pieces.emplace_back(piece);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return pieces;
}

}  // namespace edaha
