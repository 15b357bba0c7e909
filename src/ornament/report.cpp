// SPDX-License-Identifier: MIT
#include "ornament/report.h"

#include <algorithm>
#include <utility>

#include "base/locate.h"

namespace edaha::svg {
namespace {

// Nobody reads more, and each costs a walk through the text.
constexpr std::size_t kMostListed = 100;

}  // namespace

void Report::note(Notes& notes, const Spot& spot, const std::string& message) {
    // One beyond the limit is kept, as the sign that there are more.
    if (notes.size() <= kMostListed) notes.insert({spot, message});
}

bool Report::is_full() const {
    return warnings_.size() > kMostListed;
}

void Report::fail(const Spot& spot, const std::string& message) {
    error(spot, message);
    throw InputError(problems(errors_));
}

void Report::throw_if_failed() const {
    if (failed()) throw InputError(problems(errors_));
}

std::size_t Report::offset(const Spot& spot) const {
    if (spot.attribute.empty()) return offset_in_value(text_, spot.node, spot.index);
    if (!spot.in_value) return attribute_offset(text_, spot.node, spot.attribute);
    return offset_in_value(text_, attribute_value_offset(text_, spot.node, spot.attribute),
                           spot.index);
}

std::vector<Problem> Report::problems(const Notes& notes) const {
    std::vector<std::pair<std::size_t, std::string>> found;
    for (const Note& note : notes)
        found.emplace_back(offset(note.spot), note.message);
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Problem> problems;
    for (std::size_t i = 0; i < std::min(found.size(), kMostListed); ++i) {
        problems.push_back({place_of_offset(text_, found[i].first, file_), found[i].second});
    }
    if (found.size() > kMostListed) {
        Problem& more = problems.emplace_back();
        more.place.file = file_;
        more.message = "there are more (100 are listed)";
    }
    return problems;
}

}  // namespace edaha::svg
