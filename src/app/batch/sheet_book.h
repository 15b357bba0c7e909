// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "drawing/sheet.h"
#include "write/pdf.h"

namespace edaha {

// What a variant brings to the contact sheets.
struct SheetTile {
    Tile tile;
    Colour paper;
    Colour ink;  // reads on that paper
};

struct SheetBookParams {
    std::string folder;
    std::size_t tiles = 0;  // that will be added
    bool svg = true;        // a file a page: sheet-01.svg
    bool pdf = true;        // sheet.pdf
    bool cards = false;     // each tile on its own paper, not all on the first one's
    std::string heading;
    Metadata metadata;  // of all files; its recipe is completed by the page
};

// Contact sheets of a batch, written page by page as their tiles come: memory holds one page. The
// PDF appears with the last page.
class SheetBook {
  public:
    explicit SheetBook(SheetBookParams params);
    ~SheetBook();

    // Whether all its files are there, made for these params. Errors: as has_recipe().
    bool is_right(bool may_be_foreign) const;

    // The paths of its files.
    std::vector<std::string> files() const;

    // Errors of both: IoError.
    void add(SheetTile tile);
    void finish();

  private:
    std::string page_file(std::size_t page) const;
    std::string book_file() const;
    Metadata metadata_of_page(std::size_t page) const;  // 0: the book
    void write_page();

    SheetBookParams params_;
    std::size_t on_page_ = 0;
    std::size_t pages_ = 0;
    std::size_t page_ = 0;  // written ones
    SheetParams layout_;
    std::vector<Tile> tiles_;  // of the page at hand
    std::unique_ptr<AtomicFile> book_file_;
    std::unique_ptr<PdfBook> book_;
};

}  // namespace edaha
