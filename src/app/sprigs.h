// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "drawing/drawing.h"
#include "ornament/leaf.h"
#include "style/style.h"

namespace edaha {

// Small trees by the style's energy model, of SprigParams::energy each, as symbols: wood as one
// silhouette, and on it leaves, blossom and fruit in tones of their own, expanded. The foot is the
// origin; the farthest ink lies 10 units from it, as in a leaf. `variants` of them in each
// of the tones of SprigTone, in the order of SprigSymbols. Of one variant, all tones have the same
// outline. Errors: as those of `load_leaf` and of growth.
std::vector<Symbol> grow_sprigs(
    const Style& style, const std::function<LeafImport(const std::string& name)>& load_leaf);

}  // namespace edaha
