// SPDX-License-Identifier: MIT
#include "drawing/inherit.h"

#include <gtest/gtest.h>

namespace edaha {
namespace {

constexpr Colour kRed{255, 0, 0}, kBlue{0, 0, 255};

Paint painted(Ink fill, float opacity = 1) {
    Paint paint;
    paint.fill = fill;
    paint.fill_opacity = opacity;
    return paint;
}

TEST(Inherit, TheRootDrawsNothing) {
    const InheritedPaint paint = inherit({}, {});
    EXPECT_FALSE(paint.fill);
    EXPECT_FALSE(paint.stroke);
}

TEST(Inherit, UnsetIsTheParents) {
    Paint pen = painted(kRed, 0.5f);
    pen.stroke = kBlue;
    pen.stroke_width_mm = 2;
    const InheritedPaint parent = inherit({}, pen);
    EXPECT_EQ(inherit(parent, {}), parent);
    EXPECT_EQ(parent.stroke_width_mm, 2);
}

TEST(Inherit, NoneStopsTheParents) {
    const InheritedPaint parent = inherit({}, painted(kRed));
    EXPECT_FALSE(inherit(parent, painted(Ink::none())).fill);
}

TEST(Inherit, AnOpacityBelongsToItsInk) {
    const InheritedPaint parent = inherit({}, painted(kRed, 0.5f));
    EXPECT_EQ(inherit(parent, painted(kBlue)).fill_opacity, 1);
    EXPECT_EQ(inherit(parent, painted(Ink())).fill_opacity, 0.5f);
    EXPECT_EQ(inherit(parent, painted(Ink(), 0.25f)).fill_opacity, 0.25f);  // not 0.125
}

TEST(Inherit, DashesBelongToTheirInk) {
    Paint pen;
    pen.stroke = kRed;
    pen.dash_mm = 2;
    const InheritedPaint parent = inherit({}, pen);
    EXPECT_EQ(inherit(parent, {}).dash_mm, 2);
    Paint solid, finer;
    solid.stroke = kBlue;
    finer.dash_mm = 1;
    EXPECT_EQ(inherit(parent, solid).dash_mm, 0);
    EXPECT_EQ(inherit(parent, finer).dash_mm, 1);
}

}  // namespace
}  // namespace edaha
