// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace edaha::test {

// How far two PNG files are apart, both laid over white paper. Parts of the channels' full range, 0
// to 1, averaged over red, green and blue. Files of different sizes are 1 apart.
struct ImageDifference {
    double mean = 1;        // over the whole picture
    double inked_mean = 1;  // over the pixels that are not paper in at least one of the two
    double worst = 1;       // the pixel that differs most
    double inked = 0;       // share of the pixels that are not paper in at least one of the two
    std::string note;       // "640 x 480 against 640 x 479", or empty
};

ImageDifference compare_images(const std::string& expected_png, const std::string& actual_png);

// Empty where the two are alike: no more than `most` apart, measured by inked_mean. Otherwise says
// how far they are apart, and writes expected | difference | actual, side by side, to `picture`.
std::string image_complaint(const std::string& expected_png, const std::string& actual_png,
                            double most, const std::string& picture);

}  // namespace edaha::test
