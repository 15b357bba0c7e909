// SPDX-License-Identifier: MIT
#include "energy/wood.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "base/parallel.h"
#include "energy/bark.h"
#include "energy/outline.h"
#include "geometry/unite.h"

namespace edaha {
namespace {

// Limbs whose base is below this part of the trunk's width are twigs.
constexpr double kTwigShare = 0.16;

std::vector<Path> all_outlines(const Limbs& limbs, const LookParams& look) {
    std::vector<Path> paths(limbs.limbs.size());
    if (look.wood == Look::line) return paths;
    constexpr std::size_t kWorthThreads = 1024;  // some milliseconds
    for_each_index(paths.size(), kWorthThreads,
                   [&](std::size_t i) { paths[i] = outline(limbs, limbs.limbs[i], look); });
    return paths;
}

double base_width(const Limbs& limbs, const Limb& limb) {
    return 2 * limbs.nodes_of(limb)[0].half_width;
}

bool is_twig(const Limbs& limbs, const Limb& limb) {
    return base_width(limbs, limb) < kTwigShare * base_width(limbs, limbs.limbs[0]);
}

// Bough by bough; within a bough the twigs first, then the limbs of high order: each limb's start
// lies under the limb that bears it. The trunk comes last.
std::vector<std::size_t> paint_order(const Limbs& limbs) {
    // One number says it all: made once a limb, not at each comparison.
    std::vector<std::pair<std::uint64_t, std::size_t>> ranks(limbs.limbs.size());
    for (std::size_t i = 0; i < ranks.size(); ++i) {
        const Limb& limb = limbs.limbs[i];
        const std::uint64_t last = limb.order == 0, heavy = !is_twig(limbs, limb);
        const auto bough = 0xffffffffU - static_cast<std::uint32_t>(limb.bough);
        ranks[i] = {last << 49 | std::uint64_t{bough} << 17 | heavy << 16 | (0xffffU - limb.order),
                    i};
    }
    std::sort(ranks.begin(), ranks.end());
    std::vector<std::size_t> order(ranks.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = ranks[i].second;
    return order;
}

class Painter {
  public:
    Painter(const Limbs& limbs, const LookParams& look, const Palette& palette)
        : limbs_(limbs), look_(look), palette_(palette), paths_(all_outlines(limbs, look)) {}

    Wood paint() {
        Wood wood;
        const LimbNode& foot = limbs_.nodes[0];
        wood.foot = foot.position;
        wood.foot_width_mm = 2 * foot.half_width * (1 + (look_.straight ? 0 : look_.root_flare));
        if (look_.wood == Look::silhouette || look_.wood == Look::outline) {
            wood.front.push_back(united());
            return wood;
        }
        ids_ = limbs_.ids();
        Layer behind{"Wood behind", paint_of(palette_.wood_back), {}};
        Layer front{"Wood", paint_of(palette_.wood), {}};
        for (const std::size_t i : paint_order(limbs_)) {
            const Limb& limb = limbs_.limbs[i];
            add(limb.back ? behind : front, limb, std::move(paths_[i]));
        }
        if (!behind.children.empty()) wood.behind.push_back(std::move(behind));
        wood.front.push_back(std::move(front));
        return wood;
    }

  private:
    Paint paint_of(Colour colour) const {
        Paint paint;
        (look_.wood == Look::line ? paint.stroke : paint.fill) = colour;
        return paint;
    }

    Layer united() {
        Layer layer{"Wood", {}, {}};
        if (look_.wood == Look::outline) {
            layer.paint.stroke = palette_.wood;
            layer.paint.stroke_width_mm = look_.stroke_mm;
        } else {
            layer.paint.fill = palette_.wood;
        }
        layer.children.push_back(Shape{"wood", unite(paths_, UniteParams{}), {}});
        return layer;
    }

    void add(Layer& layer, const Limb& limb, Path path) {
        const std::string& id = id_of(limb);
        Group& bough = group_of(layer, limb);
        const bool twig = is_twig(limbs_, limb) && !limb.back;
        std::vector<Element>& home = twig ? twigs_of(bough).children : bough.children;
        if (look_.wood == Look::line) {
            add_strokes(home, limb, id);
        } else if (!path.empty()) {
            home.emplace_back(Shape{id, std::move(path), {}});
            if (!twig && !limb.back) add_bark(bough, limb, id);
        }
    }

    void add_strokes(std::vector<Element>& home, const Limb& limb, const std::string& id) {
        int number = 0;
        for (Stroke& stroke : centre_strokes(limbs_, limb, look_)) {
            Shape shape{
                number == 0 ? id : id + '.' + std::to_string(number), std::move(stroke.path), {}};
            shape.paint.stroke_width_mm = stroke.width_mm;
            home.emplace_back(std::move(shape));
            ++number;
        }
    }

    void add_bark(Group& bough, const Limb& limb, const std::string& id) {
        const Bark bark = draw_bark(limbs_, limb, look_);
        if (!bark.shade.empty()) {
            bough.children.emplace_back(
                Shape{id + ".shade", bark.shade, paint_of(palette_.wood_shade)});
        }
        if (!bark.marks.empty()) {
            bough.children.emplace_back(Shape{id + ".marks", bark.marks, paint_of(palette_.mark)});
        }
    }

    const std::string& id_of(const Limb& limb) const {
        return ids_[static_cast<std::size_t>(&limb - limbs_.limbs.data())];
    }

    // paint_order keeps a bough's limbs together.
    Group& group_of(Layer& layer, const Limb& limb) {
        const std::string id = limb.order == 0
                                   ? "bole"
                                   : "bough" + ids_[static_cast<std::size_t>(limb.bough)].substr(4);
        if (layer.children.empty() || std::get<Group>(layer.children.back()).id != id) {
            layer.children.emplace_back(Group{id, {}, {}});
        }
        return std::get<Group>(layer.children.back());
    }

    Group& twigs_of(Group& bough) {
        const std::string id = bough.id + ".twigs";
        if (bough.children.empty() || !std::holds_alternative<Group>(bough.children.back()) ||
            std::get<Group>(bough.children.back()).id != id) {
            bough.children.emplace_back(Group{id, paint_of(palette_.wood_light), {}});
        }
        return std::get<Group>(bough.children.back());
    }

    const Limbs& limbs_;
    const LookParams& look_;
    const Palette& palette_;
    std::vector<Path> paths_;
    std::vector<std::string> ids_;
};

}  // namespace

Wood draw_wood(const Limbs& limbs, const LookParams& look, const Palette& palette) {
    return Painter(limbs, look, palette).paint();
}

}  // namespace edaha
