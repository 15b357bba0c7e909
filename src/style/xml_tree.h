// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"

namespace edaha {

// A small XML file as plain data that knows its places, for readers that take nothing for granted.

struct XmlAttribute {
    std::string name;
    std::string value;
    std::size_t offset = 0;  // in the file's text
};

struct XmlElement {
    std::string name;
    std::size_t offset = 0;
    std::vector<XmlAttribute> attributes;  // each name once
    std::vector<XmlElement> children;
    std::string text;  // of an element without children: as it is written
};

// What is wrong with a text, said in any order.
class XmlProblems {
  public:
    XmlProblems(std::string_view text, std::string origin)
        : text_(text), origin_(std::move(origin)) {}

    void say(std::size_t offset, std::string message) {
        found_.push_back({offset, std::move(message)});
    }
    void add(std::vector<Problem> of_another_file) {
        others_.insert(others_.end(), of_another_file.begin(), of_another_file.end());
    }

    // Each once, in the order of the text, then those of other files.
    std::vector<Problem> sorted() const;

  private:
    struct Found {
        std::size_t offset;
        std::string message;
    };
    std::string_view text_;
    std::string origin_;
    std::vector<Found> found_;
    std::vector<Problem> others_;
};

// The root element of a text, which must be `root`. Comments and processing instructions are left
// out. What is no XML in UTF-8, a document type, an attribute given twice, text beside elements, or
// something behind the root is a problem; without a root, an empty element comes back.
// Cost: linear, and quadratic in the depth, which is 100 at most.
XmlElement read_xml(std::string_view text, const std::string& root, XmlProblems& problems);

}  // namespace edaha
