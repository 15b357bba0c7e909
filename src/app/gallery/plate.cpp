// SPDX-License-Identifier: MIT
#include "app/gallery/plate.h"

#include <fmt/format.h>

#include "app/picture_file.h"
#include "app/pipeline.h"
#include "app/version.h"
#include "base/fingerprint.h"
#include "style/value.h"
#include "write/format.h"

namespace edaha {
namespace {

// Sharp in four columns on a page of a code host, and on its screens of two pixels a point in six.
constexpr int kThumbnail_px = 320;

// A strip of the greatest width has 1180 pixels: as wide as such a page.
constexpr double kStripDpi = 120;
constexpr int kPoster_px = 1200;

std::string to_text(const StripParams& params) {
    return fmt::format("strip {} {}", shortest_text(params.tallest_mm),
                       shortest_text(params.caption_mm));
}

std::string to_text(const SheetParams& params) {
    return fmt::format("sheet {} {} {} {}", shortest_text(params.width_mm),
                       shortest_text(params.height_mm), shortest_text(params.caption_mm),
                       params.columns);
}

std::string to_text(const PosterParams& params) {
    return fmt::format("poster {} {} {}", shortest_text(params.width_mm),
                       shortest_text(params.caption_mm), fmt::join(params.rows, " "));
}

std::string to_text(std::monostate) {
    return "alone";
}

PngParams png_params(const Plate& plate) {
    PngParams params;
    params.background = paper_of(plate);
    if (plate.thumbnail_px > 0) {
        params.width_px = plate.thumbnail_px;
    } else if (plate.is_single()) {
        params.width_px = kThumbnail_px;
    } else if (std::holds_alternative<StripParams>(plate.arrangement)) {
        params.dpi = kStripDpi;
    } else {
        params.width_px = kPoster_px;
    }
    return params;
}

std::string fingerprint_of(std::initializer_list<std::string> texts) {
    Fingerprint fingerprint;
    for (const std::string& text : texts)
        fingerprint.add(text);
    return fingerprint.text();
}

std::string png_recipe_of(const std::string& svg_recipe, const PngParams& params) {
    const Colour& paper = *params.background;
    return fingerprint_of({"thumbnail", svg_recipe, std::to_string(params.width_px.value_or(0)),
                           shortest_text(params.dpi),
                           fmt::format("{} {} {}", paper.r, paper.g, paper.b)});
}

Metadata metadata_of_tree(const GalleryTree& tree, LeafShelf& leaves) {
    return metadata_of(tree.tree, WriteParams{}, leaves);
}

// Of several trees: nothing but the gallery draws them again.
Metadata metadata_of_group(const Plate& plate, LeafShelf& leaves) {
    Metadata metadata;
    metadata.title = plate.caption.empty() ? plate.name : to_plain(plate.caption);
    metadata.command = "edaha gallery";
    metadata.version = kVersion;
    Fingerprint recipe;
    recipe.add(kVersion);
    recipe.add(metadata.title);
    recipe.add(std::visit([](const auto& params) { return to_text(params); }, plate.arrangement));
    for (const GalleryTree& tree : plate.trees) {
        recipe.add(tree.caption);
        recipe.add(metadata_of_tree(tree, leaves).recipe);
    }
    metadata.recipe = recipe.text();
    return metadata;
}

Metadata metadata_of_plate(const Plate& plate, LeafShelf& leaves) {
    return plate.is_single() ? metadata_of_tree(plate.trees.front(), leaves)
                             : metadata_of_group(plate, leaves);
}

Drawing arranged(const Plate& plate, const std::vector<Tile>& tiles) {
    if (const auto* params = std::get_if<SheetParams>(&plate.arrangement)) {
        SheetParams on_paper = *params;
        on_paper.colours.paper = paper_of(plate);
        return sheet_page(tiles, on_paper);
    }
    if (const auto* params = std::get_if<PosterParams>(&plate.arrangement)) {
        PosterParams on_paper = *params;
        on_paper.colours.paper = paper_of(plate);
        return poster(tiles, on_paper);
    }
    return strip(tiles, std::get<StripParams>(plate.arrangement));
}

std::string write(const Drawing& drawing, Format format, const WriteParams& params) {
    std::string bytes;
    write_drawing(drawing, format, params, [&](std::string_view piece) { bytes += piece; });
    return bytes;
}

}  // namespace

PlateRecipes recipes_of(const Plate& plate, LeafShelf& leaves) {
    const std::string svg = metadata_of_plate(plate, leaves).recipe;
    return {svg, png_recipe_of(svg, png_params(plate))};
}

PlateFiles draw_plate(const Plate& plate, LeafShelf& leaves) {
    PlateFiles files;
    std::vector<Tile> tiles;
    for (const GalleryTree& tree : plate.trees) {
        Picture picture = draw_picture(tree.tree.style, leaves.loader());
        for (std::string& warning : warnings(picture, {}))
            files.warnings.push_back(std::move(warning));
        tiles.push_back({std::move(picture.drawing),
                         fmt::format("{}-{}", tree.tree.style.name, tiles.size() + 1),
                         tree.caption});
    }
    Drawing drawing = plate.is_single() ? std::move(tiles.front().drawing) : arranged(plate, tiles);
    WriteParams params;
    params.png = png_params(plate);
    drawing.metadata = metadata_of_plate(plate, leaves);
    files.svg = write(drawing, Format::svg, params);
    drawing.metadata.recipe = png_recipe_of(drawing.metadata.recipe, params.png);
    files.png = write(drawing, Format::png, params);
    return files;
}

Colour paper_of(const Plate& plate) {
    const Style& first = plate.trees.front().tree.style;
    // A painted background becomes a card on the strip, which has paper of its own.
    return plate.is_single() || !first.page.background ? first.palette.paper : Palette{}.paper;
}

}  // namespace edaha
