// SPDX-License-Identifier: MIT
#pragma once
#include "flatten/labelled_map.h"

namespace edaha {

// The map without regions (faces of one label that hang together) that are too small or too thin
// to be drawn: each joins the neighbour with which it has the longest border, the smallest first.
// What hangs on something that is seen stays: only specks that stand alone join the background.
// Small holes in which that shows vanish like other regions.
// Too thin is what is narrower than a fifth of a pixel and not mostly against the background, where
// it would be a twig. Borders and silhouettes round what vanished are lines no longer.
// Expected O(E log E).
LabelledMap absorb_small_regions(LabelledMap map, double min_area_px2);

// The map with fewer lines inside its regions: what lines cut out of a region and is too small to
// be seen, or narrower than the lines themselves, joins the piece beside it, and the line between
// them goes. The teeth of a mesh's contours vanish like that. Labels stay. Expected O(E log E).
LabelledMap erase_crowded_lines(LabelledMap map, double min_area_px2, double line_px);

}  // namespace edaha
