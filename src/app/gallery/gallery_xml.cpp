// SPDX-License-Identifier: MIT
#include "app/gallery/gallery_xml.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "app/gallery/element_reader.h"
#include "app/gallery/manual_reader.h"
#include "app/gallery/tree_reader.h"
#include "style/value.h"

namespace edaha {
namespace {

using Names = std::vector<std::string>;

// A strip is 250 mm wide at most: more pictures would be less than 10 mm.
constexpr std::size_t kMostInRow = 20;

// Leaves some room beside the gaps of a row.
constexpr int kLeastPoster_mm = 200;

// Whether a sheet's cells are wide and high enough to show something beside their captions.
bool has_room(const SheetParams& params) {
    constexpr double kLeast_mm = 5;
    constexpr double kCaptions = 3;  // what a caption takes, in its capitals
    const auto cell = [&](double page_mm, int count) {
        return (page_mm - 2 * params.margin_mm + params.gap_mm) / count - params.gap_mm;
    };
    return cell(params.width_mm, params.columns) >= kLeast_mm &&
           cell(params.height_mm, params.rows) - kCaptions * params.caption_mm >= kLeast_mm;
}

class GalleryReader {
  public:
    GalleryReader(const GallerySource& source, const Catalogue& catalogue, LeafShelf& leaves)
        : source_(source),
          problems_(source.text, source.origin),
          elements_(problems_),
          trees_(catalogue, source.folder, leaves, problems_) {}

    Gallery read() {
        const XmlElement root = read_xml(source_.text, "gallery", problems_);
        if (!root.name.empty()) read_gallery(root);
        std::vector<Problem> problems = problems_.sorted();
        if (!problems.empty()) throw InputError(std::move(problems));
        return std::move(gallery_);
    }

  private:
    // ---- pages

    void read_gallery(const XmlElement& root) {
        elements_.check_attributes(root, {"title", "description"});
        gallery_.title = elements_.required(root, "title");
        if (const std::string* const text = find_attribute(root, "description"))
            gallery_.description = elements_.line(*text, place_of(root, "description"));
        elements_.read_children(root, {{"page", [&](const XmlElement& page) { read_page(page); }}});
        if (gallery_.pages.empty()) problems_.say(root.offset, "gallery: there is no page in it");
    }

    void read_page(const XmlElement& element) {
        elements_.check_attributes(element, {"name", "title"});
        GalleryPage page{elements_.file_name(element), elements_.required(element, "title"), {}};
        // README.md is the gallery's own, on systems too where capitals count for nothing.
        const bool taken = page.name == "readme" ||
                           std::ranges::count(gallery_.pages, page.name, &GalleryPage::name) > 0;
        if (taken) {
            problems_.say(place_of(element, "name"),
                          fmt::format("page.name: {} is taken", in_quotes(page.name)));
        }
        gallery_.pages.push_back(std::move(page));
        elements_.read_children(element,
                                {{"text", [&](const XmlElement& e) { read_text(e); }},
                                 {"picture", [&](const XmlElement& e) { read_picture(e); }},
                                 {"strip", [&](const XmlElement& e) { read_strip(e); }},
                                 {"sheet", [&](const XmlElement& e) { read_sheet(e); }},
                                 {"poster", [&](const XmlElement& e) { read_poster(e); }},
                                 {"sweep", [&](const XmlElement& e) { read_sweep(e); }},
                                 {"parameters", [&](const XmlElement& e) { read_parameters(e); }},
                                 {"table", [&](const XmlElement& e) { read_table(e); }}});
    }

    GalleryPage& page() { return gallery_.pages.back(); }

    void read_text(const XmlElement& element) {
        elements_.check_attributes(element, {});
        for (const XmlElement& child : element.children)
            problems_.say(child.offset,
                          fmt::format("{} has no place in 'text'", in_quotes(child.name)));
        for (Line& line : read_paragraphs(element.text)) {
            elements_.check_addresses(line, element.offset);
            page().blocks.emplace_back(std::move(line));
        }
    }

    void read_table(const XmlElement& element) {
        elements_.check_attributes(element, {});
        Table table;
        const auto read_row = [&](const XmlElement& row) {
            elements_.check_attributes(row, {"head"});
            table.rows.push_back({elements_.flag(row, "head"), {}});
            elements_.read_children(row, {{"cell", [&](const XmlElement& cell) {
                                               elements_.check_attributes(cell, {});
                                               table.rows.back().cells.push_back(
                                                   elements_.line(cell.text, cell.offset));
                                           }}});
        };
        elements_.read_children(element, {{"row", read_row}});
        page().blocks.emplace_back(std::move(table));
    }

    // ---- pictures

    // Takes a plate into the gallery and the page.
    PlateReference add(Plate plate, std::size_t offset) {
        plate.page = page().name;
        if (!stems_.insert(plate.stem()).second) {
            problems_.say(offset,
                          fmt::format("there are two pictures {}", in_quotes(plate.stem())));
        }
        gallery_.plates.push_back(std::move(plate));
        return {gallery_.plates.size() - 1};
    }

    void add_tree(Plate& plate, const XmlElement& element, const TreeWords& words,
                  const std::string& caption) {
        if (words.options.style.empty()) {
            problems_.say(element.offset, element.name + ": style is missing");
        } else if (auto tree = trees_.tree(words)) {
            plate.trees.push_back({std::move(*tree), caption});
        }
    }

    Plate plate_of(const XmlElement& element) {
        Plate plate;
        plate.name = elements_.file_name(element);
        plate.caption = elements_.caption(element);
        plate.thumbnail_px = elements_.count(element, "thumbnail", 0, 8192);
        return plate;
    }

    void read_picture(const XmlElement& element) {
        elements_.check_attributes(element, with_tree({"name", "caption", "thumbnail"}));
        elements_.read_children(element, {{"set", ElementReader::nothing}});
        Plate plate = plate_of(element);
        add_tree(plate, element, trees_.read(element), {});
        page().blocks.emplace_back(add(std::move(plate), element.offset));
    }

    void read_tiles(Plate& plate, const XmlElement& element, const TreeWords& common) {
        const auto read_tile = [&](const XmlElement& tile) {
            elements_.check_attributes(tile, with_tree({"caption"}));
            elements_.read_children(tile, {{"set", ElementReader::nothing}});
            const std::string* const caption = find_attribute(tile, "caption");
            add_tree(plate, tile, trees_.read(tile, common), caption == nullptr ? "" : *caption);
        };
        elements_.read_children(element, {{"picture", read_tile}, {"set", ElementReader::nothing}});
        const auto pictures =
            std::ranges::count(element.children, std::string("picture"), &XmlElement::name);
        if (pictures == 0) {
            problems_.say(element.offset, element.name + ": there is no picture in it");
        }
    }

    void check_row(std::size_t pictures, const XmlElement& element) {
        if (pictures <= kMostInRow) return;
        problems_.say(element.offset,
                      fmt::format("{}: more than {} pictures in a row (a poster has several)",
                                  element.name, kMostInRow));
    }

    StripParams strip_params(const XmlElement& element) {
        StripParams params;
        params.tallest_mm = elements_.length_mm(element, "height", params.tallest_mm);
        return params;
    }

    void read_strip(const XmlElement& element) {
        elements_.check_attributes(element, with_tree({"name", "caption", "height", "thumbnail"}));
        Plate plate = plate_of(element);
        plate.arrangement = strip_params(element);
        read_tiles(plate, element, trees_.read(element));
        check_row(plate.trees.size(), element);
        page().blocks.emplace_back(add(std::move(plate), element.offset));
    }

    void read_sheet(const XmlElement& element) {
        elements_.check_attributes(element, with_tree({"name", "caption", "width", "height",
                                                       "columns", "lettering", "thumbnail"}));
        Plate plate = plate_of(element);
        SheetParams params;
        params.width_mm = elements_.length_mm(element, "width", params.width_mm);
        params.height_mm = elements_.length_mm(element, "height", params.height_mm);
        params.columns = elements_.count(element, "columns", params.columns, 100);
        params.caption_mm = elements_.length_mm(element, "lettering", params.caption_mm);
        read_tiles(plate, element, trees_.read(element));
        const int tiles = static_cast<int>(plate.trees.size());
        params.rows = std::max(1, (tiles + params.columns - 1) / params.columns);
        if (!has_room(params)) {
            problems_.say(element.offset, "sheet: there is no room for so many pictures");
        }
        plate.arrangement = params;
        page().blocks.emplace_back(add(std::move(plate), element.offset));
    }

    void read_poster(const XmlElement& element) {
        elements_.check_attributes(
            element, with_tree({"name", "caption", "width", "lettering", "thumbnail"}));
        Plate plate = plate_of(element);
        PosterParams params;
        params.width_mm = elements_.length_mm(element, "width", params.width_mm);
        params.caption_mm = elements_.length_mm(element, "lettering", params.caption_mm);
        const TreeWords common = trees_.read(element);
        const auto read_row = [&](const XmlElement& row) {
            elements_.check_attributes(row, {});
            const std::size_t before = plate.trees.size();
            read_tiles(plate, row, common);
            params.rows.push_back(plate.trees.size() - before);
            check_row(params.rows.back(), row);
        };
        elements_.read_children(element, {{"row", read_row}, {"set", ElementReader::nothing}});
        if (params.rows.empty()) problems_.say(element.offset, "poster: there is no row in it");
        if (params.width_mm < kLeastPoster_mm) {
            problems_.say(place_of(element, "width"),
                          fmt::format("width: a poster has {} mm at least", kLeastPoster_mm));
        }
        plate.arrangement = std::move(params);
        page().blocks.emplace_back(add(std::move(plate), element.offset));
    }

    // A strip over the values of a parameter; where there are several seeds, one for each value.
    void read_sweep(const XmlElement& element) {
        elements_.check_attributes(element, with_tree({"name", "caption", "height", "parameter",
                                                       "values", "seeds", "thumbnail"}));
        elements_.read_children(element, {{"set", ElementReader::nothing}});
        const std::string* const seeds = find_attribute(element, "seeds");
        const Sweep sweep{elements_.required(element, "parameter"),
                          split(elements_.required(element, "values"), "|"),
                          split(seeds == nullptr ? "" : *seeds, kBlanks)};
        if (find_parameter(sweep.parameter) == nullptr) {
            problems_.say(place_of(element, "parameter"), unknown_parameter(sweep.parameter));
            return;
        }
        const TreeWords words = trees_.read(element);
        if (sweep.seeds.size() > 1) {
            Line caption = elements_.caption(element);
            if (!caption.empty()) page().blocks.emplace_back(std::move(caption));
            for (std::size_t i = 0; i < sweep.values.size(); ++i)
                add_siblings(element, sweep, words, i);
            return;
        }
        Plate plate = sweep_plate(element, sweep);
        for (const std::string& value : sweep.values) {
            TreeWords each = words;
            set_seed(each, sweep, 0, element);
            trees_.set(each, sweep.parameter, value, place_of(element, "values"));
            add_tree(plate, element, each, value);
        }
        check_row(plate.trees.size(), element);
        page().blocks.emplace_back(add(std::move(plate), element.offset));
    }

    struct Sweep {
        std::string parameter;
        Names values;
        Names seeds;
    };

    Plate sweep_plate(const XmlElement& element, const Sweep& sweep) {
        Plate plate = plate_of(element);
        plate.arrangement = strip_params(element);
        plate.keywords = sweep.parameter;
        if (plate.caption.empty()) plate.caption = {{Words::Kind::code, sweep.parameter}};
        return plate;
    }

    void set_seed(TreeWords& words, const Sweep& sweep, std::size_t i, const XmlElement& element) {
        if (sweep.seeds.empty()) return;
        trees_.set(words, "variant.seed", sweep.seeds[i], place_of(element, "seeds"));
    }

    void add_siblings(const XmlElement& element, const Sweep& sweep, const TreeWords& words,
                      std::size_t index) {
        const std::string& value = sweep.values[index];
        Plate plate = sweep_plate(element, sweep);
        plate.name += '-' + std::to_string(index + 1);
        plate.caption = {{Words::Kind::code, sweep.parameter + '=' + value}};
        for (std::size_t i = 0; i < sweep.seeds.size(); ++i) {
            TreeWords each = words;
            set_seed(each, sweep, i, element);
            trees_.set(each, sweep.parameter, value, place_of(element, "values"));
            add_tree(plate, element, each, "seed " + sweep.seeds[i]);
        }
        check_row(plate.trees.size(), element);
        page().blocks.emplace_back(add(std::move(plate), element.offset));
    }

    void read_parameters(const XmlElement& element) {
        const auto keep = [&](Plate plate) { return add(std::move(plate), element.offset).index; };
        for (ManualGroup& group : read_manual(element, {elements_, trees_, problems_, keep}))
            page().blocks.emplace_back(std::move(group));
    }

    const GallerySource& source_;
    XmlProblems problems_;
    ElementReader elements_;
    TreeReader trees_;
    Gallery gallery_;
    std::set<std::string> stems_;
};

}  // namespace

Gallery read_gallery(const GallerySource& source, const Catalogue& catalogue, LeafShelf& leaves) {
    return GalleryReader(source, catalogue, leaves).read();
}

}  // namespace edaha
