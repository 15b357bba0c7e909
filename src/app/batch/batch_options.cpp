// SPDX-License-Identifier: MIT
#include "app/batch/batch_options.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "app/option_groups.h"

namespace edaha {
namespace {

void add_which(CLI::App& app, Options& options) {
    BatchOptions& batch = options.batch;
    app.add_option("STYLE", batch.sources, "as for draw; with --merge, manifests of shares")
        ->type_name("");
    add_text(app, "-n,--count", batch.count, "N", "so many variants of each style");
    add_text(app, "--seed-from", batch.seed_from, "N", "seed of the first, 1 if not given");
    add_changes(app, options.tree);
    app.add_option("--sweep", batch.sweeps,
                   "as --set, but evenly from a to b, or in turn, instead of by chance")
        ->type_name("GROUP.NAME=VALUE")
        ->allow_extra_args(false);
}

void add_where(CLI::App& app, Options& options) {
    BatchOptions& batch = options.batch;
    add_text(app, "-o,--output", options.output, "DIR", "folder of the files; is made");
    add_text(app, "--name", batch.name, "PATTERN",
             "names of the files: '{style}-{seed:04}'; also {index}, {family}, {palette} and any "
             "parameter");
    add_text(app, "--format", options.format, "FORMAT",
             "svg, svgz, pdf, png, eps, or several: svg,pdf");
    add_write(app, options.write);
    app.add_flag("--sheet", batch.sheet,
                 "contact sheets as SVG and PDF; --sheet=svg or --sheet=pdf: only these");
}

void add_how(CLI::App& app, Options& options) {
    BatchOptions& batch = options.batch;
    add_text(app, "--jobs", batch.jobs, "N", "so many at a time; as many as processors");
    app.add_flag("--resume", batch.resume, "draw only what is missing or has changed");
    app.add_flag("--force", options.force, "overwrite files that are there");
    add_text(app, "--shard", batch.shard, "I/N", "only a share: each N-th variant, from the I-th");
    app.add_flag("--merge", batch.merge, "put the manifests of all shares together");
    app.add_flag("--quiet", batch.quiet, "no progress, no summary");
    add_json(app, options);
}

}  // namespace

void add_batch(CLI::App& app, Options& options) {
    CLI::App& batch = *app.add_subcommand("batch", "draw many variants, and a list of them");
    add_which(batch, options);
    add_where(batch, options);
    add_how(batch, options);
    batch.footer(
        "VALUE of --set may be a..b or a|b|c: each variant draws one by chance; so may X of "
        "--vary, "
        "NAME of --palette and others.\n"
        "Examples:\n"
        "  edaha batch cherry -n 500 -o cherries\n"
        "  edaha batch oak fir -n 20 -o wood --set growth.energy=100..800 --format svg,pdf\n"
        "  edaha batch cherry -n 9 -o row --sweep growth.energy=20..300 --name '{growth.energy}'\n"
        "  edaha batch cherry -n 500 -o cherries --resume\n"
        "  edaha batch cherry -n 500 -o cherries --shard 2/8\n"
        "  edaha batch --merge -o cherries");
}

}  // namespace edaha
