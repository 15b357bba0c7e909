// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "app/batch/name_pattern.h"
#include "app/batch/variation.h"
#include "app/console.h"
#include "app/leaf_shelf.h"
#include "app/options.h"
#include "app/tree_style.h"
#include "write/format.h"

namespace edaha {

// One of a batch's pictures, before it is drawn. `tree.command` is the plain "edaha draw …" that
// draws it.
struct Variant {
    std::string name;     // of its files: a path from the batch's folder, without ending
    std::string palette;  // "main": the style's own
    TreeStyle tree;
};

// What a batch is to draw: for each style, so many seeds. All that can be wrong with the command
// line and the styles is found when it is made; drawing finds no such thing any more.
class BatchPlan {
  public:
    // Reads each style once. Errors: UsageError; InputError and IoError for styles and leaves.
    BatchPlan(const Options& options, const Catalogue& catalogue, LeafShelf& leaves,
              Console& console);

    std::size_t variants() const { return bases_.size() * per_style_; }

    // The index counts from 0, style by style. Depends on nothing but the plan. For any thread.
    Variant variant(std::size_t index) const;
    std::string name(std::size_t index) const;

    const std::vector<Format>& formats() const { return formats_; }
    const WriteOptions& write() const { return write_; }

    // What may differ from variant to variant, in the table's order: set by an option, or different
    // in the styles themselves. Not the seed.
    const std::vector<const Parameter*>& differing() const { return differing_; }
    bool varies_palette() const;
    bool varies_paper() const;

    // "cherry, oak, seeds 1 to 500"
    std::string title() const;

    // The batch again, without what decides only where, how fast and which share.
    const std::string& command() const { return command_; }

    // Equal for two plans that draw the same, byte for byte.
    const std::string& recipe() const { return recipe_; }

  private:
    void read_variations(const Options& options);
    void read_styles(const std::vector<std::string>& names, const Catalogue& catalogue,
                     Console& console);
    void check_styles(LeafShelf& leaves) const;
    void check_names_in(const Variation& variation, LeafShelf& leaves) const;
    void check_names() const;
    void find_differing();
    std::string make_recipe(LeafShelf& leaves) const;
    Position position(std::size_t index) const;
    TreeOptions changes(std::size_t index) const;
    TreeStyle tree(std::size_t index) const;
    std::string palette(std::size_t index) const;
    std::string field_text(const std::string& field, std::size_t index) const;
    std::string checked_name(std::size_t index) const;
    std::string describe(std::size_t index) const;

    std::vector<TreeStyle> bases_;
    std::size_t per_style_ = 0;
    std::size_t first_seed_ = 1;
    std::vector<Variation> variations_;  // later ones win
    std::string size_;
    bool background_ = false;
    WriteOptions write_;
    std::vector<Format> formats_;
    NamePattern pattern_;
    bool has_sheets_;
    std::vector<const Parameter*> differing_;
    std::string command_;
    std::string recipe_;
};

// "svg,pdf", each once; empty: svg. Errors: UsageError.
std::vector<Format> parse_formats(const std::string& text);

}  // namespace edaha
