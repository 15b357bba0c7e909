// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "drawing/drawing.h"

namespace edaha {

// A page that Cairo draws on: the one place that knows Cairo. PDF and EPS pages are in points of
// 1/72 inch, pictures in pixels. Cairo keeps places to 1/256 of these.
class Canvas {
  public:
    enum class Kind { picture, pdf, eps };

    // Errors: IoError where Cairo has no memory or the size is beyond it (32767 pixels a side).
    Canvas(Kind kind, double width, double height);
    ~Canvas();
    Canvas(Canvas&&) noexcept;

    void paint_background(Colour colour);

    // Draws a layer, `scale` units of the canvas a millimetre. With `paper`, translucent inks are
    // mixed with it (in a symbol, with its first fill) and drawn opaque.
    void draw(const Drawing& drawing, const Layer& layer, double scale,
              const std::optional<Colour>& paper = {});

    // The file's bytes as Cairo makes them; the canvas is used up. Errors: IoError.
    std::string finish();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace edaha
