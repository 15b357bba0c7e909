// SPDX-License-Identifier: MIT
#include "drawing/sheet.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "drawing/ink_box.h"
#include "drawing/lettering.h"
#include "drawing/mosaic.h"

namespace edaha {
namespace {

constexpr double kCardPadding_mm = 3;
constexpr double kCaptionDrop = 2.0;   // from the picture to the caption's base line, in capitals
constexpr double kCaptionDepth = 2.6;  // to below its descenders

// What of a tile is drawn, and what it stands on, in its own millimetres.
struct Stand {
    Bounds ink;
    double ground = 0;
    std::optional<Colour> card;
};

std::optional<Colour> colour_of(const Layer& background) {
    const InheritedPaint layer = inherit({}, background.paint);
    if (background.children.empty()) return std::nullopt;
    const auto* shape = std::get_if<Shape>(&background.children[0]);
    return shape == nullptr ? layer.fill : inherit(layer, shape->paint).fill;
}

// The wood stands on the ground by its lowest point, unless a twig hangs even lower.
Stand stand_of(const Drawing& drawing) {
    const InkBoxes boxes(drawing);
    Stand stand;
    Bounds wood, ground;
    for (const Layer& layer : drawing.layers) {
        if (layer.label == kBackgroundLabel) {
            stand.card = colour_of(layer);
            continue;
        }
        const Bounds box = boxes.of(layer);
        stand.ink.include(box);
        if (layer.label == "Wood") wood = box;
        if (layer.label == "Ground") ground = box;
    }
    if (stand.ink.empty()) stand.ink = {{0, 0}, {drawing.width_mm, drawing.height_mm}};
    stand.ground = wood.empty() ? stand.ink.max.y : wood.max.y;
    if (!ground.empty()) stand.ground = std::clamp(stand.ground, ground.min.y, ground.max.y);
    return stand;
}

// The box that has room for each tile, standing on the ground.
struct CommonBox {
    double width = 0, above = 0, below = 0;
    bool cards = false;

    void include(const Stand& stand) {
        width = std::max(width, stand.ink.width());
        above = std::max(above, stand.ground - stand.ink.min.y);
        below = std::max(below, stand.ink.max.y - stand.ground);
        cards |= stand.card.has_value();
    }
    double height() const { return above + below; }
    double padding() const { return cards ? kCardPadding_mm : 0; }
};

std::vector<Stand> stands_of(std::span<const Tile> tiles, CommonBox& common) {
    std::vector<Stand> stands;
    for (const Tile& tile : tiles) {
        stands.push_back(stand_of(tile.drawing));
        common.include(stands.back());
    }
    return stands;
}

Path rectangle(const Bounds& box) {
    Path path;
    path.move_to(box.min);
    path.line_to({box.max.x, box.min.y});
    path.line_to(box.max);
    path.line_to({box.min.x, box.max.y});
    path.close();
    return path;
}

double caption_depth(double caption_mm) {
    return caption_mm * kCaptionDepth;
}

// Fills the three layers of a sheet.
class Composer {
  public:
    struct Page {
        double width_mm, height_mm;
        std::optional<Colour> paper;
        Colour ink;
        double caption_mm;
        bool ids;
    };

    explicit Composer(const Page& page) : page_(page), mosaic_(drawing_, page.ids) {
        drawing_.width_mm = page.width_mm;
        drawing_.height_mm = page.height_mm;
        captions_.paint.stroke = page.ink;
        captions_.paint.stroke_width_mm = lettering_pen_mm(page.caption_mm);
        for (const char* taken : {"Paper", "Pictures", "Captions"})
            mosaic_.unique(taken);
    }

    // `cell` is the picture's; the caption goes beneath.
    void add(const Tile& tile, const Stand& stand, const Bounds& cell, double ground_mm,
             double scale) {
        const Vec2 foot(stand.ink.centre().x, stand.ground);
        const Vec2 offset = Vec2(cell.centre().x, ground_mm) - foot * scale;
        std::vector<Element> card;
        if (stand.card) {
            Paint paint;
            paint.fill = *stand.card;
            card.emplace_back(Shape{"", rectangle(cell), paint});
        }
        pictures_.children.emplace_back(mosaic_.group_of(tile, scale, offset, std::move(card)));
        write(tile.caption, {cell.centre().x, cell.max.y + page_.caption_mm * kCaptionDrop},
              LetteringParams::Anchor::middle, cell.width());
    }

    void write(const std::string& text, Vec2 at, LetteringParams::Anchor anchor, double most_mm) {
        if (!(page_.caption_mm > 0)) return;
        const double width = lettering_width_mm(text, page_.caption_mm);
        const double smaller = width > most_mm ? most_mm / width : 1;
        Path path = lettering(text, {page_.caption_mm * smaller, anchor, at});
        if (path.empty()) return;
        Shape shape{"", std::move(path), {}};
        if (smaller < 1) shape.paint.stroke_width_mm = captions_.paint.stroke_width_mm * smaller;
        captions_.children.emplace_back(std::move(shape));
    }

    Drawing finish() {
        if (page_.paper) {
            Layer paper{"Paper", {}, {}};
            paper.paint.fill = *page_.paper;
            const Bounds whole{{0, 0}, {page_.width_mm, page_.height_mm}};
            paper.children.emplace_back(Shape{"", rectangle(whole), {}});
            drawing_.layers.push_back(std::move(paper));
        }
        for (Layer* layer : {&pictures_, &captions_}) {
            if (!layer->children.empty()) drawing_.layers.push_back(std::move(*layer));
        }
        return std::move(drawing_);
    }

  private:
    Page page_;
    Drawing drawing_;
    Mosaic mosaic_;
    Layer pictures_{"Pictures", {}, {}};
    Layer captions_{"Captions", {}, {}};
};

// The cells of a contact sheet.
struct Grid {
    explicit Grid(const SheetParams& params) : params_(params) {
        const bool headed = !params.heading.empty() || params.pages > 1;
        const double capital = params.caption_mm;
        top = params.margin_mm + (headed ? capital + params.gap_mm : 0);
        width = (params.width_mm - 2 * params.margin_mm + params.gap_mm) / params.columns -
                params.gap_mm;
        pitch = (params.height_mm - top - params.margin_mm + params.gap_mm) / params.rows;
        height = pitch - params.gap_mm - caption_depth(capital);
        assert(width >= 1 && height >= 1);
    }

    double scale(const CommonBox& common) const {
        const double pad = 2 * common.padding();
        const double most =
            params_.most_scale > 0 ? params_.most_scale : std::numeric_limits<double>::infinity();
        return std::min({(width - pad) / common.width, (height - pad) / common.height(), most});
    }

    Bounds cell(std::size_t index) const {
        const auto columns = static_cast<std::size_t>(params_.columns);
        const std::size_t row = index / columns, column = index % columns;
        const Vec2 corner(
            params_.margin_mm + static_cast<double>(column) * (width + params_.gap_mm),
            top + static_cast<double>(row) * pitch);
        return {corner, corner + Vec2(width, height)};
    }

    double top, width, height, pitch;

  private:
    const SheetParams& params_;
};

void add_heading(Composer& composer, const SheetParams& params) {
    using Anchor = LetteringParams::Anchor;
    const double line = params.margin_mm + params.caption_mm;
    const double right = params.width_mm - params.margin_mm;
    const double room = (right - params.margin_mm) / 2;
    composer.write(params.heading, {params.margin_mm, line}, Anchor::start, room);
    if (params.pages <= 1) return;
    composer.write(fmt::format("{} / {}", params.page, params.pages), {right, line}, Anchor::end,
                   room);
}

// The widths of a strip's cells at a scale: a picture's, or its caption's where that is wider.
std::vector<double> cell_widths(std::span<const Tile> tiles, std::span<const Stand> stands,
                                const StripParams& params, double padding, double scale) {
    std::vector<double> widths;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        widths.push_back(std::max(stands[i].ink.width() * scale + 2 * padding,
                                  lettering_width_mm(tiles[i].caption, params.caption_mm)));
    }
    return widths;
}

// Up to what a file says of a page's size.
double hundredths(double mm) {
    return std::ceil(mm * 100 - 1e-6) / 100;
}

double sum(std::span<const double> numbers) {
    double total = 0;
    for (const double number : numbers)
        total += number;
    return total;
}

}  // namespace

double sheet_scale(std::span<const Tile> tiles, const SheetParams& params) {
    CommonBox common;
    stands_of(tiles, common);
    return Grid(params).scale(common);
}

Drawing sheet_page(std::span<const Tile> tiles, const SheetParams& params) {
    assert(tiles.size() <= static_cast<std::size_t>(params.columns * params.rows));
    CommonBox common;
    const std::vector<Stand> stands = stands_of(tiles, common);
    const Grid grid(params);
    const double scale = grid.scale(common);
    Composer composer({params.width_mm, params.height_mm, params.colours.paper, params.colours.ink,
                       params.caption_mm, true});
    add_heading(composer, params);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const Bounds cell = grid.cell(i);
        const double ground = cell.max.y - common.padding() - common.below * scale;
        composer.add(tiles[i], stands[i], cell, ground, scale);
    }
    return composer.finish();
}

Drawing strip(std::span<const Tile> tiles, const StripParams& params) {
    CommonBox common;
    const std::vector<Stand> stands = stands_of(tiles, common);
    const double pad = common.padding();
    const double gaps = params.gap_mm * static_cast<double>(tiles.empty() ? 0 : tiles.size() - 1);
    double drawn = 0;
    for (const Stand& stand : stands)
        drawn += stand.ink.width();
    const double room = params.most_width_mm - 2 * params.margin_mm - gaps -
                        2 * pad * static_cast<double>(tiles.size());
    const double scale =
        tiles.empty() ? 1 : std::min(params.tallest_mm / common.height(), room / drawn);
    const std::vector<double> widths = cell_widths(tiles, stands, params, pad, scale);
    const double height = common.height() * scale + 2 * pad;
    Composer composer({hundredths(sum(widths) + gaps + 2 * params.margin_mm),
                       hundredths(height + caption_depth(params.caption_mm) + 2 * params.margin_mm),
                       params.paper, params.ink, params.caption_mm, params.ids});
    double left = params.margin_mm;
    const double ground = params.margin_mm + pad + common.above * scale;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const Vec2 corner(left, params.margin_mm);
        composer.add(tiles[i], stands[i], {corner, corner + Vec2(widths[i], height)}, ground,
                     scale);
        left += widths[i] + params.gap_mm;
    }
    return composer.finish();
}

namespace {

// One of a poster's rows.
struct PosterRow {
    std::span<const Tile> tiles;
    std::vector<Stand> stands;
    CommonBox box;
    double drawn_mm = 0;  // all its pictures' widths

    PosterRow(std::span<const Tile> of_row) : tiles(of_row) {
        stands = stands_of(tiles, box);
        for (const Stand& stand : stands)
            drawn_mm += stand.ink.width();
    }

    double count() const { return static_cast<double>(tiles.size()); }
    double height(double scale, double caption_mm) const {
        return box.height() * scale + caption_depth(caption_mm);
    }

    void add_to(Composer& composer, double scale, Vec2 corner, double room) const {
        constexpr double kCaption = 0.9;  // of the way to the next picture's
        const double gap = (room - drawn_mm * scale) / count();
        double left = corner.x;
        for (std::size_t i = 0; i < tiles.size(); ++i) {
            const double share = stands[i].ink.width() * scale + gap;
            const double rim = share * (1 - kCaption) / 2;
            const Bounds cell{{left + rim, corner.y},
                              {left + share - rim, corner.y + box.height() * scale}};
            composer.add(tiles[i], stands[i], cell, corner.y + box.above * scale, scale);
            left += share;
        }
    }
};

}  // namespace

Drawing poster(std::span<const Tile> tiles, const PosterParams& params) {
    const double room = params.width_mm - 2 * params.margin_mm;
    std::vector<PosterRow> rows;
    double scale = std::numeric_limits<double>::infinity();
    for (std::size_t first = 0; const std::size_t count : params.rows) {
        const PosterRow& row = rows.emplace_back(tiles.subspan(first, count));
        scale = std::min(scale, (room - params.gap_mm * row.count()) / row.drawn_mm);
        first += count;
    }
    double height = 2 * params.margin_mm - params.gap_mm;
    for (const PosterRow& row : rows)
        height += row.height(scale, params.caption_mm) + params.gap_mm;
    Composer composer({params.width_mm, hundredths(height), params.colours.paper,
                       params.colours.ink, params.caption_mm, true});
    Vec2 corner(params.margin_mm, params.margin_mm);
    for (const PosterRow& row : rows) {
        row.add_to(composer, scale, corner, room);
        corner.y += row.height(scale, params.caption_mm) + params.gap_mm;
    }
    return composer.finish();
}

}  // namespace edaha
