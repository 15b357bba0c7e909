// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>

#include "drawing/drawing.h"

namespace edaha {

// A picture of pixels that Cairo draws: beside png_pixels the one place that knows it. Cairo keeps
// places to 1/256 of a pixel.
class Canvas {
  public:
    // Errors: IoError where Cairo has no memory or the size is beyond it (32767 pixels a side).
    Canvas(int width, int height);
    ~Canvas();
    Canvas(Canvas&&) noexcept;

    void paint_background(Colour colour);

    // Draws a layer, `scale` pixels a millimetre.
    void draw(const Drawing& drawing, const Layer& layer, double scale);

    // The PNG file's bytes as Cairo makes them; the canvas is used up. Errors: IoError.
    std::string finish();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace edaha
