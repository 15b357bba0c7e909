// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>

namespace edaha {

// A share of a run's variants: every count-th, from the index-th. One of one is all of it.
struct Shard {
    std::size_t index = 1;  // from 1
    std::size_t count = 1;

    bool is_all() const { return count == 1; }
    std::size_t size(std::size_t variants) const {
        return variants < index ? 0 : (variants - index) / count + 1;
    }
    // Of the share's variants, the place in the whole run; both from 0.
    std::size_t variant(std::size_t place) const { return index - 1 + place * count; }
};

// "2/8"; empty: all. Errors: UsageError.
Shard parse_shard(const std::string& text);

// "2/8"
std::string shard_text(const Shard& shard);

// What stands in the names of its files: ".2-of-8"; empty for all.
std::string shard_infix(const Shard& shard);

// A whole number as an option's value. Errors: UsageError, "-n: '0' is out of range (expected …)".
std::size_t parse_count(const std::string& option, const std::string& text, std::size_t least,
                        std::size_t most);

}  // namespace edaha
