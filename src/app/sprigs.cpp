// SPDX-License-Identifier: MIT
#include "app/sprigs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <glm/geometric.hpp>

#include "app/dress.h"
#include "base/keyed_random.h"
#include "energy/grow.h"
#include "energy/limbs.h"
#include "energy/wood.h"
#include "geometry/unite.h"
#include "ornament/place_sprigs.h"
#include "ornament/placement.h"

namespace edaha {
namespace {

constexpr std::array<const char*, kSprigParts> kSprigPartNames{"stem", "inner", "outer"};

// Leaves whose far end is nearer to the foot than this part of the sprig's reach are inner ones:
// less and all tufts are flat, more and they are dark.
constexpr double kInner = 0.62;

// A stem begins with this part of its width and has all of it so many widths on: the twig that it
// stands on may be thinner than it, and a wider foot would stick out behind that with its corners.
constexpr double kFootWidth = 0.25;
constexpr double kFootLength = 4;

// Of wood that rises from the origin; y down.
void narrow_foot(std::vector<Shape>& wood) {
    constexpr double kAtFoot_mm = 0.05;  // as it leans, one corner is that much higher
    double half = 0;
    for (const Shape& shape : wood) {
        for (const Vec2 point : shape.path.points)
            if (point.y > -kAtFoot_mm) half = std::max(half, std::abs(point.x));
    }
    if (half == 0) return;
    for (Shape& shape : wood) {
        for (Vec2& point : shape.path.points) {
            const double t = std::clamp(-point.y / (2 * half * kFootLength), 0.0, 1.0);
            point.x *= kFootWidth + (1 - kFootWidth) * t * (2 - t);
        }
    }
}

void transform(Path& path, const Affine& map) {
    for (Vec2& point : path.points)
        point = edaha::transform(map, point);
}

// All paths under some elements.
void take_paths(const std::vector<Element>& elements, std::vector<Path>& paths) {
    for (const Element& element : elements) {
        if (const auto* group = std::get_if<Group>(&element)) take_paths(group->children, paths);
        if (const auto* shape = std::get_if<Shape>(&element)) paths.push_back(shape->path);
    }
}

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
                ornaments_.push_back({dress, plain(load_leaf(dress.params.shape).leaf.shapes)});
        }
    }

    std::vector<Symbol> run() const {
        std::vector<Symbol> symbols;
        for (std::int64_t i = 0; i < style_.sprig.variants; ++i) {
            EnergyParams energy = style_.energy;
            energy.growth.energy = style_.sprig.energy;
            energy.variant.seed = step(energy.variant.seed, static_cast<Key>(i));
            energy.variant.family = step(energy.variant.family, static_cast<Key>(i));
            Parts parts = draw(make_limbs(grow(energy), energy, look_), energy.variant);
            for (std::uint32_t part = 0; part < kSprigParts; ++part) {
                symbols.push_back(
                    {"sprig-" + std::to_string(i + 1) + '-' + kSprigPartNames[part], {}});
                symbols.back().shapes = std::move(parts[part]);
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

    using Parts = std::array<std::vector<Shape>, kSprigParts>;

    Parts draw(const Limbs& limbs, const VariantParams& variant) const {
        Parts parts;
        std::vector<Path> wood;
        for (const Layer& layer : draw_wood(limbs, look_, style_.palette).front)
            take_paths(layer.children, wood);
        parts[0] = united(wood);
        narrow_foot(parts[0]);
        for (const Ornament& ornament : ornaments_)
            add(ornament, limbs, variant, parts);
        to_length(parts);
        return parts;
    }

    void add(const Ornament& ornament, const Limbs& limbs, const VariantParams& variant,
             Parts& parts) const {
        const std::vector<Affine> maps = places(ornament.dress, limbs, variant);
        if (ornament.dress.salt > 0) {
            for (const Affine& map : maps)
                append(parts[2], ornament, map);
            return;
        }
        double reach = 0;
        for (const Affine& map : maps)
            reach = std::max(reach, reach_of(map));
        std::array<std::vector<Shape>, 2> halves;
        for (const Affine& map : maps)
            append(halves[reach_of(map) < kInner * reach ? 0 : 1], ornament, map);
        for (std::size_t half = 0; half < 2; ++half)
            parts[half + 1] = merged(std::move(halves[half]));
    }

    static double reach_of(const Affine& map) {
        return glm::length(edaha::transform(map, Vec2(0, -kLeafLength)));
    }

    // One kind of leaf has the colour of the instance; other ornaments keep their middle tone.
    static void append(std::vector<Shape>& shapes, const Ornament& ornament, const Affine& map) {
        for (Shape shape : ornament.shapes) {
            shape.id.clear();
            transform(shape.path, map);
            shape.paint.stroke_width_mm *= glm::length(map[1]);
            if (ornament.dress.salt > 0 && shape.paint.fill.kind == Ink::Kind::inherit)
                shape.paint.fill = ornament.dress.tones.mid;
            shapes.push_back(std::move(shape));
        }
    }

    // What takes the instance's colour becomes one path; leaves of several colours stay as they
    // are.
    static std::vector<Shape> merged(std::vector<Shape> shapes) {
        std::vector<Path> paths;
        for (const Shape& shape : shapes) {
            if (shape.paint.fill.kind != Ink::Kind::inherit) return shapes;
            paths.push_back(shape.path);
        }
        return united(paths);
    }

    static std::vector<Shape> united(const std::vector<Path>& paths) {
        std::vector<Shape> shapes;
        Path path = unite(paths);
        Paint paint;
        paint.stroke = Ink::none();
        if (!path.verbs.empty()) shapes.push_back({{}, std::move(path), paint});
        return shapes;
    }

    std::vector<Affine> places(const Dress& dress, const Limbs& limbs,
                               const VariantParams& variant) const {
        PlacementParams params;
        params.ornament = dress.params;
        params.tones = dress.tones;
        params.label = dress.label;
        params.salt = dress.salt;
        params.clump_id = [&](std::int32_t limb) { return std::to_string(limb); };
        const SiteParams along{params.ornament.along_mm, params.ornament.along_width_mm};
        const KeyedRandom random(variant.family, variant.seed, variant.vary);
        return place(sites(limbs, look_, along), params, random).all;
    }

    // Control points lie a little outside their curves: near enough for a size.
    static void to_length(Parts& parts) {
        double reach = 1e-9;
        for (const std::vector<Shape>& shapes : parts) {
            for (const Shape& shape : shapes) {
                for (const Vec2 point : shape.path.points)
                    reach = std::max(reach, glm::length(point));
            }
        }
        const double scale = kLeafLength / reach;
        for (std::vector<Shape>& shapes : parts) {
            for (Shape& shape : shapes) {
                transform(shape.path, Affine(scale, 0, 0, scale, 0, 0));
                shape.paint.stroke_width_mm *= scale;
            }
        }
    }

    const Style& style_;
    LookParams look_;
    std::vector<Ornament> ornaments_;
};

}  // namespace

std::vector<Symbol> grow_sprigs(
    const Style& style, const std::function<LeafImport(const std::string& name)>& load_leaf) {
    return SprigGrower(style, load_leaf).run();
}

SprigInks sprig_inks(const Palette& p) {
    // Inside a clump it is darker than at its rim, by half a step: a whole one makes confetti.
    const auto between = [&](Colour from, Colour to, double part) {
        return p.strict ? from : mixed(from, to, part);
    };
    SprigInks inks;
    inks.stem = p.wood_shade;
    inks.far_stem = p.wood_back;
    const auto set = [&](SprigTone tone, Colour inner, Colour outer) {
        inks.leaves[static_cast<std::size_t>(tone)] = {inner, outer};
    };
    set(SprigTone::far_shade, between(p.leaf_back, p.leaf_shade, 0.35),
        between(p.leaf_back, p.leaf_shade, 0.15));
    set(SprigTone::far, p.leaf_back, between(p.leaf_back, p.paper, 0.2));
    set(SprigTone::shade, p.leaf_shade, between(p.leaf_shade, p.leaf, 0.2));
    set(SprigTone::mid, between(p.leaf, p.leaf_shade, 0.35), p.leaf);
    set(SprigTone::light, between(p.leaf_light, p.leaf, 0.55), p.leaf_light);
    return inks;
}

}  // namespace edaha
