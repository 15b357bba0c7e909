// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "drawing/drawing.h"

namespace edaha {

// How many pixels: `width_px` if it is set (the height follows from the page), else `dpi`.
struct PngParams {
    std::optional<int> width_px = {};
    double dpi = 300;
    std::optional<Colour> background = {};  // transparent without
    std::size_t most_pixels = 200'000'000;  // 4 bytes of memory each
};

// The drawing as a PNG file's bytes, 8 bits a channel with alpha, its physical size (pHYs) and, as
// text, title, software, the command that makes it again and its recipe. No date.
// Errors: IoError, "a picture of 40000 x 40000 pixels is above the limit of 200000000 pixels".
std::string png_bytes(const Drawing& drawing, const PngParams& params);

// Metadata::recipe of a PNG that we wrote; empty if there is none.
std::string png_recipe(std::string_view png);

}  // namespace edaha
