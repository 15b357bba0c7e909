// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "style/catalogue.h"
#include "style/parameter.h"

namespace edaha {

// One style file as it is written, before what it extends is known. Every value in it is good for
// its parameter.
struct StyleSheet {
    struct Value {
        const Parameter* parameter;
        std::string text;
    };
    struct Item {
        const ParameterList* list;
        std::vector<Value> values;
    };
    struct PaletteSheet {
        std::string name;
        std::vector<Value> colours;
    };

    std::string name;
    std::string title;
    std::string description;
    std::vector<Model> models;  // empty: as in what it extends
    std::string extends;
    Place extends_place;
    std::vector<Value> values;
    std::vector<Item> items;
    std::optional<std::string> rules;
    std::vector<PaletteSheet> palettes;
    std::vector<Problem> problems;  // in the order of the text; at most kMostProblems, and one more
};

// Somebody who has that many has another kind of file.
inline constexpr std::size_t kMostProblems = 100;

// Reads all of it, whatever is wrong: what is unknown, given twice, text, out of range … is a
// problem, never skipped. A reference to a drawing or a mesh must lead to a file. Cost: linear in
// the text.
StyleSheet read_style_sheet(const SourceText& source, const Catalogue& catalogue);

}  // namespace edaha
