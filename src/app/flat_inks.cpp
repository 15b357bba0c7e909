// SPDX-License-Identifier: MIT
#include "app/flat_inks.h"

namespace edaha {
namespace {

constexpr Colour kBlack{0, 0, 0}, kWhite{255, 255, 255};

// Weathered: light wood that has lost most of its hue.
std::vector<Colour> deadwood_tones(const Palette& p) {
    if (p.strict) return {p.wood, p.wood_light, p.paper};
    const Colour c = p.wood_light;
    const auto grey = static_cast<std::uint8_t>((3 * c.r + 6 * c.g + c.b) / 10);
    const Colour silver = mixed(mixed(c, {grey, grey, grey}, 0.7), kWhite, 0.25);
    return {mixed(silver, p.wood_shade, 0.5), silver, mixed(silver, kWhite, 0.45)};
}

std::vector<Colour> tones_of(const Palette& p, const Material& material) {
    if (material.name == "leaf") return {p.leaf_shade, p.leaf, p.leaf_light};
    if (material.name == "blossom") return {p.blossom_shade, p.blossom, p.blossom_light};
    if (material.name == "fruit") return {p.fruit_shade, p.fruit, p.fruit_light};
    if (material.name == "xylem") return {p.mark, mixed(p.mark, p.wood_shade, 0.5), p.wood_shade};
    if (material.name == "deadwood") return deadwood_tones(p);
    if (material.name == "obstacle") return {p.fruit_shade, p.fruit, p.fruit_light};
    if (!material.colour) return {p.wood_shade, p.wood, p.wood_light};
    const Colour own = *material.colour;
    return {mixed(own, kBlack, 0.35), own, mixed(own, kWhite, 0.35)};
}

}  // namespace

FlattenInks flat_inks(const Palette& palette, const std::vector<Material>& materials) {
    FlattenInks inks;
    for (const Material& material : materials)
        inks.tones.push_back(tones_of(palette, material));
    inks.line = palette.mark;
    inks.hidden = mixed(palette.mark, palette.paper, 0.5);
    inks.paper = palette.paper;
    return inks;
}

Colour middle_tone(const Palette& palette, const Material& material) {
    return tones_of(palette, material)[1];
}

}  // namespace edaha
