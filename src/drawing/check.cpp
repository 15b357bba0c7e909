// SPDX-License-Identifier: MIT
#include "drawing/check.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <unordered_set>

#include <fmt/format.h>

#include "drawing/inherit.h"
#include "drawing/subpaths.h"
#include "geometry/bounds.h"
#include "geometry/measure.h"

namespace edaha {
namespace {

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_id(std::string_view id) {
    const auto allowed = [](char c) {
        return is_letter(c) || (c >= '0' && c <= '9') || c == '.' || c == '_' || c == '-';
    };
    return !id.empty() && is_letter(id[0]) && std::all_of(id.begin(), id.end(), allowed);
}

bool finite(Vec2 p) {
    return std::isfinite(p.x) && std::isfinite(p.y);
}

std::size_t points_of(Verb verb) {
    return verb == Verb::cubic ? 3 : verb == Verb::close ? 0 : 1;
}

bool same_point(Vec2 a, Vec2 b) {
    return std::abs(a.x - b.x) <= kShortestSegment_mm && std::abs(a.y - b.y) <= kShortestSegment_mm;
}

// Why the lists don't make a path at all: nothing else can then be said of it.
std::string structure_breach(const Path& path) {
    std::size_t points = 0;
    Verb before = Verb::close;
    for (const Verb verb : path.verbs) {
        if (before == Verb::close && verb != Verb::move)
            return "a subpath does not start with move";
        if (before == Verb::move && (verb == Verb::move || verb == Verb::close)) {
            return "a subpath has no segment";
        }
        points += points_of(verb);
        before = verb;
    }
    if (path.verbs.empty()) return "the path is empty";
    if (before == Verb::move) return "a subpath has no segment";
    if (points != path.points.size()) {
        return fmt::format("its verbs take {} points, it has {}", points, path.points.size());
    }
    return "";
}

// Points that aren't numbers, or segments that go nowhere.
std::string point_breach(const Path& path) {
    Vec2 at(0);
    const Vec2* next = path.points.data();
    for (const Verb verb : path.verbs) {
        const std::size_t points = points_of(verb);
        bool moves = verb == Verb::move || verb == Verb::close;
        for (const Vec2* p = next; p != next + points; ++p) {
            if (!finite(*p)) return fmt::format("point ({}, {}) is not finite", p->x, p->y);
            moves |= !same_point(at, *p);
        }
        if (!moves) return fmt::format("the segment at ({}, {}) has no length", at.x, at.y);
        next += points;
        if (points > 0) at = next[-1];
    }
    return "";
}

// The number of the first subpath that is left open, from 1; 0 if none is.
std::size_t first_open_subpath(const Path& path) {
    std::size_t subpath = 0;
    for (std::size_t i = 0; i < path.verbs.size(); ++i) {
        if (path.verbs[i] != Verb::move) continue;
        ++subpath;
        auto end = std::find(path.verbs.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                             path.verbs.end(), Verb::move);
        if (end[-1] != Verb::close) return subpath;
    }
    return 0;
}

std::string orientation_breach(const Path& path) {
    if (std::count(path.verbs.begin(), path.verbs.end(), Verb::move) < 2) return "";
    Bounds outlines;
    std::size_t number = 0;
    for (const Path& part : subpaths(path)) {
        ++number;
        const Bounds box = bounds(part);
        const Vec2 low = box.min + kShortestSegment_mm, high = box.max - kShortestSegment_mm;
        if (signed_area(part) >= 0) {
            outlines.include(box);
        } else if (number == 1) {
            return "its first subpath is a hole: it runs anticlockwise";
        } else if (!outlines.contains(low) || !outlines.contains(high)) {
            return fmt::format("subpath {} is a hole outside the outlines before it", number);
        }
    }
    return "";
}

Bounds transformed_box(const Affine& map, const Bounds& box) {
    Bounds result;
    for (const double x : {box.min.x, box.max.x}) {
        for (const double y : {box.min.y, box.max.y})
            result.include(transform(map, {x, y}));
    }
    return result;
}

struct CheckedShape {
    const Shape* shape = nullptr;
    std::size_t open_subpath = 0;
    Bounds box;  // of the path, in the symbol's own coordinates
};

struct CheckedSymbol {
    std::vector<CheckedShape> shapes;
    bool sound = true;
    bool open_fill_named = false;
};

class Checker {
  public:
    explicit Checker(const Drawing& drawing) : drawing_(drawing) {}

    std::vector<std::string> run() {
        check_page();
        for (const Symbol& symbol : drawing_.symbols)
            check_symbol(symbol);
        for (const Layer& layer : drawing_.layers)
            check_layer(layer);
        if (breaches_ > kMostBreaches) {
            found_.push_back(fmt::format("and {} more", breaches_ - kMostBreaches));
        }
        return std::move(found_);
    }

  private:
    void check_page();
    void check_symbol(const Symbol& symbol);
    void check_layer(const Layer& layer);
    void check_elements(const std::vector<Element>& elements, const InheritedPaint& parent);
    void check_shape(const Shape& shape, const InheritedPaint& parent);
    void check_use(const Use& use, const InheritedPaint& parent);
    void check_used_shape(const CheckedShape& shape, const Use& use, const InheritedPaint& parent);
    bool check_path(const Path& path);
    void check_paint(const Paint& own);
    void check_drawn_paint(const InheritedPaint& paint);
    void check_inside(const Bounds& box, Vec2 half_stroke);
    void check_id(const std::string& id);
    void add(const std::string& what);

    const Drawing& drawing_;
    std::vector<CheckedSymbol> symbols_;
    std::unordered_set<std::string> ids_;  // asked, never walked through
    std::vector<std::string> found_;
    std::size_t breaches_ = 0;

    std::string root_;        // "layer 'Wood'"
    const char* kind_ = "";   // "shape", "use", "group" or nothing
    std::string_view id_;     // the node's, if it has one
    std::size_t number_ = 0;  // of the node in its layer, from 1, in paint order
};

void Checker::add(const std::string& what) {
    if (++breaches_ > kMostBreaches) return;
    std::string place = root_;
    if (*kind_ != 0) {
        place += id_.empty() ? fmt::format(", {} {}", kind_, number_)
                             : fmt::format(", {} '{}'", kind_, id_);
    }
    found_.push_back(place + ": " + what);
}

void Checker::check_page() {
    root_ = "page";
    const auto good = [](double size) { return std::isfinite(size) && size > 0; };
    if (!good(drawing_.width_mm) || !good(drawing_.height_mm)) {
        add(fmt::format("its size is {} x {} mm", drawing_.width_mm, drawing_.height_mm));
    }
}

void Checker::check_id(const std::string& id) {
    if (!is_id(id)) add(fmt::format("'{}' is not an id ([A-Za-z][A-Za-z0-9._-]*)", id));
    if (!id.empty() && !ids_.insert(id).second) add(fmt::format("the id '{}' is taken", id));
}

void Checker::check_symbol(const Symbol& symbol) {
    root_ = fmt::format("symbol '{}'", symbol.id);
    kind_ = "";
    check_id(symbol.id);
    number_ = 0;
    kind_ = "shape";
    CheckedSymbol& checked = symbols_.emplace_back();
    for (const Shape& shape : symbol.shapes) {
        id_ = shape.id;
        ++number_;
        if (!shape.id.empty()) check_id(shape.id);
        check_paint(shape.paint);
        checked.sound &= check_path(shape.path);
        if (!checked.sound) continue;
        checked.shapes.push_back({&shape, first_open_subpath(shape.path), bounds(shape.path)});
        const bool filled = shape.paint.fill.kind != Ink::Kind::none;
        const std::string breach = filled ? orientation_breach(shape.path) : "";
        if (!breach.empty()) add(breach);
    }
}

void Checker::check_layer(const Layer& layer) {
    root_ = fmt::format("layer '{}'", layer.label);
    kind_ = "";
    number_ = 0;
    check_id(layer.id());
    check_paint(layer.paint);
    check_elements(layer.children, inherit({}, layer.paint));
}

void Checker::check_elements(const std::vector<Element>& elements, const InheritedPaint& parent) {
    for (const Element& element : elements) {
        ++number_;
        id_ = {};
        if (const auto* shape = std::get_if<Shape>(&element)) {
            check_shape(*shape, parent);
        } else if (const auto* use = std::get_if<Use>(&element)) {
            check_use(*use, parent);
        } else {
            const auto& group = std::get<Group>(element);
            kind_ = "group";
            id_ = group.id;
            if (!group.id.empty()) check_id(group.id);
            check_paint(group.paint);
            check_elements(group.children, inherit(parent, group.paint));
        }
    }
}

void Checker::check_shape(const Shape& shape, const InheritedPaint& parent) {
    kind_ = "shape";
    id_ = shape.id;
    if (!shape.id.empty()) check_id(shape.id);
    check_paint(shape.paint);
    const InheritedPaint paint = inherit(parent, shape.paint);
    check_drawn_paint(paint);
    if (!check_path(shape.path)) return;
    if (paint.fill) {
        const std::size_t open = first_open_subpath(shape.path);
        if (open != 0) add(fmt::format("subpath {} is filled but not closed", open));
        const std::string breach = orientation_breach(shape.path);
        if (!breach.empty()) add(breach);
    }
    check_inside(bounds(shape.path), Vec2(paint.stroke ? paint.stroke_width_mm / 2 : 0));
}

void Checker::check_use(const Use& use, const InheritedPaint& parent) {
    kind_ = "use";
    if (use.symbol >= symbols_.size()) {
        return add(fmt::format("there is no symbol {} (of {})", use.symbol, symbols_.size()));
    }
    const Affine& map = use.page_from_symbol;
    if (!finite(map[0]) || !finite(map[1]) || !finite(map[2])) {
        return add("its transform is not finite");
    }
    const double area = std::abs(map[0].x * map[1].y - map[0].y * map[1].x);
    if (!(area > kShortestSegment_mm * kShortestSegment_mm)) {
        return add("its transform cannot be inverted");
    }
    check_paint(use.paint);
    CheckedSymbol& symbol = symbols_[use.symbol];
    if (!symbol.sound) return;  // said already, at the symbol
    const InheritedPaint paint = inherit(parent, use.paint);
    for (const CheckedShape& shape : symbol.shapes)
        check_used_shape(shape, use, paint);
}

void Checker::check_used_shape(const CheckedShape& checked, const Use& use,
                               const InheritedPaint& parent) {
    const InheritedPaint paint = inherit(parent, checked.shape->paint);
    check_drawn_paint(paint);
    if (paint.stroke && paint.dash_mm != 0) add("its stroke has dashes");
    CheckedSymbol& symbol = symbols_[use.symbol];
    if (paint.fill && checked.open_subpath != 0 && !symbol.open_fill_named) {
        symbol.open_fill_named = true;
        add(fmt::format("it fills subpath {} of a shape of '{}', which is not closed",
                        checked.open_subpath, drawing_.symbols[use.symbol].id));
    }
    // A round pen of this radius, mapped, is an ellipse as wide and high as the rows of the map.
    const Affine& map = use.page_from_symbol;
    const double pen = paint.stroke ? paint.stroke_width_mm / 2 : 0;
    const Vec2 half(pen * std::hypot(map[0].x, map[1].x), pen * std::hypot(map[0].y, map[1].y));
    const Bounds page{{0, 0}, {drawing_.width_mm, drawing_.height_mm}};
    const Bounds outer = transformed_box(map, checked.box);
    if (page.contains(outer.min - half) && page.contains(outer.max + half)) return;
    check_inside(bounds(transformed(map, checked.shape->path)), half);
}

bool Checker::check_path(const Path& path) {
    std::string breach = structure_breach(path);
    if (breach.empty()) breach = point_breach(path);
    if (!breach.empty()) add(breach);
    return breach.empty();
}

void Checker::check_paint(const Paint& own) {
    if (!(own.stroke_width_mm >= 0) || !std::isfinite(own.stroke_width_mm)) {
        add(fmt::format("its stroke's width is {}", own.stroke_width_mm));
    }
    if (!(own.dash_mm >= 0) || !std::isfinite(own.dash_mm))
        add(fmt::format("its dashes are {} mm long", own.dash_mm));
    for (const float opacity : {own.fill_opacity, own.stroke_opacity}) {
        if (!(opacity >= 0 && opacity <= 1)) add(fmt::format("its opacity is {}", opacity));
    }
}

void Checker::check_drawn_paint(const InheritedPaint& paint) {
    if (paint.stroke && paint.stroke_width_mm == 0) add("its stroke has no width");
}

void Checker::check_inside(const Bounds& box, Vec2 half_stroke) {
    const Vec2 low = box.min - half_stroke + kShortestSegment_mm;
    const Vec2 high = box.max + half_stroke - kShortestSegment_mm;
    const Bounds page{{0, 0}, {drawing_.width_mm, drawing_.height_mm}};
    if (page.contains(low) && page.contains(high)) return;
    add(fmt::format("it reaches from ({:.6f}, {:.6f}) to ({:.6f}, {:.6f}), outside the page", low.x,
                    low.y, high.x, high.y));
}

}  // namespace

std::vector<std::string> check(const Drawing& drawing) {
    return Checker(drawing).run();
}

}  // namespace edaha
