// SPDX-License-Identifier: MIT
#include "app/pipeline.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "app/dress.h"
#include "app/flat_model.h"
#include "app/sprigs.h"
#include "drawing/page.h"
#include "energy/grow.h"
#include "energy/move_limbs.h"
#include "energy/wood.h"
#include "flatten/light.h"
#include "ornament/placement.h"
#include "style/parameter.h"

namespace edaha {
namespace {

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
    PictureMaker(const Style& style, const DrawingLoader& load)
        : style_(style), load_(load), random_(random_of(style)) {}

    Picture run(const SurfaceWatch& watch) {
        picture_.drawing.swatches = swatches();
        if (has_model(style_.models, Model::energy)) {
            grow_by_energy();
        } else {
            flatten_model(draw_model(style_, make_model_mesh(style_, watch), 0, bark()));
        }
        picture_.drawing = on_page(std::move(picture_.drawing), style_.page, style_.palette);
        return std::move(picture_);
    }

    Picture run(ModelMesh mesh, FixedView& view) {
        picture_.drawing.swatches = swatches();
        FlatModel model = draw_model(style_, std::move(mesh), 0, bark());
        const bool grows = style_.look.ground == Ground::shadow;
        if (view.stand && !grows) model.stand = *view.stand;
        if (!view.stand) view = {model.flat.frame.mm_per_unit, model.stand};
        flatten_model(std::move(model));
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
            base = draw_model(style_, make_model_mesh(style_), 2 * limbs.nodes.front().half_width,
                              bark());
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

    void flatten_model(FlatModel model) {
        count(model);
        std::vector<Layer> behind, front;
        if (bears_sprigs(model)) {
            add_sprigs(model, behind, front);
        } else {
            const Twigs twigs = twigs_of(model);
            for (const Dress& dress : dresses(style_))
                decorate(dress, twigs, behind, front);
        }
        std::vector<Layer>& layers = picture_.drawing.layers;
        layers.push_back(draw_ground(model.stand, style_.look, style_.palette));
        append(layers, std::move(behind));
        const std::size_t at = layers.size();
        append(layers, std::move(front));
        insert_flat(std::move(model.flat.layers), at);
    }

    bool bears_sprigs(const FlatModel& model) const {
        return has_model(style_.models, Model::surface) && style_.sprig.energy > 0 &&
               !model.model.mesh.sites.empty();
    }

    void add_sprigs(const FlatModel& model, std::vector<Layer>& behind, std::vector<Layer>& front) {
        std::vector<Symbol>& symbols = picture_.drawing.symbols;
        const SprigSymbols which{static_cast<std::uint32_t>(symbols.size()),
                                 static_cast<std::uint32_t>(style_.sprig.variants)};
        std::vector<Symbol> sprigs =
            grow_sprigs(style_, [&](const std::string& name) { return import_leaf(name); });
        if (style_.palette.strict) {
            for (Symbol& sprig : sprigs)
                restrict_colours(sprig.shapes);
        }
        SprigInks inks = sprig_inks(style_.palette);
        inks.stroked = std::ranges::any_of(
            sprigs, [](const Symbol& sprig) { return has_strokes(sprig.shapes); });
        std::move(sprigs.begin(), sprigs.end(), std::back_inserter(symbols));
        const glm::dvec3 up = seen_light(style_.flatten);
        const glm::dvec3 to_light(up.x, -up.y, up.z);
        SprigLayers layers =
            place_sprigs(sprig_places(model), which, style_.sprig, inks, to_light, random_);
        picture_.counts.sprigs = layers.count;
        behind.push_back(std::move(layers.behind));
        front.push_back(std::move(layers.front));
    }

    BarkTile bark() {
        if (style_.flatten.bark_tile.empty()) return {};
        BarkImport import = load_.bark(style_.flatten.bark_tile);
        std::vector<Problem>& warnings = picture_.warnings;
        warnings.insert(warnings.end(), import.warnings.begin(), import.warnings.end());
        return std::move(import.tile);
    }

    LeafImport import_leaf(const std::string& name) {
        LeafImport import = load_.leaf(name);
        std::vector<Problem>& warnings = picture_.warnings;
        warnings.insert(warnings.end(), import.warnings.begin(), import.warnings.end());
        return import;
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
        LeafImport import = import_leaf(dress.params.shape);
        PlacementParams params;
        params.ornament = dress.params;
        params.tones = dress.tones;
        params.label = dress.label;
        params.salt = dress.salt;
        params.clump_id = twigs.clump_id;
        params.stroked = has_strokes(import.leaf.shapes);
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
        counts.surface = model.model.surface;
        if (counts.surface) {
            picture_.steps.push_back({"grow", counts.surface->seconds,
                                      static_cast<std::size_t>(counts.surface->steps), "steps"});
        }
        picture_.steps.insert(picture_.steps.end(), model.flat.steps.begin(),
                              model.flat.steps.end());
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
    const DrawingLoader& load_;
    KeyedRandom random_;
    Picture picture_;
};

}  // namespace

Picture draw_picture(const Style& style, const DrawingLoader& load, const SurfaceWatch& watch) {
    return PictureMaker(style, load).run(watch);
}

Picture draw_model_picture(const Style& style, const DrawingLoader& load, ModelMesh model,
                           FixedView& view) {
    return PictureMaker(style, load).run(std::move(model), view);
}

}  // namespace edaha
