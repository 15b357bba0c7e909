// SPDX-License-Identifier: MIT
#include "app/batch/present_file.h"

#include <filesystem>

#include "base/atomic_file.h"
#include "base/error.h"

namespace edaha {
namespace {

// Larger ones are no pictures of ours, or not worth reading to spare drawing.
constexpr std::size_t kMostBytes = std::size_t{1} << 30;

// Files of ours name their program, where they are not packed. An empty one is what a crash of the
// system may leave.
bool may_be_ours(std::string_view bytes) {
    return bytes.empty() || bytes.find("edaha") != std::string_view::npos;
}

}  // namespace

bool has_recipe(const PresentFile& file, const std::string& recipe) {
    std::error_code ignored;
    if (!std::filesystem::exists(file.path, ignored)) return false;
    const std::string bytes = read_file(file.path, kMostBytes);
    const std::string recorded = recorded_recipe(bytes, file.format);
    if (recorded.empty() && !may_be_ours(bytes) && !file.may_be_foreign) {
        throw IoError("'" + file.path + "' is none of edaha's files (--force overwrites it)");
    }
    return recorded == recipe;
}

}  // namespace edaha
