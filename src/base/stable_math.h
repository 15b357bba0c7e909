// SPDX-License-Identifier: MIT
#pragma once

namespace edaha {

// Elementary functions whose results are the same bits on every machine: the system's may differ
// in the last place from one processor to the next (it chooses among variants at run time), and a
// choice between two candidates may hang on that. Only + - * / and sqrt are used, which IEEE 754
// fixes. Errors are within 4 units in the last place over the stated domains.
namespace stable {

struct SinCos {
    double sin, cos;
};

SinCos sin_cos(double x);          // |x| <= 1e5
double exp(double x);              // -700 <= x <= 700
double log(double x);              // x > 0, normal
double pow(double x, double y);    // x > 0
double normal_cdf(double z);       // Phi; |z| > 8 gives 0 or 1; absolute error 1e-15
double normal_quantile(double u);  // Phi^-1; 0 < u < 1; error 1e-9
double atan2(double y, double x);  // (-pi, pi]; 0 for (0, 0)

}  // namespace stable
}  // namespace edaha
