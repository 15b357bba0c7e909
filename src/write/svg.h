// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

#include "drawing/drawing.h"
#include "write/sink.h"

namespace edaha {

struct SvgParams {
    static constexpr int kAutomatic = -1;
    int decimals = kAutomatic;  // of coordinates in mm, 0 to 6; automatic: page_decimals()
    bool expand = false;        // instances as shapes of their own, for tools that lose clones
    bool swatches = false;      // the palette as swatches, for Inkscape
    bool compact = false;       // no line breaks, no indentation
};

struct SvgReport {
    std::size_t bytes = 0;
    std::size_t split_paths = 0;      // written as several, for kMostPathNodes
    std::size_t oversized_paths = 0;  // of more nodes than that all the same: one subpath has them
    std::size_t vanished_shapes = 0;  // smaller than the last decimal: not written
};

// The drawing, which keeps its contract, as SVG 1.1 with Inkscape's layers: sizes in mm,
// presentation attributes only, instances as <use> of <symbol>, the metadata as RDF and as
// <edaha:tree> (svg_metadata.h). Paint that a node shares with its parent is not said again.
// Coordinates are rounded, each for itself; matrices and symbols have the decimals that make them
// as exact on the page.
//   With `expand`, the width of a stroke in an instance that is squeezed becomes its mean width.
// Cost: about 2 ns a byte; no more than a path and 64 KB stand in memory. Errors: what `sink`
// throws.
SvgReport write_svg(const Drawing& drawing, const SvgParams& params, const Sink& sink);

// The same, gzipped. `bytes` are the packed ones.
SvgReport write_svgz(const Drawing& drawing, const SvgParams& params, const Sink& sink);

}  // namespace edaha
