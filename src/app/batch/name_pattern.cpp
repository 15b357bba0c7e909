// SPDX-License-Identifier: MIT
#include "app/batch/name_pattern.h"

#include <algorithm>

#include <fmt/core.h>

#include "app/options.h"
#include "base/nearest_name.h"
#include "style/parameter.h"
#include "style/value.h"
#include "style/xml_text.h"

namespace edaha {
namespace {

constexpr std::size_t kMostDigits = 18;

// Linux allows 255 bytes; the ending takes five.
constexpr std::size_t kMostNameBytes = 250;

const std::vector<std::string> kFields{"style", "seed", "index", "family", "palette"};

bool is_control(char c) {
    return (c >= 0 && c < ' ') || c == '\x7f';
}

bool is_whole_number(const std::string& field) {
    if (field == "seed" || field == "index" || field == "family") return true;
    const Parameter* const parameter = find_parameter(field);
    return parameter != nullptr && std::holds_alternative<Integer>(parameter->field);
}

std::string unknown_field(const std::string& field) {
    std::vector<std::string> known = kFields;
    for (const Parameter& parameter : parameters())
        known.push_back(parameter.key());
    const auto nearest = nearest_name(field, known);
    return fmt::format(
        "{} is no field (expected style, seed, index, family, palette or a parameter{})",
        in_quotes('{' + field + '}'), nearest ? "; did you mean '{" + *nearest + "}'?" : "");
}

[[noreturn]] void fail(const std::string& message) {
    throw UsageError("--name: " + message);
}

std::string without_slashes(std::string text) {
    std::ranges::replace(text, '/', '-');
    std::ranges::replace(text, ' ', '_');
    return text;
}

void check_path(const std::string& path) {
    for (std::size_t begin = 0; begin <= path.size();) {
        const std::size_t end = std::min(path.find('/', begin), path.size());
        const std::string part = path.substr(begin, end - begin);
        if (part.empty() || part == "." || part == "..")
            fail(in_quotes(path) + " is no path within the folder of -o");
        if (part.size() > kMostNameBytes)
            fail(fmt::format("{} is too long (at most {} bytes)", in_quotes(part), kMostNameBytes));
        begin = end + 1;
    }
}

}  // namespace

NamePattern::NamePattern(const std::string& text) : text_(text) {
    if (text.empty()) fail("is empty");
    if (first_byte_not_xml(text) || std::ranges::any_of(text, is_control))
        fail(in_quotes(text) + " is not plain text");
    std::size_t begin = 0;
    while (begin < text.size()) {
        const std::size_t open = std::min(text.find_first_of("{}", begin), text.size());
        const std::size_t close = text.find_first_of("{}", open + 1);
        const std::string before = text.substr(begin, open - begin);
        if (open == text.size()) {
            pieces_.push_back({before, {}, 0});
            break;
        }
        if (text[open] == '}' || close == std::string::npos || text[close] == '{')
            fail(in_quotes(text) + " has a brace without its other");
        add_field(text.substr(open + 1, close - open - 1), before);
        begin = close + 1;
    }
}

void NamePattern::add_field(const std::string& field, const std::string& text) {
    const std::size_t colon = field.find(':');
    Piece piece{text, field.substr(0, colon), 0};
    const bool known =
        std::ranges::count(kFields, piece.field) > 0 || find_parameter(piece.field) != nullptr;
    if (!known) fail(unknown_field(piece.field));
    if (colon != std::string::npos) {
        const std::string digits = field.substr(colon + 1);
        const bool sound = digits.size() >= 2 && digits.size() <= 3 && digits[0] == '0' &&
                           digits.find_first_not_of("0123456789") == std::string::npos;
        piece.digits = sound ? std::stoul(digits) : 0;
        if (piece.digits == 0 || piece.digits > kMostDigits)
            fail(fmt::format("{}: ':{}' is no width (expected :01 … :{})",
                             in_quotes('{' + field + '}'), digits, kMostDigits));
        if (!is_whole_number(piece.field))
            fail(in_quotes('{' + field + '}') + ": only whole numbers have a width");
    }
    pieces_.push_back(std::move(piece));
}

std::string NamePattern::name(const FieldText& field_text) const {
    std::string path;
    for (const Piece& piece : pieces_) {
        path += piece.text;
        if (piece.field.empty()) continue;
        const std::string text = without_slashes(field_text(piece.field));
        if (text.size() < piece.digits) path.append(piece.digits - text.size(), '0');
        path += text;
    }
    check_path(path);
    return path;
}

}  // namespace edaha
