// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "drawing/drawing.h"
#include "flatten/flatten.h"
#include "flatten/view.h"
#include "support/id_buffer.h"

namespace edaha::test {

// Flat drawings as librsvg draws them, against a depth buffer of as many pixels: 256 parts at most.
// All throw std::runtime_error where a program fails.
inline constexpr int kSize = 800;  // pixels a side

struct Pixels {
    std::string rgb;

    Colour at(int x, int y) const {
        const auto i = static_cast<std::size_t>(3 * (y * kSize + x));
        const auto channel = [&](std::size_t k) { return static_cast<std::uint8_t>(rgb[i + k]); };
        return {channel(0), channel(1), channel(2)};
    }
};

// A material a part, of a colour without red: its number as green and blue.
Mesh with_materials(Mesh mesh);
FlattenInks inks_of(const Mesh& mesh);

// The fills on a page whose pixels are those of the depth buffer.
Drawing on_square_page(Flattened flat, const View& view, const FlattenParams& params);

// Over magenta, with or without antialiasing.
Pixels rendered(const Drawing& drawing, bool antialiased);

// Pixels with any red, away from the border.
std::size_t count_red(const Pixels& pixels);

IdBuffer fine_truth(const Mesh& mesh, const FlattenParams& params);

struct Judgement {
    std::vector<std::string> breaches;  // of the contract
    Disagreement labels;
    std::size_t red = 0;
};
Judgement judge(const Mesh& plain, const FlattenParams& params);

// A wall behind all that is seen, a little larger: what is red within it is magenta that leaks.
Mesh before_a_wall(const Mesh& mesh, const CameraParams& camera);

// In pixels, ascending, 8 for all that is further.
struct StrokeDistances {
    std::vector<double> of_strokes, of_edges;
};

// Both ways: of strokes from the depth buffer's edges, of these from strokes; without a group.
StrokeDistances stroke_distances(const Mesh& mesh, const FlattenParams& params,
                                 const std::string& left_out);

}  // namespace edaha::test
