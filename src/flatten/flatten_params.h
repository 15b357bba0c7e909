// SPDX-License-Identifier: MIT
#pragma once
#include <numbers>
#include <string>

namespace edaha {

enum class Projection { orthographic, perspective };
enum class FlatLook { fills, lines, fills_lines, tones, facets, blueprint };

// From where a mesh is looked at. Azimuth 0 looks along -z, at the front; growing, the eye walks
// to the right round the y axis. Elevation above the horizon.
struct CameraParams {
    Projection projection = Projection::orthographic;
    double azimuth_rad = 0;
    double elevation_rad = 0;
    double field_of_view_rad = 35 * std::numbers::pi / 180;  // perspective: of the longer side
};

// How a mesh becomes a flat drawing. Lengths in mm of a drawing whose longer side is size_mm.
struct FlattenParams {
    CameraParams camera;
    FlatLook look = FlatLook::tones;
    double size_mm = 200;      // longer side of the drawing
    double mm_per_unit = 0;    // of the mesh's unit, at its middle; 0: as size_mm says
    double resolution = 1000;  // pixels along the longer side: what is much smaller is left out
    int bands = 3;             // tones of one material: 2-4
    double light_azimuth_rad = -50 * std::numbers::pi / 180;  // from the eye's own direction
    double light_elevation_rad = 40 * std::numbers::pi / 180;
    double shade = 0.35;        // n.l below which the darkest band lies
    double shine = 0.8;         // n.l above which the lightest band lies
    bool axis_normals = false;  // tones of parts with an axis: normals point away from that
    double tone_smoothing = 2;  // rounds in which normals are averaged with their neighbours
    double crease_rad = 50 * std::numbers::pi / 180;  // edges sharper than this are lines
    double silhouette_mm = 0.5;                       // widths of lines by kind; 0: not drawn
    double contour_mm = 0.35;
    double border_mm = 0.3;     // between parts
    double crease_mm = 0.2;     // creases, and where surfaces pass through each other
    double taper_mm = 0;        // lines thin out to points over this length: they become fills then
    double min_line_mm = 0.6;   // shorter lines are left out
    double smoothing_px = 0.5;  // how far curves may be from the mesh's own edges
    double min_area_px2 = 2;    // smaller areas join a neighbour
    double trap_mm = 0.08;      // areas run under their neighbours by this, against seams
    double fade = 0;            // how far parts at the back turn to the paper's colour: 0-1
    double bark_mm = 0;         // spacing of plain bark strokes along (u,v); 0: none
    std::string bark_tile;      // bark drawn after a tile instead: its name; empty: none
    double bark_scale = 1;      // of that tile: 1 is as large as drawn
    double bark_width = 1;      // of its strokes
    double bark_shade = 0.6;    // how far strokes gather in the shade: 0-1
};

}  // namespace edaha
