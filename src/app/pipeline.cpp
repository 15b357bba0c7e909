// SPDX-License-Identifier: MIT
#include "app/pipeline.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "app/flat_model.h"
#include "drawing/page.h"
#include "energy/grow.h"
#include "energy/move_limbs.h"
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

// Where ornaments may sit.
struct Twigs {
    std::function<std::vector<Site>(const SiteParams&)> sites;
    std::function<std::string(std::int32_t)> clump_id;
};

void append(std::vector<Layer>& layers, std::vector<Layer>&& more) {
    std::move(more.begin(), more.end(), std::back_inserter(layers));
}

class PictureMaker {
  public:
    PictureMaker(const Style& style, const LeafLoader& load_leaf)
        : style_(style), load_leaf_(load_leaf), random_(random_of(style)) {}

    Picture run() {
        picture_.drawing.swatches = swatches();
        if (has_model(style_.models, Model::energy)) {
            grow_by_energy();
        } else {
            flatten_model();
        }
        picture_.drawing = on_page(std::move(picture_.drawing), style_.page, style_.palette);
        return std::move(picture_);
    }

  private:
    // On prop roots, if the style has any.
    void grow_by_energy() {
        const Skeleton skeleton = grow(style_.energy);
        LookParams look = style_.look;
        if (makes_mesh(style_)) look.root_flare = 0;  // it has roots enough
        Limbs limbs = make_limbs(skeleton, style_.energy, look);
        std::optional<FlatModel> base;
        if (makes_mesh(style_)) {
            base = draw_model(style_, 2 * limbs.nodes.front().half_width);
            limbs = moved_limbs(std::move(limbs), base->crown);
            count(*base);
        }
        Wood wood = draw_wood(limbs, look, style_.palette);
        std::vector<Layer> behind, front;
        const Twigs twigs = twigs_of(limbs);
        for (const Dress& dress : dresses(style_))
            decorate(dress, twigs, behind, front);
        count(skeleton, limbs);

        std::vector<Layer>& layers = picture_.drawing.layers;
        Stand place = stand(limbs, wood);
        if (base) place = on_roots(place, base->stand);
        layers.push_back(draw_ground(place, style_.look, style_.palette));
        append(layers, std::move(wood.behind));
        append(layers, std::move(behind));
        std::vector<Layer> flat;
        if (base) flat = std::move(base->flat.layers);
        const std::size_t at = layers.size();
        append(layers, std::move(wood.front));
        append(layers, std::move(front));
        insert_flat(std::move(flat), at);
    }

    void flatten_model() {
        FlatModel model = draw_model(style_, 0);
        count(model);
        std::vector<Layer> behind, front;
        const Twigs twigs = twigs_of(model);
        for (const Dress& dress : dresses(style_))
            decorate(dress, twigs, behind, front);
        std::vector<Layer>& layers = picture_.drawing.layers;
        layers.push_back(draw_ground(model.stand, style_.look, style_.palette));
        append(layers, std::move(behind));
        const std::size_t at = layers.size();
        append(layers, std::move(front));
        insert_flat(std::move(model.flat.layers), at);
    }

    // Below the layer `at`, with ids that are nobody else's.
    void insert_flat(std::vector<Layer> flat, std::size_t at) {
        if (flat.empty()) return;
        const bool roots = has_model(style_.models, Model::prop_root);
        name_layers(flat, roots ? "Root" : "Tree");
        std::vector<Layer>& layers = picture_.drawing.layers;
        settle_ids(flat, layers, picture_.drawing.symbols);
        layers.insert(layers.begin() + static_cast<std::ptrdiff_t>(at),
                      std::make_move_iterator(flat.begin()), std::make_move_iterator(flat.end()));
    }

    static void name_layers(std::vector<Layer>& flat, const std::string& what) {
        for (Layer& layer : flat) {
            if (layer.label == "Fills") layer.label = what == "Root" ? "Roots" : what;
            if (layer.label == "Lines") layer.label = what + " lines";
        }
    }

    Twigs twigs_of(const Limbs& limbs) const {
        return {[&](const SiteParams& params) { return sites(limbs, style_.look, params); },
                [&](std::int32_t limb) {
                    return limbs.id(limbs.limbs[static_cast<std::size_t>(limb)]);
                }};
    }

    static Twigs twigs_of(const FlatModel& model) {
        return {[&](const SiteParams&) { return sites(model); },
                [&](std::int32_t part) {
                    const MeshPart& bough = model.model.mesh.parts[static_cast<std::size_t>(part)];
                    return id_from_label(bough.name);
                }};
    }

    void decorate(const Dress& dress, const Twigs& twigs, std::vector<Layer>& behind,
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
        params.clump_id = twigs.clump_id;
        params.stroked = std::any_of(
            import.leaf.shapes.begin(), import.leaf.shapes.end(),
            [](const Shape& shape) { return shape.paint.stroke.kind == Ink::Kind::inherit; });
        params.symbol = symbol_of(std::move(import.leaf));
        const SiteParams along{dress.params.along_mm, dress.params.along_width_mm};
        Placement placement = place(twigs.sites(along), params, random_);
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
        Stand stand;
        stand.foot = wood.foot;
        stand.foot_width_mm = wood.foot_width_mm;
        stand.crown_left_mm = stand.crown_right_mm = wood.foot.x;
        for (const LimbNode& node : limbs.nodes) {
            stand.crown_left_mm = std::min(stand.crown_left_mm, node.position.x);
            stand.crown_right_mm = std::max(stand.crown_right_mm, node.position.x);
        }
        return stand;
    }

    // The crown's shade, where the roots stand.
    static Stand on_roots(const Stand& crown, Stand roots) {
        roots.crown_left_mm = std::min(roots.crown_left_mm, crown.crown_left_mm);
        roots.crown_right_mm = std::max(roots.crown_right_mm, crown.crown_right_mm);
        return roots;
    }

    void count(const FlatModel& model) {
        TreeCounts& counts = picture_.counts;
        counts.triangles = model.model.mesh.triangles.size();
        counts.parts = model.model.mesh.parts.size();
        counts.prisms = model.model.prisms;
        counts.roots = model.model.roots;
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
