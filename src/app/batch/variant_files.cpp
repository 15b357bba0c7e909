// SPDX-License-Identifier: MIT
#include "app/batch/variant_files.h"

#include <algorithm>
#include <filesystem>

#include <fmt/core.h>

#include "app/batch/present_file.h"
#include "app/overlap.h"
#include "base/error.h"
#include "drawing/statistics.h"

namespace edaha {
namespace {

namespace fs = std::filesystem;

// Captions are quieter than the trees: like their wood, or on dark paper nearly white.
Colour caption_ink(const Palette& palette) {
    constexpr Colour kWhite{0xff, 0xff, 0xff};
    const Colour paper = palette.paper;
    const bool dark = paper.r + paper.g + paper.b < 3 * 0x80;
    return dark ? mixed(paper, kWhite, 0.7) : mixed(paper, palette.wood, 0.9);
}

void append(std::vector<std::string>& texts, const std::vector<std::string>& more) {
    for (const std::string& text : more)
        if (std::ranges::count(texts, text) == 0) texts.push_back(text);
}

SheetTile tile_of(Drawing&& drawing, const Style& style, std::size_t index) {
    const Palette& palette = style.palette;
    SheetTile tile{{}, palette.paper, caption_ink(palette)};
    tile.tile.drawing = std::move(drawing);
    tile.tile.id = fmt::format("tree-{:04}", index + 1);
    tile.tile.caption = fmt::format("{} {:04}", style.name, style.energy.variant.seed);
    return tile;
}

}  // namespace

void make_folders(const std::string& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    // A name that ends in / is made, but counts as not made.
    if (!fs::is_directory(folder)) {
        if (!error) error = std::make_error_code(std::errc::not_a_directory);
        throw IoError(fmt::format("cannot make the folder '{}': {}", folder, error.message()));
    }
}

VariantFiles::Wanted VariantFiles::look_at(const std::string& variant, Format format,
                                           const std::string& recipe) const {
    Wanted wanted;
    wanted.format = format;
    wanted.row.file = variant + '.' + std::string(name(format));
    wanted.row.recipe = recipe;
    const std::string path = path_of(wanted.row);
    wanted.right = params_.resume && has_recipe({path, format, params_.force}, recipe);
    if (!wanted.right) return wanted;
    wanted.row.bytes = fs::file_size(path);
    if (auto known = journal_.find(wanted.row.file, recipe)) {
        wanted.row = std::move(*known);
        wanted.measured = true;
    }
    return wanted;
}

// Overlap is that of the solid look, whatever the tree is drawn in.
Measures VariantFiles::measure(const Picture& picture, const Style& style) const {
    Measures measures;
    measures.width_mm = picture.drawing.width_mm;
    measures.height_mm = picture.drawing.height_mm;
    measures.branches = picture.counts.branches;
    measures.leaves = picture.counts.ornaments;
    measures.nodes = count(picture.drawing).nodes;
    if (style.look.wood == Look::solid) {
        measures.overlap = overlap_ratio(picture.drawing);
    } else {
        Style solid = style;
        solid.look.wood = Look::solid;
        measures.overlap = overlap_ratio(draw_picture(solid, leaves_.loader()).drawing);
    }
    return measures;
}

void VariantFiles::write(Wanted& file, const Picture& picture, const WriteParams& params,
                         DrawnVariant& drawn) const {
    const std::string path = path_of(file.row);
    if (file.row.file.find('/') != std::string::npos)
        make_folders(fs::path(path).parent_path().string());
    const WriteReport report = write_file(picture.drawing, path, file.format, params);
    file.row.bytes = report.bytes;
    ++drawn.written;
    append(drawn.warnings, warnings(picture, report.svg));
}

DrawnVariant VariantFiles::draw(std::size_t index) const {
    const Variant variant = plan_.variant(index);
    const Style& style = variant.tree.style;
    const WriteParams params = write_params(plan_.write(), style);
    const Metadata metadata = metadata_of(variant.tree, params, leaves_);
    std::vector<Wanted> files;
    for (const Format format : plan_.formats())
        files.push_back(look_at(variant.name, format, metadata.recipe));

    DrawnVariant drawn;
    const bool all_measured = std::ranges::all_of(files, &Wanted::measured);
    if (!all_measured || params_.tiles) {
        Picture picture = draw_picture(style, leaves_.loader());
        picture.drawing.metadata = metadata;
        const Measures measures = all_measured ? Measures{} : measure(picture, style);
        for (Wanted& file : files) {
            if (!file.measured) file.row.measures = measures;
            if (!file.right) write(file, picture, params, drawn);
        }
        if (params_.tiles) drawn.tile = tile_of(std::move(picture.drawing), style, index);
    }
    for (const Wanted& file : files)
        drawn.rows.push_back(row_json(file.row, variant, plan_));
    return drawn;
}

std::string VariantFiles::path_of(const FileRow& row) const {
    return (fs::path(params_.folder) / row.file).string();
}

}  // namespace edaha
