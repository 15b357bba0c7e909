// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/pipeline.h"
#include "write/format.h"

namespace edaha::test {

// A test for each built-in style: the parameter is its name.
class EveryStyle : public testing::TestWithParam<std::string> {};

// The figures of surface growth take seconds each and differ in numbers alone: one stands for all.
std::vector<std::string> built_in_styles();

bool grows_surface(const std::string& style);

// "paper/energy-a-100-plain" as gtest takes it: paper_energy_a_100_plain.
std::string style_test_name(const testing::TestParamInfo<std::string>& info);

// 1 to `last`, or to $EDAHA_SEEDS. Of trees whose surface grows, which takes seconds, the first.
std::vector<std::uint64_t> seeds(const std::string& style, std::size_t last = 20);

// A built-in style's picture, and any picture in a format.
Picture draw_tree(const std::string& style, std::uint64_t seed);
std::string in_format(const Drawing& drawing, Format format);

}  // namespace edaha::test
