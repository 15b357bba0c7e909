// SPDX-License-Identifier: MIT
#include "ornament/svg_shapes.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "base/nearest_name.h"
#include "geometry/bounds.h"
#include "geometry/measure.h"
#include "ornament/scan.h"
#include "ornament/svg_geometry.h"
#include "ornament/svg_names.h"
#include "ornament/svg_values.h"

namespace edaha::svg {
namespace {

constexpr Affine kIdentity(1, 0, 0, 1, 0, 0);

// Beyond it lies no drawing, only transforms that have run away.
constexpr double kFarthest = 1e12;

struct Context {
    Affine root_from_here = kIdentity;
    SvgStyle style;
    int depth = 0;
    bool in_use = false;  // ids of copies don't count
};

Spot spot_of(pugi::xml_node node) {
    return {offset_of(node), {}, false, 0};
}

bool is_near(Vec2 p) {
    return std::abs(p.x) <= kFarthest && std::abs(p.y) <= kFarthest;
}

double mean_scale(const Affine& m) {
    return std::sqrt(std::abs(m[0].x * m[1].y - m[0].y * m[1].x));
}

pugi::xml_attribute reference_of(pugi::xml_node node) {
    const pugi::xml_attribute plain = node.attribute("href");
    return plain ? plain : node.attribute("xlink:href");
}

class Collector {
  public:
    Collector(const SvgDocument& document, Report& report)
        : document_(document),
          report_(report),
          styles_(document, report),
          viewport_(root_viewport()),
          lengths_(viewport_, report) {}

    SvgPicture run() {
        for (const pugi::xml_node script : document_.scripts()) {
            report_.warn(spot_of(script), "script is not kept");
        }
        Context context;
        visit(document_.root(), context);
        charge(document_.root());  // for what the last one cost
        if (!picture_.stem) look_for_misnamed_stem();
        return std::move(picture_);
    }

  private:
    Viewport root_viewport() const;
    void visit(pugi::xml_node node, Context context);
    void visit_children(pugi::xml_node node, const Context& context);
    void visit_use(pugi::xml_node node, Context context);
    void visit_choice(pugi::xml_node node, const Context& context);
    void visit_stem(pugi::xml_node node, const Context& context);
    void draw(pugi::xml_node node, const Context& context);
    void complain(pugi::xml_node node);
    void warn_of_group_opacity(pugi::xml_node node, const Context& context, std::size_t before);
    pugi::xml_node used_by(pugi::xml_node use);
    Affine own_transform(pugi::xml_node node) const;
    Affine view_transform(pugi::xml_node node, pugi::xml_node sized) const;
    void charge(pugi::xml_node node);
    void look_for_misnamed_stem();

    const SvgDocument& document_;
    Report& report_;
    StyleResolver styles_;
    Viewport viewport_;
    LengthReader lengths_;
    SvgPicture picture_;
    std::vector<pugi::xml_node> used_;  // what is being drawn for a <use>, outermost first
    std::size_t points_ = 0;
    std::size_t work_ = 0;
    bool in_stem_ = false;
    Bounds stem_box_;
};

Viewport Collector::root_viewport() const {
    const pugi::xml_node root = document_.root();
    const pugi::xml_attribute box = root.attribute("viewBox");
    try {
        if (box) return {read_view_box(box.value()).size};
        const SvgLength width = read_length(root.attribute("width").as_string("100"));
        const SvgLength height = read_length(root.attribute("height").as_string("100"));
        if (!width.percent && !height.percent) return {{width.value, height.value}};
    } catch (const SyntaxError& fault) {
        if (box) {
            report_.error(value_spot(offset_of(root), "viewBox", fault.offset()),
                          fmt::format("svg viewBox: {}", fault.what()));
        }
    }
    return {};
}

// Every visit costs what the element's attributes weigh, so that a few <use> of large elements
// cannot be made to cost more than a large file.
void Collector::charge(pugi::xml_node node) {
    work_ += 64;
    for (const pugi::xml_attribute attribute : node.attributes()) {
        work_ += 16 + std::string_view(attribute.value()).size();
    }
    // A declaration costs about as much as 64 bytes.
    if (work_ + 64 * styles_.work() > kMostWork) {
        report_.fail(spot_of(node),
                     fmt::format("the drawing is too large with all <use> and styles written out "
                                 "(expected at most {} bytes)",
                                 kMostWork));
    }
}

Affine Collector::own_transform(pugi::xml_node node) const {
    const pugi::xml_attribute attribute = node.attribute("transform");
    if (!attribute) return kIdentity;
    try {
        return read_transform(attribute.value());
    } catch (const SyntaxError& fault) {
        report_.error(value_spot(offset_of(node), "transform", fault.offset()),
                      fmt::format("{} transform: {}", node.name(), fault.what()));
        return kIdentity;
    }
}

// From the view box of a symbol or nested <svg> to where it is put (SVG 1.1, 7.8: uniform,
// centred). `sized` is the element whose width and height count: the <use>, if it has them.
Affine Collector::view_transform(pugi::xml_node node, pugi::xml_node sized) const {
    const pugi::xml_attribute attribute = node.attribute("viewBox");
    if (!attribute) return kIdentity;
    ViewBox box;
    try {
        box = read_view_box(attribute.value());
    } catch (const SyntaxError& fault) {
        report_.error(value_spot(offset_of(node), "viewBox", fault.offset()),
                      fmt::format("{} viewBox: {}", node.name(), fault.what()));
        return kIdentity;
    }
    const auto side = [&](const char* name, Axis axis, double whole) {
        return lengths_.read_size(sized.attribute(name) ? sized : node, name, axis, whole);
    };
    const Vec2 size(side("width", Axis::x, viewport_.size.x),
                    side("height", Axis::y, viewport_.size.y));
    const double scale = std::min(size.x / box.size.x, size.y / box.size.y);
    const Vec2 corner = (size - box.size * scale) * 0.5 - box.origin * scale;
    return Affine(scale, 0, 0, scale, corner.x, corner.y);
}

void Collector::visit(pugi::xml_node node, Context context) {
    if (node.type() != pugi::node_element) return;
    if (++context.depth > kDeepest) {
        report_.fail(spot_of(node), fmt::format("{} is nested too deep with all <use> written out "
                                                "(expected at most {})",
                                                quoted(node.name()), kDeepest));
    }
    charge(node);
    const bool is_stem =
        !context.in_use && std::string_view(node.attribute("id").value()) == "stem";
    if (is_stem && !in_stem_ && !picture_.stem) return visit_stem(node, context);
    const ElementRole role = element_role(document_.element(node));
    if (role == ElementRole::silent) return;
    if (role == ElementRole::lost || role == ElementRole::unknown) {
        if (context.style.is_displayed) complain(node);
        return;
    }
    context.root_from_here = compose(context.root_from_here, own_transform(node));
    if (context.style.is_displayed) context.style = styles_.resolve(context.style, node);
    const std::size_t before = picture_.shapes.size();
    if (role == ElementRole::shape) {
        draw(node, context);
    } else if (role == ElementRole::use) {
        visit_use(node, context);
    } else if (role == ElementRole::choice) {
        visit_choice(node, context);
    } else {
        if (node != document_.root() && document_.element(node) == "svg") {
            const Vec2 at(lengths_.read(node, "x", Axis::x), lengths_.read(node, "y", Axis::y));
            const Affine put = compose(Affine(1, 0, 0, 1, at.x, at.y), view_transform(node, node));
            context.root_from_here = compose(context.root_from_here, put);
        }
        visit_children(node, context);
    }
    warn_of_group_opacity(node, context, before);
}

void Collector::visit_children(pugi::xml_node node, const Context& context) {
    for (const pugi::xml_node child : node.children())
        visit(child, context);
}

void Collector::complain(pugi::xml_node node) {
    const std::string_view element = document_.element(node);
    if (element.empty() || in_stem_) return;  // another vocabulary's: no looks
    if (element_role(element) == ElementRole::lost) {
        if (element != "script")
            report_.warn(spot_of(node), fmt::format("{} is not kept", element));
    } else {
        report_.warn(spot_of(node), fmt::format("{} is not an element of SVG, and left out{}",
                                                quoted(element), meant_element(element)));
    }
}

// Shapes that overlap under a group's opacity are seen through each other afterwards.
void Collector::warn_of_group_opacity(pugi::xml_node node, const Context& context,
                                      std::size_t before) {
    if (context.style.own_opacity == 1 || picture_.shapes.size() < before + 2) return;
    report_.warn(
        spot_of(node),
        fmt::format("{}: the group's opacity is given to each of its shapes", node.name()));
}

// Illustrator puts its own data first, for readers that know the extension, then the drawing.
void Collector::visit_choice(pugi::xml_node node, const Context& context) {
    for (const pugi::xml_node child : node.children()) {
        const bool is_drawn = child.type() == pugi::node_element &&
                              !document_.element(child).empty() &&
                              trimmed(child.attribute("requiredExtensions").value()).empty();
        if (is_drawn) return visit(child, context);
    }
}

pugi::xml_node Collector::used_by(pugi::xml_node use) {
    const pugi::xml_attribute attribute = reference_of(use);
    const Spot spot = value_spot(offset_of(use), attribute.name());
    if (!attribute) {
        report_.error(spot_of(use), "use: there is no href (expected href=\"#id\")");
        return {};
    }
    const std::optional<std::string> id = read_reference(attribute.value());
    if (!id) {
        report_.warn(spot, fmt::format("use: {} is outside this file, and not kept",
                                       quoted(attribute.value())));
        return {};
    }
    const pugi::xml_node target = document_.find(*id);
    if (!target) {
        const std::optional<std::string> meant = nearest_name(*id, document_.ids());
        report_.error(spot, fmt::format("use: {} is not an id of this file{}", quoted('#' + *id),
                                        meant ? " (did you mean '#" + *meant + "'?)" : ""));
        return {};
    }
    const bool is_ancestor = std::find(used_.begin(), used_.end(), target) != used_.end();
    bool holds_it = false;
    for (pugi::xml_node up = use; up && !holds_it; up = up.parent())
        holds_it = up == target;
    if (is_ancestor || holds_it) {
        report_.error(spot,
                      fmt::format("use: {} would draw itself without end", quoted('#' + *id)));
        return {};
    }
    return target;
}

void Collector::visit_use(pugi::xml_node node, Context context) {
    const pugi::xml_node target = used_by(node);
    if (!target) return;
    const Vec2 at(lengths_.read(node, "x", Axis::x), lengths_.read(node, "y", Axis::y));
    context.root_from_here = compose(context.root_from_here, Affine(1, 0, 0, 1, at.x, at.y));
    context.in_use = true;
    used_.push_back(target);
    if (document_.element(target) == "symbol") {
        const Affine view = compose(own_transform(target), view_transform(target, node));
        context.root_from_here = compose(context.root_from_here, view);
        if (context.style.is_displayed) context.style = styles_.resolve(context.style, target);
        visit_children(target, context);
    } else {
        visit(target, context);
    }
    used_.pop_back();
}

// The stem is only looked at: a point, a small circle, a line.
void Collector::visit_stem(pugi::xml_node node, const Context& context) {
    in_stem_ = true;
    Context within = context;
    within.in_use = true;
    --within.depth;
    visit(node, within);
    in_stem_ = false;
    if (stem_box_.empty()) {
        report_.error(spot_of(node), fmt::format("stem: {} has no place (expected a point: a small "
                                                 "circle or a path)",
                                                 quoted(node.name())));
    } else {
        picture_.stem = stem_box_.centre();
    }
}

void Collector::draw(pugi::xml_node node, const Context& context) {
    const std::string_view element = document_.element(node);
    const SvgStyle& style = context.style;
    if (!in_stem_) {
        if (!style.is_displayed || !style.is_visible) return;
        for (const pugi::xml_node child : node.children()) {
            if (element_role(document_.element(child)) == ElementRole::lost) complain(child);
        }
    }
    const Path path = transformed(context.root_from_here, read_geometry(node, element, lengths_));
    if (!std::all_of(path.points.begin(), path.points.end(), is_near)) {
        report_.error(spot_of(node), fmt::format("{}: it lies beyond 1e12 units (is a transform "
                                                 "wrong?)",
                                                 node.name()));
        return;
    }
    if (in_stem_) return stem_box_.include(bounds(path));
    points_ += path.points.size();
    if (points_ > kMostPoints) {
        report_.fail(spot_of(node), fmt::format("there are more than {} points", kMostPoints));
    }
    if (picture_.shapes.size() == kMostShapes) {
        report_.fail(spot_of(node), fmt::format("there are more than {} shapes", kMostShapes));
    }
    picture_.shapes.push_back({path, style, spot_of(node)});
    SvgShape& shape = picture_.shapes.back();
    shape.style.stroke_width *= mean_scale(context.root_from_here);
    if (element == "line") shape.style.fill = {};  // it has no inside
}

// A name is easily given in the wrong field, or capitalised.
void Collector::look_for_misnamed_stem() {
    const std::vector<std::string> wanted = {"stem"};
    for (const std::string& id : document_.ids()) {
        if (id == "stem") {
            report_.warn(attribute_spot(offset_of(document_.find(id)), "id"),
                         "id: 'stem' is not drawn where it stands, and does not count");
            return;
        }
        if (!nearest_name(id, wanted)) continue;
        report_.warn(attribute_spot(offset_of(document_.find(id)), "id"),
                     fmt::format("id: {} is not the stem (did you mean 'stem'?)", quoted(id)));
    }
    const auto is_labelled = [](pugi::xml_node node) {
        return lower_case(node.attribute("inkscape:label").value()) == "stem";
    };
    if (const pugi::xml_node node = document_.root().find_node(is_labelled)) {
        report_.warn(attribute_spot(offset_of(node), "inkscape:label"),
                     "the label is 'stem', but the id counts (expected id=\"stem\")");
    }
}

}  // namespace

SvgPicture collect_shapes(const SvgDocument& document, Report& report) {
    return Collector(document, report).run();
}

}  // namespace edaha::svg
