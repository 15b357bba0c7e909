// SPDX-License-Identifier: MIT
#include "drawing/subpaths.h"

#include <algorithm>

namespace edaha {

std::vector<Path> subpaths(const Path& path) {
    std::vector<Path> parts;
    const Vec2* point = path.points.data();
    for (const Verb verb : path.verbs) {
        if (verb == Verb::move) parts.emplace_back();
        const int points = verb == Verb::cubic ? 3 : verb == Verb::close ? 0 : 1;
        Path& part = parts.back();
        part.verbs.push_back(verb);
        part.points.insert(part.points.end(), point, point + points);
        point += points;
    }
    return parts;
}

std::size_t node_count(const Path& path) {
    const auto closes = std::count(path.verbs.begin(), path.verbs.end(), Verb::close);
    return path.verbs.size() - static_cast<std::size_t>(closes);
}

}  // namespace edaha
