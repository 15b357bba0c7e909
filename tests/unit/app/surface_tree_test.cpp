// SPDX-License-Identifier: MIT
// From a style that grows by its surface to its pictures.
#include <algorithm>
#include <memory>

#include <gtest/gtest.h>

#include "app/flat_inks.h"
#include "app/frames.h"
#include "app/obstacle_mesh.h"
#include "drawing/check.h"
#include "geometry/bit_raster.h"
#include "mesh/mesh_check.h"
#include "style/catalogue.h"

namespace edaha {
namespace {

LeafImport load_leaf(const std::string& name) {
    return read_leaf(Catalogue().find_leaf(name).text, name);
}

BarkImport load_tile(const std::string& name) {
    const SourceText source = Catalogue().find_leaf(name);
    return read_bark(source.text, source.origin);
}

const DrawingLoader load{load_leaf, load_tile};

Style small_tree() {
    Style style;
    style.models = {Model::surface};
    style.surface.steps = 12;
    style.surface.seed_height_mm = 400;
    style.page.size_mm = 60;
    return style;
}

TEST(SurfacePicture, KeepsTheContractAndReportsGrowth) {
    Style style = small_tree();
    style.sprig.energy = 8;
    style.leaf.shape = "round";
    const Picture picture = draw_picture(style, load);
    for (const auto& problem : check(picture.drawing))
        ADD_FAILURE() << problem;
    ASSERT_TRUE(picture.counts.surface.has_value());
    EXPECT_EQ(picture.counts.surface->steps, 12);
    EXPECT_GT(picture.counts.triangles, 0U);
    EXPECT_NEAR(std::max(picture.drawing.width_mm, picture.drawing.height_mm), 60, 0.02);
    EXPECT_EQ(picture.steps.front().name, "grow");
}

const Layer& layer_of(const Drawing& drawing, const std::string& label) {
    return *std::ranges::find(drawing.layers, label, &Layer::label);
}

void fill_wood(const std::vector<Element>& elements, double scale, BitRaster& raster) {
    for (const Element& element : elements) {
        if (const auto* group = std::get_if<Group>(&element))
            fill_wood(group->children, scale, raster);
        if (const auto* shape = std::get_if<Shape>(&element))
            raster.fill(shape->path, Affine(scale, 0, 0, scale, 0, 0));
    }
}

// Whether there is a sample within `reach` of a point.
bool is_near(const BitRaster& raster, Vec2 point, int reach) {
    for (int row = -reach; row <= reach; ++row) {
        for (int column = -reach; column <= reach; ++column) {
            const int x = static_cast<int>(point.x) + column, y = static_cast<int>(point.y) + row;
            if (x >= 0 && y >= 0 && x < raster.columns() && y < raster.rows() && raster.at(x, y))
                return true;
        }
    }
    return false;
}

TEST(SurfacePicture, NoStemBeginsBesideTheWood) {
    Style style = small_tree();
    style.surface.steps = 40;
    style.surface.sprig_spacing_mm = 60;
    style.sprig.energy = 8;
    style.leaf.shape = "round";
    const Picture picture = draw_picture(style, load);
    constexpr double kScale = 10;  // samples a mm
    BitRaster wood(600, 600);
    fill_wood(layer_of(picture.drawing, "Tree").children, kScale, wood);
    std::size_t feet = 0;
    for (const Element& element : layer_of(picture.drawing, "Sprigs behind").children) {
        const Group& group = std::get<Group>(element);
        if (!group.id.ends_with("stems")) continue;
        for (const Element& stem : group.children) {
            const Vec2 foot = std::get<Use>(stem).page_from_symbol[2];
            EXPECT_TRUE(is_near(wood, foot * kScale, 3)) << foot.x << ' ' << foot.y;
            ++feet;
        }
    }
    EXPECT_GT(feet, 20U);
}

TEST(SurfacePicture, DeadwoodIsGreyerThanWoodButOfThePaletteIfThatIsStrict) {
    const auto hue = [](Colour c) { return std::max({c.r, c.g, c.b}) - std::min({c.r, c.g, c.b}); };
    Palette palette;
    palette.wood_light = {0xc7, 0x9f, 0x80};
    const std::vector<Material> materials{{"wood", {}}, {"deadwood", {}}};
    const auto tones = flat_inks(palette, materials).tones;
    EXPECT_LT(2 * hue(tones[1][1]), hue(palette.wood_light));
    palette.strict = true;
    const std::vector<Colour> strict = flat_inks(palette, materials).tones[1];
    EXPECT_EQ(strict, (std::vector{palette.wood, palette.wood_light, palette.paper}));
}

TEST(SurfacePicture, HasItsBarkOverItsWood) {
    Style style = small_tree();
    style.flatten.bark_tile = "bark-plated";
    style.flatten.bark_scale = 0.2;
    const Picture picture = draw_picture(style, load);
    for (const auto& problem : check(picture.drawing))
        ADD_FAILURE() << problem;
    const auto bark = std::ranges::find(picture.drawing.layers, "Bark", &Layer::label);
    ASSERT_NE(bark, picture.drawing.layers.end());
    EXPECT_FALSE(bark->children.empty());
}

TEST(SurfacePicture, FramesShareAPageAndTheirFoot) {
    const std::vector<Picture> frames = draw_frames(small_tree(), load, 4, {});
    ASSERT_EQ(frames.size(), 4U);
    for (const Picture& frame : frames) {
        EXPECT_EQ(frame.drawing.width_mm, frames.back().drawing.width_mm);
        EXPECT_EQ(frame.drawing.height_mm, frames.back().drawing.height_mm);
        EXPECT_TRUE(check(frame.drawing).empty());
    }
    EXPECT_LE(frames.front().counts.triangles, frames.back().counts.triangles);
}

TEST(SurfacePicture, FrameFilesSortByTheirNumber) {
    EXPECT_EQ(frame_file("out/grow.svg", 7, 12), "out/grow-007.svg");
    EXPECT_EQ(frame_file("grow.pdf", 12, 1000), "grow-0012.pdf");
}

TEST(SurfacePicture, ObstaclesAreClosedAndOneSided) {
    SolidParams solid;
    for (const SolidShape shape : {SolidShape::box, SolidShape::ball, SolidShape::rod}) {
        solid.shape = shape;
        solid.to = {300, 1000, 200};
        const Mesh mesh = obstacle_mesh(solid, "obstacle-1");
        const MeshReport report = validate(mesh);
        EXPECT_TRUE(report.sound()) << static_cast<int>(shape);
        EXPECT_EQ(report.open_edges, 0U) << static_cast<int>(shape);
        EXPECT_EQ(report.inverted_pieces, 0U) << static_cast<int>(shape);
    }
    solid.shape = SolidShape::mesh;
    EXPECT_TRUE(obstacle_mesh(solid, "obstacle-1").triangles.empty());
    SolidParams box = solid;
    box.shape = SolidShape::box;
    solid.mesh = std::make_shared<const Mesh>(obstacle_mesh(box, "box"));
    const Mesh moved = obstacle_mesh(solid, "obstacle-1");
    EXPECT_TRUE(validate(moved).sound());
    EXPECT_EQ(moved.points.front(), solid.mesh->points.front() + solid.from);
    EXPECT_EQ(moved.parts.front().name, "obstacle-1");
    solid.shape = SolidShape::plane;
    EXPECT_TRUE(obstacle_mesh(solid, "obstacle-1").triangles.empty());
}

}  // namespace
}  // namespace edaha
