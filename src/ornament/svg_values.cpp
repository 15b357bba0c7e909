// SPDX-License-Identifier: MIT
#include "ornament/svg_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/nearest_name.h"
#include "base/stable_math.h"
#include "ornament/named_colours.h"
#include "ornament/scan.h"

namespace edaha::svg {
namespace {

[[noreturn]] void fail(const Scanner& scanner, const std::string& why) {
    throw SyntaxError(scanner.offset(), scanner.here() + ' ' + why);
}

void expect_end(Scanner& scanner, const std::string& expected) {
    scanner.skip_space();
    if (!scanner.at_end()) fail(scanner, "is too much (expected " + expected + ')');
}

double expect_number(Scanner& scanner, const std::string& expected) {
    scanner.skip_space();
    const std::optional<double> value = scanner.take_number();
    if (!value) fail(scanner, "is not a number (expected " + expected + ')');
    return *value;
}

// User units a unit, 96 to the inch; 0 for an unknown one.
double unit_px(std::string_view unit) {
    if (unit.empty() || unit == "px") return 1;
    if (unit == "mm") return 96 / 25.4;
    if (unit == "cm") return 96 / 2.54;
    if (unit == "in") return 96;
    if (unit == "pt") return 96.0 / 72;
    if (unit == "pc") return 16;
    return 0;
}

// The numbers between the parentheses of a function; the closing one is passed.
std::vector<double> read_arguments(Scanner& scanner) {
    std::vector<double> numbers;
    scanner.skip_space();
    while (!scanner.take(')')) {
        numbers.push_back(expect_number(scanner, "numbers and a closing parenthesis"));
        scanner.skip_comma();
    }
    return numbers;
}

// What a transform's name allows; the counts are of numbers, 0 for none.
struct TransformKind {
    std::string_view name;
    std::size_t count, other_count;
    std::string_view expected;
};

constexpr std::array<TransformKind, 6> kTransforms{{
    {"matrix", 6, 0, "6"},
    {"translate", 2, 1, "1 or 2"},
    {"scale", 2, 1, "1 or 2"},
    {"rotate", 1, 3, "1 or 3"},
    {"skewX", 1, 0, "1"},
    {"skewY", 1, 0, "1"},
}};

Affine rotation(double degrees, Vec2 about) {
    const auto [sin, cos] = stable::sin_cos(std::fmod(degrees, 360) * (std::numbers::pi / 180));
    const Vec2 moved(cos * about.x - sin * about.y, sin * about.x + cos * about.y);
    return Affine(Vec2(cos, sin), Vec2(-sin, cos), about - moved);
}

double tangent(double degrees) {
    const auto [sin, cos] = stable::sin_cos(std::fmod(degrees, 360) * (std::numbers::pi / 180));
    return sin / cos;
}

Affine make_transform(std::string_view name, const std::vector<double>& n) {
    if (name == "matrix") return Affine(n[0], n[1], n[2], n[3], n[4], n[5]);
    if (name == "translate") return Affine(1, 0, 0, 1, n[0], n.size() > 1 ? n[1] : 0);
    if (name == "scale") return Affine(n[0], 0, 0, n.back(), 0, 0);
    if (name == "rotate") return rotation(n[0], n.size() > 1 ? Vec2(n[1], n[2]) : Vec2(0));
    if (name == "skewX") return Affine(1, 0, tangent(n[0]), 1, 0, 0);
    return Affine(1, tangent(n[0]), 0, 1, 0, 0);
}

Affine read_one_transform(Scanner& scanner) {
    const std::size_t begin = scanner.offset();
    const std::string here = scanner.here();
    const std::string name(scanner.take_word());
    const auto kind = std::find_if(kTransforms.begin(), kTransforms.end(),
                                   [&](const TransformKind& k) { return k.name == name; });
    if (kind == kTransforms.end()) {
        const std::vector<std::string> known = {"matrix", "translate", "scale",
                                                "rotate", "skewX",     "skewY"};
        const std::optional<std::string> meant = nearest_name(name, known);
        throw SyntaxError(begin, here + " is not a transform (" +
                                     (meant ? "did you mean '" + *meant + "'?"
                                            : "expected matrix, translate, scale, rotate, "
                                              "skewX or skewY") +
                                     ')');
    }
    scanner.skip_space();
    if (!scanner.take('(')) fail(scanner, "is not '(' (expected numbers in parentheses)");
    const std::vector<double> numbers = read_arguments(scanner);
    if (numbers.size() != kind->count && (numbers.size() != kind->other_count || numbers.empty())) {
        throw SyntaxError(begin, quoted(name) + " has " + std::to_string(numbers.size()) +
                                     " numbers (expected " + std::string(kind->expected) + ')');
    }
    return make_transform(name, numbers);
}

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

// `digits` without the #; none if their number or one of them is wrong.
std::optional<SvgColour> read_hex(std::string_view digits) {
    const std::size_t width = digits.size() <= 4 ? 1 : 2;
    const std::size_t channels = digits.size() / width;
    if (digits.size() % width != 0 || (channels != 3 && channels != 4)) return std::nullopt;
    std::array<int, 4> value{0, 0, 0, 255};
    for (std::size_t i = 0; i < channels; ++i) {
        const int high = hex_digit(digits[i * width]);
        const int low = hex_digit(digits[i * width + width - 1]);
        if (high < 0 || low < 0) return std::nullopt;
        value[i] = high * 16 + low;
    }
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(value[i]); };
    return SvgColour{{byte(0), byte(1), byte(2)}, value[3] / 255.0};
}

// rgb( and rgba( behind the parenthesis.
SvgColour read_rgb(Scanner& scanner) {
    std::array<double, 4> value{0, 0, 0, 1};
    std::size_t count = 0;
    for (scanner.skip_space(); !scanner.take(')'); ++count) {
        if (count == 4) fail(scanner, "is too much (expected rgb(r, g, b))");
        value[count] = expect_number(scanner, "rgb(r, g, b)");
        if (scanner.take('%')) value[count] *= count < 3 ? 2.55 : 0.01;
        if (!scanner.skip_comma()) scanner.take('/');
    }
    if (count < 3) fail(scanner, "comes too early (expected rgb(r, g, b))");
    const auto byte = [&](std::size_t i) {
        return static_cast<std::uint8_t>(std::lround(std::clamp(value[i], 0.0, 255.0)));
    };
    return {{byte(0), byte(1), byte(2)}, std::clamp(value[3], 0.0, 1.0)};
}

SvgColour take_colour(Scanner& scanner) {
    const std::size_t begin = scanner.offset();
    const bool hash = scanner.take('#');
    const std::string word(scanner.take_word());
    const std::string name = lower_case(word);
    if (hash) {
        if (const std::optional<SvgColour> colour = read_hex(word)) return *colour;
        throw SyntaxError(begin,
                          quoted('#' + word) + " is not a colour (expected #rgb or #rrggbb)");
    }
    if ((name == "rgb" || name == "rgba") && scanner.take('(')) return read_rgb(scanner);
    if (const std::optional<Colour> colour = named_colour(name)) return {*colour, 1};
    if (word.empty()) fail(scanner, "is not a colour (expected a name, #rrggbb or rgb())");
    const std::optional<std::string> meant = nearest_name(name, colour_names());
    throw SyntaxError(
        begin,
        quoted(word) + " is not a colour (" +
            (meant ? "did you mean '" + *meant + "'?" : "expected a name, #rrggbb or rgb()") + ')');
}

// url( behind the parenthesis.
std::string take_url(Scanner& scanner) {
    std::string_view inside = trimmed(scanner.take_until(')'));
    const bool quotes = inside.size() > 1 && inside.front() == inside.back() &&
                        (inside.front() == '"' || inside.front() == '\'');
    if (quotes) inside = inside.substr(1, inside.size() - 2);
    return std::string(inside);
}

}  // namespace

SvgLength read_length(std::string_view text) {
    Scanner scanner(text);
    scanner.skip_space();
    const std::optional<double> value = scanner.take_number();
    if (!value) fail(scanner, "is not a length (expected a number)");
    if (scanner.take('%')) {
        expect_end(scanner, "one length");
        return {*value, true};
    }
    const std::size_t at = scanner.offset();
    const std::string unit(scanner.take_word());
    const double px = unit_px(unit);
    if (px == 0) {
        throw SyntaxError(at, quoted(unit) + " is not a unit (expected mm, cm, in, pt, pc or px)");
    }
    expect_end(scanner, "one length");
    return {*value * px, false};
}

double read_opacity(std::string_view text) {
    Scanner scanner(text);
    double value = expect_number(scanner, "0 to 1");
    if (scanner.take('%')) value /= 100;
    expect_end(scanner, "one number");
    return std::clamp(value, 0.0, 1.0);
}

std::vector<Vec2> read_points(std::string_view text) {
    Scanner scanner(text);
    std::vector<Vec2> points;
    scanner.skip_space();
    while (!scanner.at_end()) {
        const double x = expect_number(scanner, "x,y of every point");
        scanner.skip_comma();
        if (scanner.at_end()) fail(scanner, "is not a number (expected x,y of every point)");
        points.emplace_back(x, expect_number(scanner, "x,y of every point"));
        scanner.skip_comma();
    }
    return points;
}

ViewBox read_view_box(std::string_view text) {
    Scanner scanner(text);
    std::array<double, 4> number{};
    for (double& n : number) {
        n = expect_number(scanner, "min-x min-y width height");
        scanner.skip_comma();
    }
    expect_end(scanner, "min-x min-y width height");
    if (!(number[2] > 0 && number[3] > 0)) {
        throw SyntaxError(0, quoted(text) + " has no size (expected a positive width and height)");
    }
    return {{number[0], number[1]}, {number[2], number[3]}};
}

Affine read_transform(std::string_view text) {
    Scanner scanner(text);
    Affine result(1, 0, 0, 1, 0, 0);
    scanner.skip_space();
    if (trimmed(text) == "none") return result;
    while (!scanner.at_end()) {
        result = compose(result, read_one_transform(scanner));
        scanner.skip_comma();
    }
    return result;
}

SvgColour read_colour(std::string_view text) {
    Scanner scanner(text);
    scanner.skip_space();
    const SvgColour colour = take_colour(scanner);
    scanner.skip_space();
    if (scanner.take_word() == "icc-color") return colour;  // the same in a printer's terms
    expect_end(scanner, "one colour");
    return colour;
}

SvgPaint read_paint(std::string_view text) {
    const std::string word = lower_case(trimmed(text));
    SvgPaint paint;
    if (word == "none" || word == "transparent") return paint;
    if (word == "currentcolor" || word == "context-fill" || word == "context-stroke") {
        paint.kind = SvgPaint::Kind::current;
        return paint;
    }
    if (!word.starts_with("url(")) {
        paint.kind = SvgPaint::Kind::colour;
        paint.colour = read_colour(text);
        return paint;
    }
    Scanner scanner(text);
    scanner.take_until('(');
    const std::string url = take_url(scanner);
    paint.kind = SvgPaint::Kind::reference;
    paint.reference = url.starts_with('#') ? url.substr(1) : url;
    scanner.skip_space();
    const std::string_view rest = text.substr(scanner.offset());
    if (!rest.empty() && rest != "none" && lower_case(rest) != "currentcolor") {
        paint.has_fallback = true;
        paint.colour = read_colour(rest);
    }
    return paint;
}

std::optional<std::string> read_reference(std::string_view text) {
    const std::string_view inside = trimmed(text);
    if (inside.starts_with('#') && inside.size() > 1) return std::string(inside.substr(1));
    if (!lower_case(inside.substr(0, 4)).starts_with("url(")) return std::nullopt;
    Scanner scanner(inside);
    scanner.take_until('(');
    const std::string url = take_url(scanner);
    if (!url.starts_with('#') || url.size() < 2) return std::nullopt;
    return url.substr(1);
}

}  // namespace edaha::svg
