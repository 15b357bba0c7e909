// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace edaha::test {

// A file of the project: its path from the top folder, with /, and its lines.
struct TextFile {
    std::string path;
    std::vector<std::string> lines;
};

std::vector<std::string> split_lines(std::string_view text);

// The files below these folders whose names end in one of `endings`, sorted by path.
std::vector<TextFile> project_files(const std::vector<std::string>& folders,
                                    const std::vector<std::string>& endings);

}  // namespace edaha::test
