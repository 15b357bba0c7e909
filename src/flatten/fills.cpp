// SPDX-License-Identifier: MIT
#include "flatten/fills.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "flatten/grow_ring.h"
#include "flatten/paint_order.h"
#include "geometry/bounds.h"
#include "geometry/measure.h"

namespace edaha {
namespace {

constexpr std::size_t kWorthThreads = 64;
constexpr double kTwig_px = 3;
constexpr std::uint32_t kUnderlayTime = 0;  // before all parts

// The rings of one label, outlines first.
struct Area {
    std::uint32_t label = 0;
    std::uint32_t time = 0;  // when it is painted
    std::vector<std::uint32_t> rings;
    Path path;
};

// The rings of a labelling by label.
struct Areas {
    const RegionRings& traced;
    std::vector<Area> areas;
};

// Those of the labels that `wanted` accepts, in the order of labels.
template <typename Wanted>
Areas collect(const RegionRings& traced, const Wanted& wanted) {
    Areas result{traced, {}};
    const auto& rings = traced.rings;
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < rings.size(); ++i) {
        if (wanted(rings[i].label)) order.push_back(i);
    }
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const auto key = [&](std::uint32_t i) {
            return std::tuple(rings[i].label, rings[i].area < 0, i);
        };
        return key(a) < key(b);
    });
    for (const std::uint32_t i : order) {
        if (result.areas.empty() || result.areas.back().label != rings[i].label)
            result.areas.push_back({rings[i].label, 0, {}, {}});
        result.areas.back().rings.push_back(i);
    }
    return result;
}

std::uint8_t mixed(std::uint8_t a, std::uint8_t b, double t) {
    return static_cast<std::uint8_t>(std::lround(a + (double(b) - a) * t));
}
Colour mix(Colour a, Colour b, double t) {
    return {mixed(a.r, b.r, t), mixed(a.g, b.g, t), mixed(a.b, b.b, t)};
}

// `share` from 0, the darkest, to 1.
Colour tone_at(std::span<const Colour> tones, double share) {
    if (tones.empty()) return {0x80, 0x80, 0x80};
    const double place = share * static_cast<double>(tones.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(place), tones.size() - 1);
    const std::size_t next = std::min(i + 1, tones.size() - 1);
    return mix(tones[i], tones[next], place - static_cast<double>(i));
}

class FillPainter {
  public:
    FillPainter(const FlatPicture& picture, const FlattenParams& params, const FlattenInks& inks)
        : picture_(picture),
          map_(picture.map.map),
          params_(params),
          inks_(inks),
          bands_(params.look == FlatLook::tones || params.look == FlatLook::facets
                     ? std::max(params.bands, 1)
                     : 1),
          trap_px_(params.trap_mm / picture.mm_per_px),
          order_(paint_order(picture.map, picture.parts.size(), bands_)) {}

    Layer paint() {
        Layer layer{"Fills", {}, {}};
        if (order_.parts.empty()) return layer;
        measure_sides();
        const RegionRings rings = part_rings();
        std::vector<Area> bases = paths(collect(rings, [](std::uint32_t) { return true; }), true);
        const auto is_no_base = [&](std::uint32_t code) {
            const FaceLabel label = label_of(code);
            return order_.time(label) != order_.time_of_base(label.part);
        };
        std::vector<Area> tones = paths(collect(picture_.regions.rings, is_no_base), false);
        if (trap_px_ > 0 && is_bare()) add_underlay(layer, rings);
        std::size_t base = 0, tone = 0;
        for (const PaintOrder::Part& part : order_.parts) {
            Group group{id_of(part.part), {}, {}};
            const std::uint32_t last = order_.time_of_base(part.part) + 15;
            for (; base < bases.size() && bases[base].time <= last; ++base)
                add(group, std::move(bases[base]), part, part.base);
            for (; tone < tones.size() && tones[tone].time <= last; ++tone) {
                const std::uint8_t band = label_of(tones[tone].label).tone;
                add(group, std::move(tones[tone]), part, band);
            }
            add_to(layer, std::move(group));
        }
        share_colour(layer);
        return layer;
    }

  private:
    RegionRings part_rings() const {
        std::vector<std::uint32_t> parts(map_.faces());
        for (std::size_t f = 0; f < parts.size(); ++f)
            parts[f] = picture_.map.labels[f].part == kNone ? 0 : picture_.map.labels[f].part + 1;
        return trace_region_rings(map_, parts);
    }

    // Whether seams between parts may show: no line lies on them.
    bool is_bare() const {
        return params_.look == FlatLook::fills || params_.contour_mm <= 0 || params_.border_mm <= 0;
    }

    // The areas with their paths, in the order in which they are painted.
    std::vector<Area> paths(Areas areas, bool of_parts) const {
        for_each_index(areas.areas.size(), kWorthThreads, [&](std::size_t i) {
            Area& area = areas.areas[i];
            area.time =
                of_parts ? order_.time_of_base(area.label - 1) : order_.time(label_of(area.label));
            area.path = path_of(areas.traced, area);
        });
        std::sort(areas.areas.begin(), areas.areas.end(), [](const Area& a, const Area& b) {
            return std::pair(a.time, a.label) < std::pair(b.time, b.label);
        });
        return std::move(areas.areas);
    }

    // Which parts are twigs before the sky: thinner than a seam's pixels, and there are many.
    std::vector<std::uint8_t> find_twigs(const RegionRings& rings) const {
        struct Measure {
            double area = 0, border = 0, sky = 0;
        };
        std::vector<Measure> measures(picture_.parts.size());
        for (const RegionRings::Ring& ring : rings.rings) {
            Measure& part = measures[ring.label - 1];
            part.area += ring.area;
            for (const std::uint32_t h : rings.of(ring)) {
                const double length = glm::distance(at(map_.origin(h)), at(map_.target(h)));
                part.border += length;
                if (time_left_of(twin(h)) == 0) part.sky += length;
            }
        }
        const double thin = kTwig_px * picture_.map.steps_per_px;
        std::vector<std::uint8_t> is_twig(measures.size());
        for (std::size_t i = 0; i < measures.size(); ++i) {
            const auto& [area, border, sky] = measures[i];
            is_twig[i] = 2 * area < thin * border && 2 * sky > border;
        }
        return is_twig;
    }

    // All but the twigs as one area under everything: pixels that two parts share by halves have
    // it behind them, however wide the pixels are.
    void add_underlay(Layer& layer, const RegionRings& rings) const {
        const std::vector<std::uint8_t> is_twig = find_twigs(rings);
        std::vector<std::uint32_t> inside(map_.faces());
        for (std::size_t f = 0; f < inside.size(); ++f) {
            const std::uint32_t part = picture_.map.labels[f].part;
            inside[f] = part != kNone && !is_twig[part];
        }
        const RegionRings outlines = trace_region_rings(map_, inside);
        Areas all = collect(outlines, [](std::uint32_t) { return true; });
        if (all.areas.empty()) return;
        all.areas[0].time = kUnderlayTime;
        const PaintOrder::Part& part = order_.parts.front();
        Shape shape{"underlay", path_of(outlines, all.areas[0]), {colour(part, part.base), {}}};
        if (!shape.path.empty()) layer.children.emplace_back(std::move(shape));
    }

    Vec2 at(std::uint32_t node) const { return to_vec(map_.nodes[node]); }

    // What is seen on both sides of each arc.
    void measure_sides() {
        sides_.resize(2 * picture_.graph.ends.size());
        for_each_index(picture_.graph.ends.size(), kWorthThreads, [&](std::size_t a) {
            const std::uint32_t h = picture_.graph.first_half_edge({std::uint32_t(a), true});
            for (const std::uint32_t side : {0U, 1U}) {
                sides_[2 * a + side] = {time_left_of(h ^ side), picture_.regions.width[h ^ side]};
            }
        });
    }

    std::uint32_t time_left_of(std::uint32_t h) const {
        return order_.time(picture_.map.labels[map_.face_of(h)]);
    }

    // Outwards under what is painted later. Inwards where the area itself is painted over up to its
    // border: of two edges in one place the lower one would show through the upper one's pixels.
    double growth(ArcUse use, std::uint32_t time) const {
        const Side& left = sides_[2 * use.arc + (use.forward ? 0 : 1)];
        const Side& right = sides_[2 * use.arc + (use.forward ? 1 : 0)];
        if (right.time > time) return std::min(trap_px_, 0.4 * double(right.width));
        return left.time > time ? -std::min(trap_px_, 0.4 * double(left.width)) : 0;
    }

    // How far an area painted at `time` may spread round the node that `spoke` leaves, on the side
    // away from it, until what was painted before comes. `other` is its next border there.
    GrownEnd end_kind(std::uint32_t spoke, std::uint32_t other, bool leftwards,
                      std::uint32_t time) const {
        std::vector<std::uint32_t> spokes;  // clockwise (where y points up), from this one on
        for (std::uint32_t s = spoke; spokes.empty() || s != spoke; s = map_.next[twin(s)])
            spokes.push_back(s);
        const std::size_t count = spokes.size();
        std::size_t turns = 0;
        std::uint32_t s = spoke;
        while (turns < count && time_left_of(leftwards ? s : twin(s)) > time) {
            ++turns;
            s = spokes[leftwards ? (count - turns) % count : turns % count];
        }
        if (s == other) return GrownEnd::open;
        const Vec2 a = at(map_.target(spoke)) - at(map_.origin(spoke));
        const Vec2 b = at(map_.target(s)) - at(map_.origin(s));
        const double turn = (a.x * b.y - a.y * b.x) * (leftwards ? 1 : -1);
        const bool narrow = turn > 0 && glm::dot(a, b) > 0.17 * glm::length(a) * glm::length(b);
        return narrow ? GrownEnd::taper : GrownEnd::butt;
    }

    // `trapped`: grown and shrunk along its borders.
    std::vector<CurvePiece> outline(std::span<const ArcUse> uses, std::uint32_t time,
                                    bool trapped) const {
        const ArcGraph& graph = picture_.graph;
        const auto growth_of = [&](ArcUse use) { return trapped ? growth(use, time) : 0; };
        std::vector<GrownPiece> ring;
        for (std::size_t i = 0; i < uses.size();) {
            const double by = growth_of(uses[i]);
            std::vector<CurveSpan> spans{picture_.curves.span(uses[i])};
            std::size_t end = i + 1;
            for (; end < uses.size() && growth_of(uses[end]) == by; ++end) {
                const CurveSpan next = picture_.curves.span(uses[end]);
                if (next.run != spans.back().run || next.from != spans.back().to) break;
                spans.push_back(next);
            }
            const std::size_t first = ring.size();
            for (const CurvePiece& piece : pieces_along(picture_.curves, spans))
                ring.push_back({piece, by, GrownEnd::open, GrownEnd::open});
            const ArcUse before = uses[(i + uses.size() - 1) % uses.size()];
            const ArcUse after = uses[end % uses.size()];
            if (by < 0 && ring.size() > first) {
                if (growth(before, time) >= 0) ring[first].start = GrownEnd::butt;
                if (growth(after, time) >= 0) ring.back().end = GrownEnd::butt;
            }
            if (by > 0 && ring.size() > first) {
                ring[first].start = end_kind(graph.first_half_edge(uses[i]),
                                             twin(graph.last_half_edge(before)), false, time);
                ring.back().end = end_kind(twin(graph.last_half_edge(uses[end - 1])),
                                           graph.first_half_edge(after), true, time);
            }
            i = end;
        }
        return grow_ring(ring);
    }

    // A hole that touches its outline in a node may come to stick out of it where one grows and the
    // other shrinks: then both stay as they are.
    Path path_of(const RegionRings& traced, const Area& area) const {
        bool sound = true;
        Path path = path_of(traced, area, true, sound);
        return sound ? path : path_of(traced, area, false, sound);
    }

    Path path_of(const RegionRings& traced, const Area& area, bool trapped, bool& sound) const {
        Path path;
        Bounds outlines;
        for (const std::uint32_t i : area.rings) {
            const RegionRings::Ring& ring = traced.rings[i];
            const std::vector<ArcUse> uses = arcs_of_ring(picture_.graph.arcs, traced.of(ring));
            Path outline_path;
            append_pieces(outline_path, outline(uses, area.time, trapped), picture_.page_from_px);
            if (outline_path.verbs.size() < 3) continue;
            outline_path.close();
            // Curves may turn a sliver inside out: then nothing of it is left.
            if (signed_area(outline_path) * ring.area <= 0) continue;
            if (path.empty() && ring.area < 0) continue;
            const Bounds box = bounds(outline_path);
            if (ring.area > 0) outlines.include(box);
            sound = sound && outlines.contains(box.min) && outlines.contains(box.max);
            path.verbs.insert(path.verbs.end(), outline_path.verbs.begin(),
                              outline_path.verbs.end());
            path.points.insert(path.points.end(), outline_path.points.begin(),
                               outline_path.points.end());
        }
        return path;
    }

    Colour colour(const PaintOrder::Part& part, std::uint8_t tone) const {
        const std::size_t material = picture_.parts[part.part].material;
        std::span<const Colour> tones;
        if (material < inks_.tones.size()) tones = inks_.tones[material];
        const double share = bands_ > 1 ? double(tone) / (bands_ - 1) : 0.5;
        return mix(tone_at(tones, std::min(share, 1.0)), inks_.paper,
                   params_.fade * (1 - part.nearness));
    }

    // The part's name as an XML name, with a number where that is taken.
    std::string id_of(std::uint32_t part) {
        std::string id = id_from_label(picture_.parts[part].name);
        const bool starts_well =
            !id.empty() && ((id[0] >= 'a' && id[0] <= 'z') || (id[0] >= 'A' && id[0] <= 'Z'));
        if (!starts_well) id = "part-" + id;
        std::string free = id;
        for (int number = 2; !ids_.insert(free).second; ++number)
            free = id + "-" + std::to_string(number);
        return free;
    }

    void add(Group& group, Area&& area, const PaintOrder::Part& part, std::uint8_t tone) const {
        if (area.path.empty()) return;
        Paint paint;
        paint.fill = colour(part, tone);
        group.children.emplace_back(Shape{"", std::move(area.path), paint});
    }

    // The most frequent colour is the layer's: shapes inherit it.
    static void share_colour(Layer& layer) {
        std::map<std::uint32_t, std::size_t> shapes;
        const auto key = [](Colour c) { return std::uint32_t{c.r} << 16 | c.g << 8 | c.b; };
        visit_shapes(layer.children, [&](Shape& s) { ++shapes[key(s.paint.fill.colour)]; });
        std::size_t most = 0;
        std::uint32_t colour = 0;
        for (const auto& [c, count] : shapes) {
            if (count > most) most = count, colour = c;
        }
        visit_shapes(layer.children, [&](Shape& s) {
            if (key(s.paint.fill.colour) != colour) return;
            layer.paint.fill = s.paint.fill;
            s.paint.fill = {};
        });
    }

    template <typename Visit>
    static void visit_shapes(std::vector<Element>& elements, const Visit& visit) {
        for (Element& element : elements) {
            if (auto* group = std::get_if<Group>(&element)) {
                visit_shapes(group->children, visit);
            } else {
                visit(std::get<Shape>(element));
            }
        }
    }

    static void add_to(Layer& layer, Group&& group) {
        if (group.children.empty()) return;
        if (group.children.size() > 1) {
            layer.children.emplace_back(std::move(group));
            return;
        }
        Shape shape = std::move(std::get<Shape>(group.children[0]));
        shape.id = group.id;
        layer.children.emplace_back(std::move(shape));
    }

    const FlatPicture& picture_;
    const PlanarMap& map_;
    const FlattenParams& params_;
    const FlattenInks& inks_;
    int bands_;
    double trap_px_;
    PaintOrder order_;
    struct Side {
        std::uint32_t time = 0;
        float width = 0;
    };
    // Taken: what layers, groups of lines and the underlay are called.
    std::set<std::string> ids_{"Fills",         "Bark",    "Lines",    "Hidden-lines", "Creases",
                               "Intersections", "Borders", "Contours", "Silhouette",   "underlay"};
    std::vector<Side> sides_;  // of an arc: left, right
};

}  // namespace

Layer draw_fills(const FlatPicture& picture, const FlattenParams& params, const FlattenInks& inks) {
    return FillPainter(picture, params, inks).paint();
}

}  // namespace edaha
