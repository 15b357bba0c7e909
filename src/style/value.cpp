// SPDX-License-Identifier: MIT
#include "style/value.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include <fmt/core.h>

#include "base/nearest_name.h"
#include "base/number_text.h"
#include "style/xml_text.h"

namespace edaha {
namespace {

constexpr std::string_view kSpace = " \t\r\n";
constexpr std::size_t kMostOrders = 32;  // list by order: no limb of a drawing is of higher order
constexpr std::size_t kMostReference = 1024;

template <class... Cases>
struct Match : Cases... {
    using Cases::operator()...;
};
template <class... Cases>
Match(Cases...) -> Match<Cases...>;

std::vector<std::string_view> words(std::string_view text) {
    std::vector<std::string_view> found;
    while (!(text = trim(text)).empty()) {
        const std::size_t end = std::min(text.find_first_of(kSpace), text.size());
        found.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return found;
}

double stored(double shown, Unit unit) {
    return unit == Unit::degrees ? radians(shown) : shown;
}

// Degrees whose radians are exactly `angle`, if they lie within two ulps of the quotient.
std::optional<double> exact_degrees(double angle) {
    const double infinity = std::numeric_limits<double>::infinity();
    double below = angle * 180 / std::numbers::pi;
    double above = below;
    for (int ulps = 0; ulps <= 2; ++ulps) {
        if (radians(below) == angle) return below;
        if (radians(above) == angle) return above;
        below = std::nextafter(below, -infinity);
        above = std::nextafter(above, infinity);
    }
    return std::nullopt;
}

// Not every double is the product of another and pi / 180; a neighbour that is one must do then,
// so that the text stays as it is when it is read and written again.
double stable_degrees(double angle) {
    if (const auto degrees = exact_degrees(angle)) return *degrees;
    const double degrees = angle * 180 / std::numbers::pi;
    return exact_degrees(radians(degrees)).value_or(degrees);
}

std::string degrees_text(double angle) {
    const double degrees = stable_degrees(angle);
    const double whole = std::round(degrees);
    if (radians(whole) == radians(degrees)) return shortest_text(whole);
    char buffer[40];
    for (int digits = 1; digits < 17; ++digits) {
        const auto end = std::to_chars(buffer, buffer + sizeof buffer, degrees,
                                       std::chars_format::general, digits);
        const auto rounded = parse_number({buffer, end.ptr});
        if (rounded && radians(*rounded) == radians(degrees)) return shortest_text(*rounded);
    }
    return shortest_text(degrees);
}

std::string colour_text(Colour colour) {
    constexpr char kDigits[] = "0123456789abcdef";
    std::string text = "#";
    for (const std::uint8_t part : {colour.r, colour.g, colour.b}) {
        text += kDigits[part >> 4];
        text += kDigits[part & 15];
    }
    return text;
}

std::string shown_text(double value, Unit unit) {
    return unit == Unit::degrees ? degrees_text(value) : shortest_text(value);
}

std::string limits_text(const Limits& limits) {
    const char* const unit = limits.unit == Unit::mm        ? " mm"
                             : limits.unit == Unit::degrees ? " degrees"
                                                            : "";
    return fmt::format("{} … {}{}", shortest_text(limits.least), shortest_text(limits.most), unit);
}

std::string list_names(const std::vector<std::string>& names) {
    std::string text = names.front();
    for (std::size_t i = 1; i < names.size(); ++i) {
        text += (i + 1 == names.size() ? " or " : ", ") + names[i];
    }
    return text;
}

std::string wrong(const Parameter& parameter, std::string_view text, std::string_view what) {
    return fmt::format("{} {} (expected {})", in_quotes(text), what, expected_text(parameter));
}

bool within(double value, const Limits& limits) {
    return value >= limits.least && value <= limits.most;
}

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

std::optional<Colour> parse_colour(std::string_view text) {
    if (text.size() != 7 || text[0] != '#') return std::nullopt;
    std::uint8_t bytes[3];
    for (std::size_t i = 0; i < 3; ++i) {
        const int high = hex_digit(text[1 + 2 * i]);
        const int low = hex_digit(text[2 + 2 * i]);
        if (high < 0 || low < 0) return std::nullopt;
        bytes[i] = static_cast<std::uint8_t>(high * 16 + low);
    }
    return Colour{bytes[0], bytes[1], bytes[2]};
}

// "low high", "low..high", or one number for both.
std::optional<Range> parse_range(std::string_view text) {
    const std::size_t dots = text.find("..");
    const std::vector<std::string_view> parts =
        dots == std::string_view::npos
            ? words(text)
            : std::vector{trim(text.substr(0, dots)), trim(text.substr(dots + 2))};
    if (parts.empty() || parts.size() > 2) return std::nullopt;
    const auto low = parse_number(parts.front());
    const auto high = parse_number(parts.back());
    if (!low || !high) return std::nullopt;
    return Range{*low, *high};
}

std::optional<glm::dvec3> parse_spot(std::string_view text) {
    const std::vector<std::string_view> parts = words(text);
    if (parts.size() != 3) return std::nullopt;
    glm::dvec3 spot(0);
    for (int i = 0; i < 3; ++i) {
        const auto value = parse_number(parts[static_cast<std::size_t>(i)]);
        if (!value) return std::nullopt;
        spot[i] = *value;
    }
    return spot;
}

// One value of a text, for each kind of field.
struct Assignment {
    Style& style;
    const Parameter& parameter;
    std::string_view text;

    using Wrong = std::optional<std::string>;

    Wrong fail(std::string_view what) const { return wrong(parameter, text, what); }

    Wrong operator()(const Number& field) const {
        const auto value = parse_number(text);
        if (!value) return fail("is not a number");
        if (!within(*value, parameter.limits)) return fail("is out of range");
        field.set(style, stored(*value, parameter.limits.unit));
        return {};
    }

    Wrong operator()(const Integer& field) const {
        const auto value = parse_number(text);
        if (!value || std::floor(*value) != *value) return fail("is not a whole number");
        if (!within(*value, parameter.limits)) return fail("is out of range");
        field.set(style, static_cast<std::int64_t>(*value));
        return {};
    }

    Wrong operator()(const Flag& field) const {
        if (text != "yes" && text != "no") return fail("is neither");
        field.set(style, text == "yes");
        return {};
    }

    Wrong operator()(const Choice& field) const {
        const auto found = std::ranges::find(field.names, text);
        if (found != field.names.end()) {
            field.set(style, static_cast<std::size_t>(found - field.names.begin()));
            return {};
        }
        const auto nearest = nearest_name(text, field.names);
        return fmt::format("{} is not known (expected {}{})", in_quotes(text),
                           expected_text(parameter),
                           nearest ? "; did you mean '" + *nearest + "'?" : "");
    }

    Wrong operator()(const Interval& field) const {
        const auto range = parse_range(text);
        if (!range) return fail("is not a range");
        if (range->low > range->high) return fail("is a reversed range");
        if (!within(range->low, parameter.limits) || !within(range->high, parameter.limits)) {
            return fail("is out of range");
        }
        const Unit unit = parameter.limits.unit;
        field.set(style, {stored(range->low, unit), stored(range->high, unit)});
        return {};
    }

    Wrong operator()(const ByOrder& field) const {
        std::vector<double> values;
        for (const std::string_view word : words(text)) {
            const auto value = parse_number(word);
            if (!value) return fail("is not a list of numbers");
            if (!within(*value, parameter.limits)) return fail("is out of range");
            values.push_back(stored(*value, parameter.limits.unit));
        }
        if (values.empty() || values.size() > kMostOrders) return fail("is not a list of numbers");
        field.set(style, std::move(values));
        return {};
    }

    Wrong operator()(const Tint& field) const {
        const auto colour = parse_colour(text);
        if (!colour) return fail("is not a colour");
        field.set(style, *colour);
        return {};
    }

    Wrong operator()(const Spot& field) const {
        const auto spot = parse_spot(text);
        if (!spot) return fail("is not a point");
        for (int i = 0; i < 3; ++i) {
            if (!within((*spot)[i], parameter.limits)) return fail("is out of range");
        }
        field.set(style, *spot);
        return {};
    }

    Wrong operator()(const Reference& field) const {
        const bool is_text = !first_byte_not_xml(text) && text.find_first_of("\t\r\n") == text.npos;
        if (!is_text || text.size() > kMostReference) return fail("is not a name");
        field.set(style, std::string(text));
        return {};
    }

    Wrong operator()(const MeshReference& field) const {
        return (*this)(static_cast<const Reference&>(field));
    }
};

}  // namespace

std::optional<std::string> assign(Style& style, const Parameter& parameter, std::string_view text) {
    return std::visit(Assignment{style, parameter, trim(text)}, parameter.field);
}

std::string value_text(const Style& style, const Parameter& parameter) {
    const Unit unit = parameter.limits.unit;
    return std::visit(
        Match{[&](const Number& field) { return shown_text(field.get(style), unit); },
              [&](const Integer& field) { return std::to_string(field.get(style)); },
              [&](const Flag& field) { return std::string(field.get(style) ? "yes" : "no"); },
              [&](const Choice& field) { return field.names[field.get(style)]; },
              [&](const Interval& field) {
                  const Range range = field.get(style);
                  const std::string low = shown_text(range.low, unit);
                  const std::string high = shown_text(range.high, unit);
                  return low == high ? low : low + ' ' + high;
              },
              [&](const ByOrder& field) {
                  std::string text;
                  for (const double value : field.get(style)) {
                      if (!text.empty()) text += ' ';
                      text += shown_text(value, unit);
                  }
                  return text;
              },
              [&](const Tint& field) { return colour_text(field.get(style)); },
              [&](const Reference& field) { return field.get(style); },
              [&](const MeshReference& field) { return field.get(style); },
              [&](const Spot& field) {
                  const glm::dvec3 spot = field.get(style);
                  return shortest_text(spot.x) + ' ' + shortest_text(spot.y) + ' ' +
                         shortest_text(spot.z);
              }},
        parameter.field);
}

std::string expected_text(const Parameter& parameter) {
    const Limits& limits = parameter.limits;
    return std::visit(
        Match{[&](const Number&) { return limits_text(limits); },
              [&](const Integer&) { return limits_text(limits); },
              [](const Flag&) { return std::string("yes or no"); },
              [](const Choice& field) { return list_names(field.names); },
              [&](const Interval&) { return "low high, each " + limits_text(limits); },
              [&](const ByOrder&) {
                  return fmt::format("1 to {} numbers, each {}", kMostOrders, limits_text(limits));
              },
              [](const Tint&) { return std::string("#rrggbb"); },
              [](const Reference&) { return std::string("a drawing's name or path"); },
              [](const MeshReference&) { return std::string("an OBJ or PLY file"); },
              [&](const Spot&) { return "x y z, each " + limits_text(limits); }},
        parameter.field);
}

std::string kind_text(const Parameter& parameter) {
    constexpr const char* kKinds[] = {"number", "whole number",  "yes or no", "choice",
                                      "range",  "list by order", "colour",    "drawing",
                                      "point",  "mesh"};
    static_assert(std::size(kKinds) == std::variant_size_v<Field>);
    return kKinds[parameter.field.index()];
}

std::string_view trim(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(kSpace);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(kSpace) - begin + 1);
}

std::string in_quotes(std::string_view text) {
    constexpr std::size_t kMostCharacters = 40;  // more would push the rest of a message off a line
    std::string cut;
    std::size_t characters = 0;
    for (const char c : text) {
        const bool continues = (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
        if (!continues && ++characters > kMostCharacters) {
            cut += "…";
            break;
        }
        cut += (c >= 0 && c < ' ') || c == '\x7f' ? '?' : c;
    }
    return '\'' + cut + '\'';
}

std::string shortest_text(double value) {
    if (value == 0) return "0";
    // Most of them, and every file records some two hundred.
    constexpr double kPlain = 1e5;
    if (std::abs(value) < kPlain && value == std::trunc(value))
        return std::to_string(static_cast<int>(value));
    char buffer[400];  // the fixed form of the largest double has 309 digits
    const auto end = std::to_chars(buffer, std::end(buffer), value, std::chars_format::fixed);
    const std::string fixed(buffer, end.ptr);
    const auto power_end =
        std::to_chars(buffer, std::end(buffer), value, std::chars_format::scientific);
    std::string power(buffer, power_end.ptr);
    const std::size_t sign = power.find('e') + 1;
    if (power[sign] == '+') power.erase(sign, 1);
    const std::size_t first = sign + (power[sign] == '-' ? 1 : 0);
    while (power[first] == '0' && first + 1 < power.size())
        power.erase(first, 1);
    // People read 100000 more easily than 1e5, but 1e6 more easily than 1000000.
    return power.size() + 3 < fixed.size() ? power : fixed;
}

}  // namespace edaha
