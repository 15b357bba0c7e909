// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace edaha {
namespace {

// A tree that is soon grown.
const std::string kYoung =
    "<tree name=\"young\" models=\"surface\">\n"
    "  <surface steps=\"12\" seed-height=\"400\"/>\n"
    "  <page size=\"60\"/>\n"
    "</tree>\n";

class SurfaceCommands : public test::Program {
  protected:
    void SetUp() override { write("young.xml", kYoung); }
};

TEST_F(SurfaceCommands, DrawsAndDrawsAgainFromThePicture) {
    expect("edaha draw young.xml", 0, "", "edaha: wrote young.svg\n");
    expect("edaha draw young.svg -o again.svg", 0, "", "");
    EXPECT_EQ(read("again.svg"), read("young.svg"));
}

TEST_F(SurfaceCommands, WritesFramesOnOnePage) {
    expect("edaha draw young.xml --frames 3 -o grow.svg", 0, "", "");
    EXPECT_TRUE(exists("grow-001.svg") && exists("grow-002.svg") && exists("grow-003.svg"));
    EXPECT_FALSE(exists("grow.svg") || exists("grow-004.svg"));
    const auto page = [&](const std::string& file) {
        const std::string svg = read(file);
        const std::size_t at = svg.find(" width=\"");
        return svg.substr(at, svg.find("viewBox") - at);
    };
    EXPECT_EQ(page("grow-001.svg"), page("grow-003.svg"));
    EXPECT_NE(read("grow-001.svg"), read("grow-003.svg"));
    expect("edaha draw young.xml --frames 2", 0, "",
           "edaha: wrote young-001.svg\nedaha: wrote young-002.svg\n");
    expect("edaha draw young.xml --frames 2", 1, "",
           "edaha: 'young-001.svg' is there already (--force overwrites it, -o names another)\n");
}

TEST_F(SurfaceCommands, RefusesFramesThatCantBe) {
    expect("edaha draw young.xml --frames 13 -o x.svg", 2, "",
           "edaha: --frames: '13' is not a whole number from 1 to 12\n");
    expect("edaha draw young.xml --frames 2.5 -o x.svg", 2, "",
           "edaha: --frames: '2.5' is not a whole number from 1 to 12\n");
    expect("edaha draw oak --frames 4 -o x.svg", 2, "",
           "edaha: --frames: 'oak' does not grow by its surface\n");
    expect("edaha draw young.xml --frames 2 -o -", 2, "",
           "edaha: --frames needs files (-o names them)\n");
}

TEST_F(SurfaceCommands, ReportsTheGrowth) {
    const auto json = nlohmann::json::parse(sh("edaha measure young.xml --json").out);
    EXPECT_EQ(json["steps"], 12);
    for (const char* key :
         {"vertices", "faces", "grown_branches", "fusions", "pins", "contacts", "crossing_pairs",
          "edges_in_range", "thick_edges_in_range", "longest_edge_mm", "deepest_mm"})
        EXPECT_TRUE(json[key].is_number()) << key;
    const auto stats = sh("edaha draw young.xml --stats -o x.svg");
    EXPECT_EQ(stats.err.substr(0, 5), "grow ") << stats.err;
    EXPECT_NE(stats.err.find("12 steps\n"), std::string::npos) << stats.err;
    EXPECT_EQ(sh("edaha mesh young.xml -o young.ply").exit_code, 0);
    EXPECT_EQ(sh("edaha flatten young.ply -o x.svg").err, "");
}

TEST_F(SurfaceCommands, ExplainsLists) {
    expect("edaha explain burl.radius", 0,
           "burl.radius: R: beyond it, the burl makes nothing grow faster\n"
           "  value    number: 1 … 1e6 mm\n"
           "  default  300\n"
           "  source   paper 6.1\n",
           "");
    expect("edaha explain hollw", 2, "", "edaha: hollw: no such group (did you mean 'hollow'?)\n");
    expect("edaha draw young.xml --set burl.radius=3", 2, "",
           "edaha: --set: burl.radius: only style files can set it: there may be many\n");
}

TEST_F(SurfaceCommands, ChecksLists) {
    write("bad.xml", "<tree name=\"bad\" models=\"surface\">\n  <burl strenth=\"2\"/>\n</tree>\n");
    expect("edaha check bad.xml", 1,
           "bad.xml:2:9: burl.strenth: no such parameter (did you mean 'strength'?)\n", "");
}

// Four sides of a cube of 100 mm; with both ends closed.
const std::string kOpen =
    "v 0 0 0\nv 100 0 0\nv 0 100 0\nv 100 100 0\nv 0 0 100\nv 100 0 100\nv 0 100 100\n"
    "v 100 100 100\nf 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\n";
const std::string kCube = kOpen + "f 1 5 7 3\nf 2 4 8 6\n";

std::string with_obstacle(const std::string& attributes) {
    return "<tree name=\"walled\" models=\"surface\">\n  <obstacle " + attributes +
           "/>\n  <surface steps=\"12\"/>\n  <page size=\"60\"/>\n</tree>\n";
}

TEST_F(SurfaceCommands, DrawsObstaclesFromFilesBesideTheStyle) {
    std::filesystem::create_directory(folder_ / "rocks");
    write("rocks/cube.obj", kCube);
    write("rocks/walled.xml", with_obstacle("shape=\"mesh\" file=\"cube.obj\" from=\"300 0 0\""));
    expect("edaha draw rocks/walled.xml", 0, "", "edaha: wrote walled.svg\n");
    const std::string svg = read("walled.svg");
    EXPECT_NE(svg.find("id=\"obstacle-1\""), std::string::npos);
    EXPECT_NE(svg.find("file=\"rocks/cube.obj\""), std::string::npos);
    expect("edaha draw walled.svg -o again.svg", 0, "", "");
    EXPECT_EQ(read("again.svg"), svg);
    expect("edaha check rocks/walled.xml", 0, "", "");
}

TEST_F(SurfaceCommands, RefusesFilesThatAreNoSolids) {
    write("open.obj", kOpen);
    write("crowded.obj", kCube + "v 9 9 300\nf 5 6 9\n");
    write("sheet.obj", "v 0 0 0\nv 900 0 0\nv 0 900 0\nf 1 2 3\nf 1 3 2\n");
    write("text.obj", "hello\n");
    write("text.ply", "hello\n");
    write("cube.stl", "solid cube\n");
    const auto expect_refused = [&](const std::string& file, const std::string& err) {
        write("walled.xml", with_obstacle("shape=\"mesh\" file=\"" + file + "\""));
        expect("edaha draw walled.xml", 1, "", err);
        expect("edaha check walled.xml", 1, err, "");
    };
    expect_refused("open.obj", "open.obj: the mesh bounds no solid: 8 open edges\n");
    expect_refused("sheet.obj", "sheet.obj: the mesh bounds no solid: it has no volume\n");
    expect_refused("crowded.obj",
                   "crowded.obj: the mesh bounds no solid: 2 open edges, "
                   "1 edge of more than two triangles\n");
    expect_refused("text.obj", "text.obj:2:1: there are no faces\n");
    expect_refused("text.ply", "text.ply:1:1: this is no PLY file (expected 'ply')\n");
    expect_refused("cube.stl", "cube.stl: the ending is no mesh (expected obj or ply)\n");
    expect_refused("none.obj", "walled.xml:2:26: obstacle.file: there is no file 'none.obj'\n");
}

TEST_F(SurfaceCommands, MeshesAndFilesGoTogether) {
    write("cube.obj", kCube);
    write("walled.xml", with_obstacle("shape=\"mesh\""));
    expect("edaha draw walled.xml", 1, "",
           "walled.xml:2:4: obstacle: shape=\"mesh\" needs a file\n");
    write("walled.xml", with_obstacle("shape=\"rod\" file=\"cube.obj\""));
    expect("edaha draw walled.xml", 1, "",
           "walled.xml:2:4: obstacle: only shape=\"mesh\" has a file\n");
    expect("edaha explain hollow.file", 0,
           "hollow.file: of a mesh: closed, in mm, y up\n"
           "  value    mesh: an OBJ or PLY file\n"
           "  default  (empty)\n"
           "  source   Edaha\n",
           "");
}

}  // namespace
}  // namespace edaha
