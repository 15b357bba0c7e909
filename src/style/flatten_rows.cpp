// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>

#include "style/parameter_rows.h"

namespace edaha {
namespace {

constexpr const char* kOurs = "Edaha";

std::vector<Parameter> camera_rows() {
    using P = CameraParams;
    RowWriter rows(
        "flatten", [](auto& s) -> auto& { return s.flatten.camera; });
    // clang-format off
    rows.add(&P::projection, {"projection", {"orthographic", "perspective"}, kOurs,
        "parallel, or smaller with distance"});
    rows.add(&P::azimuth_rad, {"azimuth", degrees(-360, 360), kOurs,
        "from where it is seen: 0 is the front, 90 its right side", {-90, 90}});
    rows.add(&P::elevation_rad, {"elevation", degrees(-90, 90), kOurs,
        "from how high it is seen: 90 is straight from above", {-20, 60}});
    rows.add(&P::field_of_view_rad, {"field-of-view", degrees(1, 150), kOurs,
        "perspective: angle that the longer side spans", {10, 100}});
    // clang-format on
    return rows.take();
}

}  // namespace

std::vector<Parameter> flatten_rows() {
    using P = FlattenParams;
    RowWriter rows(
        "flatten", [](auto& s) -> auto& { return s.flatten; });
    // clang-format off
    rows.add(&P::look, {"look", {"fills", "lines", "fills-lines", "tones", "facets", "blueprint"},
        kOurs, "one colour a part, lines, both, tones and lines, straight facets, or hidden lines "
        "too"});
    rows.add(&P::size_mm, {"size", mm(1, 10000), kOurs,
        "longer side of what is seen", {60, 300}});
    rows.add(&P::mm_per_unit, {"scale", mm(0, 1e6), kOurs,
        "of a unit of the mesh, instead of the size; 0: as the size says", {0.25, 2}});
    rows.add(&P::resolution, {"resolution", {16, 8000}, kOurs,
        "pixels along the longer side: what is much smaller is left out", {150, 2000}});
    rows.add(&P::bands, {"bands", {2, 4}, kOurs, "tones of one material", {2, 4}});
    rows.add(&P::light_azimuth_rad, {"light-azimuth", degrees(-180, 180), kOurs,
        "where the light comes from: 0 is the eye, 90 its right", {-120, 120}});
    rows.add(&P::light_elevation_rad, {"light-elevation", degrees(-90, 90), kOurs,
        "how high the light stands", {-20, 90}});
    rows.add(&P::shade, {"shade", {-1, 1}, kOurs,
        "surfaces that get less of the light are in the darkest tone", {-0.2, 0.8}});
    rows.add(&P::shine, {"shine", {-1, 1}, kOurs,
        "surfaces that get more of the light are in the lightest tone", {0.4, 1}});
    rows.add(&P::axis_normals, {"axis-normals", kOurs,
        "straight parts are shaded as if they were round"});
    rows.add(&P::tone_smoothing, {"tone-smoothing", {0, 100}, kOurs,
        "rounds in which the light is averaged with its neighbours'", {0, 8}});
    rows.add(&P::crease_rad, {"crease-angle", degrees(0, 180), kOurs,
        "edges that are sharper are creases", {10, 120}});
    rows.add(&P::silhouette_mm, {"silhouette", mm(0, 50), kOurs,
        "width of lines against the background; 0: none", {0, 1.2}});
    rows.add(&P::contour_mm, {"contour", mm(0, 50), kOurs,
        "width of lines where a surface turns away; 0: none", {0, 1.2}});
    rows.add(&P::border_mm, {"border", mm(0, 50), kOurs,
        "width of lines between parts; 0: none", {0, 1.2}});
    rows.add(&P::crease_mm, {"crease", mm(0, 50), kOurs,
        "width of lines along creases; 0: none", {0, 1.2}});
    rows.add(&P::taper_mm, {"taper", mm(0, 1000), kOurs,
        "length over which lines thin out to points; 0: they don't", {0, 20}});
    rows.add(&P::min_line_mm, {"min-line", mm(0, 1000), kOurs,
        "shorter lines are left out", {0, 6}});
    rows.add(&P::smoothing_px, {"smoothing", {0, 100}, kOurs,
        "how far curves may be from the mesh's own edges, in pixels", {0, 3}});
    rows.add(&P::min_area_px2, {"min-area", {0, 1e6}, kOurs,
        "smaller areas join a neighbour, in square pixels", {0, 200}});
    rows.add(&P::trap_mm, {"trap", mm(0, 10), kOurs,
        "areas run under their neighbours by this, against seams", {0, 0.4}});
    rows.add(&P::fade, {"fade", {0, 1}, kOurs,
        "how far parts at the back turn to the colour of the paper"});
    rows.add(&P::bark_mm, {"bark", mm(0, 1000), kOurs,
        "spacing of bark strokes; 0: none", {0, 12}});
    rows.add(&P::bark_tile, {"bark-tile", kOurs,
        "bark drawn after a tile instead: a name (bark-furrowed) or an SVG file; empty: none"});
    rows.add(&P::bark_scale, {"bark-scale", {0.01, 100}, kOurs,
        "size of the bark tile: 1 is as large as drawn", {0.4, 2}});
    rows.add(&P::bark_width, {"bark-width", {0, 10}, kOurs,
        "width of the tile's strokes: 1 is as wide as drawn", {0.5, 2}});
    rows.add(&P::bark_shade, {"bark-shade", {0, 1}, kOurs,
        "how far the tile's strokes gather in the shade"});
    // clang-format on
    std::vector<Parameter> all = camera_rows();
    std::ranges::move(rows.take(), std::back_inserter(all));
    return all;
}

}  // namespace edaha
