// SPDX-License-Identifier: MIT
#include "style/catalogue.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/nearest_name.h"
#include "style/built_in.h"

namespace edaha {
namespace {

namespace fs = std::filesystem;

// A style has some 150 values; a leaf drawing is limited by its importer, to 8 MB.
constexpr std::size_t kMostStyleBytes = 1'000'000;
constexpr std::size_t kMostLeafBytes = 8'000'000;

// What is searched: one of the two kinds of files.
struct Shelf {
    std::string what;    // "style"
    std::string folder;  // "styles"
    std::string ending;  // ".xml"
    std::size_t most_bytes;
    std::span<const BuiltIn> built_in;
};

Shelf style_shelf() {
    return {"style", "styles", ".xml", kMostStyleBytes, built_in_styles()};
}

Shelf leaf_shelf() {
    return {"leaf", "leaves", ".svg", kMostLeafBytes, built_in_leaves()};
}

bool is_file(const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

// "paper/oak": names, with folders before the last.
bool is_shelf_name(std::string_view text) {
    const std::size_t slash = text.rfind('/');
    if (slash == std::string_view::npos) return is_name(text);
    return is_name(text.substr(slash + 1)) && is_shelf_name(text.substr(0, slash));
}

SourceText read_source(const fs::path& path, const Shelf& shelf) {
    std::error_code ignored;
    if (fs::exists(path, ignored) && !is_file(path)) {
        throw IoError("cannot read '" + path.string() + "': it is not a file");
    }
    return {read_file(path.string(), shelf.most_bytes), path.string(), path.parent_path()};
}

// Where a name or path leads on disk, if it does.
std::optional<fs::path> find_on_disk(const std::string& name, const fs::path& folder,
                                     const fs::path& user_folder, const Shelf& shelf) {
    const fs::path path = folder / name;
    const bool has_slash = name.find('/') != std::string::npos;
    if (name.ends_with(shelf.ending) || (has_slash && is_file(path))) return path;
    if (user_folder.empty() || !is_shelf_name(name)) return std::nullopt;
    fs::path users = user_folder / shelf.folder / (name + shelf.ending);
    return is_file(users) ? std::optional(std::move(users)) : std::nullopt;
}

void add_names_in(const fs::path& folder, const Shelf& shelf, std::vector<std::string>& names) {
    std::error_code error;
    fs::recursive_directory_iterator entry(folder, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
        const fs::path path = entry->path();
        if (path.extension() != shelf.ending || !is_file(path)) continue;
        std::string name = path.lexically_relative(folder).replace_extension().generic_string();
        if (is_shelf_name(name)) names.push_back(std::move(name));
    }
}

std::vector<std::string> names_of(const Shelf& shelf, const fs::path& user_folder) {
    std::vector<std::string> names;
    for (const BuiltIn& file : shelf.built_in)
        names.emplace_back(file.name);
    if (!user_folder.empty()) add_names_in(user_folder / shelf.folder, shelf, names);
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

SourceText find_source(const std::string& name, const fs::path& folder, const fs::path& user_folder,
                       const Shelf& shelf) {
    if (const auto path = find_on_disk(name, folder, user_folder, shelf)) {
        return read_source(*path, shelf);
    }
    const auto found = std::ranges::find(shelf.built_in, name, &BuiltIn::name);
    if (found != shelf.built_in.end()) {
        return {
            std::string(found->text), "built-in " + shelf.folder + '/' + name + shelf.ending, {}};
    }
    std::string message = "there is no " + shelf.what + " '" + name + '\'';
    if (const auto nearest = nearest_name(name, names_of(shelf, user_folder))) {
        message += " (did you mean '" + *nearest + "'?)";
    }
    throw InputError(std::vector<Problem>{Problem{Place{}, std::move(message)}});
}

}  // namespace

Catalogue::Catalogue(fs::path user_folder) : user_folder_(std::move(user_folder)) {}

SourceText Catalogue::find_style(const std::string& name, const fs::path& folder) const {
    return find_source(name, folder, user_folder_, style_shelf());
}

SourceText Catalogue::find_leaf(const std::string& name) const {
    return find_source(name, {}, user_folder_, leaf_shelf());
}

bool Catalogue::has_leaf(const std::string& name) const {
    const Shelf shelf = leaf_shelf();
    if (const auto path = find_on_disk(name, {}, user_folder_, shelf)) return is_file(*path);
    return std::ranges::count(shelf.built_in, name, &BuiltIn::name) > 0;
}

std::vector<std::string> Catalogue::style_names() const {
    return names_of(style_shelf(), user_folder_);
}

std::vector<std::string> Catalogue::leaf_names() const {
    return names_of(leaf_shelf(), user_folder_);
}

std::string resolve_leaf(const std::string& reference, const fs::path& folder) {
    const bool is_path = reference.ends_with(".svg") || reference.find('/') != std::string::npos;
    return is_path && !folder.empty() ? (folder / reference).generic_string() : reference;
}

bool is_name(std::string_view text) {
    if (text.empty() || text.starts_with('-') || text.ends_with('-')) return false;
    return std::ranges::all_of(
        text, [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; });
}

}  // namespace edaha
