// SPDX-License-Identifier: MIT
#include <ostream>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/output_file.h"
#include "app/picture_file.h"

namespace edaha {
namespace {

void print_report(const Picture& picture, const Target& target, const WriteReport& report,
                  Console& console) {
    nlohmann::ordered_json json;
    json["file"] = target.file;
    json["format"] = name(target.format);
    json["bytes"] = report.bytes;
    json["seed"] = picture.drawing.metadata.seed;
    json["command"] = picture.drawing.metadata.command;
    json["width_mm"] = picture.drawing.width_mm;
    json["height_mm"] = picture.drawing.height_mm;
    json["branches"] = picture.counts.branches;
    json["limbs"] = picture.counts.limbs;
    json["leaves"] = picture.counts.ornaments;
    json["warnings"] = warnings(picture, report.svg);
    console.out << json.dump(2) << '\n';
}

}  // namespace

int draw(const Options& options, Console& console) {
    if (options.json && options.output == "-") {
        throw UsageError("--json and the picture can't both go to standard output");
    }
    const Catalogue catalogue(console.user_folder);
    const TreeStyle tree = read_tree_style(options.tree, catalogue, console);
    const Target target = choose_target(options, tree.style.name);
    const WriteParams params = write_params(options.write, tree.style);
    LeafShelf leaves(catalogue);
    Picture picture = draw_picture(tree.style, leaves.loader());
    picture.drawing.metadata = metadata_of(tree, params, leaves);
    const WriteReport report = write_target(picture.drawing, target, params, console);
    for (const std::string& warning : warnings(picture, report.svg))
        console.err << "edaha: warning: " << warning << '\n';
    if (options.output.empty()) console.err << "edaha: wrote " << target.file << '\n';
    if (options.json) print_report(picture, target, report, console);
    return 0;
}

}  // namespace edaha
