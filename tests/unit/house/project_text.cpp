// SPDX-License-Identifier: MIT
#include "unit/house/project_text.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace edaha::test {
namespace {

namespace fs = std::filesystem;

std::string read_text(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

std::vector<std::string> split_lines(std::string_view text) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

std::vector<TextFile> project_files(const std::vector<std::string>& folders,
                                    const std::vector<std::string>& endings) {
    const fs::path top = PROJECT_DIR;
    std::vector<TextFile> files;
    for (const std::string& folder : folders) {
        for (const auto& entry : fs::recursive_directory_iterator(top / folder)) {
            const std::string name = entry.path().filename().string();
            const auto ends = [&](const std::string& ending) { return name.ends_with(ending); };
            if (!entry.is_regular_file() || std::ranges::none_of(endings, ends)) continue;
            files.push_back({entry.path().lexically_relative(top).generic_string(),
                             split_lines(read_text(entry.path()))});
        }
    }
    std::ranges::sort(files, {}, &TextFile::path);
    return files;
}

}  // namespace edaha::test
