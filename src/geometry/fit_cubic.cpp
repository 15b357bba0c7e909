// SPDX-License-Identifier: MIT
#include "geometry/fit_cubic.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

namespace edaha {
namespace {

double cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}

// Arms are shares of the arc: below the first the curve turns on the spot at its end, above the
// second it bulges (a half circle needs 0.42, a straight line 0.33).
constexpr double kShortestArm = 0.05;
constexpr double kLongestArm = 0.6;

// Samples without repetition, unit tangents, and sums along them relative to the first sample:
// arc length, the area and its first moments by Green's theorem. With these the area and
// moments of any piece cost nothing.
struct Curve {
    struct Node {
        Vec2 position, tangent;
        double length = 0;
        double area = 0;  // 1/2 integral of x dy - y dx
        Vec2 moment{0};   // 1/2 integral of x^2 dy, -1/2 integral of y^2 dx
    };
    std::vector<Node> nodes;
};

// The piece's end tangents, area and moment in the frame in which its chord runs from (0,0) to
// (1,0).
struct Piece {
    Vec2 start, chord;
    double chord_length = 0;
    double arc_length = 0;  // in chords
    Vec2 tangent0, tangent1;
    double area = 0;    // integral of y dx
    double moment = 0;  // integral of x y dx
};

// Arms as factors of the end tangents, in the chord's frame.
struct Arms {
    double first = 0, second = 0;
};

// Integrals over one Hermite step between neighbouring samples, by Simpson's rule on its middle:
// the step is a cubic with arms of a third of the chord.
void add_step(const Curve::Node& from, Curve::Node& to) {
    const double chord = glm::distance(from.position, to.position);
    const Vec2 middle =
        (from.position + to.position) * 0.5 + (from.tangent - to.tangent) * (chord * 0.125);
    const Vec2 slope[3] = {
        from.tangent * chord,
        (to.position - from.position) * 1.5 - (from.tangent + to.tangent) * (chord * 0.25),
        to.tangent * chord};
    const Vec2 at[3] = {from.position, middle, to.position};
    static constexpr double kSimpson[3] = {1.0 / 12, 4.0 / 12, 1.0 / 12};  // halved
    to.length = from.length + chord;
    to.area = from.area;
    to.moment = from.moment;
    for (int i = 0; i < 3; ++i) {
        to.area += kSimpson[i] * cross(at[i], slope[i]);
        to.moment +=
            kSimpson[i] * Vec2(at[i].x * at[i].x * slope[i].y, -at[i].y * at[i].y * slope[i].x);
    }
}

Curve prepare(std::span<const CurveSample> samples) {
    Curve curve;
    if (samples.empty()) return curve;
    curve.nodes.reserve(samples.size());
    const Vec2 origin = samples.front().position;
    for (const CurveSample& sample : samples) {
        const Vec2 position = sample.position - origin;
        const Curve::Node node{position, glm::normalize(sample.tangent)};
        if (!curve.nodes.empty() && curve.nodes.back().position == position) continue;
        curve.nodes.push_back(node);
        const std::size_t count = curve.nodes.size();
        if (count > 1) add_step(curve.nodes[count - 2], curve.nodes[count - 1]);
    }
    return curve;
}

Piece cut_piece(const Curve::Node& from, const Curve::Node& to) {
    Piece piece;
    piece.start = from.position;
    piece.chord = to.position - from.position;
    piece.chord_length = glm::length(piece.chord);
    const double scale = 1 / piece.chord_length;
    const Vec2 u = piece.chord * scale;
    piece.arc_length = (to.length - from.length) * scale;
    piece.tangent0 = {glm::dot(u, from.tangent), cross(u, from.tangent)};
    piece.tangent1 = {glm::dot(u, to.tangent), cross(u, to.tangent)};
    // Close the piece by its chord, p1 back to p0, in both integrals; move the moment to p0.
    const Vec2 p0 = from.position, p1 = to.position;
    const Vec2 squares = p0 * p0 + p0 * p1 + p1 * p1;
    const double area = to.area - from.area + 0.5 * cross(p1, p0);
    const Vec2 moment = to.moment - from.moment +
                        Vec2(squares.x * (p0.y - p1.y), squares.y * (p1.x - p0.x)) / 6.0 -
                        area * p0;
    piece.area = -area * scale * scale;
    piece.moment = -glm::dot(u, moment) * scale * scale * scale;
    return piece;
}

// Integral of x y dx over the cubic with these arms: products of Bernstein polynomials
// integrated exactly (x = 0, x1, x2, 1 and y = 0, y1, y2, 0).
double moment_of(const Piece& piece, Arms arms) {
    const double x1 = arms.first * piece.tangent0.x, y1 = arms.first * piece.tangent0.y;
    const double x2 = 1 - arms.second * piece.tangent1.x, y2 = -arms.second * piece.tangent1.y;
    return (y1 * (9 * x1 * x2 + 6 * x1 + 9 * x2 * x2 + 15 * x2 + 10) +
            y2 * (-9 * x1 * x1 - 9 * x1 * x2 + 15 * x2 + 35)) /
           280;
}

// The second arm that gives the piece's area to the first; 20 area = 6 a0 s0 - 6 a1 s1 - 3 a0 a1
// sin(angle between the tangents).
double matching_arm(const Piece& piece, double first) {
    const double turn = cross(piece.tangent1, piece.tangent0);
    return (6 * first * piece.tangent0.y - 20 * piece.area) /
           (6 * piece.tangent1.y + 3 * first * turn);
}

double moment_error(const Piece& piece, double first) {
    return moment_of(piece, {first, matching_arm(piece, first)}) - piece.moment;
}

bool arm_allowed(const Piece& piece, double arm) {
    return arm >= kShortestArm * piece.arc_length && arm <= kLongestArm * piece.arc_length;
}

// Regula falsi (Illinois) between two first arms with moment errors of different sign.
double moment_root(const Piece& piece, double a, double error_a, double b, double error_b) {
    for (int i = 0; i < 12 && std::abs(b - a) > 1e-6; ++i) {
        const double c = (a * error_b - b * error_a) / (error_b - error_a);
        const double error = moment_error(piece, c);
        if (std::abs(error) < 1e-9) return c;
        if ((error < 0) == (error_b < 0)) {
            error_a *= 0.5;
        } else {
            a = b;
            error_a = error_b;
        }
        b = c;
        error_b = error;
    }
    return b;
}

// The arms of the circle's arc that turns as much as the piece does.
Arms arc_arms(const Piece& piece) {
    const double turn = glm::dot(piece.tangent0, piece.tangent1);
    const double half = std::sqrt(std::max(0.0, (1 + turn) * 0.5));  // cosine of half the angle
    const double arm = 2.0 / (3 * (1 + half));
    return {arm, arm};
}

// What to try for a piece, the likeliest first: no fixed memory is asked for.
struct Candidates {
    Arms arms[6];
    int count = 0;
    void add(Arms a) {
        if (count < 6) arms[count++] = a;
    }
};

// The roots of the moment along the line of arms with the right area; the quartic of Levien's
// paper, searched where arms are allowed.
Candidates candidates(const Piece& piece) {
    static constexpr int kSteps = 8;  // the quartic's roots lie further apart than this
    Candidates found;
    const double turn = std::abs(cross(piece.tangent1, piece.tangent0));
    const double bend = std::max(std::abs(piece.tangent0.y), std::abs(piece.tangent1.y));
    found.add(arc_arms(piece));
    if (bend < 1e-7 && turn < 1e-7) return found;
    const double lowest = kShortestArm * piece.arc_length;
    const double step = (kLongestArm - kShortestArm) * piece.arc_length / kSteps;
    double before = 0, error_before = 0;
    bool before_valid = false;
    for (int i = 0; i <= kSteps; ++i) {
        const double first = lowest + step * i;
        const double second = matching_arm(piece, first);
        const bool valid = std::isfinite(second) && std::abs(second) < 4 * piece.arc_length;
        const double error = valid ? moment_of(piece, {first, second}) - piece.moment : 0;
        if (valid && before_valid && (error < 0) != (error_before < 0)) {
            const double root = moment_root(piece, before, error_before, first, error);
            const Arms arms{root, matching_arm(piece, root)};
            if (arm_allowed(piece, arms.first) && arm_allowed(piece, arms.second)) found.add(arms);
        }
        before = first, error_before = error, before_valid = valid;
    }
    std::reverse(found.arms, found.arms + found.count);
    return found;
}

Cubic cubic_of(const Piece& piece, const Curve::Node& from, const Curve::Node& to, Arms arms) {
    return {from.position, from.position + from.tangent * (arms.first * piece.chord_length),
            to.position - to.tangent * (arms.second * piece.chord_length), to.position};
}

// True if every sample between the ends has the curve within `tolerance` on its normal, in order
// and running the same way. One Newton step a sample from where the last left off, a second one
// where that is not enough.
bool fits(std::span<const Curve::Node> nodes, const Cubic& cubic, double tolerance) {
    const Vec2 a = cubic.p3 - cubic.p0 + 3.0 * (cubic.p1 - cubic.p2);
    const Vec2 b = 3.0 * (cubic.p0 - 2.0 * cubic.p1 + cubic.p2);
    const Vec2 c = 3.0 * (cubic.p1 - cubic.p0);
    const double tolerance2 = tolerance * tolerance;
    double t = 0, speed = glm::length(c);
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
        t += (nodes[i].length - nodes[i - 1].length) / speed;
        double miss2 = 0;
        for (int round = 0; round < 3; ++round) {
            const Vec2 offset = ((a * t + b) * t + c) * t + cubic.p0 - nodes[i].position;
            miss2 = glm::dot(offset, offset);
            speed = glm::dot((3.0 * a * t + 2.0 * b) * t + c, nodes[i].tangent);
            if (!(speed > 0)) return false;
            const double along = glm::dot(offset, nodes[i].tangent);
            if (miss2 <= tolerance2 && along * along <= 0.25 * tolerance2) break;
            t -= along / speed;
        }
        if (!(miss2 <= tolerance2) || t < -0.01 || t > 1.01) return false;
    }
    return true;
}

// A piece from node `from` to node `to`, if one cubic does.
std::optional<Cubic> fit_piece(const Curve& curve, std::size_t from, std::size_t to,
                               double tolerance) {
    const std::span<const Curve::Node> nodes(&curve.nodes[from], to - from + 1);
    const Piece piece = cut_piece(nodes.front(), nodes.back());
    // A piece that comes back on itself has no frame; cubics end well before this.
    if (!(piece.chord_length > 0) || piece.arc_length > 3) return std::nullopt;
    const Candidates tries = candidates(piece);
    for (int i = 0; i < tries.count; ++i) {
        const Cubic cubic = cubic_of(piece, nodes.front(), nodes.back(), tries.arms[i]);
        if (fits(nodes, cubic, tolerance)) return cubic;
    }
    return std::nullopt;
}

Cubic shortest_piece(const Curve& curve, std::size_t from) {
    const Curve::Node& a = curve.nodes[from];
    const Curve::Node& b = curve.nodes[from + 1];
    const Piece piece = cut_piece(a, b);
    return cubic_of(piece, a, b, arc_arms(piece));
}

struct Reach {
    Cubic cubic;
    std::size_t end = 0;
};

// The longest piece from `from` that fits: strides doubled from `stride`, then halved.
Reach furthest_piece(const Curve& curve, std::size_t from, std::size_t stride, double tolerance) {
    const std::size_t last = curve.nodes.size() - 1;
    Reach reach{shortest_piece(curve, from), from + 1};
    std::size_t too_far = last + 1;
    for (std::size_t end = std::min(from + stride, last); end > reach.end;) {
        if (const auto cubic = fit_piece(curve, from, end, tolerance)) {
            reach = {*cubic, end};
            end = too_far <= last ? end + (too_far - end) / 2
                                  : std::min(from + 2 * (end - from), last);
        } else {
            too_far = end;
            end = reach.end + (too_far - reach.end) / 2;
        }
    }
    return reach;
}

std::vector<Cubic> fit_all(const Curve& curve, double tolerance, std::size_t most) {
    std::vector<Cubic> cubics;
    const std::size_t last = curve.nodes.size() - 1;
    std::size_t stride = last;
    for (std::size_t from = 0; from < last && cubics.size() <= most;) {
        const Reach reach = furthest_piece(curve, from, stride, tolerance);
        cubics.push_back(reach.cubic);
        stride = reach.end - from;
        from = reach.end;
    }
    return cubics;
}

}  // namespace

std::vector<Cubic> fit_cubics(std::span<const CurveSample> samples, double tolerance) {
    const Curve curve = prepare(samples);
    if (curve.nodes.size() < 2) return {};
    std::vector<Cubic> cubics = fit_all(curve, tolerance, curve.nodes.size());
    // Evening: the tightest of these tolerances that needs no more pieces.
    for (const double factor : {0.6, 0.3}) {
        if (cubics.size() < 2) break;
        std::vector<Cubic> tighter = fit_all(curve, tolerance * factor, cubics.size());
        if (tighter.size() > cubics.size()) break;
        cubics = std::move(tighter);
    }
    const Vec2 origin = samples.front().position;
    for (Cubic& c : cubics)
        c = {c.p0 + origin, c.p1 + origin, c.p2 + origin, c.p3 + origin};
    return cubics;
}

}  // namespace edaha
