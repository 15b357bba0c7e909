// SPDX-License-Identifier: MIT
#include "style/parameter_rows.h"

namespace edaha {
namespace {

constexpr const char* kOurs = "Edaha";

}  // namespace

// Named as the thesis' readers know them, hence the underscores. -1 or 0: by the thesis' tables.
std::vector<Parameter> proproot_rows() {
    using P = PropRootParams;
    RowWriter rows(
        "proproot", [](auto& s) -> auto& { return s.prop_root; });
    // clang-format off
    rows.add(&P::primaries, {"primaries", {1, 100}, "paper 3.3.3",
        "roots that leave the trunk: the plant's age", {4, 64}});
    rows.add(&P::type, {"type", {"standard", "gentle", "steep"}, "paper 3.3.2",
        "how far out the roots run"});
    rows.add(&P::max_order, {"max_order", {0, 5}, "paper table 3.3",
        "how often roots fork on the way from the trunk, at most; 0: by the age", {1, 5}});
    rows.add(&P::branchings, {"branchings", {-1, 20}, "paper table 3.4",
        "forks of a root of typical length; -1: by the age", {0, 4}});
    rows.add(&P::max_branchings, {"max_branchings", {-1, 20}, "paper table 3.4",
        "most forks of one root; -1: by the age", {0, 6}});
    rows.add(&P::bulges, {"bulges", {-1, 1}, "paper table 3.2",
        "part of the roots that rise before they fall; -1: by the type", {0, 1}});
    rows.add(&P::highest, {"highest", {0, 1000}, "paper table 3.1",
        "where the highest root may leave the trunk, in cm; 0: by the age", {40, 160}});
    rows.add(&P::heights, {"heights", {"uniform", "geometric"}, "paper 3.3.2; geometric: Edaha",
        "where roots leave the trunk: anywhere alike, or denser below"});
    rows.add(&P::turn_weights, {"turn_weights", {0, 1e6}, "paper fig. 3.9",
        "how often a child turns from its parent by 0-20, 20-40 ... 160-170 degrees", {1, 5}});
    rows.add(&P::apart, {"apart", "paper 4.3", "no root passes through another"});
    rows.add(&P::tries, {"tries", {0, 1000}, kOurs,
        "so often a root that would do that is drawn anew, then left out", {0, 40}});
    rows.add(&P::young, {"young", {0, 1}, "paper 4.3",
        "part of the roots that have not reached the ground"});
    rows.add(&P::knob, {"knob", {0, 3}, "paper 4.3",
        "swelling where a root leaves the trunk, part of its radius", {0, 1.2}});
    rows.add(&P::trunk_bend, {"trunk_bend", {0, 3}, "paper 4.3",
        "how bent a trunk is, the more the older", {0, 2}});
    rows.add(&P::trunk_taper, {"trunk_taper", {0, 0.9}, "paper 4.3",
        "part of its thickness that a trunk loses upwards, the more the older"});
    rows.add(&P::propagule_length, {"propagule_length", {1, 100}, "paper 4.3",
        "length of the seedling, in cm: more has more roots; 30 changes nothing", {15, 60}});
    rows.add(&P::planting_depth, {"planting_depth", {0, 1}, "paper 4.3",
        "part of it that was buried: more has more roots; 0.5 changes nothing"});
    rows.add(&P::circle_points, {"circle_points", {3, 256}, "paper 3.3.1",
        "corners of a root's section", {4, 24}});
    rows.add(&P::curve_points, {"curve_points", {1, 256}, "paper 3.3.1",
        "sections along a root for a bend of a right angle", {4, 48}});
    rows.add(&P::order_colours, {"order_colours", "paper fig. 4.1",
        "roots in red, orange, yellow, cream and white by their order, not in the wood's colours"});
    // clang-format on
    return rows.take();
}

}  // namespace edaha
