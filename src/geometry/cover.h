// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/bezier.h"
#include "geometry/planar_map.h"

namespace edaha {

// A cubic or line of an input path, cut into chords.
struct SourceCurve {
    Cubic cubic;
    bool straight = false;
    std::uint32_t first_chord = 0, chords = 0;
};

// A subpath of an input path, closed: chords first..end follow each other round it.
struct SourceRing {
    std::uint32_t path = 0;
    std::uint32_t first_chord = 0, end_chord = 0;
};

// Paths as chords on a grid, each with where it comes from.
struct Chords {
    double grid = 1;  // grid step in the paths' units
    std::vector<GridSegment> segments;
    std::vector<std::uint32_t> curve_of;  // a chord
    std::vector<std::uint32_t> ring_of;   // a chord
    std::vector<SourceCurve> curves;
    std::vector<SourceRing> rings;
};

// The plane divided by the outlines of paths; a face is covered (label 1) if at least one path
// winds round it (non-zero rule for each path by itself).
struct Cover {
    Chords chords;
    Arrangement arrangement;  // without nodes and edges: those are the map's
    PlanarMap map;
    std::vector<std::uint32_t> covered;  // a face: 0 or 1
};

struct CoverParams {
    double tolerance = 0.01;  // of chords against curves
    double grid = 0.0;        // grid step, doubled until the paths fit the grid's limits
};

// Subpaths count as closed. Paths are taken in the order of their points, so that the order in
// which they are given doesn't matter.
Cover cover_plane(std::span<const Path> paths, const CoverParams& params);

// Where on a source ring a place counted in chords lies; laps beyond the first chord or the last
// are counted on. At a corner between two curves it is the one that a run in this direction enters.
struct CurvePlace {
    std::uint32_t curve = 0;
    double first = 0;  // the place of the curve's start on the same lap
    double t = 0;      // the curve's parameter
};
CurvePlace curve_place(const Chords& chords, std::uint32_t ring, double place, bool forward);

// How far along the chord a node of it lies, 0 at its start to 1 at its end.
double fraction_at(const GridSegment& chord, GridPoint node);

}  // namespace edaha
