// SPDX-License-Identifier: MIT
#include "app/pipeline.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "drawing/page.h"
#include "energy/ground.h"
#include "energy/grow.h"
#include "energy/wood.h"
#include "ornament/placement.h"
#include "style/parameter.h"

namespace edaha {
namespace {

// One kind of ornament of a style, with its tones and the salt of its random numbers.
struct Dress {
    const OrnamentParams& params;
    Tones tones;
    const char* label;
    std::uint32_t salt;
};

std::vector<Dress> dresses(const Style& style) {
    const Palette& p = style.palette;
    return {{style.leaf, {p.leaf_light, p.leaf, p.leaf_shade, p.leaf_back}, "Leaves", 0},
            {style.blossom,
             {p.blossom_light, p.blossom, p.blossom_shade, p.blossom_back},
             "Blossom",
             1},
            {style.fruit, {p.fruit_light, p.fruit, p.fruit_shade, p.fruit_back}, "Fruit", 2}};
}

void append(std::vector<Layer>& layers, std::vector<Layer>&& more) {
    std::move(more.begin(), more.end(), std::back_inserter(layers));
}

class PictureMaker {
  public:
    PictureMaker(const Style& style, const LeafLoader& load_leaf)
        : style_(style),
          load_leaf_(load_leaf),
          random_(style.energy.variant.family, style.energy.variant.seed,
                  style.energy.variant.vary) {}

    Picture run() {
        const Skeleton skeleton = grow(style_.energy);
        const Limbs limbs = make_limbs(skeleton, style_.energy, style_.look);
        Wood wood = draw_wood(limbs, style_.look, style_.palette);
        std::vector<Layer> behind, front;
        for (const Dress& dress : dresses(style_))
            decorate(dress, limbs, behind, front);
        count(skeleton, limbs);
        picture_.drawing.swatches = swatches();

        std::vector<Layer>& layers = picture_.drawing.layers;
        layers.push_back(draw_ground(stand(limbs, wood), style_.look, style_.palette));
        append(layers, std::move(wood.behind));
        append(layers, std::move(behind));
        append(layers, std::move(wood.front));
        append(layers, std::move(front));
        picture_.drawing = on_page(std::move(picture_.drawing), style_.page, style_.palette);
        return std::move(picture_);
    }

  private:
    void decorate(const Dress& dress, const Limbs& limbs, std::vector<Layer>& behind,
                  std::vector<Layer>& front) {
        if (dress.params.shape.empty()) return;
        LeafImport import = load_leaf_(dress.params.shape);
        std::vector<Problem>& warnings = picture_.warnings;
        warnings.insert(warnings.end(), import.warnings.begin(), import.warnings.end());
        PlacementParams params;
        params.ornament = dress.params;
        params.tones = dress.tones;
        params.label = dress.label;
        params.salt = dress.salt;
        params.clump_id = [&](std::int32_t limb) {
            return limbs.id(limbs.limbs[static_cast<std::size_t>(limb)]);
        };
        params.stroked = std::any_of(
            import.leaf.shapes.begin(), import.leaf.shapes.end(),
            [](const Shape& shape) { return shape.paint.stroke.kind == Ink::Kind::inherit; });
        params.symbol = symbol_of(std::move(import.leaf));
        const SiteParams along{dress.params.along_mm, dress.params.along_width_mm};
        Placement placement = place(sites(limbs, style_.look, along), params, random_);
        picture_.counts.ornaments += placement.all.size();
        behind.push_back(std::move(placement.behind));
        front.push_back(std::move(placement.front));
    }

    // Leaves and fruit may share a drawing: one symbol a name.
    std::uint32_t symbol_of(Leaf leaf) {
        std::vector<Symbol>& symbols = picture_.drawing.symbols;
        const auto known = std::find_if(symbols.begin(), symbols.end(), [&](const Symbol& symbol) {
            return symbol.id == leaf.name;
        });
        if (known != symbols.end()) return static_cast<std::uint32_t>(known - symbols.begin());
        if (style_.palette.strict) restrict_colours(leaf.shapes);
        symbols.push_back({leaf.name, std::move(leaf.shapes)});
        return static_cast<std::uint32_t>(symbols.size() - 1);
    }

    void restrict_colours(std::vector<Shape>& shapes) const {
        for (Shape& shape : shapes) {
            for (Ink* ink : {&shape.paint.fill, &shape.paint.stroke}) {
                if (ink->kind == Ink::Kind::colour) *ink = nearest(style_.palette, ink->colour);
            }
        }
    }

    std::vector<Swatch> swatches() const {
        std::vector<Swatch> result;
        for (const Parameter& parameter : find_group("palette")->parameters) {
            const auto* colour = std::get_if<Tint>(&parameter.field);
            if (colour != nullptr) result.push_back({parameter.name, colour->get(style_)});
        }
        return result;
    }

    static Stand stand(const Limbs& limbs, const Wood& wood) {
        Stand stand{wood.foot, wood.foot_width_mm, wood.foot.x, wood.foot.x};
        for (const LimbNode& node : limbs.nodes) {
            stand.crown_left_mm = std::min(stand.crown_left_mm, node.position.x);
            stand.crown_right_mm = std::max(stand.crown_right_mm, node.position.x);
        }
        return stand;
    }

    void count(const Skeleton& skeleton, const Limbs& limbs) {
        TreeCounts& counts = picture_.counts;
        counts.branches = skeleton.branches.size();
        counts.dropped = skeleton.dropped.size();
        counts.limbs = limbs.limbs.size();
        for (const Limb& limb : limbs.limbs) {
            if (counts.limbs_by_order.size() <= limb.order)
                counts.limbs_by_order.resize(limb.order + 1U);
            ++counts.limbs_by_order[limb.order];
        }
        double turns = 0;
        for (const Branch& branch : skeleton.branches) {
            if (branch.parent < 0) continue;
            const Branch& parent = skeleton.branches[static_cast<std::size_t>(branch.parent)];
            turns += std::abs(branch.heading_rad - parent.heading_rad);
        }
        if (counts.branches > 1)
            counts.mean_turn_rad = turns / static_cast<double>(counts.branches - 1);
    }

    const Style& style_;
    const LeafLoader& load_leaf_;
    KeyedRandom random_;
    Picture picture_;
};

}  // namespace

Picture draw_picture(const Style& style, const LeafLoader& load_leaf) {
    return PictureMaker(style, load_leaf).run();
}

}  // namespace edaha
