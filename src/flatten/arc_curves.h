// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "flatten/runs.h"
#include "flatten/smooth_line.h"

namespace edaha {

// A stretch of a run's curve, in pieces from its start with fractions: from 1.5 to 3 is the second
// half of piece 1 and all of piece 2. Backwards if from > to.
struct CurveSpan {
    std::uint32_t run = kNone;
    double from = 0, to = 0;
};

// Every arc of a map as a curve, in pixels.
struct ArcCurves {
    struct RunCurve {
        std::vector<CurvePiece> pieces;
        bool closed = false;
    };
    std::vector<RunCurve> runs;
    std::vector<CurveSpan> span_of;  // an arc, run forward; run kNone if it vanished

    CurveSpan span(ArcUse use) const {
        const CurveSpan s = span_of[use.arc];
        return use.forward ? s : CurveSpan{s.run, s.to, s.from};
    }
};

struct FitParams {
    double steps_per_px = 2048;
    std::span<const float> width{};  // a half-edge: pixels; SeenRegions::width
    SmoothParams smooth;
};

// Each run fitted once, nowhere further from the map than a share of the narrowest region beside
// it: its two sides don't cross. At a node that a run passes through, arcs of other runs end
// exactly on its curve, which is cut there without changing its shape: what meets in the map meets
// in the drawing, and both sides of an arc use the same curve. Parallel over runs; a microsecond a
// pixel of curved line.
ArcCurves fit_arcs(const ArcGraph& graph, const RunSet& runs, const FitParams& params);

// The pieces of spans that follow each other, those of one run and direction joined where one goes
// on where another ends. Ends of joined pieces are equal bit by bit.
std::vector<CurvePiece> pieces_along(const ArcCurves& curves, std::span<const CurveSpan> spans);

// Spans of one run that go on where the last one ends are one.
std::vector<CurveSpan> joined(std::span<const CurveSpan> spans);

// Adds the way along the pieces to a path on the page; it starts a subpath where none is open.
// Pieces below a thousandth of a pixel are left out.
void append_pieces(Path& path, std::span<const CurvePiece> pieces, const Affine& page_from_px);

}  // namespace edaha
