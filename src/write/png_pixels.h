// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

namespace edaha {

struct PixelSize {
    int width = 0;
    int height = 0;
    bool operator==(const PixelSize&) const = default;
};

// What a PNG file's header says; 0 x 0 if it is none.
PixelSize png_size(std::string_view png);

// Whether two PNG files have the same size and, pixel by pixel, shades that are at most `most` of
// 255 apart. False where one of them can't be read. O(pixels).
bool are_alike(const std::string& png, const std::string& other_png, int most);

}  // namespace edaha
