// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <exception>
#include <functional>

#include "app/batch/variant_files.h"

namespace edaha {

struct RunParams {
    std::size_t variants = 0;
    std::size_t jobs = 1;
    std::function<bool()> stop;  // asked before each variant
};

struct RunReport {
    std::size_t done = 0;      // variants that were taken
    std::exception_ptr error;  // the first in order, if any; null
};

// Draws variants 0 … variants - 1 by many threads and takes them one by one, in order. A few more
// than there are jobs are under way at a time, so memory does not grow with their number. At the
// first error, or when it shall stop, no further one is begun; those under way are finished and
// taken, but for those that failed, and none after `take` itself has failed.
RunReport run_variants(const RunParams& params,
                       const std::function<DrawnVariant(std::size_t)>& draw,
                       const std::function<void(DrawnVariant&&)>& take);

}  // namespace edaha
