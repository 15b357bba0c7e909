// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "app/pipeline.h"
#include "style/catalogue.h"

namespace edaha {

// Leaf drawings and bark tiles of a catalogue, each read once for any number of pictures and
// threads. Errors of all calls: InputError and IoError, as for the drawing itself.
class LeafShelf {
  public:
    // The catalogue must live as long as this. Relative paths begin at `folder`.
    explicit LeafShelf(const Catalogue& catalogue, std::filesystem::path folder = {})
        : catalogue_(catalogue), folder_(std::move(folder)) {}
    LeafShelf(const LeafShelf&) = delete;
    LeafShelf& operator=(const LeafShelf&) = delete;

    const LeafImport& leaf(const std::string& name);
    const BarkImport& bark(const std::string& name);
    std::string fingerprint(const std::string& name);  // of its text

    // For draw_picture; as long as this lives.
    DrawingLoader loader();

  private:
    SourceText source_of(const std::string& name) const;

    const Catalogue& catalogue_;
    std::filesystem::path folder_;
    std::mutex mutex_;
    std::map<std::string, LeafImport> leaves_;  // which never move
    std::map<std::string, BarkImport> barks_;
    std::map<std::string, std::string> fingerprints_;
};

}  // namespace edaha
