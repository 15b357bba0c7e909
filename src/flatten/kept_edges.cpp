// SPDX-License-Identifier: MIT
#include "flatten/kept_edges.h"

namespace edaha {
namespace {

std::uint32_t kind_of(LineKind line) {
    return 1 + static_cast<std::uint32_t>(line);
}

}  // namespace

std::vector<std::uint32_t> kept_edges(const LabelledMap& map, FlatLook look) {
    const bool filled = look != FlatLook::lines && look != FlatLook::blueprint;
    const bool lined = look != FlatLook::fills;
    std::vector<std::uint32_t> kinds(map.map.edges.size(), 0);
    for (std::uint32_t e = 0; e < kinds.size(); ++e) {
        const FaceLabel& left = map.labels[map.map.face_of(2 * e)];
        const FaceLabel& right = map.labels[map.map.face_of(2 * e + 1)];
        if (lined && map.line[e] < LineKind::tone) {
            kinds[e] = kind_of(map.line[e]);
        } else if (filled && left != right) {
            kinds[e] = kind_of(left.part == right.part ? LineKind::tone : LineKind::none);
        } else if (look == FlatLook::blueprint && map.hidden[e] < LineKind::tone) {
            kinds[e] = kind_of(map.hidden[e]) + kHiddenKind;
        }
    }
    return kinds;
}

}  // namespace edaha
