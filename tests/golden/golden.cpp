// SPDX-License-Identifier: MIT
#include "golden/golden.h"

#include <filesystem>
#include <sstream>

#include "support/image_diff.h"
#include "support/run.h"

namespace edaha::test {
namespace {

// Other versions of Cairo may round an edge's shade otherwise.
constexpr double kMostApart = 0.004;

std::string first_difference(const std::string& expected, const std::string& actual) {
    std::istringstream expected_lines(expected), actual_lines(actual);
    std::string a, b;
    for (int number = 1;; ++number) {
        const bool has_a = static_cast<bool>(std::getline(expected_lines, a));
        const bool has_b = static_cast<bool>(std::getline(actual_lines, b));
        if (has_a == has_b && (!has_a || a == b)) {
            if (has_a) continue;
            return "they end otherwise";
        }
        return "line " + std::to_string(number) + "\n  expected: " + (has_a ? a : "the end") +
               "\n  actual:   " + (has_b ? b : "the end");
    }
}

}  // namespace

std::string GoldenFolder::file(const std::string& name, const char* ending) const {
    return path_ + '/' + name + ending;
}

std::string GoldenFolder::complaint(const std::string& name, const Rendering& actual,
                                    const std::string& evidence) const {
    const std::string svg = file(name, ".svg"), png = file(name, ".png");
    if (!std::filesystem::exists(svg) || !std::filesystem::exists(png)) {
        return name + ": nothing is expected yet";
    }
    std::string text;
    if (const std::string expected = read_whole(svg); expected != actual.svg) {
        const std::string kept = evidence + '/' + name + ".svg";
        write_whole(kept, actual.svg);
        text = svg + " against " + kept + ": " + first_difference(expected, actual.svg) + '\n';
    }
    const std::string kept = evidence + '/' + name + ".png";
    write_whole(kept, actual.png);
    return text + image_complaint(png, kept, kMostApart, evidence + '/' + name + "-compared.png");
}

void GoldenFolder::bless(const std::string& name, const Rendering& actual) const {
    std::filesystem::create_directories(path_);
    write_whole(file(name, ".svg"), actual.svg);
    write_whole(file(name, ".png"), actual.png);
}

}  // namespace edaha::test
