// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <ostream>
#include <set>

#include <fmt/core.h>
#include <nlohmann/json.hpp>
#include <tbb/task_arena.h>

#include "app/batch/journal.h"
#include "app/batch/manifest.h"
#include "app/batch/merge.h"
#include "app/batch/plan.h"
#include "app/batch/progress.h"
#include "app/batch/run_variants.h"
#include "app/batch/shard.h"
#include "app/batch/sheet_book.h"
#include "app/batch/stop_signals.h"
#include "app/commands.h"
#include "app/version.h"
#include "base/error.h"

namespace edaha {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostJobs = 1024;
constexpr std::size_t kMostWarnings = 20;

[[noreturn]] void fail_usage(const std::string& what) {
    throw UsageError("batch: " + what + "\nTry 'edaha batch --help'.");
}

std::size_t read_jobs(const std::string& text) {
    if (text.empty()) return static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
    return parse_count("--jobs", text, 1, kMostJobs);
}

double seconds_now() {
    using Clock = std::chrono::steady_clock;
    return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

// "svg,pdf"; "true": both, as the option without a value.
std::vector<Format> read_sheet(const BatchOptions& options) {
    if (options.sheet.empty()) return {};
    if (!options.shard.empty()) {
        throw UsageError(
            "--sheet shows all variants, not a share: after --merge, --resume --sheet draws it");
    }
    if (options.sheet == "true") return {Format::svg, Format::pdf};
    std::vector<Format> formats = parse_formats(options.sheet);
    for (const Format format : formats) {
        if (format != Format::svg && format != Format::pdf) {
            throw UsageError(
                fmt::format("--sheet: '{}' is not known (expected svg or pdf)", name(format)));
        }
    }
    return formats;
}

void check_options(const Options& options) {
    const BatchOptions& batch = options.batch;
    if (options.output.empty()) fail_usage("-o is missing");
    if (batch.merge) return;
    if (batch.sources.empty()) fail_usage("STYLE is missing");
    if (batch.count.empty()) fail_usage("-n is missing");
}

// One run of the command, of all variants or a share of them.
class Batch {
  public:
    Batch(const Options& options, Console& console)
        : options_(options),
          console_(console),
          catalogue_(console.user_folder),
          leaves_(catalogue_),
          shard_(parse_shard(options.batch.shard)),
          jobs_(read_jobs(options.batch.jobs)),
          sheet_formats_(read_sheet(options.batch)),
          plan_(options, catalogue_, leaves_, console),
          variants_(shard_.size(plan_.variants())),
          book_(sheet_params()),
          start_(seconds_now()) {}

    int run() {
        if (!options_.batch.resume && !options_.force) refuse_what_is_there();
        make_folders(options_.output);
        Journal journal(journal_path(), options_.batch.resume);
        if (options_.batch.resume) take_over_manifest(journal);
        journal.begin_run();
        draw_all(journal);
        finish(journal);
        if (report_.error) std::rethrow_exception(report_.error);
        return tell();
    }

  private:
    SheetBookParams sheet_params() const {
        SheetBookParams params;
        params.folder = options_.output;
        params.tiles = variants_;
        params.svg = std::ranges::count(sheet_formats_, Format::svg) > 0;
        params.pdf = std::ranges::count(sheet_formats_, Format::pdf) > 0;
        params.cards = plan_.varies_paper();
        params.heading = plan_.title();
        params.metadata.title = plan_.title();
        params.metadata.command = plan_.command();
        params.metadata.version = kVersion;
        params.metadata.recipe = plan_.recipe();
        return params;
    }

    std::string journal_path() const {
        return (fs::path(options_.output) / (".manifest" + shard_infix(shard_) + ".journal"))
            .string();
    }

    void refuse_what_is_there() const {
        if (!fs::exists(options_.output)) return;
        std::string first;
        std::size_t count = 0;
        const auto look_at = [&](const fs::path& path) {
            std::error_code ignored;
            if (!fs::exists(fs::symlink_status(path, ignored))) return;
            if (count++ == 0) first = path.string();
        };
        const fs::path folder = options_.output;
        for (std::size_t place = 0; place < variants_; ++place) {
            const std::string variant = plan_.name(shard_.variant(place));
            for (const Format format : plan_.formats())
                look_at(folder / (variant + '.' + std::string(name(format))));
        }
        for (const char* ending : {".csv", ".json"})
            look_at(manifest_path(options_.output, shard_) + ending);
        for (const std::string& file : book_.files())
            look_at(file);
        if (count == 0) return;
        throw IoError(fmt::format(
            "'{}' is there already{} (--resume keeps what is still right, --force overwrites)",
            first, count > 1 ? fmt::format(", and {} more files", count - 1) : ""));
    }

    // Rows of an earlier manifest are kept in the journal: a run that is stopped loses none.
    void take_over_manifest(Journal& journal) const {
        const std::string path = manifest_path(options_.output, shard_) + ".json";
        if (!fs::exists(path)) return;
        try {
            ManifestReader reader(path);
            while (const auto row = reader.next_row())
                journal.append(*row);
        } catch (const IoError&) {
            // Not ours: its files are measured again.
        }
    }

    void draw_all(Journal& journal) {
        const bool resume = options_.batch.resume;
        const bool sheets = !sheet_formats_.empty() && !(resume && book_.is_right(options_.force));
        const VariantFiles files(plan_, leaves_, journal,
                                 {options_.output, resume, options_.force, sheets});
        const bool shows = !options_.batch.quiet;
        Progress progress(console_.err, variants_, console_.err_columns, start_);
        const StopSignals signals;
        const RunParams params{variants_, jobs_, [] { return StopSignals::received() != 0; }};
        std::size_t taken = 0;
        report_ = run_variants(
            params, [&](std::size_t place) { return files.draw(shard_.variant(place)); },
            [&](DrawnVariant&& drawn) {
                for (const std::string& row : drawn.rows)
                    journal.append(row);
                count(drawn, progress);
                if (drawn.tile) book_.add(std::move(*drawn.tile));
                if (shows) progress.advance(++taken, seconds_now());
            });
        progress.clear();
        signal_ = StopSignals::received();
    }

    void count(const DrawnVariant& drawn, Progress& progress) {
        files_ += drawn.written;
        drawn_ += drawn.written > 0 ? 1 : 0;
        for (const std::string& warning : drawn.warnings) {
            if (warned_.size() == kMostWarnings || !warned_.insert(warning).second) continue;
            progress.say("edaha: warning: " + warning);
            if (warned_.size() == kMostWarnings)
                progress.say("edaha: warning: further ones are left out");
        }
    }

    void finish(Journal& journal) {
        const bool complete = report_.done == variants_;
        if (complete) finish_sheets();
        try {
            write_manifest(options_.output, manifest_head(plan_, shard_),
                           [&] { return journal.next_line(); });
            if (complete || !journal.knows_earlier_rows()) journal.remove();
        } catch (const IoError&) {
            if (!report_.error) throw;  // else it is most likely the same, a full disk
        }
    }

    void finish_sheets() {
        try {
            book_.finish();
        } catch (const IoError&) {
            report_.error = std::current_exception();
        }
    }

    int tell() {
        const bool stopped = report_.done < variants_;
        const double seconds = seconds_now() - start_;
        if (options_.json) print_report(seconds);
        if (stopped) {
            console_.err << fmt::format(
                "edaha: stopped after {} of {} variants; --resume goes on\n", report_.done,
                variants_);
            console_.ended_by_signal = signal_;
            return 128 + signal_;
        }
        if (options_.batch.quiet) return 0;
        const std::size_t kept = report_.done - drawn_;
        console_.err << fmt::format("edaha: drew {} of {} variants ({} files) in {:.1f} s", drawn_,
                                    variants_, files_, seconds);
        if (drawn_ > 0)
            console_.err << fmt::format(", {:.0f}/s", static_cast<double>(drawn_) / seconds);
        if (kept > 0) console_.err << fmt::format("; {} were right already", kept);
        console_.err << '\n';
        return 0;
    }

    void print_report(double seconds) const {
        nlohmann::ordered_json json;
        json["folder"] = options_.output;
        json["manifest"] = manifest_path(options_.output, shard_) + ".json";
        json["variants"] = variants_;
        json["done"] = report_.done;
        json["drawn"] = drawn_;
        json["files"] = files_;
        json["seconds"] = seconds;
        json["warnings"] = warned_;
        console_.out << json.dump(2) << '\n';
    }

    const Options& options_;
    Console& console_;
    Catalogue catalogue_;
    LeafShelf leaves_;
    Shard shard_;
    std::size_t jobs_;
    std::vector<Format> sheet_formats_;
    BatchPlan plan_;
    std::size_t variants_;  // of the share
    SheetBook book_;
    double start_;
    RunReport report_;
    int signal_ = 0;
    std::size_t drawn_ = 0;
    std::size_t files_ = 0;
    std::set<std::string> warned_;
};

int merge(const Options& options, Console& console) {
    const std::size_t variants =
        merge_manifests(options.output, options.batch.sources, options.force);
    if (!options.batch.quiet)
        console.err << fmt::format("edaha: merged the manifests of {} variants\n", variants);
    return 0;
}

}  // namespace

int batch(const Options& options, Console& console) {
    check_options(options);
    if (options.batch.merge) return merge(options, console);
    return Batch(options, console).run();
}

}  // namespace edaha
