// SPDX-License-Identifier: MIT
#include "write/xml_text.h"

#include <cstdint>

#include "base/utf8.h"

namespace edaha {
namespace {

constexpr std::string_view kReplacement = "\xef\xbf\xbd";

bool allowed_in_xml(std::int32_t code) {
    if (code < 0x20) return code == '\t' || code == '\n' || code == '\r';
    return code != 0xfffe && code != 0xffff;
}

// Letters, digits and all else that stands for itself wherever it stands.
struct PlainBytes {
    bool at[256] = {};

    constexpr PlainBytes() {
        for (int byte = ' '; byte < 0x80; ++byte)
            at[byte] = byte != '&' && byte != '<' && byte != '>' && byte != '"';
    }
};

constexpr PlainBytes kPlain;

// How many plain bytes the text starts with.
std::size_t plain_run(std::string_view text) {
    std::size_t run = 0;
    while (run < text.size() && kPlain.at[static_cast<unsigned char>(text[run])])
        ++run;
    return run;
}

std::string_view escaped(char byte, XmlPlace place) {
    const bool in_attribute = place == XmlPlace::attribute;
    if (byte == '&') return "&amp;";
    if (byte == '<') return "&lt;";
    if (byte == '>' && !in_attribute) return "&gt;";
    if (byte == '"' && in_attribute) return "&quot;";
    if (byte == '\t' && in_attribute) return "&#09;";
    if (byte == '\n' && in_attribute) return "&#10;";
    if (byte == '\r' && in_attribute) return "&#13;";
    return {};
}

// Takes the first character off the text and calls pass() with what is to be written for it.
template <class Pass>
void pass_character(std::string_view& text, const Pass& pass) {
    const auto [code, bytes] = first_character(text);
    if (code == kNoCharacter) {
        pass(kReplacement);
    } else if (allowed_in_xml(code)) {
        pass(text.substr(0, bytes));
    }
    text.remove_prefix(bytes);
}

}  // namespace

std::string xml_safe(std::string_view text) {
    std::string safe;
    safe.reserve(text.size());
    while (!text.empty())
        pass_character(text, [&](std::string_view character) { safe += character; });
    return safe;
}

void append_xml(std::string& to, std::string_view text, XmlPlace place) {
    while (true) {
        const std::size_t run = plain_run(text);
        to += text.substr(0, run);
        text.remove_prefix(run);
        if (text.empty()) return;
        pass_character(text, [&](std::string_view character) {
            const std::string_view other = escaped(character[0], place);
            to += other.empty() ? character : other;
        });
    }
}

}  // namespace edaha
