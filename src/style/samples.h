// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "style/parameter.h"

namespace edaha {

// The interval that sliders and samples run over: Parameter::usual, else the limits where they are
// narrow (a part, 0 to 1). Equal ends: there is nothing to run over.
Range usual_range(const Parameter& parameter);

// Values that show what a parameter does, in order, as assign() reads them: five for numbers, in
// even steps, or by even factors where the usual range spans a factor of eight; for ranges five
// that follow each other, or, where they lie round zero, widen; lists by order hold one number; no
// and yes; each name of a choice; five of the built-in drawings. None for colours, and where there
// is no usual range.
std::vector<std::string> samples(const Parameter& parameter);

}  // namespace edaha
