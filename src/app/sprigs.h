// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "drawing/drawing.h"
#include "ornament/leaf.h"
#include "ornament/place_sprigs.h"
#include "style/style.h"

namespace edaha {

// Small trees by the style's energy model, of SprigParams::energy each, as symbols: `variants` of
// them, each in the parts of SprigPart and in the order of SprigSymbols. The stem is the wood as
// one silhouette; leaves in the half near the foot are the inner part, the others the outer one,
// each their union; all take the instance's colour. Blossom and fruit lie on the outer part in
// colours of their own. The foot is the origin; the farthest ink lies 10 units from it, as in
// a leaf. Errors: as those of `load_leaf` and of growth.
std::vector<Symbol> grow_sprigs(
    const Style& style, const std::function<LeafImport(const std::string& name)>& load_leaf);

// Their colours: steps about the palette's leaf tones, or these alone if it is strict.
SprigInks sprig_inks(const Palette& palette);

}  // namespace edaha
