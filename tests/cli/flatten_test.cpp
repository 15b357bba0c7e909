// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace edaha {
namespace {

using test::RunResult;

class FlattenCommand : public test::Program {
  protected:
    // The picture is drawn, and all that is said on standard error is this.
    void expect_drawn(const std::string& file, const std::string& warnings) const {
        expect("edaha flatten " + file + " -o out.svg", 0, "", warnings);
        const std::string svg = read("out.svg");
        EXPECT_NE(svg.find("<path"), std::string::npos) << svg;
        EXPECT_EQ(svg.find("nan"), std::string::npos) << svg;
        EXPECT_EQ(sh("xmllint --noout out.svg").exit_code, 0);
        expect("rm out.svg", 0, "", "");
    }
};

const std::string kPoints =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n";
const std::string kSides = "f 1 5 7 3\nf 2 4 8 6\nf 1 2 6 5\nf 3 7 8 4\nf 1 3 4 2\n";
const std::string kFront = "f 5 6 8 7\n";
const std::string kCube = kPoints + kSides + kFront;

TEST_F(FlattenCommand, WritesAllFormats) {
    write("cube.obj", kCube);
    expect("edaha flatten cube.obj", 0, "", "edaha: wrote cube.svg\n");
    expect("edaha flatten cube.obj", 1, "",
           "edaha: 'cube.svg' is there already (--force overwrites it, -o names another)\n");
    for (const char* format : {"svg", "svgz", "pdf", "png", "eps"}) {
        expect(std::string("edaha flatten cube.obj --force --format ") + format, 0, "",
               std::string("edaha: wrote cube.") + format + "\n");
        EXPECT_GT(read(std::string("cube.") + format).size(), 200U) << format;
    }
    EXPECT_NE(sh("edaha flatten cube.obj -o -")
                  .out.find("<dc:source>edaha flatten cube.obj"
                            "</dc:source>"),
              std::string::npos);
}

TEST_F(FlattenCommand, SeesFromWhereItIsTold) {
    write("cube.obj", kCube);
    const auto size = [&](const std::string& options) {
        const RunResult result =
            sh("edaha flatten cube.obj -o x.svg --json --set page.margin=0 "
               "--set flatten.silhouette=0 --set flatten.contour=0 "
               "--set flatten.crease=0 " +
               options);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        const auto json = nlohmann::json::parse(result.out);
        return json["width_mm"].get<double>() / json["height_mm"].get<double>();
    };
    EXPECT_NEAR(size(""), 1, 1e-3);
    EXPECT_NEAR(size("--azimuth 45"), std::numbers::sqrt2, 2e-3);
    EXPECT_NEAR(size("--azimuth 45 --elevation 90"), 1, 2e-3);
    EXPECT_NEAR(size("--elevation 45"), std::numbers::sqrt2 / 2, 2e-3);
}

TEST_F(FlattenCommand, TurnsMeshesUp) {
    write("slab.obj", "v 0 0 0\nv 4 0 0\nv 4 0 1\nv 0 0 1\nf 1 2 3 4\n");
    const auto json = [&](const std::string& options) {
        return nlohmann::json::parse(
            sh("edaha flatten slab.obj -o x.svg --json --set page.margin=0 " + options).out);
    };
    EXPECT_NEAR(json("--up z")["height_mm"], json("--elevation 90")["height_mm"], 0.2);
    expect("edaha flatten slab.obj --up w", 2, "",
           "edaha: --up: 'w' is not known (expected y or z)\n");
}

TEST_F(FlattenCommand, DrawsWhatIsWrongAndSaysSo) {
    write("open.obj", kPoints + kSides);
    expect_drawn("open.obj", "edaha: warning: open.obj: 4 open edges\n");
    write("turned.obj", kPoints + kSides + "f 5 7 8 6\n");
    expect_drawn("turned.obj",
                 "edaha: warning: turned.obj: 4 edges whose triangles face opposite ways\n");
    write("inverted.obj",
          kPoints + "f 1 3 7 5\nf 2 6 8 4\nf 1 5 6 2\nf 3 4 8 7\nf 1 2 4 3\nf 5 7 8 6\n");
    expect_drawn("inverted.obj",
                 "edaha: warning: inverted.obj: 1 closed piece that is inside out\n");
    write("crowded.obj", kCube + "v 2 2 2\nf 6 8 9\n");
    expect_drawn("crowded.obj",
                 "edaha: warning: crowded.obj: 2 open edges\n"
                 "edaha: warning: crowded.obj: 1 edge of more than two triangles\n");
    write("flat.obj", kCube + "v 3 0 0\nv 4 0 0\nv 5 0 0\nf 9 10 11\n");
    expect_drawn("flat.obj",
                 "edaha: warning: flat.obj: 1 triangle without area\n"
                 "edaha: warning: flat.obj: 3 open edges\n");
    write("broken.obj", kCube + "v nan 0 0\nf 9 1 2\n");
    expect_drawn("broken.obj", "edaha: warning: broken.obj: 1 point that is not finite\n");
    write("twice.obj", kCube + kFront);
    const RunResult twice = sh("edaha flatten twice.obj -o twice.svg");
    EXPECT_EQ(twice.exit_code, 0);
    EXPECT_NE(twice.err.find("2 triangles that are there twice\n"), std::string::npos) << twice.err;
}

// What is mended is drawn as what was sound from the start; only the recipe tells them apart.
TEST_F(FlattenCommand, MendsWhatItCan) {
    for (const char* folder : {"a", "b"})
        std::filesystem::create_directory(folder_ / folder);
    write("a/cube.obj", kCube);
    write("b/cube.obj", kPoints + kSides + "f 5 7 8 6\n");
    const std::string draw = " && edaha flatten cube.obj -o - --azimuth 30 --elevation 20";
    const auto picture = [&](const std::string& folder) {
        return sh("cd " + folder + draw + " | grep -v edaha:recipe").out;
    };
    EXPECT_EQ(picture("a"), picture("b"));
    EXPECT_NE(picture("a").find("<path"), std::string::npos);
}

TEST_F(FlattenCommand, RefusesWhatIsNoMesh) {
    expect("edaha flatten", 2, "",
           "edaha: flatten: MODEL is missing\nTry 'edaha flatten --help'.\n");
    expect("edaha flatten gone.obj", 1, "",
           "edaha: cannot read 'gone.obj': No such file or directory\n");
    expect("edaha flatten part.stl", 2, "",
           "edaha: the ending of 'part.stl' is no mesh (expected obj or ply)\n");
    write("empty.obj", "");
    expect("edaha flatten empty.obj", 1, "", "empty.obj:1:1: there are no faces\n");
    write("empty.ply", "");
    expect("edaha flatten empty.ply", 1, "",
           "empty.ply:1:1: this is no PLY file (expected 'ply')\n");
    write("bad.obj", "v 0 0 0\nv 1 zero 0\nf 1 2 3\n");
    expect("edaha flatten bad.obj", 1, "",
           "bad.obj:2:5: 'zero' is not a number\n"
           "bad.obj:3:7: there is no point 3 (expected 1 to 1, or -1 to -1)\n");
    write("nothing.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    expect("edaha flatten nothing.obj", 1, "", "nothing.obj: none of its triangles can be drawn\n");
    write("cube.obj", kCube);
    expect("edaha flatten cube.obj --look blue", 2, "",
           "edaha: --look: 'blue' is not known (expected fills, lines, fills-lines, tones, facets "
           "or blueprint)\n");
    for (const char* file : {"empty.svg", "bad.svg", "nothing.svg", "cube.svg"})
        EXPECT_FALSE(exists(file)) << file;
}

// A closed torus of 2 n^2 triangles as binary PLY.
std::string torus_ply(std::uint32_t n) {
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(n * n) +
        "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
        std::to_string(2 * n * n) + "\nproperty list uchar uint vertex_indices\nend_header\n";
    const auto put = [&](const auto value) {
        char raw[sizeof value];
        std::memcpy(raw, &value, sizeof value);
        bytes.append(raw, sizeof value);
    };
    const double step = 2 * std::numbers::pi / n;
    for (std::uint32_t i = 0; i < n * n; ++i) {
        const double u = step * (i / n), v = step * (i % n), r = 3 + std::cos(v);
        put(static_cast<float>(r * std::cos(u)));
        put(static_cast<float>(std::sin(v)));
        put(static_cast<float>(r * std::sin(u)));
    }
    for (std::uint32_t i = 0; i < n * n; ++i) {
        const std::uint32_t row = i / n * n, next = (row + n) % (n * n), k = (i + 1) % n;
        const std::uint32_t b = row + k, c = next + k, d = next + i % n;
        for (const std::uint32_t corner : {b, c}) {
            put(std::uint8_t{3});
            put(i);
            put(corner);
            put(corner == b ? c : d);
        }
    }
    return bytes;
}

TEST_F(FlattenCommand, RefusesTruncatedAndBoastfulFiles) {
    const std::string whole = torus_ply(12);
    write("whole.ply", whole);
    expect_drawn("whole.ply", "");
    write("cut.ply", whole.substr(0, whole.size() - 1));
    expect("edaha flatten cut.ply", 1, "",
           "cut.ply:7:1: a list 'vertex_indices' has more values than the file holds\n");
    write("head.ply", whole.substr(0, whole.size() / 4));
    EXPECT_EQ(sh("edaha flatten head.ply").exit_code, 1);
    write("boast.ply",
          "ply\nformat ascii 1.0\nelement vertex 4294967295\nproperty float x\n"
          "property float y\nproperty float z\nend_header\n");
    expect("ulimit -v 1000000; edaha flatten boast.ply", 1, "",
           "boast.ply:3:1: 4294967295 records of 'vertex' need 25769803770 bytes at least, but 0 "
           "are left in the file\n");
    EXPECT_FALSE(exists("cut.svg") || exists("head.svg") || exists("boast.svg"));
}

TEST_F(FlattenCommand, DrawsTwoMillionTrianglesInFourGigabytes) {
    write("torus.ply", torus_ply(1000));
    const RunResult result =
        sh("ulimit -v 4000000; edaha flatten torus.ply -o torus.svg --elevation 35 --json");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["triangles"], 2'000'000);
    EXPECT_EQ(json["mesh"]["pieces"], 1);
    EXPECT_EQ(json["mesh"]["open_edges"], 0);
}

TEST_F(FlattenCommand, GivesTheSameBytesWithOneThread) {
    write("torus.ply", torus_ply(60));
    expect(
        "edaha flatten torus.ply -o a.svg --elevation 30 && "
        "taskset -c 0 \"" EDAHA_BINARY
        "\" flatten torus.ply -o b.svg --elevation 30 && "
        "cmp a.svg b.svg",
        0, "", "");
}

TEST_F(FlattenCommand, TellsItsSteps) {
    write("cube.obj", kCube);
    const RunResult result = sh("edaha flatten cube.obj -o cube.svg --stats");
    EXPECT_EQ(result.out, "");
    for (const char* step : {"read  ", "check  ", "snap  ", "write  "})
        EXPECT_NE(result.err.find(step), std::string::npos) << result.err;
    EXPECT_NE(result.err.find(" 12 triangles\n"), std::string::npos) << result.err;
}

constexpr const char* kPrisms =
    "<tree name='low-poly' models='prism'><prism depth='4'/><foliage shape='balls'/></tree>";

TEST_F(FlattenCommand, DrawsWhatMeshWrites) {
    write("p.xml", kPrisms);
    expect("edaha mesh p.xml", 0, "", "edaha: wrote low-poly.obj\n");
    expect("edaha mesh p.xml", 1, "",
           "edaha: 'low-poly.obj' is there already (--force overwrites it, -o names another)\n");
    EXPECT_TRUE(read("low-poly.obj").starts_with("mtllib low-poly.mtl\n"));
    EXPECT_NE(read("low-poly.obj").find("\ng trunk-1\nusemtl wood\nf "), std::string::npos);
    EXPECT_NE(read("low-poly.mtl").find("newmtl leaf\nKd "), std::string::npos);
    expect("edaha flatten low-poly.obj", 0, "", "edaha: wrote low-poly.svg\n");
    expect("edaha mesh p.xml -o tree.ply && edaha mesh p.xml --format ply -o - | cmp - tree.ply", 0,
           "", "");
    const auto report = nlohmann::json::parse(sh("edaha mesh p.xml -o x.ply --json").out);
    const auto flat = nlohmann::json::parse(sh("edaha flatten x.ply -o x.svg --json").out);
    EXPECT_EQ(report["triangles"], flat["triangles"]);
    EXPECT_EQ(report["parts"], flat["parts"]);
    EXPECT_EQ(flat["mesh"]["pieces"], flat["parts"]);
}

TEST_F(FlattenCommand, MeshNeedsAModelThatMakesOne) {
    expect("edaha mesh oak -o oak.obj", 1, "",
           "edaha: 'oak' grows by energy, which makes no mesh (expected a style of prisms, prop "
           "roots or surface growth)\n");
    write("p.xml", kPrisms);
    expect("edaha mesh p.xml -o p.stl", 2, "",
           "edaha: --output: the ending of 'p.stl' is no format (expected obj or ply)\n");
    expect("edaha mesh p.xml --format stl", 2, "",
           "edaha: --format: 'stl' is not known (expected obj or ply)\n");
    EXPECT_FALSE(exists("oak.obj") || exists("p.stl"));
}

TEST_F(FlattenCommand, StylesOfMeshesAreDrawnAndMeasured) {
    write("p.xml", kPrisms);
    expect("edaha draw p.xml -o p.svg && edaha draw p.svg -o q.svg && cmp p.svg q.svg", 0, "", "");
    const auto json = nlohmann::json::parse(sh("edaha measure p.xml --json").out);
    EXPECT_EQ(json["parts"], json["prisms"].get<int>() + json["foliage"].get<int>());
    EXPECT_FALSE(json.contains("branches"));
    write("m.xml",
          "<tree name='m' models='prop-root energy'><growth energy='40'/>"
          "<leaf shape='oak'/></tree>");
    const auto both = nlohmann::json::parse(sh("edaha measure m.xml --json").out);
    EXPECT_GT(both["roots"], 0);
    EXPECT_GT(both["branches"], 0);
    EXPECT_EQ(both["parts"], both["roots"].get<int>() + 1) << "and the trunk";
}

}  // namespace
}  // namespace edaha
