// SPDX-License-Identifier: MIT
#include "app/frames.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <fmt/core.h>

#include "drawing/ink_box.h"
#include "drawing/page.h"

namespace edaha {
namespace {

struct Moment {
    std::int64_t step;
    SurfaceTree tree;
};

// The last step of each of `count` even parts.
std::int64_t step_of_frame(std::int64_t number, std::int64_t count, std::int64_t steps) {
    return number * steps / count;
}

std::vector<Moment> grow_moments(const Style& style, std::int64_t count, SurfaceWatch watch) {
    const std::int64_t steps = style.surface.steps;
    std::vector<Moment> moments;
    std::int64_t next = 1;
    watch.wants = [&](std::int64_t step) {
        return next < count && step == step_of_frame(next, count, steps);
    };
    watch.frame = [&](std::int64_t step, SurfaceTree tree) {
        moments.push_back({step, std::move(tree)});
        ++next;
    };
    SurfaceTree last = grow_surface(style.surface, random_of(style), watch);
    moments.push_back({steps, std::move(last)});
    return moments;
}

}  // namespace

std::vector<Picture> draw_frames(const Style& style, const DrawingLoader& load, std::int64_t count,
                                 SurfaceWatch watch) {
    std::vector<Moment> moments = grow_moments(style, count, std::move(watch));
    std::vector<Picture> pictures(moments.size());
    Style scaled = style;
    FixedView view;
    Bounds box;
    for (std::size_t i = moments.size(); i-- > 0;) {
        ModelMesh model = model_of(style, std::move(moments[i].tree), moments[i].step);
        pictures[i] = draw_model_picture(scaled, load, std::move(model), view);
        scaled.flatten.mm_per_unit = view.mm_per_unit;
        box.include(InkBoxes(pictures[i].drawing).of_all());
    }
    for (Picture& picture : pictures)
        picture.drawing = on_page(std::move(picture.drawing), box, style.page, style.palette);
    return pictures;
}

std::string frame_file(const std::string& file, std::size_t number, std::size_t count) {
    const std::filesystem::path path = file;
    const std::size_t digits = std::max<std::size_t>(3, std::to_string(count).size());
    const std::string name =
        fmt::format("{}-{:0{}}{}", path.stem().string(), number, digits, path.extension().string());
    return (path.parent_path() / name).string();
}

}  // namespace edaha
