// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "drawing/check.h"
#include "ornament/leaf.h"

namespace {

// The drawing's contract, for a leaf used as placement uses it, in the middle of a page large
// enough: what it reaches is not the reader's matter.
bool is_sound(const edaha::Leaf& leaf) {
    using namespace edaha;
    double reach = 0;
    for (const double side : {leaf.box.min.x, leaf.box.min.y, leaf.box.max.x, leaf.box.max.y}) {
        reach = std::max(reach, 2 * std::abs(side) + 1);
    }
    Drawing drawing;
    drawing.width_mm = drawing.height_mm = 2 * reach;
    drawing.symbols.push_back({"leaf", leaf.shapes});
    Use use;
    use.page_from_symbol = Affine(1, 0, 0, 1, reach, reach);
    use.paint.fill = use.paint.stroke = Colour{};
    use.paint.stroke_width_mm = 1;
    drawing.layers.emplace_back().label = "Leaves";
    drawing.layers.back().children.emplace_back(use);
    const std::vector<std::string> breaches = check(drawing);
    for (const std::string& breach : breaches)
        std::fprintf(stderr, "%s\n", breach.c_str());
    return breaches.empty();
}

}  // namespace

// Any text is refused by InputError or gives a leaf that keeps the contract and is as long as all.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace edaha;
    try {
        const LeafImport import =
            read_leaf({reinterpret_cast<const char*>(data), size}, "leaf.svg");
        if (import.leaf.shapes.empty() || !is_sound(import.leaf)) std::abort();
    } catch (const InputError& error) {
        if (error.problems().empty()) std::abort();
    }
    return 0;
}
