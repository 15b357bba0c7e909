// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

namespace edaha::svg {

class Report;

// Limits of what is read, so that a hostile file costs seconds and megabytes at most. Drawn leaves
// stay far below: a detailed one has 100 shapes, 10,000 points and 200 kB.
inline constexpr std::size_t kMostBytes = 8U << 20U;
inline constexpr std::size_t kMostShapes = 10'000;  // a tree bears thousands of each
inline constexpr std::size_t kMostPoints = 1'000'000;
inline constexpr int kDeepest = 200;                  // elements in elements; we recurse into them
inline constexpr std::size_t kMostWork = 64U << 20U;  // bytes of attributes, again for every <use>

// The text as UTF-8: Latin-1 that says so (old Illustrator files) is converted.
std::string utf8_text(std::string_view text);

// A well-formed XML file with <svg> as its root, not too large and not too deep.
class SvgDocument {
  public:
    // `text` is UTF-8 and stays the caller's. Errors go to `report`, and are thrown as InputError.
    SvgDocument(std::string_view text, Report& report);

    pugi::xml_node root() const { return document_.document_element(); }

    // Without the prefix that stands for SVG; empty for elements of other vocabularies.
    std::string_view element(pugi::xml_node node) const;

    // A null node if there is none; the first if there are several.
    pugi::xml_node find(std::string_view id) const;
    std::vector<std::string> ids() const;

    // All <style> elements, and all <script>.
    const std::vector<pugi::xml_node>& sheets() const { return sheets_; }
    const std::vector<pugi::xml_node>& scripts() const { return scripts_; }

  private:
    void index_elements(Report& report);

    pugi::xml_document document_;
    std::string prefix_;
    std::map<std::string, pugi::xml_node, std::less<>> by_id_;
    std::vector<pugi::xml_node> sheets_;
    std::vector<pugi::xml_node> scripts_;
};

// Where the element's name begins in the text.
inline std::size_t offset_of(pugi::xml_node node) {
    const std::ptrdiff_t offset = node.offset_debug();
    return offset < 0 ? 0 : static_cast<std::size_t>(offset);
}

}  // namespace edaha::svg
