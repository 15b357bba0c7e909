// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "app/gallery/words.h"
#include "style/xml_tree.h"

namespace edaha {

// The attributes and children of gallery.xml's elements, checked. Whatever is wrong becomes a
// problem, and something harmless comes back, so that reading goes on.
class ElementReader {
  public:
    explicit ElementReader(XmlProblems& problems) : problems_(problems) {}

    // All others are problems.
    void check_attributes(const XmlElement& element, const std::vector<std::string>& known);

    // Calls the reader of each child by its name. There is no place for text.
    using Readers = std::map<std::string, std::function<void(const XmlElement&)>>;
    void read_children(const XmlElement& element, const Readers& readers);
    static void nothing(const XmlElement&) {}  // the reader of what is read elsewhere

    std::string required(const XmlElement& element, const char* name);
    std::string file_name(const XmlElement& element);  // of `name`: small letters, digits, hyphens
    double length_mm(const XmlElement& element, const char* name, double otherwise);
    int count(const XmlElement& element, const char* name, int otherwise, int most);
    bool flag(const XmlElement& element, const char* name);  // no, if it is missing
    Line line(const std::string& text, std::size_t offset);
    Line caption(const XmlElement& element);
    void check_addresses(const Line& line, std::size_t offset);

  private:
    XmlProblems& problems_;
};

// The value of an attribute; null if there is none.
const std::string* find_attribute(const XmlElement& element, const char* name);

// Where that attribute stands; where the element does, if there is none.
std::size_t place_of(const XmlElement& element, const char* name);

// `names`, and those of an element's that means a tree.
std::vector<std::string> with_tree(std::vector<std::string> names);

// The pieces between any of the characters `ends`, trimmed; none of them empty.
std::vector<std::string> split(std::string_view text, std::string_view ends);
inline constexpr std::string_view kBlanks = " \t\r\n";

}  // namespace edaha
