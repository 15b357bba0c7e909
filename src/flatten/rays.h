// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "flatten/view.h"

namespace edaha {

// Rays that look straight into a view: at integer places they are exact in the plane, in depth
// right to a step or so. By Embree, in its robust mode: none slips between two triangles.
class RayScene {
  public:
    struct Hit {
        std::uint32_t triangle = 0;
        float z = 0;                   // of the view
        std::array<float, 3> weights;  // of the triangle's corners
    };

    // Of the triangles that are shown. `flush` as intersect_shown() tells it. The mesh must outlive
    // the scene. Errors: std::bad_alloc.
    RayScene(const View& view, const Mesh& mesh, std::vector<std::uint8_t> flush);
    ~RayScene();
    RayScene(RayScene&&) noexcept;

    // What is seen at a place: of triangles in one plane, the one of the lowest part.
    std::optional<Hit> look(Vec2 place) const;

    // Whether something lies in front of a point of the view, by more than kNear steps and other
    // than the two triangles that the point lies on.
    bool is_hidden(Vec2 place, double z, std::array<std::uint32_t, 2> own) const;

    // A sixteenth of a pixel: less, and a steep surface hides its own edges; more, and thin sheets
    // don't hide what is behind them.
    static constexpr float kNear = kStepsPerPx / 16.0F;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace edaha
