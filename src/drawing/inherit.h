// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "drawing/paint.h"

namespace edaha {

// What a node is drawn with once its parents have been asked. As it starts: the root's, nothing.
struct InheritedPaint {
    std::optional<Colour> fill;
    std::optional<Colour> stroke;
    double stroke_width_mm = 0;
    float fill_opacity = 1;
    float stroke_opacity = 1;
    bool operator==(const InheritedPaint&) const = default;
};

// The rules of Paint, applied once.
InheritedPaint inherit(const InheritedPaint& parent, const Paint& own);

}  // namespace edaha
