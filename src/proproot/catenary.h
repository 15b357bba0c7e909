// SPDX-License-Identifier: MIT
#pragma once

namespace edaha {

// An inverted catenary in an upright plane: heights over the horizontal distance x >= 0 from the
// root's branching point at height b,
//   y(x) = a cosh((x - apex) / a) - a cosh(apex / a) + b,   a < 0.
// With apex = 0 it is Sato's (3.5). An apex beyond the branching point makes it rise at first.
struct Catenary {
    double a = -200;
    double b = 40;
    double apex = 0;  // its x, >= 0

    double height(double x) const;
    double slope(double x) const;          // dy / dx
    double length(double x) const;         // of the curve, from the branching point
    double at_length(double along) const;  // the x there
    double at_height(double y) const;      // the x there, beyond the apex; y below the apex
};

// The catenary that rises by `rise` above its branching point before it falls.
Catenary rising_catenary(double a, double b, double rise);

}  // namespace edaha
