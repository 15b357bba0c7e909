// SPDX-License-Identifier: MIT
#include "app/mesh_file.h"

#include <algorithm>
#include <filesystem>

#include <fmt/core.h>

#include "app/options.h"
#include "base/atomic_file.h"
#include "base/fingerprint.h"
#include "mesh/obj.h"
#include "mesh/ply.h"
#include "style/value.h"

namespace edaha {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = std::size_t{4} << 30;
constexpr std::size_t kMostMaterialBytes = std::size_t{16} << 20;

// Exporters write whole paths of the computer that they ran on.
std::string file_name(const std::string& path) {
    return path.substr(path.find_last_of("/\\") + 1);
}

}  // namespace

std::optional<MeshFormat> mesh_format_of_file(const std::string& file) {
    std::string ending = fs::path(file).extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    if (ending == ".obj") return MeshFormat::obj;
    if (ending == ".ply") return MeshFormat::ply;
    return std::nullopt;
}

MeshFile read_mesh_file(const std::string& file) {
    const std::optional<MeshFormat> format = mesh_format_of_file(file);
    if (!format) {
        throw UsageError(
            fmt::format("the ending of {} is no mesh (expected obj or ply)", in_quotes(file)));
    }
    const std::string bytes = read_file(file, kMostBytes);
    Fingerprint fingerprint;
    fingerprint.add(bytes);
    const LoadMaterials load = [&](const std::string& name) -> std::optional<std::string> {
        const fs::path path = fs::path(file).parent_path() / file_name(name);
        std::error_code ignored;
        if (!fs::is_regular_file(path, ignored)) return std::nullopt;
        std::string text = read_file(path.string(), kMostMaterialBytes);
        fingerprint.add(text);
        return text;
    };
    MeshFile result;
    const bool is_ply = *format == MeshFormat::ply || bytes.starts_with("ply\n");
    result.input = is_ply ? read_ply(bytes, file) : read_obj(bytes, file, {}, load);
    result.fingerprint = fingerprint.text();
    return result;
}

}  // namespace edaha
