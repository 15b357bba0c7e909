// SPDX-License-Identifier: MIT
#pragma once
#include <string_view>

#include <pugixml.hpp>

#include "geometry/path.h"
#include "ornament/report.h"

namespace edaha::svg {

// What percentages are of: the drawing's view box.
struct Viewport {
    Vec2 size{100};
};

enum class Axis { x, y, other };  // `other` (radii) is measured by the diagonal / sqrt 2

// A length attribute in user units; `otherwise` if it is missing, or "auto". Wrong ones are
// errors; percentages, which a leaf without a page cannot keep, are warnings.
class LengthReader {
  public:
    LengthReader(const Viewport& viewport, Report& report) : viewport_(viewport), report_(report) {}
    double read(pugi::xml_node node, const char* attribute, Axis axis, double otherwise = 0) const;
    double read_size(pugi::xml_node node, const char* attribute, Axis axis,
                     double otherwise = 0) const;  // not negative
    Report& report() const { return report_; }

  private:
    Viewport viewport_;
    Report& report_;
};

// The outline of a path or basic shape (SVG 1.1, 8 and 9) in its own user units; circles and
// rounded corners are cubics (arc.h). A shape without size is a lone move to its centre, which
// draws nothing but has a place. Wrong values are errors, and give an empty path.
Path read_geometry(pugi::xml_node node, std::string_view element, const LengthReader& lengths);

}  // namespace edaha::svg
