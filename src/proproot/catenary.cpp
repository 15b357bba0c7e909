// SPDX-License-Identifier: MIT
#include "proproot/catenary.h"

#include <cmath>

#include "base/stable_math.h"

namespace edaha {
namespace {

double sinh(double t) {
    const double e = stable::exp(t);
    return (e - 1 / e) / 2;
}

double cosh(double t) {
    const double e = stable::exp(t);
    return (e + 1 / e) / 2;
}

// The t >= 0 with cosh(t) = 1 + z.
double inverse_cosh_of_1_plus(double z) {
    return stable::log(1 + z + std::sqrt(z * (2 + z)));
}

double inverse_sinh(double s) {
    const double t = stable::log(std::abs(s) + std::sqrt(s * s + 1));
    return s < 0 ? -t : t;
}

}  // namespace

double Catenary::height(double x) const {
    return a * (cosh((x - apex) / a) - cosh(apex / a)) + b;
}

double Catenary::slope(double x) const {
    return sinh((x - apex) / a);
}

double Catenary::length(double x) const {
    return -a * (sinh((apex - x) / a) - sinh(apex / a));
}

double Catenary::at_length(double along) const {
    return apex - a * inverse_sinh(sinh(apex / a) - along / a);
}

double Catenary::at_height(double y) const {
    const double top = height(apex);
    return apex - a * inverse_cosh_of_1_plus((y - top) / a);
}

Catenary rising_catenary(double a, double b, double rise) {
    return {a, b, -a * inverse_cosh_of_1_plus(-rise / a)};
}

}  // namespace edaha
