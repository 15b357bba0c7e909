// SPDX-License-Identifier: MIT
#include <ostream>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/frames.h"
#include "app/growth_watch.h"
#include "app/output_file.h"
#include "app/picture_file.h"
#include "app/step_times.h"
#include "app/surface_report.h"
#include "base/number_text.h"
#include "style/value.h"

namespace edaha {
namespace {

// What is drawn, and how it is told of.
struct DrawJob {
    const Options& options;
    TreeStyle tree;
    WriteParams params;
    Target target;
};

nlohmann::ordered_json report_of(const DrawJob& job, const Picture& picture,
                                 const std::string& file, const WriteReport& report) {
    nlohmann::ordered_json json;
    json["file"] = file;
    json["format"] = name(job.target.format);
    json["bytes"] = report.bytes;
    json["seed"] = picture.drawing.metadata.seed;
    json["command"] = picture.drawing.metadata.command;
    json["width_mm"] = picture.drawing.width_mm;
    json["height_mm"] = picture.drawing.height_mm;
    json["branches"] = picture.counts.branches;
    json["limbs"] = picture.counts.limbs;
    json["leaves"] = picture.counts.ornaments;
    if (picture.counts.surface) {
        nlohmann::ordered_json surface;
        add_to_json(surface, *picture.counts.surface);
        surface["sprigs"] = picture.counts.sprigs;
        json["surface"] = surface;
    }
    if (job.options.stats) json["steps"] = json_of(picture.steps);
    json["warnings"] = warnings(picture, report.svg);
    return json;
}

void warn(const Picture& picture, const WriteReport& report, Console& console) {
    for (const std::string& warning : warnings(picture, report.svg))
        console.err << "edaha: warning: " << warning << '\n';
}

void draw_one(const DrawJob& job, LeafShelf& leaves, Console& console) {
    Picture picture = [&] {
        GrowthWatch growth(job.tree.style, console);
        return draw_picture(job.tree.style, leaves.loader(), growth.watch());
    }();
    picture.drawing.metadata = metadata_of(job.tree, job.params, leaves);
    Stopwatch watch;
    const WriteReport report = write_target(picture.drawing, job.target, job.params, console);
    picture.steps.push_back({"write", watch.lap(), report.bytes, "bytes"});
    warn(picture, report, console);
    if (job.options.output.empty()) console.err << "edaha: wrote " << job.target.file << '\n';
    if (job.options.stats) print_steps(picture.steps, console);
    if (job.options.json)
        console.out << report_of(job, picture, job.target.file, report).dump(2) << '\n';
}

std::int64_t frame_count(const DrawJob& job) {
    const Style& style = job.tree.style;
    if (!has_model(style.models, Model::surface)) {
        throw UsageError(
            fmt::format("--frames: {} does not grow by its surface", in_quotes(style.name)));
    }
    const std::string& text = job.options.frames;
    const auto count = parse_number(trim(text));
    const std::int64_t most = std::min(kMostFrames, style.surface.steps);
    const bool is_whole = count && *count == static_cast<double>(static_cast<std::int64_t>(*count));
    if (!is_whole || *count < 1 || *count > static_cast<double>(most)) {
        throw UsageError(
            fmt::format("--frames: {} is not a whole number from 1 to {}", in_quotes(text), most));
    }
    if (job.target.file == "-") throw UsageError("--frames needs files (-o names them)");
    return static_cast<std::int64_t>(*count);
}

void draw_all_frames(DrawJob job, std::int64_t count, LeafShelf& leaves, Console& console) {
    const auto total = static_cast<std::size_t>(count);
    for (std::size_t i = 1; job.options.output.empty() && i <= total; ++i)
        refuse_existing(frame_file(job.target.file, i, total), job.options.force);
    std::vector<Picture> pictures = [&] {
        GrowthWatch growth(job.tree.style, console);
        return draw_frames(job.tree.style, leaves.loader(), count, growth.watch());
    }();
    job.tree.command += " --frames " + std::to_string(count);
    const Metadata metadata = metadata_of(job.tree, job.params, leaves);
    auto reports = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        Picture& picture = pictures[i];
        picture.drawing.metadata = metadata;
        Target target = job.target;
        target.file = frame_file(target.file, i + 1, total);
        Stopwatch watch;
        const WriteReport report = write_target(picture.drawing, target, job.params, console);
        picture.steps.push_back({"write", watch.lap(), report.bytes, "bytes"});
        if (i + 1 == total) warn(picture, report, console);
        if (job.options.output.empty()) console.err << "edaha: wrote " << target.file << '\n';
        if (job.options.stats && i + 1 == total) print_steps(picture.steps, console);
        reports.push_back(report_of(job, picture, target.file, report));
    }
    if (job.options.json) console.out << reports.dump(2) << '\n';
}

}  // namespace

int draw(const Options& options, Console& console) {
    if (options.json && options.output == "-") {
        throw UsageError("--json and the picture can't both go to standard output");
    }
    const Catalogue catalogue(console.user_folder);
    DrawJob job{options, read_tree_style(options.tree, catalogue, console), {}, {}};
    Options named = options;
    named.force = options.force || !options.frames.empty();  // frames have names of their own
    job.target = choose_target(named, job.tree.style.name);
    job.params = write_params(options.write, job.tree.style);
    LeafShelf leaves(catalogue);
    if (options.frames.empty()) {
        draw_one(job, leaves, console);
    } else {
        draw_all_frames(job, frame_count(job), leaves, console);
    }
    return 0;
}

}  // namespace edaha
