// SPDX-License-Identifier: MIT
#include "app/sprigs.h"

#include <algorithm>
#include <array>
#include <iterator>

#include <glm/geometric.hpp>

#include "app/dress.h"
#include "base/keyed_random.h"
#include "energy/grow.h"
#include "energy/limbs.h"
#include "energy/wood.h"
#include "ornament/place_sprigs.h"
#include "ornament/placement.h"

namespace edaha {
namespace {

constexpr std::array<const char*, kSprigTones> kSprigToneNames{"shade", "mid", "light", "back"};

// A sprig in one tone is mostly of that tone, with some of its neighbours': so it has depth, and a
// crown still has large light and dark parts.
Tones tones_in(const Tones& all, SprigTone tone, const Palette& palette) {
    switch (tone) {
        case SprigTone::shade:
            return {all.mid, all.shade, all.shade, all.back};
        case SprigTone::light:
            return {all.light, all.light, all.mid, all.back};
        case SprigTone::back: {
            const Colour far = mixed(all.back, palette.paper, 0.12);
            return {all.back, all.back, far, all.back};
        }
        case SprigTone::mid:
            break;
    }
    return all;
}

Colour wood_in(const Palette& palette, SprigTone tone) {
    if (tone == SprigTone::back) return palette.wood_back;
    if (tone == SprigTone::shade) return palette.wood_shade;
    return palette.wood;
}

void transform(Path& path, const Affine& map) {
    for (Vec2& point : path.points)
        point = edaha::transform(map, point);
}

// All shapes under some elements, moved by the instances' maps.
class ShapeCollector {
  public:
    explicit ShapeCollector(const std::vector<Shape>& leaf) : leaf_(leaf) {}

    void take(const std::vector<Element>& elements, Paint paint) {
        for (const Element& element : elements) {
            if (const auto* group = std::get_if<Group>(&element)) {
                take(group->children, inherit(paint, group->paint));
            } else if (const auto* use = std::get_if<Use>(&element)) {
                for (const Shape& shape : leaf_)
                    add(shape, inherit(paint, use->paint), use->page_from_symbol);
            } else {
                add(std::get<Shape>(element), paint, Affine(1, 0, 0, 1, 0, 0));
            }
        }
    }

    std::vector<Shape> result;

  private:
    static Paint inherit(Paint outer, const Paint& inner) {
        if (inner.fill.kind != Ink::Kind::inherit) outer.fill = inner.fill;
        if (inner.stroke.kind != Ink::Kind::inherit) outer.stroke = inner.stroke;
        if (inner.stroke_width_mm > 0) outer.stroke_width_mm = inner.stroke_width_mm;
        outer.fill_opacity = std::min(outer.fill_opacity, inner.fill_opacity);
        outer.stroke_opacity = std::min(outer.stroke_opacity, inner.stroke_opacity);
        return outer;
    }

    void add(const Shape& shape, const Paint& outer, const Affine& map) {
        Shape made{{}, shape.path, inherit(outer, shape.paint)};
        transform(made.path, map);
        made.paint.stroke_width_mm *= glm::length(map[1]);
        // Neighbours of one paint become one path: a sprig has few tones, and many leaves.
        if (!result.empty() && result.back().paint == made.paint &&
            made.paint.stroke.kind != Ink::Kind::colour) {
            Path& path = result.back().path;
            path.verbs.insert(path.verbs.end(), made.path.verbs.begin(), made.path.verbs.end());
            path.points.insert(path.points.end(), made.path.points.begin(), made.path.points.end());
            return;
        }
        result.push_back(std::move(made));
    }

    const std::vector<Shape>& leaf_;
};

class SprigGrower {
  public:
    SprigGrower(const Style& style,
                const std::function<LeafImport(const std::string& name)>& load_leaf)
        : style_(style), look_(style.look) {
        look_.wood = Look::silhouette;
        look_.root_flare = 0;
        look_.back = 0;
        look_.marks = 0;
        for (const Dress& dress : dresses(style)) {
            if (!dress.params.shape.empty())
                leaves_.push_back({dress, plain(load_leaf(dress.params.shape).leaf.shapes)});
        }
    }

    std::vector<Symbol> run() const {
        const auto variants = static_cast<std::size_t>(style_.sprig.variants);
        std::vector<Symbol> symbols(kSprigTones * variants);
        for (std::size_t i = 0; i < variants; ++i) {
            EnergyParams energy = style_.energy;
            energy.growth.energy = style_.sprig.energy;
            energy.variant.seed = step(energy.variant.seed, i);
            energy.variant.family = step(energy.variant.family, i);
            const Limbs limbs = make_limbs(grow(energy), energy, look_);
            for (std::uint32_t tone = 0; tone < kSprigTones; ++tone) {
                Symbol& symbol = symbols[tone * variants + i];
                symbol.id =
                    std::string("sprig-") + std::to_string(i + 1) + '-' + kSprigToneNames[tone];
                symbol.shapes = draw(limbs, energy.variant, static_cast<SprigTone>(tone));
            }
        }
        return symbols;
    }

  private:
    // Veins and other details would be specks at this size, and many: what takes the tone's colour
    // is enough, if there is any of it.
    static std::vector<Shape> plain(const std::vector<Shape>& leaf) {
        std::vector<Shape> toned;
        std::ranges::copy_if(leaf, std::back_inserter(toned), [](const Shape& shape) {
            return shape.paint.fill.kind == Ink::Kind::inherit && shape.paint.fill_opacity == 1;
        });
        for (Shape& shape : toned)
            shape.paint.stroke = Ink::none();
        return toned.empty() ? leaf : toned;
    }

    struct Ornament {
        Dress dress;
        std::vector<Shape> shapes;
    };

    std::vector<Shape> draw(const Limbs& limbs, const VariantParams& variant,
                            SprigTone tone) const {
        Palette palette = style_.palette;
        palette.wood = palette.wood_light = palette.wood_shade = wood_in(style_.palette, tone);
        std::vector<Shape> behind, front;
        for (const Ornament& ornament : leaves_)
            add(limbs, variant, ornament, tone, behind, front);
        ShapeCollector wood({});
        for (const Layer& layer : draw_wood(limbs, look_, palette).front)
            wood.take(layer.children, layer.paint);
        std::vector<Shape> shapes = std::move(behind);
        shapes.insert(shapes.end(), wood.result.begin(), wood.result.end());
        shapes.insert(shapes.end(), front.begin(), front.end());
        to_length(shapes);
        return shapes;
    }

    void add(const Limbs& limbs, const VariantParams& variant, const Ornament& ornament,
             SprigTone tone, std::vector<Shape>& behind, std::vector<Shape>& front) const {
        PlacementParams params;
        params.ornament = ornament.dress.params;
        params.tones = tones_in(ornament.dress.tones, tone, style_.palette);
        params.label = ornament.dress.label;
        params.salt = ornament.dress.salt;
        params.clump_id = [&](std::int32_t limb) { return std::to_string(limb); };
        params.stroked = has_strokes(ornament.shapes);
        const SiteParams along{params.ornament.along_mm, params.ornament.along_width_mm};
        const KeyedRandom random(variant.family, variant.seed, variant.vary);
        const Placement placement = place(sites(limbs, look_, along), params, random);
        ShapeCollector low(ornament.shapes), high(ornament.shapes);
        low.take(placement.behind.children, placement.behind.paint);
        high.take(placement.front.children, placement.front.paint);
        behind.insert(behind.end(), low.result.begin(), low.result.end());
        front.insert(front.end(), high.result.begin(), high.result.end());
    }

    // Control points lie a little outside their curves: near enough for a size.
    static void to_length(std::vector<Shape>& shapes) {
        double reach = 1e-9;
        for (const Shape& shape : shapes) {
            for (const Vec2 point : shape.path.points)
                reach = std::max(reach, glm::length(point));
        }
        const double scale = kLeafLength / reach;
        for (Shape& shape : shapes) {
            transform(shape.path, Affine(scale, 0, 0, scale, 0, 0));
            shape.paint.stroke_width_mm *= scale;
        }
    }

    const Style& style_;
    LookParams look_;
    std::vector<Ornament> leaves_;
};

}  // namespace

std::vector<Symbol> grow_sprigs(
    const Style& style, const std::function<LeafImport(const std::string& name)>& load_leaf) {
    return SprigGrower(style, load_leaf).run();
}

}  // namespace edaha
