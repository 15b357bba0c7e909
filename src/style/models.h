// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace edaha {

// What grows a tree. Energy draws; the others make meshes, which flatten() turns into a drawing.
// Prop roots may stand below a crown that another model grows; surface growth goes alone.
enum class Model : std::uint8_t { energy, prism, prop_root, surface };
inline constexpr std::string_view kModelNames[] = {"energy", "prism", "prop-root", "surface"};

bool has_model(std::span<const Model> models, Model model);

// "prop-root energy", as in the attribute `models` of a style.
std::string models_text(std::span<const Model> models);

// Throws SyntaxError, its offset being in the text: names that are not known or come twice, models
// that don't go together, none.
std::vector<Model> parse_models(std::string_view text);

}  // namespace edaha
