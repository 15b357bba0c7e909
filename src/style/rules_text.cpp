// SPDX-License-Identifier: MIT
#include "style/rules_text.h"

#include <algorithm>

#include "base/error.h"
#include "style/value.h"
#include "style/xml_text.h"
#include "surface/rules.h"

namespace edaha {
namespace {

bool continues(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

}  // namespace

void RulesText::add(std::string_view file, std::size_t offset, std::string_view value,
                    bool is_cdata) {
    std::size_t at = offset, next = offset;
    bool is_reference = false;
    for (const char byte : value) {
        if (!continues(byte)) {
            at = std::min(next, file.size());
            const std::string_view rest = file.substr(at);
            is_reference = !is_cdata && rest.starts_with('&');
            next = at + (is_reference               ? std::min(rest.find(';'), rest.size()) + 1
                         : rest.starts_with("\r\n") ? 2
                                                    : 1);
        } else if (!is_reference) {
            ++next;
        }
        text_ += byte == '\r' ? '\n' : byte;  // from &#13;, which would not come back
        offsets_.push_back(at);
    }
    end_ = std::min(next, file.size());
}

std::size_t RulesText::offset_of(int line, int column) const {
    std::size_t at = 0;
    for (; line > 1 && at < text_.size(); ++at)
        line -= text_[at] == '\n' ? 1 : 0;
    for (; column > 1 && at < text_.size() && text_[at] != '\n'; --column) {
        ++at;
        while (at < text_.size() && continues(text_[at]))
            ++at;
    }
    return at < offsets_.size() ? offsets_[at] : end_;
}

std::vector<RulesText::Wrong> RulesText::problems() const {
    if (const auto bad = first_byte_not_xml(text_)) return {{offsets_[*bad], "is not XML text"}};
    if (trim(text_).empty()) return {};
    try {
        parse_rules(text_, {});
    } catch (const InputError& error) {
        std::vector<Wrong> found;
        for (const Problem& problem : error.problems())
            found.push_back({offset_of(problem.place.line, problem.place.column), problem.message});
        return found;
    }
    return {};
}

}  // namespace edaha
