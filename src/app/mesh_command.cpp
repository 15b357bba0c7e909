// SPDX-License-Identifier: MIT
#include <filesystem>
#include <ostream>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/flat_inks.h"
#include "app/growth_watch.h"
#include "app/mesh_file.h"
#include "app/model_mesh.h"
#include "app/output_file.h"
#include "app/surface_report.h"
#include "app/tree_style.h"
#include "base/atomic_file.h"
#include "mesh/obj.h"
#include "mesh/ply.h"
#include "style/value.h"

namespace edaha {
namespace {

namespace fs = std::filesystem;

MeshFormat choose_format(const Options& options) {
    if (options.format == "obj") return MeshFormat::obj;
    if (options.format == "ply") return MeshFormat::ply;
    if (!options.format.empty()) {
        throw UsageError(fmt::format("--format: {} is not known (expected obj or ply)",
                                     in_quotes(options.format)));
    }
    if (options.output.empty() || options.output == "-") return MeshFormat::obj;
    if (const auto format = mesh_format_of_file(options.output)) return *format;
    throw UsageError(fmt::format("--output: the ending of {} is no format (expected obj or ply)",
                                 in_quotes(options.output)));
}

void write_whole(const std::string& path, const std::string& bytes) {
    AtomicFile file(path);
    file.write(bytes);
    file.commit();
}

struct MeshTarget {
    std::string file;       // "-": standard output
    std::string materials;  // the file .mtl beside it; empty: none
    MeshFormat format;
};

MeshTarget choose_mesh_target(const Options& options, const Style& style) {
    MeshTarget target{options.output, {}, choose_format(options)};
    const bool is_obj = target.format == MeshFormat::obj;
    if (target.file.empty()) target.file = style.name + (is_obj ? ".obj" : ".ply");
    if (options.output.empty()) refuse_existing(target.file, options.force);
    if (!is_obj || target.file == "-") return target;
    target.materials = fs::path(target.file).replace_extension(".mtl").string();
    if (options.output.empty()) refuse_existing(target.materials, options.force);
    return target;
}

void write_mesh_files(const Mesh& mesh, const MeshTarget& target, Console& console) {
    if (target.format == MeshFormat::ply) {
        const std::string bytes = write_ply(mesh);
        if (target.file != "-") return write_whole(target.file, bytes);
        console.out << bytes;
        return;
    }
    const ObjText text = write_obj(mesh, fs::path(target.materials).filename().string());
    if (target.file == "-") {
        console.out << text.obj;
        return;
    }
    write_whole(target.materials, text.mtl);
    write_whole(target.file, text.obj);
}

void print_report(const ModelMesh& model, const MeshTarget& target, const TreeStyle& tree,
                  Console& console) {
    nlohmann::ordered_json json;
    json["file"] = target.file;
    json["format"] = target.format == MeshFormat::obj ? "obj" : "ply";
    json["seed"] = tree.style.energy.variant.seed;
    json["points"] = model.mesh.points.size();
    json["triangles"] = model.mesh.triangles.size();
    json["parts"] = model.mesh.parts.size();
    if (model.surface) add_to_json(json, *model.surface);
    console.out << json.dump(2) << '\n';
}

}  // namespace

int write_mesh(const Options& options, Console& console) {
    if (options.json && options.output == "-")
        throw UsageError("--json and the mesh can't both go to standard output");
    const Catalogue catalogue(console.user_folder);
    const TreeStyle tree = read_tree_style(options.tree, catalogue, console);
    const MeshTarget target = choose_mesh_target(options, tree.style);
    if (!makes_mesh(tree.style)) {
        throw IoError(
            fmt::format("{} grows by energy, which makes no mesh (expected a style of "
                        "prisms, prop roots or surface growth)",
                        in_quotes(tree.style.name)));
    }
    ModelMesh model = [&] {
        GrowthWatch growth(tree.style, console);
        return make_model_mesh(tree.style, growth.watch());
    }();
    for (Material& material : model.mesh.materials)
        material.colour = middle_tone(tree.style.palette, material);
    write_mesh_files(model.mesh, target, console);
    if (options.output.empty()) console.err << "edaha: wrote " << target.file << '\n';
    if (options.json) print_report(model, target, tree, console);
    return 0;
}

}  // namespace edaha
