// SPDX-License-Identifier: MIT
#pragma once
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/batch/plan.h"
#include "app/batch/shard.h"

namespace edaha {

// The head of a manifest: which run it lists, or which share of one.
struct ManifestHead {
    std::string version;
    std::string command;
    std::string recipe;        // of the plan
    std::size_t variants = 0;  // of the whole run
    std::vector<std::string> formats;
    std::vector<std::string> columns;
    Shard shard;

    bool is_same_run(const ManifestHead& other) const {
        return version == other.version && command == other.command && recipe == other.recipe &&
               variants == other.variants && formats == other.formats && columns == other.columns;
    }
    std::size_t files() const { return shard.size(variants) * formats.size(); }
};

ManifestHead manifest_head(const BatchPlan& plan, const Shard& shard);

// "out/manifest.2-of-8"; .csv and .json are two forms of the same rows.
std::string manifest_path(const std::string& folder, const Shard& shard);

// Gives the rows as lines of JSON, then nothing.
using NextRow = std::function<std::optional<std::string>()>;

// Writes both forms; each appears whole or not at all. In JSON, each row is a line of its own.
// Errors: IoError.
void write_manifest(const std::string& folder, const ManifestHead& head, const NextRow& next_row);

// Reads what write_manifest wrote, line by line: memory does not grow with it.
class ManifestReader {
  public:
    // Errors: IoError if it can't be read, or is no such manifest.
    explicit ManifestReader(const std::string& path);

    const ManifestHead& head() const { return head_; }
    std::optional<std::string> next_row();

  private:
    [[noreturn]] void fail() const;

    std::string path_;
    std::ifstream file_;
    ManifestHead head_;
};

}  // namespace edaha
