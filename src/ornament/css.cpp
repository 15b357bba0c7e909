// SPDX-License-Identifier: MIT
#include "ornament/css.h"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "ornament/scan.h"

namespace edaha::svg {
namespace {

// Comments and the marks that hide a sheet from old browsers, made blank: offsets stay.
std::string without_comments(std::string_view text) {
    std::string plain(text);
    for (std::size_t at = plain.find("/*"); at != std::string::npos; at = plain.find("/*", at)) {
        const std::size_t end = plain.find("*/", at + 2);
        const std::size_t stop = end == std::string::npos ? plain.size() : end + 2;
        std::fill(plain.begin() + static_cast<std::ptrdiff_t>(at),
                  plain.begin() + static_cast<std::ptrdiff_t>(stop), ' ');
        at = stop;
    }
    for (const std::string_view mark : {"<!--", "-->"}) {
        for (std::size_t at = plain.find(mark); at != std::string::npos;
             at = plain.find(mark, at)) {
            plain.replace(at, mark.size(), mark.size(), ' ');
        }
    }
    return plain;
}

// The end of a piece that begins at `at`: `end` outside quotes and parentheses, or the text's end.
std::size_t find_outside(std::string_view text, std::size_t at, char end) {
    char quote = '\0';
    int depth = 0;
    for (; at < text.size(); ++at) {
        const char c = text[at];
        if (quote != '\0') {
            if (c == quote) quote = '\0';
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '(') {
            ++depth;
        } else if (c == ')') {
            --depth;
        } else if (c == end && depth <= 0) {
            return at;
        }
    }
    return text.size();
}

std::size_t offset_of(std::string_view part, std::string_view whole) {
    return static_cast<std::size_t>(part.data() - whole.data());
}

CssDeclaration read_declaration(std::string_view piece, std::size_t colon) {
    CssDeclaration declaration;
    declaration.property = lower_case(trimmed(piece.substr(0, colon)));
    std::string_view value = trimmed(piece.substr(colon + 1));
    if (lower_case(value).ends_with("important")) {
        const std::size_t mark = value.rfind('!');
        declaration.important = mark != std::string_view::npos;
        if (declaration.important) value = trimmed(value.substr(0, mark));
    }
    declaration.value = value;
    declaration.offset = offset_of(value, piece);
    return declaration;
}

// None if it is more than element, classes and id.
std::optional<CssSelector> read_selector(std::string_view text) {
    CssSelector selector;
    Scanner scanner(text);
    if (!scanner.take('*')) selector.element = scanner.take_word();
    while (!scanner.at_end()) {
        const char kind = scanner.take();
        const std::string name(scanner.take_word());
        if (name.empty()) return std::nullopt;
        if (kind == '.') {
            selector.classes.push_back(name);
        } else if (kind == '#' && selector.id.empty()) {
            selector.id = name;
        } else {
            return std::nullopt;
        }
    }
    return selector;
}

// The keys of CssSheet's rules that an element may match.
std::vector<std::string> keys_of(const CssSubject& subject) {
    std::vector<std::string> keys{"", std::string(subject.element)};
    for (const std::string_view c : subject.classes)
        keys.push_back('.' + std::string(c));
    if (!subject.id.empty()) keys.push_back('#' + std::string(subject.id));
    return keys;
}

}  // namespace

std::vector<CssDeclaration> read_declarations(std::string_view text,
                                              std::vector<CssComplaint>& complaints) {
    const std::string plain = without_comments(text);
    const std::string_view all = plain;
    std::vector<CssDeclaration> declarations;
    for (std::size_t begin = 0; begin < all.size();) {
        const std::size_t end = find_outside(all, begin, ';');
        const std::string_view piece = all.substr(begin, end - begin);
        const std::size_t colon = piece.find(':');
        if (colon != std::string_view::npos) {
            declarations.push_back(read_declaration(piece, colon));
            declarations.back().offset += begin;
        } else if (const std::string_view junk = trimmed(piece); !junk.empty()) {
            complaints.push_back(
                {offset_of(junk, all),
                 "style: " + quoted(junk) + " is not a declaration (expected property: value)"});
        }
        begin = end + 1;
    }
    return declarations;
}

bool CssSelector::matches(const CssSubject& subject) const {
    if (!element.empty() && element != subject.element) return false;
    if (!id.empty() && id != subject.id) return false;
    return std::all_of(classes.begin(), classes.end(), [&](const std::string& c) {
        return std::find(subject.classes.begin(), subject.classes.end(), c) !=
               subject.classes.end();
    });
}

int CssSelector::specificity() const {
    constexpr int kMany = 1000;  // no selector names more classes to any purpose
    const int classes_count = std::min(static_cast<int>(classes.size()), kMany - 1);
    return (id.empty() ? 0 : kMany * 2) + classes_count * 2 + (element.empty() ? 0 : 1);
}

void CssSheet::add_rule(CssSelector selector, std::size_t block) {
    const std::string key = !selector.id.empty()        ? '#' + selector.id
                            : !selector.classes.empty() ? '.' + selector.classes.front()
                                                        : selector.element;
    rules_by_key_[key].push_back(rules_.size());
    rules_.push_back({std::move(selector), block});
}

std::vector<CssComplaint> CssSheet::add(std::string_view text, std::size_t base) {
    const std::string plain = without_comments(text);
    const std::string_view all = plain;
    std::vector<CssComplaint> complaints;
    const auto left_out = [&](std::string_view what, const std::string& why) {
        complaints.push_back({offset_of(what, all), "style sheet: " + quoted(what) + why});
    };
    for (std::size_t begin = 0; begin < all.size();) {
        const std::size_t open = find_outside(all, begin, '{');
        const std::string_view head = trimmed(all.substr(begin, open - begin));
        if (head.starts_with('@')) {
            // Either a statement that ends at a semicolon, or a block with blocks in it.
            const std::size_t statement = find_outside(all.substr(0, open), begin, ';');
            left_out(head.substr(0, head.find_first_of(" ;(")), " is left out");
            if (statement < open) {
                begin = statement + 1;
                continue;
            }
            int depth = 1;
            for (begin = open + 1; begin < all.size() && depth > 0; ++begin) {
                depth += all[begin] == '{' ? 1 : all[begin] == '}' ? -1 : 0;
            }
            continue;
        }
        if (open == all.size()) {
            if (!head.empty()) left_out(head, " is left out (expected rules with { })");
            break;
        }
        const std::size_t close = find_outside(all, open + 1, '}');
        std::vector<CssComplaint> inside;
        blocks_.push_back(read_declarations(all.substr(open + 1, close - open - 1), inside));
        for (CssDeclaration& d : blocks_.back())
            d.offset += base + open + 1;
        for (CssComplaint& c : inside)
            complaints.push_back({c.offset + open + 1, c.message});
        for (std::size_t at = 0; at <= head.size();) {
            const std::size_t end = std::min(head.find(',', at), head.size());
            const std::string_view one = trimmed(head.substr(at, end - at));
            if (std::optional<CssSelector> selector = read_selector(one)) {
                add_rule(std::move(*selector), blocks_.size() - 1);
            } else {
                left_out(one, " is a selector beyond element, .class and #id, and left out");
            }
            at = end + 1;
        }
        begin = close + 1;
    }
    for (CssComplaint& c : complaints)
        c.offset += base;
    return complaints;
}

const std::vector<std::size_t>& CssSheet::rules_for(const std::string& key) const {
    static const std::vector<std::size_t> none;
    const auto found = rules_by_key_.find(key);
    return found == rules_by_key_.end() ? none : found->second;
}

std::size_t CssSheet::candidates(const CssSubject& subject) const {
    std::size_t count = 0;
    for (const std::string& key : keys_of(subject))
        count += rules_for(key).size();
    return count;
}

std::vector<const CssDeclaration*> CssSheet::match(const CssSubject& subject) const {
    std::vector<std::size_t> matching;
    for (const std::string& key : keys_of(subject)) {
        for (const std::size_t i : rules_for(key)) {
            if (rules_[i].selector.matches(subject)) matching.push_back(i);
        }
    }
    std::sort(matching.begin(), matching.end(), [&](std::size_t a, std::size_t b) {
        return std::tuple(rules_[a].selector.specificity(), a) <
               std::tuple(rules_[b].selector.specificity(), b);
    });
    matching.erase(std::unique(matching.begin(), matching.end()), matching.end());
    std::vector<const CssDeclaration*> declarations;
    for (const std::size_t i : matching) {
        for (const CssDeclaration& d : blocks_[rules_[i].block])
            declarations.push_back(&d);
    }
    return declarations;
}

}  // namespace edaha::svg
