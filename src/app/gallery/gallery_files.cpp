// SPDX-License-Identifier: MIT
#include "app/gallery/gallery_files.h"

#include <algorithm>
#include <optional>
#include <set>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "app/gallery/gallery_pages.h"
#include "app/gallery/plate.h"
#include "base/atomic_file.h"
#include "base/error.h"
#include "write/format.h"
#include "write/png_pixels.h"

namespace edaha {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = std::size_t{1} << 30;

// Steps of 255 by which a shade may differ: other versions of Cairo round edges otherwise.
constexpr int kSameShade = 2;

std::optional<std::string> read_if_there(const fs::path& path) {
    std::error_code ignored;
    if (!fs::exists(fs::symlink_status(path, ignored))) return std::nullopt;
    return read_file(path.string(), kMostBytes);
}

void write_whole(const fs::path& path, const std::string& bytes) {
    AtomicFile file(path.string());
    file.write(bytes);
    file.commit();
}

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) {
        throw IoError("cannot make the folder '" + folder.string() + "': " + error.message());
    }
}

// What happens to each plate, in any order, on several threads.
template <class Each>
void for_each_plate(const Gallery& gallery, int jobs, const Each& each) {
    tbb::task_arena arena(jobs > 0 ? jobs : tbb::task_arena::automatic);
    arena.execute([&] {
        const tbb::blocked_range<std::size_t> all(0, gallery.plates.size(), 1);
        tbb::parallel_for(
            all,
            [&](const tbb::blocked_range<std::size_t>& some) {
                for (std::size_t i = some.begin(); i != some.end(); ++i)
                    each(i);
            },
            tbb::simple_partitioner());
    });
}

// The pictures in page folders that no plate has.
std::vector<std::string> stale_files(const Gallery& gallery, const fs::path& folder) {
    std::set<std::string> known;
    for (const Plate& plate : gallery.plates)
        known.insert({plate.stem() + ".svg", plate.stem() + ".png"});
    std::vector<std::string> stale;
    for (const GalleryPage& page : gallery.pages) {
        std::error_code error;
        fs::directory_iterator entry(folder / page.name, error);
        for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
            const std::string name = page.name + '/' + entry->path().filename().string();
            const bool is_picture = name.ends_with(".svg") || name.ends_with(".png");
            if (is_picture && !known.contains(name)) stale.push_back(name);
        }
    }
    std::ranges::sort(stale);
    return stale;
}

// A README.md of somebody's own must not be lost.
void refuse_to_replace(const Gallery& gallery, const fs::path& folder) {
    std::vector<std::string> names{"README.md", "index.html"};
    for (const GalleryPage& page : gallery.pages)
        names.push_back(page.name + ".md");
    for (const std::string& name : names) {
        const fs::path path = folder / name;
        const auto text = read_if_there(path);
        if (!text || text->find(kPageMark) != std::string::npos) continue;
        throw IoError("'" + path.string() +
                      "' is there already, and edaha gallery has not written it (move it away)");
    }
}

void append(std::vector<std::string>& names, const std::vector<std::string>& more) {
    names.insert(names.end(), more.begin(), more.end());
}

void add_once(std::vector<std::string>& texts, const std::vector<std::string>& more) {
    for (const std::string& text : more) {
        if (std::ranges::count(texts, text) == 0) texts.push_back(text);
    }
}

PlateFacts facts_of(const Plate& plate, const std::string& svg, const std::string& png) {
    const PixelSize size = png_size(png);
    return {svg.size(), size.width, size.height, paper_of(plate)};
}

// One plate's share of a report.
struct Outcome {
    PlateFacts facts;
    GalleryReport report;
};

Outcome update(const Plate& plate, const GalleryPlace& place, LeafShelf& leaves) {
    const fs::path& folder = place.folder;
    const PlateRecipes recipes = recipes_of(plate, leaves);
    const fs::path svg_file = folder / (plate.stem() + ".svg");
    const fs::path png_file = folder / (plate.stem() + ".png");
    const auto svg = read_if_there(svg_file), png = read_if_there(png_file);
    const bool is_there = svg && png && recorded_recipe(*svg, Format::svg) == recipes.svg &&
                          recorded_recipe(*png, Format::png) == recipes.png;
    if (is_there && !place.all) return {facts_of(plate, *svg, *png), {}};
    const PlateFiles files = draw_plate(plate, leaves);
    make_folder(folder / plate.page);
    write_whole(svg_file, files.svg);
    write_whole(png_file, files.png);
    Outcome outcome{facts_of(plate, files.svg, files.png), {}};
    outcome.report.drawn = {plate.stem() + ".svg"};
    outcome.report.warnings = files.warnings;
    return outcome;
}

bool is_same_text(const std::string& expected, const std::string& actual) {
    return expected == actual;
}

// zlib too packs otherwise in other versions: what counts are the pixels and what they record.
bool is_same_png(const std::string& expected, const std::string& actual) {
    return expected == actual ||
           (recorded_recipe(expected, Format::png) == recorded_recipe(actual, Format::png) &&
            are_alike(expected, actual, kSameShade));
}

template <class IsSame>
void compare(const std::string& name, const std::string& expected, const fs::path& folder,
             const IsSame& is_same, GalleryReport& report) {
    const auto actual = read_if_there(folder / name);
    if (!actual) {
        report.missing.push_back(name);
    } else if (!is_same(expected, *actual)) {
        report.different.push_back(name);
    }
}

Outcome check(const Plate& plate, const fs::path& folder, LeafShelf& leaves) {
    const PlateFiles files = draw_plate(plate, leaves);
    Outcome outcome{facts_of(plate, files.svg, files.png), {}};
    compare(plate.stem() + ".svg", files.svg, folder, is_same_text, outcome.report);
    compare(plate.stem() + ".png", files.png, folder, is_same_png, outcome.report);
    outcome.report.warnings = files.warnings;
    return outcome;
}

// The report of all plates, in their order, and what the pages say of them.
template <class Each>
GalleryReport run(const Gallery& gallery, const GalleryPlace& place, std::vector<PlateFacts>& facts,
                  const Each& each) {
    std::vector<Outcome> outcomes(gallery.plates.size());
    for_each_plate(gallery, place.jobs,
                   [&](std::size_t i) { outcomes[i] = each(gallery.plates[i]); });
    GalleryReport report;
    for (const Outcome& outcome : outcomes) {
        facts.push_back(outcome.facts);
        append(report.drawn, outcome.report.drawn);
        append(report.missing, outcome.report.missing);
        append(report.different, outcome.report.different);
        add_once(report.warnings, outcome.report.warnings);
    }
    report.stale = stale_files(gallery, place.folder);
    return report;
}

}  // namespace

GalleryReport update_gallery(const Gallery& gallery, const GalleryPlace& place, LeafShelf& leaves) {
    refuse_to_replace(gallery, place.folder);
    std::vector<PlateFacts> facts;
    GalleryReport report = run(gallery, place, facts,
                               [&](const Plate& plate) { return update(plate, place, leaves); });
    for (const PageFile& file : gallery_pages(gallery, facts)) {
        if (read_if_there(place.folder / file.name) == file.text) continue;
        write_whole(place.folder / file.name, file.text);
        report.written.push_back(file.name);
    }
    return report;
}

GalleryReport check_gallery(const Gallery& gallery, const GalleryPlace& place, LeafShelf& leaves) {
    std::vector<PlateFacts> facts;
    GalleryReport report = run(gallery, place, facts, [&](const Plate& plate) {
        return check(plate, place.folder, leaves);
    });
    for (const PageFile& file : gallery_pages(gallery, facts))
        compare(file.name, file.text, place.folder, is_same_text, report);
    return report;
}

}  // namespace edaha
