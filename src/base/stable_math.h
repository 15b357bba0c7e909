// SPDX-License-Identifier: MIT
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace edaha {

// Elementary functions whose results are the same bits on every machine: the system's may differ
// in the last place from one processor to the next (it chooses among variants at run time), and a
// choice between two candidates may hang on that. Only + - * / and sqrt are used, which IEEE 754
// fixes. Errors are within 4 units in the last place over the stated domains.
namespace stable {

struct SinCos {
    double sin, cos;
};

// The largest whole number <= x, for |x| < 2^62. (std::floor is a call where the processor's own
// instruction may not be used.)
inline std::int64_t floor(double x) {
    const auto whole = static_cast<std::int64_t>(x);
    return whole - (static_cast<double>(whole) > x ? 1 : 0);
}

namespace detail {

// pi/2 as a leading part with trailing zeros (products with small whole numbers are exact) and the
// rest.
inline constexpr double kHalfPiHigh = 0x1.921fb544p+0;
inline constexpr double kHalfPiLow = 0x1.0b4611a626331p-34;

// c[0] + c[1] x + c[2] x^2 + …, even and odd powers side by side: half the wait of Horner's scheme.
template <std::size_t N>
constexpr double polynomial(const double (&c)[N], double x) {
    constexpr std::size_t last_even = (N - 1) / 2 * 2, last_odd = N / 2 * 2 - 1;
    const double q = x * x;
    double even = c[last_even], odd = c[last_odd];
    for (std::size_t i = last_even; i >= 2; i -= 2)
        even = even * q + c[i - 2];
    for (std::size_t i = last_odd; i >= 3; i -= 2)
        odd = odd * q + c[i - 2];
    return even + odd * x;
}

// Taylor series on |x| <= pi/4; the first left-out terms are below 1e-16.
inline double sin_near_zero(double x) {
    constexpr double c[] = {-1.0 / 6,        1.0 / 120,        -1.0 / 5040,         1.0 / 362880,
                            -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000};
    const double q = x * x;
    return x + x * q * polynomial(c, q);
}

inline double cos_near_zero(double x) {
    constexpr double c[] = {
        -1.0 / 2,       1.0 / 24,        -1.0 / 720,         1.0 / 40320,
        -1.0 / 3628800, 1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000};
    const double q = x * x;
    return 1 + q * polynomial(c, q);
}

}  // namespace detail

// |x| <= 1e5. Without a jump or a call, so that a loop of them runs two at a time: headings come
// from all quadrants, and a wrong guess costs more than both series.
inline SinCos sin_cos(double x) {
    // 1.5 * 2^52 pushes the fraction out: what stays are the quarter turns, rounded, in the low
    // bits.
    constexpr double kRounder = 0x1.8p52;
    const double pushed = x * (2 / std::numbers::pi) + kRounder;
    const double turns = pushed - kRounder;
    const auto quarter = std::bit_cast<std::uint64_t>(pushed);
    const double r = (x - turns * detail::kHalfPiHigh) - turns * detail::kHalfPiLow;
    const auto s = std::bit_cast<std::uint64_t>(detail::sin_near_zero(r));
    const auto c = std::bit_cast<std::uint64_t>(detail::cos_near_zero(r));
    const std::uint64_t swapped = (s ^ c) & (0 - (quarter & 1));
    const std::uint64_t sin_sign = (quarter & 2) << 62, cos_sign = ((quarter + 1) & 2) << 62;
    return {std::bit_cast<double>(s ^ swapped ^ sin_sign),
            std::bit_cast<double>(c ^ swapped ^ cos_sign)};
}

double exp(double x);              // -700 <= x <= 700
double log(double x);              // x > 0, normal
double pow(double x, double y);    // x > 0
double normal_cdf(double z);       // Phi; |z| > 8 gives 0 or 1; absolute error 1e-15
double normal_quantile(double u);  // Phi^-1; 0 < u < 1; error 1e-9
double atan2(double y, double x);  // (-pi, pi]; 0 for (0, 0)

}  // namespace stable
}  // namespace edaha
