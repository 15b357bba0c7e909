// SPDX-License-Identifier: MIT
#include "mesh/materials.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "mesh/text_cursor.h"

namespace edaha {
namespace {

std::uint8_t channel(double value) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
}

}  // namespace

std::map<std::string, Colour> read_material_colours(std::string_view text) {
    std::map<std::string, Colour> colours;
    std::string name;
    for (TextCursor cursor(text); !cursor.at_end(); cursor.next_line()) {
        const std::string_view keyword = cursor.word();
        if (keyword == "newmtl") name = cursor.line_rest();
        if (keyword != "Kd") continue;
        try {
            const double r = cursor.number(), g = cursor.number(), b = cursor.number();
            if (std::isfinite(r + g + b)) colours[name] = {channel(r), channel(g), channel(b)};
        } catch (const SyntaxError&) {
            continue;  // "Kd spectral file": no colour
        }
    }
    return colours;
}

std::string material_text(const Mesh& mesh) {
    std::string text;
    for (const Material& material : mesh.materials) {
        text += "newmtl " + material.name + '\n';
        if (!material.colour) continue;
        text += "Kd";
        for (const int c : {material.colour->r, material.colour->g, material.colour->b}) {
            text += ' ';
            append_number(text, c / 255.0, 4);
        }
        text += '\n';
    }
    return text;
}

}  // namespace edaha
