// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "drawing/drawing.h"
#include "geometry/bounds.h"

namespace edaha {

// The boxes of what a drawing shows, strokes included, wherever it lies in the plane. An instance
// counts by the corners of its symbol's box: the answer may be larger than the ink. A stroke that
// an instance passes on to its symbol is not counted. The drawing outlives this.
class InkBoxes {
  public:
    explicit InkBoxes(const Drawing& drawing);

    Bounds of_all() const;
    Bounds of(const Layer& layer) const;

  private:
    void include(Bounds& box, const std::vector<Element>& elements, const Paint& inherited) const;
    void include(Bounds& box, const Use& use) const;

    const Drawing& drawing_;
    std::vector<Bounds> symbols_;
};

}  // namespace edaha
