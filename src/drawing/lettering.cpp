// SPDX-License-Identifier: MIT
#include "drawing/lettering.h"

#include <cassert>
#include <charconv>
#include <cmath>
#include <cstring>
#include <numbers>
#include <optional>

#include "base/stable_math.h"
#include "base/utf8.h"
#include "drawing/glyphs.h"

namespace edaha {
namespace {

constexpr double kUnitsOfCapital = 20;
constexpr double kDotRadius = 0.5;  // of the pen's way: the dot is a little thicker than the pen

struct Knot {
    Vec2 at{0, 0};
    std::optional<Vec2> heading;  // of length 1
};

double cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}

double dot(Vec2 a, Vec2 b) {
    return a.x * b.x + a.y * b.y;
}

// A curve's handles, as lengths along its headings.
struct Handles {
    double leave, arrive;
};

// Where the headings meet in a point ahead, the curve is an arc of a circle squeezed or sheared
// into place, so that a quarter between an upright and a level heading is an ellipse's: handles are
// parts of the way to that point, h / (1 + h) * 4/3 with h the cosine of half the turn.
std::optional<Handles> arc_handles(Vec2 chord, Vec2 out, Vec2 in) {
    const double turn = cross(out, in);
    if (std::abs(turn) < 1e-3) return std::nullopt;
    const double before = cross(chord, in) / turn, after = cross(out, chord) / turn;
    if (!(before > 0 && after > 0)) return std::nullopt;
    const double half = std::sqrt((1 + dot(out, in)) / 2);
    const double part = half / (1 + half) * (4.0 / 3);
    return Handles{part * before, part * after};
}

// Otherwise, for an S or a half turn: J. Hobby, "Smooth, easy to compute interpolating splines"
// (1986), the velocity function rho with tension 1; theta and phi are the headings' angles to the
// chord.
Handles spline_handles(Vec2 chord, Vec2 out, Vec2 in) {
    const double length = std::sqrt(dot(chord, chord));
    const double sin_theta = cross(chord, out) / length, cos_theta = dot(chord, out) / length;
    const double sin_phi = cross(in, chord) / length, cos_phi = dot(chord, in) / length;
    const double bend = std::sqrt(2.0) * (sin_theta - sin_phi / 16) * (sin_phi - sin_theta / 16) *
                        (cos_theta - cos_phi);
    const double small = (std::sqrt(5.0) - 1) / 2, large = (3 - std::sqrt(5.0)) / 2;
    return {length * (2 + bend) / (3 * (1 + small * cos_theta + large * cos_phi)),
            length * (2 - bend) / (3 * (1 + small * cos_phi + large * cos_theta))};
}

void add_curve(Path& path, const Knot& from, const Knot& to) {
    const Vec2 chord = to.at - from.at, out = *from.heading, in = *to.heading;
    const auto arc = arc_handles(chord, out, in);
    const Handles handles = arc ? *arc : spline_handles(chord, out, in);
    path.cubic_to(from.at + out * handles.leave, to.at - in * handles.arrive, to.at);
}

// Reads the notation of glyphs.h.
class GlyphPen {
  public:
    explicit GlyphPen(const char* strokes) : next_(strokes), end_(next_ + std::strlen(strokes)) {}

    Path draw() {
        while (next_ != end_) {
            if (skip('|')) {
                last_.reset();
            } else if (!skip(' ')) {
                skip('*') ? add_dot(knot().at) : step(knot());
            }
        }
        return std::move(path_);
    }

  private:
    bool skip(char c) {
        const bool there = next_ != end_ && *next_ == c;
        next_ += there;
        return there;
    }

    double number() {
        double value = 0;
        const auto [stop, error] = std::from_chars(next_, end_, value, std::chars_format::fixed);
        assert(error == std::errc{});
        next_ = stop;
        return value;
    }

    Knot knot() {
        Knot knot;
        knot.at.x = number();
        skip(',');
        knot.at.y = number();
        if (skip('n')) {
            knot.heading = Vec2(0, 1);
        } else if (skip('e')) {
            knot.heading = Vec2(1, 0);
        } else if (skip('s')) {
            knot.heading = Vec2(0, -1);
        } else if (skip('w')) {
            knot.heading = Vec2(-1, 0);
        } else if (skip('@')) {
            const auto [sine, cosine] = stable::sin_cos(number() * (std::numbers::pi / 180));
            knot.heading = Vec2(cosine, sine);
        }
        return knot;
    }

    void step(const Knot& to) {
        if (!last_) {
            path_.move_to(to.at);
        } else if (last_->heading && to.heading) {
            add_curve(path_, *last_, to);
        } else {
            path_.line_to(to.at);
        }
        last_ = to;
    }

    void add_dot(Vec2 at) {
        const Knot left{at - Vec2(kDotRadius, 0), Vec2(0, 1)};
        const Knot right{at + Vec2(kDotRadius, 0), Vec2(0, -1)};
        path_.move_to(left.at);
        add_curve(path_, left, right);
        add_curve(path_, right, left);
    }

    const char* next_;
    const char* end_;
    Path path_;
    std::optional<Knot> last_;
};

// Calls `take` with each character's glyph.
template <typename Take>
void for_each_glyph(std::string_view text, const Take& take) {
    while (!text.empty()) {
        const auto [code, bytes] = first_character(text);
        take(glyph_of(code == kNoCharacter ? U'\0' : static_cast<char32_t>(code)));
        text.remove_prefix(bytes);
    }
}

}  // namespace

Path lettering(std::string_view text, const LetteringParams& params) {
    const double unit = params.size_mm / kUnitsOfCapital;
    Vec2 pen = params.at;
    if (params.anchor != LetteringParams::Anchor::start) {
        const double width = lettering_width_mm(text, params.size_mm);
        pen.x -= params.anchor == LetteringParams::Anchor::middle ? width / 2 : width;
    }
    Path line;
    for_each_glyph(text, [&](const Glyph& glyph) {
        const Path strokes = GlyphPen(glyph.strokes).draw();
        line.verbs.insert(line.verbs.end(), strokes.verbs.begin(), strokes.verbs.end());
        for (const Vec2 p : strokes.points)
            line.points.push_back(pen + Vec2(p.x, -p.y) * unit);
        pen.x += glyph.advance * unit;
    });
    return line;
}

double lettering_width_mm(std::string_view text, double size_mm) {
    double units = 0;
    for_each_glyph(text, [&](const Glyph& glyph) { units += glyph.advance; });
    return units * (size_mm / kUnitsOfCapital);
}

double lettering_pen_mm(double size_mm) {
    return size_mm / 9;
}

}  // namespace edaha
