// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace edaha::test {

// A picture as the two kinds of bytes that are compared.
struct Rendering {
    std::string svg;
    std::string png;
};

// A folder of NAME.svg and NAME.png.
class GoldenFolder {
  public:
    explicit GoldenFolder(std::string path) : path_(std::move(path)) {}

    // Empty where the picture is as expected: the SVG to the byte, the pixels but for rounding.
    // Otherwise says how they differ, and leaves in the folder `evidence` the SVG and
    // expected | difference | actual side by side.
    std::string complaint(const std::string& name, const Rendering& actual,
                          const std::string& evidence) const;

    // Makes this what is expected.
    void bless(const std::string& name, const Rendering& actual) const;

  private:
    std::string file(const std::string& name, const char* ending) const;

    std::string path_;
};

}  // namespace edaha::test
