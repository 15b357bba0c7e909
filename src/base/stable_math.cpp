// SPDX-License-Identifier: MIT
#include "base/stable_math.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace edaha::stable {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kHalfPi = kPi / 2;
// ln 2 as a leading part with trailing zeros and the rest.
constexpr double kLn2High = 0x1.62e42feep-1;
constexpr double kLn2Low = 0x1.a39ef35793c76p-33;

double power_of_two(int n) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(n + 1023) << 52);
}

// Abramowitz & Stegun 26.2.23: error below 4.5e-4; the lower tail, u <= 1/2.
double quantile_guess(double u) {
    const double t = std::sqrt(-2 * log(u));
    const double above = 2.515517 + t * (0.802853 + t * 0.010328);
    const double below = 1 + t * (1.432788 + t * (0.189269 + t * 0.001308));
    return above / below - t;
}

}  // namespace

double exp(double x) {
    // Taylor series on |r| <= ln 2 / 2; the first left-out term is below 1e-17.
    constexpr double c[] = {1.0 / 2,       1.0 / 6,        1.0 / 24,        1.0 / 120,
                            1.0 / 720,     1.0 / 5040,     1.0 / 40320,     1.0 / 362880,
                            1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800};
    const std::int64_t k = floor(x * (1 / std::numbers::ln2) + 0.5);
    const auto turns = static_cast<double>(k);
    const double r = (x - turns * kLn2High) - turns * kLn2Low;
    return (1 + (r + r * r * detail::polynomial(c, r))) * power_of_two(static_cast<int>(k));
}

double log(double x) {
    // log m = 2 artanh s = 2 s (1 + s^2/3 + s^4/5 + …), |s| <= 0.172.
    constexpr double c[] = {1.0 / 3,  1.0 / 5,  1.0 / 7,  1.0 / 9,  1.0 / 11, 1.0 / 13,
                            1.0 / 15, 1.0 / 17, 1.0 / 19, 1.0 / 21, 1.0 / 23};
    const auto bits = std::bit_cast<std::uint64_t>(x);
    int exponent = static_cast<int>(bits >> 52) - 1022;
    double m = std::bit_cast<double>((bits & 0x000fffffffffffff) | 0x3fe0000000000000);  // 0.5 … 1
    if (m < std::numbers::sqrt2 / 2) m *= 2, --exponent;
    const double s = (m - 1) / (m + 1);
    const double q = s * s;
    return exponent * kLn2High +
           (2 * s + (2 * s * q * detail::polynomial(c, q) + exponent * kLn2Low));
}

double pow(double x, double y) {
    if (y == 0.5) return std::sqrt(x);
    return exp(y * log(x));
}

// Marsaglia, "Evaluating the Normal Distribution" (2004): Phi(z) = 1/2 + phi(z) (z + z^3/3 +
// z^5/(3 5) + …). Stops when a term changes nothing.
double normal_cdf(double z) {
    if (z > 8) return 1;
    if (z < -8) return 0;
    const double q = z * z;
    double sum = z, term = z;
    for (int n = 3;; n += 2) {
        term *= q / n;
        const double next = sum + term;
        if (next == sum) break;
        sum = next;
    }
    return 0.5 + sum * exp(-q / 2) * (std::numbers::inv_sqrtpi / std::numbers::sqrt2);
}

double normal_quantile(double u) {
    const double z = u <= 0.5 ? quantile_guess(u) : -quantile_guess(1 - u);
    // One step of Halley's method: it cubes the error of the guess.
    const double density = exp(-z * z / 2) * (std::numbers::inv_sqrtpi / std::numbers::sqrt2);
    const double error = (normal_cdf(z) - u) / density;
    return z - error / (1 + z * error / 2);
}

double atan2(double y, double x) {
    const double ax = std::abs(x), ay = std::abs(y);
    if (ax == 0 && ay == 0) return 0;
    // One third-order step on sin(angle - a), from a guess within 0.005 rad (Rajan et al. 2006).
    const double ratio = ax < ay ? ax / ay : ay / ax;
    double a = ratio * (kPi / 4 + 0.273 * (1 - ratio));
    if (ax < ay) a = kHalfPi - a;
    const double length = std::sqrt(x * x + y * y);
    for (int step = 0; step < 2; ++step) {
        const auto [s, c] = sin_cos(a);
        const double d = (ay * c - ax * s) / length;
        a += d + d * d * d / 6;
    }
    if (x < 0) a = kPi - a;
    return y < 0 ? -a : a;
}

}  // namespace edaha::stable
