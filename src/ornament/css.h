// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace edaha::svg {

// `property: value`, and where the value stands in the text.
struct CssDeclaration {
    std::string property;
    std::string value;
    std::size_t offset = 0;
    bool important = false;
};

struct CssComplaint {
    std::size_t offset;
    std::string message;
};

// A style attribute. Pieces without a colon are complained of and left out.
std::vector<CssDeclaration> read_declarations(std::string_view text,
                                              std::vector<CssComplaint>& complaints);

// What a selector is matched against.
struct CssSubject {
    std::string_view element;
    std::string_view id;
    std::vector<std::string_view> classes;
};

// One `type.class#id`; an empty type is any.
struct CssSelector {
    std::string element;
    std::string id;
    std::vector<std::string> classes;

    bool matches(const CssSubject& subject) const;
    int specificity() const;  // CSS 2.1, 6.4.3: ids, then classes, then the element
};

struct CssRule {
    CssSelector selector;
    std::size_t block = 0;  // index of its declarations
};

// A <style> sheet of plain rules: element, .class, #id, joined or listed by commas. Whatever else
// it has (@rules, combinators, attributes, pseudo-classes) becomes a complaint.
class CssSheet {
  public:
    // Adds a text's rules; offsets of its declarations are counted from `base`.
    std::vector<CssComplaint> add(std::string_view text, std::size_t base);

    // How many rules match() looks at: its cost.
    std::size_t candidates(const CssSubject& subject) const;

    // The declarations for it, the weakest first (6.4.1), without looking at `important`.
    std::vector<const CssDeclaration*> match(const CssSubject& subject) const;

  private:
    const std::vector<std::size_t>& rules_for(const std::string& key) const;
    void add_rule(CssSelector selector, std::size_t block);

    std::vector<CssRule> rules_;
    std::vector<std::vector<CssDeclaration>> blocks_;
    // Rules by the id, else the first class, else the element they ask for: "#id", ".class",
    // "path".
    std::map<std::string, std::vector<std::size_t>, std::less<>> rules_by_key_;
};

}  // namespace edaha::svg
