// SPDX-License-Identifier: MIT
#include "app/batch/sheet_book.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/core.h>

#include "app/batch/present_file.h"
#include "app/picture_file.h"
#include "base/fingerprint.h"

namespace edaha {
namespace {

// The sheet reads no more of it than its colour: any shape will do.
void lay_on_card(Drawing& drawing, Colour paper) {
    Layer card{kBackgroundLabel, {}, {}};
    card.paint.fill = paper;
    card.children.emplace_back(Shape{});
    drawing.layers.insert(drawing.layers.begin(), std::move(card));
}

bool has_card(const Drawing& drawing) {
    return std::ranges::any_of(drawing.layers,
                               [](const Layer& layer) { return layer.label == kBackgroundLabel; });
}

}  // namespace

SheetBook::SheetBook(SheetBookParams params) : params_(std::move(params)) {
    // Few pictures fill the page as well as many do.
    const auto tiles = static_cast<double>(params_.tiles);
    const double across = std::sqrt(tiles * layout_.columns / layout_.rows);
    layout_.columns = std::min(layout_.columns, static_cast<int>(std::ceil(across)));
    const double down = std::ceil(tiles / layout_.columns);
    layout_.rows = static_cast<int>(std::min<double>(layout_.rows, down));
    on_page_ = static_cast<std::size_t>(layout_.columns) * static_cast<std::size_t>(layout_.rows);
    pages_ = (params_.tiles + on_page_ - 1) / on_page_;
    layout_.heading = params_.heading;
    layout_.pages = pages_;
}

SheetBook::~SheetBook() = default;

std::string SheetBook::page_file(std::size_t page) const {
    const std::size_t digits = std::max<std::size_t>(2, std::to_string(pages_).size());
    return (std::filesystem::path(params_.folder) / fmt::format("sheet-{:0{}}.svg", page, digits))
        .string();
}

std::string SheetBook::book_file() const {
    return (std::filesystem::path(params_.folder) / "sheet.pdf").string();
}

std::vector<std::string> SheetBook::files() const {
    std::vector<std::string> files;
    for (std::size_t page = 1; params_.svg && page <= pages_; ++page)
        files.push_back(page_file(page));
    if (params_.pdf) files.push_back(book_file());
    return files;
}

Metadata SheetBook::metadata_of_page(std::size_t page) const {
    Fingerprint recipe;
    recipe.add(params_.metadata.recipe);
    recipe.add(std::to_string(page));
    Metadata metadata = params_.metadata;
    metadata.recipe = recipe.text();
    return metadata;
}

bool SheetBook::is_right(bool may_be_foreign) const {
    bool right = true;
    for (std::size_t page = 1; params_.svg && page <= pages_; ++page) {
        const PresentFile file{page_file(page), Format::svg, may_be_foreign};
        right = has_recipe(file, metadata_of_page(page).recipe) && right;
    }
    if (!params_.pdf) return right;
    const PresentFile book{book_file(), Format::pdf, may_be_foreign};
    return has_recipe(book, metadata_of_page(0).recipe) && right;
}

void SheetBook::add(SheetTile tile) {
    if (page_ == 0 && tiles_.empty() && !params_.cards && !has_card(tile.tile.drawing))
        layout_.colours = {tile.paper, tile.ink};
    if (params_.cards && !has_card(tile.tile.drawing)) lay_on_card(tile.tile.drawing, tile.paper);
    tiles_.push_back(std::move(tile.tile));
    if (tiles_.size() == on_page_) write_page();
}

void SheetBook::finish() {
    if (!tiles_.empty()) write_page();
    if (!book_) return;
    book_->finish();
    book_file_->commit();
}

void SheetBook::write_page() {
    layout_.page = ++page_;
    // All pages at the scale of the first, so that trees can be compared.
    if (page_ == 1) layout_.most_scale = sheet_scale(tiles_, layout_);
    Drawing page = sheet_page(tiles_, layout_);
    tiles_.clear();
    if (params_.pdf) {
        if (!book_) {
            book_file_ = std::make_unique<AtomicFile>(book_file());
            book_ = std::make_unique<PdfBook>(
                [file = book_file_.get()](std::string_view bytes) { file->write(bytes); },
                metadata_of_page(0));
        }
        book_->add_page(page);
    }
    page.metadata = metadata_of_page(page_);
    if (params_.svg) write_file(page, page_file(page_), Format::svg, {});
}

}  // namespace edaha
