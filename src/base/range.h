// SPDX-License-Identifier: MIT
#pragma once

namespace edaha {

// A closed interval that a value is drawn from, uniformly. low <= high.
struct Range {
    double low = 0;
    double high = 0;
    bool operator==(const Range&) const = default;

    double at(double u) const { return low + (high - low) * u; }
};

}  // namespace edaha
