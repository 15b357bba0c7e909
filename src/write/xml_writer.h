// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "write/sink.h"

namespace edaha {

// Writes a document of XML 1.0 as it goes along: an element a line, a blank deeper than the one it
// stands in, or compact, all in one line. Nothing but the last 64 KB is kept.
//   - Values and texts may hold anything: see append_xml(). Names are taken as they are; those of
//     elements outlive their element.
//   - An element holds either elements or one text, and its attributes come before these.
// Cost: a copy of its bytes, and what the sink costs. Errors: what the sink throws.
class XmlWriter {
  public:
    // The sink outlives the writer.
    XmlWriter(const Sink& sink, bool compact);

    void declare();
    // `attributes`: what thousands of elements begin with, as text, with a blank before each.
    void open(std::string_view name, std::string_view attributes = {});
    void attribute(std::string_view name, std::string_view value);
    // For numbers, path data and the like, in which no character means anything to XML.
    void plain_attribute(std::string_view name, std::string_view value);
    void text(std::string_view text);
    void close();
    // An element that holds nothing but a text; none where that is empty.
    void text_element(std::string_view name, std::string_view text);

    // Sends what is left, when all elements are closed. Returns the bytes of all.
    std::size_t finish();

  private:
    void put(std::string_view bytes);
    void put_split(std::string_view bytes);
    void put(char byte);
    void send();
    void end_start_tag();
    void indent();
    void end_line();

    const Sink& sink_;
    bool compact_;
    bool in_start_tag_ = false;
    bool holds_text_ = false;              // the open element
    std::vector<std::string_view> names_;  // of the open elements, outermost first
    std::string escaped_;                  // the last value or text, reused
    std::vector<char> buffer_;
    std::size_t used_ = 0;
    std::size_t sent_ = 0;
};

}  // namespace edaha
