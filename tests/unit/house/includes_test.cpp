// SPDX-License-Identifier: MIT
// Data runs one way through the rooms of src/: who may include whom, and which libraries are named
// where.
#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "unit/house/project_text.h"

namespace edaha::test {
namespace {

using Names = std::set<std::string>;

// The other rooms that a room may include. Of those in kParamsOnly, only what stages are told.
const std::map<std::string, Names> kRooms{
    {"base", {}},
    {"geometry", {"base"}},
    {"drawing", {"base", "geometry"}},
    {"energy", {"base", "geometry", "drawing"}},
    {"mesh", {"base", "geometry"}},
    {"prism", {"base", "geometry", "mesh"}},
    {"proproot", {"base", "geometry", "mesh"}},
    {"surface", {"base", "geometry", "mesh"}},
    {"flatten", {"base", "geometry", "drawing", "mesh"}},
    {"ornament", {"base", "geometry", "drawing"}},
    {"style", {"base", "drawing", "energy", "prism", "proproot", "surface", "flatten", "ornament"}},
    {"write", {"base", "geometry", "drawing"}},
    {"app",
     {"base", "geometry", "drawing", "mesh", "energy", "prism", "proproot", "surface", "flatten",
      "ornament", "style", "write"}}};
const std::map<std::string, Names> kParamsOnly{
    {"style", {"energy", "prism", "proproot", "surface", "flatten", "ornament"}}};
// A language that stands in style files, so that these are checked whole.
const Names kLanguages{"surface/rules.h"};

// Libraries, by how their headers begin, and the rooms that may name them.
const std::map<std::string, Names> kLibraries{
    {"cairo", {"write"}},       {"qpdf/", {"write"}},
    {"zlib", {"write", "app"}}, {"pugixml", {"style", "ornament", "write"}},
    {"CLI/", {"app"}},          {"nlohmann/", {"app"}},
    {"embree", {"flatten"}},    {"clipper", {"flatten"}},
    {"iostream", {"app"}}};

std::string part_before(const std::string& text, char end) {
    return text.substr(0, text.find(end));
}

// What stands between the marks of `#include "…"` or `#include <…>`; empty for another line.
std::string included(const std::string& line, char open, char close) {
    const std::string start = std::string("#include ") + open;
    return line.starts_with(start) ? part_before(line.substr(start.size()), close) : "";
}

std::string complaint_of_room(const std::string& room, const std::string& header) {
    const std::string other = part_before(header, '/');
    if (other == header) return "not written as \"room/file.h\"";
    if (other == room) return "";
    if (!kRooms.at(room).contains(other)) return "not a room that " + room + " may know";
    const auto limited = kParamsOnly.find(room);
    const bool is_limited = limited != kParamsOnly.end() && limited->second.contains(other);
    return is_limited && !header.ends_with("_params.h") && !kLanguages.contains(header)
               ? "not a stage's parameters"
               : "";
}

std::string complaint_of_library(const std::string& room, const std::string& header) {
    for (const auto& [start, rooms] : kLibraries) {
        if (header.starts_with(start) && !rooms.contains(room)) return "not for " + room;
    }
    return "";
}

// One line for each include that the rules forbid.
std::vector<std::string> complaints(const TextFile& file) {
    const std::string room = part_before(file.path.substr(std::string("src/").size()), '/');
    if (!kRooms.contains(room)) return {file.path + ": no room of that name"};
    std::vector<std::string> found;
    for (const std::string& line : file.lines) {
        std::string complaint;
        if (const auto own = included(line, '"', '"'); !own.empty()) {
            complaint = complaint_of_room(room, own);
        } else if (const auto other = included(line, '<', '>'); !other.empty()) {
            complaint = complaint_of_library(room, other);
        }
        if (!complaint.empty()) found.push_back(file.path + ": " + line + ": " + complaint);
    }
    return found;
}

TEST(Includes, RoomsKnowOnlyWhatComesBefore) {
    const auto files = project_files({"src"}, {".h", ".cpp"});
    EXPECT_GT(files.size(), 100U);
    for (const TextFile& file : files) {
        for (const std::string& complaint : complaints(file))
            ADD_FAILURE() << complaint;
    }
}

std::size_t count_complaints(const std::string& path, const std::string& text) {
    return complaints({path, split_lines(text)}).size();
}

TEST(Includes, ForbiddenOnesAreFound) {
    EXPECT_EQ(count_complaints("src/base/a.h", "#include \"geometry/path.h\"\n"), 1U);
    EXPECT_EQ(count_complaints("src/energy/a.cpp", "#include \"ornament/leaf.h\"\n"), 1U);
    EXPECT_EQ(count_complaints("src/write/a.cpp", "#include \"style/style.h\"\n"), 1U);
    EXPECT_EQ(count_complaints("src/style/a.cpp", "#include \"energy/grow.h\"\n"), 1U);
    EXPECT_EQ(count_complaints("src/style/a.cpp", "#include \"energy/growth_params.h\"\n"), 0U);
    EXPECT_EQ(count_complaints("src/energy/a.cpp", "int a;\n#include \"wood.h\"\n"), 1U);
    EXPECT_EQ(count_complaints("src/app/a.cpp", "#include <cairo-pdf.h>\n"), 1U);
    EXPECT_EQ(count_complaints("src/app/a.cpp", "#include <pugixml.hpp>\n"), 1U);
    EXPECT_EQ(count_complaints("src/write/a.cpp", "#include <cairo.h>\n#include <cmath>\n"), 0U);
    EXPECT_EQ(count_complaints("src/attic/a.cpp", "\n"), 1U);
}

}  // namespace
}  // namespace edaha::test
