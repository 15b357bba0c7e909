// SPDX-License-Identifier: MIT
#include <filesystem>
#include <ostream>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/gallery/gallery_files.h"
#include "app/gallery/gallery_xml.h"
#include "base/atomic_file.h"
#include "base/number_text.h"
#include "style/value.h"

namespace edaha {
namespace {

// A gallery of ten thousand pictures has a tenth of that.
constexpr std::size_t kMostXmlBytes = 16'000'000;
constexpr int kMostJobs = 1024;

int parse_jobs(const std::string& text) {
    if (text.empty()) return 0;
    const auto number = parse_number(text);
    if (number && *number >= 1 && *number <= kMostJobs && *number == static_cast<int>(*number))
        return static_cast<int>(*number);
    throw UsageError(
        fmt::format("--jobs: {} is not a whole number of 1 … {}", in_quotes(text), kMostJobs));
}

using Names = std::vector<std::string>;

void print_json(const std::string& file, std::size_t pictures, const GalleryReport& report,
                bool check, Console& console) {
    nlohmann::ordered_json json;
    json["file"] = file;
    json["pictures"] = pictures;
    if (check) {
        json["missing"] = report.missing;
        json["different"] = report.different;
    } else {
        json["drawn"] = report.drawn;
        json["written"] = report.written;
    }
    json["stale"] = report.stale;
    json["warnings"] = report.warnings;
    console.out << json.dump(2) << '\n';
}

void say_each(const Names& names, const std::filesystem::path& folder, const char* what,
              std::ostream& out) {
    for (const std::string& name : names)
        out << (folder / name).generic_string() << ": " << what << '\n';
}

void report_check(const GalleryReport& report, const GalleryPlace& place, Console& console) {
    say_each(report.missing, place.folder, "is missing", console.out);
    say_each(report.different, place.folder, "is not what is drawn now", console.out);
    say_each(report.stale, place.folder, "is not of this gallery", console.out);
}

void report_update(const GalleryReport& report, std::size_t pictures, const GalleryPlace& place,
                   Console& console) {
    say_each(report.stale, place.folder, "is not of this gallery", console.err);
    console.err << fmt::format("edaha: drew {} of {} pictures\n", report.drawn.size(), pictures);
}

}  // namespace

int make_gallery(const Options& options, Console& console) {
    const std::string& file = options.gallery.file;
    const GalleryPlace place{std::filesystem::path(file).parent_path(),
                             parse_jobs(options.gallery.jobs), options.gallery.all};
    const Catalogue catalogue(console.user_folder);
    LeafShelf leaves(catalogue, place.folder);
    const Gallery gallery =
        read_gallery({read_file(file, kMostXmlBytes), file, place.folder}, catalogue, leaves);
    const std::size_t pictures = gallery.plates.size();
    const bool check = options.gallery.check;
    const GalleryReport report =
        check ? check_gallery(gallery, place, leaves) : update_gallery(gallery, place, leaves);
    for (const std::string& warning : report.warnings)
        console.err << "edaha: warning: " << warning << '\n';
    if (options.json) {
        print_json(file, pictures, report, check, console);
    } else if (check) {
        report_check(report, place, console);
    } else {
        report_update(report, pictures, place, console);
    }
    const bool good = report.missing.empty() && report.different.empty() && report.stale.empty();
    return check && !good ? 1 : 0;
}

}  // namespace edaha
