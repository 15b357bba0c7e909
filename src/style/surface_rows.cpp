// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>

#include "style/parameter_rows.h"

namespace edaha {
namespace {

constexpr const char* kOurs = "Edaha";

// Real trees, in mm: a kilometre is more than any is high.
constexpr double kFar = 1e6;

// The item that a row of a list reaches is the last one: who reads or writes a list goes through it
// item by item.
template <class Item>
const Item& last_of(const std::vector<Item>& items) {
    static const Item kDefault;
    return items.empty() ? kDefault : items.back();
}
template <class Item>
Item& last_of(std::vector<Item>& items) {
    if (items.empty()) items.emplace_back();
    return items.back();
}

std::vector<Parameter> burl_rows() {
    using P = BurlPlace;
    RowWriter rows(
        "burl", [](auto& s) -> auto& { return last_of(s.surface.burls); });
    // clang-format off
    rows.add(&P::height_mm, {"height", mm(0, kFar), "paper 6.2",
        "above the foot, of the point of the trunk next to which it grows"});
    rows.add(&P::azimuth_rad, {"azimuth", degrees(-360, 360), "paper 6.2",
        "of that point round the trunk: 0 is the front, 90 its right side"});
    rows.add(&P::radius_mm, {"radius", mm(1, kFar), "paper 6.1",
        "R: beyond it, the burl makes nothing grow faster"});
    rows.add(&P::core_mm, {"core", mm(0, kFar), "paper 6.1",
        "R': within it, all grows faster by the whole strength"});
    rows.add(&P::strength, {"strength", {-1, 100}, "paper 6.1",
        "k: the cambium grows 1 + k times as fast; below 0 slower"});
    rows.add(&P::from, {"step", {1, 1e6}, kOurs, "from which on it is there"});
    // clang-format on
    return rows.take();
}

template <class Reach>
std::vector<Parameter> solid_rows(const std::string& group, const char* source, Reach reach) {
    using P = SolidParams;
    RowWriter rows(group, reach);
    // clang-format off
    rows.add(&P::shape, {"shape", {"plane", "box", "ball", "rod", "wire", "mesh"}, source,
        "what it is; a wire is a rod in zigzag, a mesh comes from a file"});
    rows.add(&P::from, {"from", mm(-kFar, kFar), kOurs,
        "x y z, y up: an end, a corner, the middle of a ball, a point of a plane, the origin of a mesh"});
    rows.add(&P::to, {"to", mm(-kFar, kFar), kOurs,
        "x y z: the other end or corner; a plane faces from there"});
    rows.add(&P::radius_mm, {"radius", mm(0.1, kFar), kOurs, "of a ball, a rod, a wire"});
    rows.add(&P::step, {"step", {1, 1e6}, kOurs, "from which on it is there"});
    rows.add_mesh(&P::file, {"file", kOurs, "of a mesh: closed, in mm, y up"});
    // clang-format on
    return rows.take();
}

std::optional<std::string> fault_of(const BurlPlace&) {
    return std::nullopt;
}

std::optional<std::string> fault_of(const SolidParams& solid) {
    const bool is_mesh = solid.shape == SolidShape::mesh;
    if (is_mesh && solid.file.empty()) return "shape=\"mesh\" needs a file";
    if (!is_mesh && !solid.file.empty()) return "only shape=\"mesh\" has a file";
    return std::nullopt;
}

template <class Item>
ParameterList list_of(std::string name, std::string help, std::vector<Item> SurfaceParams::*items,
                      std::vector<Parameter> rows) {
    return {std::move(name),
            std::move(help),
            std::move(rows),
            [items](const Style& style) { return (style.surface.*items).size(); },
            [items](Style& style, std::size_t size) { (style.surface.*items).resize(size); },
            [items](const Style& style) { return fault_of(last_of(style.surface.*items)); }};
}

std::vector<Parameter> sprig_rows() {
    using P = SprigParams;
    RowWriter rows(
        "surface", [](auto& s) -> auto& { return s.sprig; });
    // clang-format off
    rows.add(&P::energy, {"sprig-energy", {0, 1e4}, kOurs,
        "of the sprigs that the energy tree grows; 0: none, but leaves", {0, 60}});
    rows.add(&P::variants, {"sprig-variants", {1, 64}, kOurs,
        "so many different sprigs are grown", {1, 12}});
    rows.add(&P::size_spread, {"sprig-size-spread", {0, 0.9}, kOurs,
        "sizes vary by up to this part of themselves"});
    rows.add(&P::droop, {"sprig-droop", {0, 1}, kOurs,
        "how far sprigs turn to hang straight down"});
    rows.add(&P::clump, {"sprig-clump", {0.1, 1000}, kOurs,
        "radius of the clumps that they stand in and are shaded as: lengths of a sprig", {0.8, 3}});
    rows.add(&P::rounding, {"sprig-rounding", {0, 1}, kOurs,
        "how far they turn away from the middle of their clump"});
    // clang-format on
    return rows.take();
}

}  // namespace

std::vector<Parameter> surface_rows() {
    using P = SurfaceParams;
    RowWriter rows(
        "surface", [](auto& s) -> auto& { return s.surface; });
    // clang-format off
    rows.add(&P::steps, {"steps", {1, 100000}, "paper 4.2",
        "n_end: after so many steps the tree is grown", {100, 400}});
    rows.add(&P::split_mm, {"split", mm(1, 100000), "paper 4.3",
        "T_s: longer edges are split", {100, 300}});
    rows.add(&P::merge_mm, {"merge", mm(0, 50000), "paper 4.3",
        "T_m: shorter edges are merged away if they shrink; at most half of split", {40, 140}});
    rows.add(&P::flips, {"flips", kOurs, "edges turn towards better angles"});
    rows.add(&P::smoothing, {"smoothing", {0, 1}, kOurs,
        "how far vertices slide along the surface to the middle of their neighbours"});
    rows.add(&P::sides, {"sides", {3, 64}, "paper 4.1",
        "of the prism that is the seed; each bears a phloem line", {5, 12}});
    rows.add(&P::seed_radius_mm, {"seed-radius", mm(1, 10000), "paper 4.1",
        "of the seed's foot", {60, 240}});
    rows.add(&P::seed_height_mm, {"seed-height", mm(1, 10000), "paper 4.1",
        "of the seed", {100, 400}});
    rows.add(&P::speed_mm, {"speed", mm(0, 10000), "paper 5.1",
        "S_a: the first apex goes so far a step", {20, 80}});
    rows.add(&P::thickening_mm, {"thickening", mm(0, 1000), "paper 5.2",
        "S_c: the bark moves out by this a step", {1, 6}});
    rows.add(&P::winding_rad, {"winding", degrees(-60, 60), "paper 6.3",
        "theta_p: phloem winds by this a mm that its apex goes (0.004 radians are 0.2292)",
        {0, 0.3}});
    rows.add(&P::strung, {"strung", {0, 100000}, "paper 6.3",
        "m: so many burls are strung along a phloem line", {0, 50}});
    rows.add(&P::burl_radius_mm, {"burl-radius", mm(1, 100000), "paper 6.1",
        "R of burls that are strung or random", {200, 800}});
    rows.add(&P::burl_core_mm, {"burl-core", mm(0, 100000), "paper 6.1",
        "R' of those, and of rims and contacts: within it, they work with all their strength",
        {50, 300}});
    rows.add(&P::burl_strength, {"burl-strength", {-1, 100}, "paper 6.1",
        "k of those: the bark grows 1 + k times as fast", {0, 3}});
    rows.add(&P::random_burls, {"random-burls", {0, 100000}, "paper 6.2",
        "so many burls by insects and bacteria, anywhere", {0, 20}});
    rows.add(&P::decay_mm, {"decay", mm(0, 1000), "paper 7.1",
        "S_h: rotten wood goes back by this a step", {0, 12}});
    rows.add(&P::closing, {"closing", {0, 100}, "paper 7.2",
        "A: how much bark at a hollow grows over it", {0, 3}});
    rows.add(&P::rim, {"rim", "paper 7.2", "bark beside a hollow swells to a rim"});
    rows.add(&P::rim_radius_mm, {"rim-radius", mm(1, 100000), "paper 7.2",
        "R of the rim's burls", {100, 500}});
    rows.add(&P::rim_strength, {"rim-strength", {0, 100}, "paper 7.2",
        "k of the rim's burls", {0, 2}});
    rows.add(&P::wrapping, {"wrapping", {0, 100}, "paper 8",
        "B: how much bark at an obstacle grows round it", {0, 3}});
    rows.add(&P::contact_radius_mm, {"contact-radius", mm(1, 100000), "paper 8",
        "R of the burl at each contact with an obstacle", {100, 600}});
    rows.add(&P::contact_strength, {"contact-strength", {0, 100}, "paper 8",
        "k of the burl at each contact", {0, 6}});
    rows.add(&P::sprig_mm, {"sprig-size", mm(1, 100000), kOurs,
        "of the places for sprigs or leaves", {100, 1500}});
    rows.add(&P::sprig_spacing_mm, {"sprig-spacing", mm(1, 100000), kOurs,
        "between those places", {100, 1000}});
    rows.add(&P::sprig_reach_mm, {"sprig-reach", mm(0, kFar), kOurs,
        "those places lie so near to the tip of their branch", {500, 5000}});
    rows.add(&P::deadwood, {"deadwood", kOurs, "branches that the rules stop are bare and grey"});
    rows.add(&P::face_limit, {"face-limit", {100, 1e8}, kOurs,
        "a tree of more triangles is refused"});
    // clang-format on
    std::vector<Parameter> all = rows.take();
    std::ranges::move(sprig_rows(), std::back_inserter(all));
    return all;
}

std::vector<ParameterList> surface_lists() {
    using P = SurfaceParams;
    std::vector<ParameterList> lists;
    lists.push_back(
        list_of("burl", "a place where the surface grows faster", &P::burls, burl_rows()));
    lists.push_back(list_of(
        "hollow", "a region in which wood rots away", &P::hollows,
        solid_rows(
            "hollow", "paper 7.1", [](auto& s) -> auto& { return last_of(s.surface.hollows); })));
    lists.push_back(list_of(
        "obstacle", "what the tree can't grow through, but round", &P::obstacles,
        solid_rows(
            "obstacle", "paper 8", [](auto& s) -> auto& { return last_of(s.surface.obstacles); })));
    return lists;
}

}  // namespace edaha
