// SPDX-License-Identifier: MIT
#include "drawing/sheet.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "drawing/check.h"
#include "drawing/inherit.h"
#include "drawing/ink_box.h"
#include "drawing/lettering.h"
#include "support/sample_drawing.h"

namespace edaha {
namespace {

constexpr double kAlmost_mm = 1e-9;

Path rectangle(double left, double top, double width, double height) {
    Path path;
    path.move_to({left, top}), path.line_to({left + width, top});
    path.line_to({left + width, top + height}), path.line_to({left, top + height}), path.close();
    return path;
}

// A trunk on a ground that reaches `depth` below its foot.
Drawing post(double width, double height, double depth = 0) {
    Drawing drawing;
    drawing.width_mm = width + 20;
    drawing.height_mm = height + depth + 20;
    Layer ground{"Ground", {}, {}}, wood{"Wood", {}, {}};
    ground.paint.fill = Colour{200, 190, 160};
    wood.paint.fill = Colour{90, 70, 60};
    if (depth > 0) {
        ground.children.emplace_back(
            Shape{"mound", rectangle(10, 10 + height - 1, width, depth + 1), {}});
    }
    wood.children.emplace_back(Shape{"trunk", rectangle(10, 10, width, height), {}});
    drawing.layers = {ground, wood};
    return drawing;
}

const Layer& layer_of(const Drawing& drawing, const std::string& label) {
    for (const Layer& layer : drawing.layers) {
        if (layer.label == label) return layer;
    }
    throw std::runtime_error("no layer " + label);
}

std::vector<Group> pictures_of(const Drawing& sheet) {
    std::vector<Group> groups;
    for (const Element& element : layer_of(sheet, "Pictures").children)
        groups.push_back(std::get<Group>(element));
    return groups;
}

// The box of the picture's wood.
Bounds wood_of(const Group& picture) {
    for (const Element& element : picture.children) {
        const auto* layer = std::get_if<Group>(&element);
        if (layer == nullptr || layer->id != picture.id + ".Wood") continue;
        return bounds(std::get<Shape>(layer->children[0]).path);
    }
    return {};
}

// What is drawn, with the paint and the width of the pen on the page: all that a renderer sees.
struct Mark {
    InheritedPaint paint;
    std::size_t points;
};

void collect(const Drawing& drawing, const std::vector<Element>& elements,
             const InheritedPaint& parent, std::vector<Mark>& marks) {
    for (const Element& element : elements) {
        if (const auto* shape = std::get_if<Shape>(&element)) {
            marks.push_back({inherit(parent, shape->paint), shape->path.points.size()});
        } else if (const auto* use = std::get_if<Use>(&element)) {
            const Affine& map = use->page_from_symbol;
            const double area = map[0].x * map[1].y - map[0].y * map[1].x;
            for (const Shape& part : drawing.symbols[use->symbol].shapes) {
                InheritedPaint paint = inherit(inherit(parent, use->paint), part.paint);
                paint.stroke_width_mm *= std::sqrt(std::abs(area));
                marks.push_back({paint, part.path.points.size()});
            }
        } else {
            const auto& group = std::get<Group>(element);
            collect(drawing, group.children, inherit(parent, group.paint), marks);
        }
    }
}

std::vector<Mark> marks_of(const Drawing& drawing, const std::vector<Layer>& layers) {
    std::vector<Mark> marks;
    for (const Layer& layer : layers)
        collect(drawing, layer.children, inherit({}, layer.paint), marks);
    return marks;
}

// One of everything, and a leaf whose vein takes the pen from far above.
Drawing rich_drawing() {
    Drawing drawing = test::sample_drawing();
    drawing.layers.erase(drawing.layers.begin());
    Symbol sprig{"sprig", {{"", rectangle(0, 0, 4, 6), {}}}};
    drawing.symbols.push_back(sprig);
    Layer pens{"Pens", {}, {}};
    pens.paint.stroke = Colour{10, 20, 30};
    pens.paint.stroke_width_mm = 0.4;
    Group group{"bunch", {}, {}};
    group.children.emplace_back(Use{2, Affine(0.5, 0, 0, 0.5, 60, 60), {}});
    group.children.emplace_back(Shape{"line", rectangle(40, 40, 5, 5), {}});
    pens.children.emplace_back(std::move(group));
    drawing.layers.push_back(std::move(pens));
    return drawing;
}

std::vector<Tile> rich_tiles(std::size_t count) {
    std::vector<Tile> tiles;
    for (std::size_t i = 0; i < count; ++i) {
        const std::string number = std::to_string(i + 1);
        tiles.push_back({rich_drawing(), "sample-" + number, "sample " + number});
    }
    return tiles;
}

TEST(Sheet, KeepsTheContract) {
    SheetParams params;
    params.heading = "Samples";
    params.pages = 3;
    EXPECT_EQ(check(sheet_page(rich_tiles(24), params)), std::vector<std::string>{});
    EXPECT_EQ(check(sheet_page(std::vector<Tile>{}, params)), std::vector<std::string>{});
    for (const bool ids : {false, true}) {
        StripParams strip_params;
        strip_params.ids = ids;
        EXPECT_EQ(check(strip(rich_tiles(5), strip_params)), std::vector<std::string>{});
    }
}

TEST(Sheet, PicturesHaveOneScaleAndOneGround) {
    const std::vector<Tile> tiles{{post(10, 100, 5), "a", ""}, {post(60, 40, 20), "b", ""}};
    const SheetParams params;
    const Drawing sheet = sheet_page(tiles, params);
    const auto pictures = pictures_of(sheet);
    ASSERT_EQ(pictures.size(), 2U);
    const Bounds a = wood_of(pictures[0]), b = wood_of(pictures[1]);
    const double scale = sheet_scale(tiles, params);
    EXPECT_NEAR(a.width(), 10 * scale, kAlmost_mm);
    EXPECT_NEAR(a.height(), 100 * scale, kAlmost_mm);
    EXPECT_NEAR(b.width(), 60 * scale, kAlmost_mm);
    EXPECT_NEAR(b.height(), 40 * scale, kAlmost_mm);
    EXPECT_NEAR(a.max.y, b.max.y, kAlmost_mm);
    EXPECT_LT(a.max.x, b.min.x);
}

TEST(Sheet, TheScaleIsTheLargestThatFits) {
    SheetParams params;
    params.columns = params.rows = 1;
    params.caption_mm = 0;
    const std::vector<Tile> wide{{post(500, 10), "a", ""}}, tall{{post(10, 500), "a", ""}};
    EXPECT_NEAR(sheet_scale(wide, params), (297.0 - 24) / 500, 1e-12);
    EXPECT_NEAR(sheet_scale(tall, params), (210.0 - 24) / 500, 1e-12);
    params.most_scale = 0.25;
    EXPECT_EQ(sheet_scale(tall, params), 0.25);
}

TEST(Sheet, CellsFollowInReadingOrder) {
    std::vector<Tile> tiles;
    for (const char* id : {"a", "b", "c", "d", "e"})
        tiles.push_back({post(10, 10), id, ""});
    SheetParams params;
    params.columns = 3;
    params.rows = 2;
    const auto pictures = pictures_of(sheet_page(tiles, params));
    ASSERT_EQ(pictures.size(), 5U);
    for (const std::size_t i : {1U, 2U, 4U})
        EXPECT_LT(wood_of(pictures[i - 1]).max.x, wood_of(pictures[i]).min.x);
    EXPECT_NEAR(wood_of(pictures[0]).min.x, wood_of(pictures[3]).min.x, kAlmost_mm);
    EXPECT_LT(wood_of(pictures[0]).max.y, wood_of(pictures[3]).min.y);
}

TEST(Sheet, PaintIsKept) {
    const std::vector<Tile> tiles = rich_tiles(2);
    const SheetParams params;
    const Drawing sheet = sheet_page(tiles, params);
    const double scale = sheet_scale(tiles, params);
    const Drawing& drawing = tiles[1].drawing;
    const std::vector<Mark> expected = marks_of(drawing, drawing.layers);
    for (const Group& picture : pictures_of(sheet)) {
        std::vector<Mark> marks;
        collect(sheet, {Element(picture)}, {}, marks);
        ASSERT_EQ(marks.size(), expected.size());
        for (std::size_t i = 0; i < marks.size(); ++i) {
            const InheritedPaint &paint = marks[i].paint, &own = expected[i].paint;
            EXPECT_EQ(paint.fill, own.fill);
            EXPECT_EQ(paint.fill_opacity, own.fill_opacity);
            EXPECT_EQ(paint.stroke, own.stroke);
            EXPECT_EQ(paint.stroke_opacity, own.stroke_opacity);
            if (own.stroke) {
                EXPECT_NEAR(paint.stroke_width_mm, own.stroke_width_mm * scale, kAlmost_mm);
            }
            EXPECT_EQ(marks[i].points, expected[i].points);
        }
    }
}

TEST(Sheet, SymbolsThatAreAlikeAreTakenOnce) {
    std::vector<Tile> tiles = rich_tiles(3);
    EXPECT_EQ(sheet_page(tiles, {}).symbols.size(), tiles[0].drawing.symbols.size());
    tiles[1].drawing.symbols[0].shapes[0].path.points[1].x += 0.1;
    const Drawing sheet = sheet_page(tiles, {});
    ASSERT_EQ(sheet.symbols.size(), tiles[0].drawing.symbols.size() + 1);
    EXPECT_EQ(sheet.symbols[0].id, "leaf");
    EXPECT_EQ(sheet.symbols.back().id, "leaf-2");
    EXPECT_EQ(check(sheet), std::vector<std::string>{});
}

TEST(Sheet, IdsBelongToTheirTile) {
    const auto pictures = pictures_of(sheet_page(rich_tiles(2), {}));
    for (const Group& picture : pictures) {
        const auto& wood = std::get<Group>(picture.children[0]);
        EXPECT_EQ(wood.id, picture.id + ".Wood---bark");
        EXPECT_EQ(std::get<Shape>(wood.children[0]).id, picture.id + ".trunk");
    }
    const auto plain = pictures_of(strip(rich_tiles(2), {}));
    EXPECT_EQ(plain[1].id, "sample-2");
    EXPECT_EQ(std::get<Group>(plain[1].children[0]).id, "");
}

TEST(Sheet, ABackgroundBecomesTheCellsCard) {
    Drawing drawing = post(10, 20);
    Layer background{kBackgroundLabel, {}, {}};
    background.paint.fill = Colour{20, 30, 60};
    background.children.emplace_back(
        Shape{"paper", rectangle(0, 0, drawing.width_mm, drawing.height_mm), {}});
    drawing.layers.insert(drawing.layers.begin(), background);
    const std::vector<Tile> tiles{{drawing, "a", ""}, {post(10, 20), "b", ""}};
    const auto pictures = pictures_of(sheet_page(tiles, {}));
    ASSERT_EQ(pictures[0].children.size(), 2U);
    const auto& card = std::get<Shape>(pictures[0].children[0]);
    EXPECT_EQ(card.paint.fill, Ink(Colour{20, 30, 60}));
    const Bounds wood = wood_of(pictures[0]), cell = bounds(card.path);
    EXPECT_LT(cell.min.y, wood.min.y);
    EXPECT_GT(cell.max.y, wood.max.y);
    EXPECT_EQ(pictures[1].children.size(), 1U);
}

TEST(Sheet, CaptionsStandBeneathAndFit) {
    std::vector<Tile> tiles{{post(10, 20), "a", "short"}, {post(10, 20), "b", ""}};
    for (int i = 0; i < 20; ++i)
        tiles[1].caption += "very long ";
    const Drawing sheet = sheet_page(tiles, {});
    const auto pictures = pictures_of(sheet);
    const auto& captions = layer_of(sheet, "Captions").children;
    ASSERT_EQ(captions.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        const Bounds ink = bounds(std::get<Shape>(captions[i]).path);
        EXPECT_NEAR(ink.centre().x, wood_of(pictures[i]).centre().x, 0.2);
        EXPECT_GT(ink.min.y, wood_of(pictures[i]).max.y);
    }
    const double cell = (297.0 - 24 + 4) / 6 - 4;
    EXPECT_LE(bounds(std::get<Shape>(captions[1]).path).width(), cell);
}

TEST(Sheet, AnyPageOfSeveralHasItsNumber) {
    SheetParams params;
    const std::vector<Tile> tiles{{post(10, 20), "a", ""}};
    EXPECT_EQ(sheet_page(tiles, params).layers.size(), 2U);  // no captions
    params.page = 2;
    params.pages = 12;
    const Drawing sheet = sheet_page(tiles, params);
    const auto& captions = layer_of(sheet, "Captions").children;
    ASSERT_EQ(captions.size(), 1U);
    const Path& number = std::get<Shape>(captions[0]).path;
    EXPECT_EQ(number.verbs, lettering("2 / 12", {}).verbs);
    EXPECT_LE(bounds(number).max.x, 297 - 12);
}

TEST(Strip, IsAsLargeAsItsTilesNeed) {
    const std::vector<Tile> tiles{{post(10, 100), "a", "1"}, {post(60, 40), "b", "2"}};
    StripParams params;
    params.tallest_mm = 50;
    const Drawing row = strip(tiles, params);
    EXPECT_NEAR(row.width_mm, (10 + 60) * 0.5 + 6 + 4, 0.01);
    const Bounds box = InkBoxes(row).of(layer_of(row, "Pictures"));
    EXPECT_NEAR(box.height(), 50, kAlmost_mm);
    EXPECT_NEAR(box.width(), (10 + 60) * 0.5 + 6, kAlmost_mm);
    params.most_width_mm = 30;
    const Drawing narrow = strip(tiles, params);
    EXPECT_NEAR(narrow.width_mm, 30, 0.01);
    EXPECT_EQ(check(narrow), std::vector<std::string>{});
}

TEST(Poster, TheFullestRowFillsTheWidthAndSharesItsSpace) {
    const std::vector<Tile> tiles{
        {post(10, 100), "a", "1"}, {post(60, 40), "b", "2"}, {post(30, 20, 5), "c", "3"}};
    PosterParams params;
    params.width_mm = 100;
    params.rows = {2, 1};
    const Drawing drawing = poster(tiles, params);
    EXPECT_EQ(check(drawing), std::vector<std::string>{});
    const double scale = (100 - 16 - 2 * 6) / 70.0;
    const auto pictures = pictures_of(drawing);
    ASSERT_EQ(pictures.size(), 3U);
    const Bounds a = wood_of(pictures[0]), b = wood_of(pictures[1]), c = wood_of(pictures[2]);
    EXPECT_NEAR(a.height(), 100 * scale, kAlmost_mm);
    EXPECT_NEAR(c.width(), 30 * scale, kAlmost_mm);
    EXPECT_NEAR(a.min.x, 8 + 3, kAlmost_mm);
    EXPECT_NEAR(b.min.x - a.max.x, 6, kAlmost_mm);
    EXPECT_NEAR(b.max.x, 100 - 8 - 3, kAlmost_mm);
    EXPECT_NEAR(a.max.y, b.max.y, kAlmost_mm);
    EXPECT_NEAR(a.min.y, 8, kAlmost_mm);
    EXPECT_NEAR(c.centre().x, 50, kAlmost_mm);
    EXPECT_GT(c.min.y, a.max.y + 6);
}

}  // namespace
}  // namespace edaha
