// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "drawing/subpaths.h"
#include "ornament/path_data.h"
#include "ornament/rings.h"
#include "ornament/scan.h"

namespace {

void require(bool holds) {
    if (!holds) std::abort();
}

}  // namespace

// Any text is read or refused within it; what is read is finite, begins with moves, and stays so
// when it is tidied and filled.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace edaha;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        const Path path = read_path_data(text);
        require(path.empty() || path.verbs.front() == Verb::move);
        for (const Vec2 p : path.points)
            require(std::isfinite(p.x) && std::isfinite(p.y));
        const Path tidy = without_short_segments(path, 1e-5);
        for (const bool even_odd : {false, true}) {
            const Path filled = fill_rings(tidy, even_odd).path;
            require(is_closed(filled));
            // A ring turned round may need a line for what was its close.
            const std::size_t rings = subpaths(filled).size();
            require(filled.points.size() <= tidy.points.size() + rings);
        }
    } catch (const SyntaxError& error) {
        require(error.offset() <= size);
    }
    return 0;
}
