// SPDX-License-Identifier: MIT
#include "app/batch/shard.h"

#include <cmath>

#include <fmt/core.h>

#include "app/options.h"
#include "base/number_text.h"
#include "style/value.h"

namespace edaha {
namespace {

// Merging opens the manifests of all: most systems allow a process 1024 open files.
constexpr std::size_t kMostShards = 1000;

std::optional<std::size_t> whole_number(std::string_view text) {
    if (text.empty() || text.find_first_not_of("0123456789") != std::string_view::npos)
        return std::nullopt;
    const auto value = parse_number(text);
    if (!value || *value > 0x1p53) return std::nullopt;
    return static_cast<std::size_t>(*value);
}

}  // namespace

std::size_t parse_count(const std::string& option, const std::string& text, std::size_t least,
                        std::size_t most) {
    const auto value = parse_number(text);
    const bool whole = value && std::floor(*value) == *value;
    if (whole && *value >= static_cast<double>(least) && *value <= static_cast<double>(most))
        return static_cast<std::size_t>(*value);
    throw UsageError(fmt::format("{}: {} is {} (expected {} … {})", option, in_quotes(text),
                                 whole ? "out of range" : "not a whole number", least, most));
}

Shard parse_shard(const std::string& text) {
    if (text.empty()) return {};
    const std::size_t slash = std::min(text.find('/'), text.size());
    const auto index = whole_number(std::string_view(text).substr(0, slash));
    const auto count =
        whole_number(std::string_view(text).substr(std::min(slash + 1, text.size())));
    if (index && count && *index >= 1 && *index <= *count && *count <= kMostShards)
        return {*index, *count};
    throw UsageError(
        fmt::format("--shard: {} is no share (expected i/n, 1 <= i <= n <= {}, as 2/8)",
                    in_quotes(text), kMostShards));
}

std::string shard_text(const Shard& shard) {
    return fmt::format("{}/{}", shard.index, shard.count);
}

std::string shard_infix(const Shard& shard) {
    return shard.is_all() ? "" : fmt::format(".{}-of-{}", shard.index, shard.count);
}

}  // namespace edaha
