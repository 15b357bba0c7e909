// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "drawing/drawing.h"
#include "drawing/palette.h"
#include "drawing/site.h"
#include "energy/limbs.h"

namespace edaha {

// The wood of a tree as layers, bottom first, and what other stages set on it and under it.
struct Wood {
    std::vector<Layer> behind;  // boughs that stand behind the trunk
    std::vector<Layer> front;
    Vec2 foot;  // middle of the trunk's foot
    double foot_width_mm = 0;
};

// One path a limb, one group a bough, named after Limbs::id; the trunk is painted last, so that
// limbs start behind it. Looks [E]:
//   solid       filled: thin limbs in the palette's light tone, thick ones with a shaded side;
//   silhouette  all wood is one compound path, a true union;
//   outline     the contour of that path as a stroke;
//   line        centre lines as strokes.
Wood draw_wood(const Limbs& limbs, const LookParams& look, const Palette& palette);

// Ends of twigs, and places along those limbs that are thinner than `along_width_mm`, `along_mm`
// apart (none if 0), alternately left and right.
struct SiteParams {
    double along_mm = 0;
    double along_width_mm = 0;
};
std::vector<Site> sites(const Limbs& limbs, const LookParams& look, const SiteParams& params);

}  // namespace edaha
