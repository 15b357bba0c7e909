// SPDX-License-Identifier: MIT
#include "app/batch/merge.h"

#include <algorithm>
#include <deque>
#include <filesystem>
#include <regex>

#include <fmt/core.h>
#include <fmt/format.h>

#include "app/batch/manifest.h"
#include "base/error.h"

namespace edaha {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostNamed = 10;

std::vector<std::string> find_manifests(const std::string& folder) {
    static const std::regex kShare(R"(manifest\.[0-9]+-of-[0-9]+\.json)");
    std::error_code error;
    std::vector<std::string> paths;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        if (std::regex_match(entry.path().filename().string(), kShare))
            paths.push_back(entry.path().string());
    }
    if (error) throw IoError(fmt::format("cannot read '{}': {}", folder, error.message()));
    if (paths.empty())
        throw IoError(fmt::format("there are no manifests of shares in '{}'", folder));
    std::ranges::sort(paths);
    return paths;
}

struct Share {
    std::string path;
    ManifestHead head;
};

std::size_t index_of(const Share& share) {
    return share.head.shard.index;
}

void check_one_run(const std::vector<Share>& shares) {
    const Share& first = shares.front();
    for (std::size_t i = 1; i < shares.size(); ++i) {
        const Share &before = shares[i - 1], &share = shares[i];
        const bool same_count = share.head.shard.count == first.head.shard.count;
        if (!share.head.is_same_run(first.head) || !same_count) {
            throw IoError(
                fmt::format("'{}' and '{}' are not shares of one run", first.path, share.path));
        }
        if (share.head.shard.index == before.head.shard.index)
            throw IoError(fmt::format("'{}' and '{}' are the same share", before.path, share.path));
    }
}

void check_none_missing(const std::vector<Share>& shares) {
    const std::size_t count = shares.front().head.shard.count;
    std::vector<std::string> missing;
    for (std::size_t index = 1; index <= count; ++index) {
        if (std::ranges::count(shares, index, index_of) == 0)
            missing.push_back(shard_text({index, count}));
    }
    if (missing.empty()) return;
    const std::size_t more = missing.size() > kMostNamed ? missing.size() - kMostNamed : 0;
    missing.resize(missing.size() - more);
    throw IoError(fmt::format("shares are missing: {}{}", fmt::join(missing, ", "),
                              more > 0 ? fmt::format(" and {} more", more) : ""));
}

void check_complete(const std::string& path) {
    ManifestReader reader(path);
    std::size_t rows = 0;
    while (reader.next_row())
        ++rows;
    if (rows == reader.head().files()) return;
    throw IoError(
        fmt::format("'{}' is not complete: {} of {} files (--resume of its share goes on)", path,
                    rows, reader.head().files()));
}

bool lists_run(const std::string& path, const ManifestHead& run) {
    try {
        return ManifestReader(path).head().is_same_run(run);
    } catch (const IoError&) {
        return false;  // no manifest at all
    }
}

// Merging again replaces what merging wrote, and nothing else.
void check_place(const std::string& folder, const ManifestHead& run) {
    const std::string place = manifest_path(folder, {});
    for (const std::string& path : {place + ".json", place + ".csv"}) {
        if (!fs::exists(path) || lists_run(place + ".json", run)) continue;
        throw IoError(
            fmt::format("'{}' is there already, and not of this run (--force overwrites)", path));
    }
}

// The rows of all shares in the run's order: a variant of each in turn.
class Interleaved {
  public:
    explicit Interleaved(const std::vector<Share>& shares) {
        for (const Share& share : shares)
            readers_.emplace_back(share.path);
    }

    const ManifestHead& head() const { return readers_.front().head(); }

    std::optional<std::string> next_row() {
        const std::size_t per_variant = head().formats.size();
        if (row_ == head().variants * per_variant) return std::nullopt;
        return readers_[row_++ / per_variant % readers_.size()].next_row();
    }

  private:
    std::deque<ManifestReader> readers_;
    std::size_t row_ = 0;
};

}  // namespace

std::size_t merge_manifests(const std::string& folder, std::vector<std::string> paths, bool force) {
    if (paths.empty()) paths = find_manifests(folder);
    std::vector<Share> shares;
    for (const std::string& path : paths)
        shares.push_back({path, ManifestReader(path).head()});
    std::ranges::stable_sort(shares, {}, index_of);
    check_one_run(shares);
    check_none_missing(shares);
    for (const Share& share : shares)
        check_complete(share.path);
    if (!force) check_place(folder, shares.front().head);
    Interleaved rows(shares);
    ManifestHead whole = rows.head();
    whole.shard = {};
    write_manifest(folder, whole, [&] { return rows.next_row(); });
    return whole.variants;
}

}  // namespace edaha
