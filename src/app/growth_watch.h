// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "app/console.h"
#include "style/style.h"
#include "surface/grow_surface.h"

namespace edaha {

// Shows on standard error, if that is a terminal, how far the growth of a surface is: from the
// second second on. Its line goes away when this is destroyed. The console outlives it.
class GrowthWatch {
  public:
    GrowthWatch(const Style& style, Console& console);
    ~GrowthWatch();
    GrowthWatch(const GrowthWatch&) = delete;
    GrowthWatch& operator=(const GrowthWatch&) = delete;

    // For whoever grows; as long as this lives.
    SurfaceWatch watch();

  private:
    struct Line;
    std::unique_ptr<Line> line_;  // null: there is nothing to show, or no terminal
};

}  // namespace edaha
