// SPDX-License-Identifier: MIT
#include <filesystem>
#include <ostream>
#include <utility>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/flat_inks.h"
#include "app/flat_model.h"
#include "app/mesh_file.h"
#include "app/output_file.h"
#include "app/picture_file.h"
#include "app/shell_word.h"
#include "app/step_times.h"
#include "app/version.h"
#include "base/fingerprint.h"
#include "drawing/page.h"
#include "mesh/mesh_check.h"
#include "style/style_xml.h"
#include "style/value.h"

namespace edaha {
namespace {

// A mesh from its file to its picture, with all that is told of the way.
struct FlatFile {
    std::string fingerprint;
    MeshReport report;
    std::size_t points = 0, triangles = 0, parts = 0;
    std::vector<std::string> warnings;
    std::vector<StepReport> steps;
    Drawing drawing;  // without metadata
};

std::string file_stem(const std::string& file) {
    const std::string stem = std::filesystem::path(file).stem().string();
    return stem.empty() ? "mesh" : stem;
}

TreeStyle read_look(const Options& options, const Catalogue& catalogue, Console& console) {
    TreeStyle tree;
    tree.command = "edaha flatten " + shell_word(options.flatten.model);
    if (!options.tree.style.empty()) {
        tree.style = read_unchanged_style(options.tree.style, catalogue, console).style;
        tree.command += " --style " + shell_word(options.tree.style);
    }
    if (!options.flatten.up.empty()) tree.command += " --up " + shell_word(options.flatten.up);
    return change_style(std::move(tree), options.tree);
}

bool z_is_up(const std::string& axis) {
    if (axis.empty() || axis == "y") return false;
    if (axis == "z") return true;
    throw UsageError(fmt::format("--up: {} is not known (expected y or z)", in_quotes(axis)));
}

// From z up to y up, without mirroring.
void stand_up(Mesh& mesh) {
    for (Vec3& point : mesh.points)
        point = {point.x, point.z, -point.y};
}

Mesh read_and_mend(const std::string& file, bool z_up, FlatFile& result) {
    Stopwatch watch;
    MeshFile source = read_mesh_file(file);
    Mesh mesh = std::move(source.input.mesh);
    result.fingerprint = source.fingerprint;
    for (const Problem& warning : source.input.warnings)
        result.warnings.push_back(to_string(warning));
    if (z_up) stand_up(mesh);
    result.points = mesh.points.size();
    result.triangles = mesh.triangles.size();
    result.parts = mesh.parts.size();
    result.steps.push_back({"read", watch.lap(), result.triangles, "triangles"});
    result.report = validate(mesh);
    for (const std::string& line : result.report.lines())
        result.warnings.push_back(fmt::format("{}: {}", file, line));
    if (!result.report.sound()) mesh = mend(std::move(mesh));
    result.steps.push_back({"check", watch.lap(), result.report.pieces, "pieces"});
    if (mesh.triangles.empty()) {
        Problem problem;
        problem.place.file = file;
        problem.message = "none of its triangles can be drawn";
        throw InputError({std::move(problem)});
    }
    return mesh;
}

BarkTile read_tile(const std::string& name, LeafShelf& leaves, FlatFile& result) {
    if (name.empty()) return {};
    const BarkImport& import = leaves.bark(name);
    for (const Problem& warning : import.warnings)
        result.warnings.push_back(to_string(warning));
    return import.tile;
}

FlatFile flatten_mesh_file(const std::string& file, bool z_up, const Style& style,
                           LeafShelf& leaves) {
    FlatFile result;
    const BarkTile bark = read_tile(style.flatten.bark_tile, leaves, result);
    const Mesh mesh = read_and_mend(file, z_up, result);
    if (mesh.uv.empty() && (!bark.empty() || style.flatten.bark_mm > 0))
        result.warnings.push_back(file + ": it has no bark, because it has no places in (u,v)");
    Flattened flat = flatten(mesh, style.flatten, flat_inks(style.palette, mesh.materials), bark);
    result.steps.insert(result.steps.end(), flat.steps.begin(), flat.steps.end());
    settle_ids(flat.layers, {}, {});
    result.drawing.layers = std::move(flat.layers);
    result.drawing = on_page(std::move(result.drawing), style.page, style.palette);
    return result;
}

Metadata metadata_of_file(const TreeStyle& tree, const Options& options, const WriteParams& params,
                          const FlatFile& flat, LeafShelf& leaves) {
    Metadata metadata;
    metadata.title = file_stem(options.flatten.model);
    metadata.command = tree.command;
    metadata.version = kVersion;
    Fingerprint recipe;
    for (const std::string& text : {metadata.version, metadata.command, to_xml(tree.style),
                                    text_of(params), flat.fingerprint})
        recipe.add(text);
    const std::string& bark = tree.style.flatten.bark_tile;
    if (!bark.empty()) recipe.add(leaves.fingerprint(bark));
    metadata.recipe = recipe.text();
    return metadata;
}

nlohmann::ordered_json json_of(const MeshReport& report) {
    return {
        {"broken_points", report.broken_points},       {"missing_points", report.missing_points},
        {"shared_points", report.shared_points},       {"flat_triangles", report.flat_triangles},
        {"double_triangles", report.double_triangles}, {"open_edges", report.open_edges},
        {"crowded_edges", report.crowded_edges},       {"turned_edges", report.turned_edges},
        {"inverted_pieces", report.inverted_pieces},   {"pieces", report.pieces}};
}

void print_report(const FlatFile& flat, const Target& target, std::uint64_t bytes,
                  Console& console) {
    nlohmann::ordered_json json;
    json["file"] = target.file;
    json["format"] = name(target.format);
    json["bytes"] = bytes;
    json["command"] = flat.drawing.metadata.command;
    json["width_mm"] = flat.drawing.width_mm;
    json["height_mm"] = flat.drawing.height_mm;
    json["points"] = flat.points;
    json["triangles"] = flat.triangles;
    json["parts"] = flat.parts;
    json["mesh"] = json_of(flat.report);
    json["steps"] = json_of(flat.steps);
    json["warnings"] = flat.warnings;
    console.out << json.dump(2) << '\n';
}

}  // namespace

int flatten_file(const Options& options, Console& console) {
    if (options.json && options.output == "-")
        throw UsageError("--json and the picture can't both go to standard output");
    const Catalogue catalogue(console.user_folder);
    const TreeStyle tree = read_look(options, catalogue, console);
    const bool z_up = z_is_up(options.flatten.up);
    const Target target = choose_target(options, file_stem(options.flatten.model));
    const WriteParams params = write_params(options.write, tree.style);
    LeafShelf leaves(catalogue);
    FlatFile flat = flatten_mesh_file(options.flatten.model, z_up, tree.style, leaves);
    flat.drawing.metadata = metadata_of_file(tree, options, params, flat, leaves);
    Stopwatch watch;
    const WriteReport report = write_target(flat.drawing, target, params, console);
    flat.steps.push_back({"write", watch.lap(), report.bytes, "bytes"});
    for (std::string& warning : warnings({}, report.svg))
        flat.warnings.push_back(std::move(warning));
    for (const std::string& warning : flat.warnings)
        console.err << "edaha: warning: " << warning << '\n';
    if (options.output.empty()) console.err << "edaha: wrote " << target.file << '\n';
    if (options.stats) print_steps(flat.steps, console);
    if (options.json) print_report(flat, target, report.bytes, console);
    return 0;
}

}  // namespace edaha
