// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/batch/journal.h"
#include "app/batch/plan.h"
#include "app/batch/sheet_book.h"
#include "app/picture_file.h"

namespace edaha {

struct VariantFilesParams {
    std::string folder;
    bool resume = false;  // leave files alone that are still right
    bool force = false;   // overwrite also what no edaha wrote
    bool tiles = false;   // for sheets
};

// What became of one variant.
struct DrawnVariant {
    std::vector<std::string> rows;  // of all its files, as JSON
    std::size_t written = 0;        // files; the others were right
    std::vector<std::string> warnings;
    std::optional<SheetTile> tile;  // with VariantFilesParams::tiles
};

// Draws variants into files, for any number of threads at once.
class VariantFiles {
  public:
    // All must live as long as this.
    VariantFiles(const BatchPlan& plan, LeafShelf& leaves, const Journal& journal,
                 VariantFilesParams params)
        : plan_(plan), leaves_(leaves), journal_(journal), params_(std::move(params)) {}

    // Draws and writes what is missing or changed. A file is right if it records the recipe that it
    // would get now. Errors: InputError, IoError.
    DrawnVariant draw(std::size_t index) const;

  private:
    struct Wanted {
        FileRow row;
        Format format = Format::svg;
        bool right = false;     // on the disk
        bool measured = false;  // its row is complete
    };
    Wanted look_at(const std::string& name, Format format, const std::string& recipe) const;
    void write(Wanted& file, const Picture& picture, const WriteParams& params,
               DrawnVariant& drawn) const;
    std::string path_of(const FileRow& row) const;
    Measures measure(const Picture& picture, const Style& style) const;

    const BatchPlan& plan_;
    LeafShelf& leaves_;
    const Journal& journal_;
    VariantFilesParams params_;
};

// Makes the folder, and those above it. Errors: IoError, "cannot make the folder 'out': …".
void make_folders(const std::string& folder);

}  // namespace edaha
