// SPDX-License-Identifier: MIT
#include "base/nearest_name.h"

#include <algorithm>
#include <vector>

namespace edaha {
namespace {

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool same(char a, char b) {
    return lower(a) == lower(b);
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before_last(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::swap(before_last, last);
        std::swap(last, row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = last[j - 1] + (same(a[i - 1], b[j - 1]) ? 0 : 1);
            row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
            if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1])) {
                row[j] = std::min(row[j], before_last[j - 2] + 1);
            }
        }
    }
    return row[b.size()];
}

}  // namespace

std::optional<std::string> nearest_name(std::string_view wrong,
                                        std::span<const std::string> known) {
    std::size_t least = std::max<std::size_t>(1, wrong.size() / 3) + 1;
    std::optional<std::string> nearest;
    for (const std::string& name : known) {
        const std::size_t longer = std::max(name.size(), wrong.size());
        if (longer - std::min(name.size(), wrong.size()) >= least) continue;
        const std::size_t distance = edit_distance(wrong, name);
        if (distance >= least) continue;
        least = distance;
        nearest = name;
    }
    return nearest;
}

std::string did_you_mean(std::string_view wrong, const std::vector<std::string>& known) {
    const auto nearest = nearest_name(wrong, known);
    return nearest ? " (did you mean '" + *nearest + "'?)" : "";
}

}  // namespace edaha
