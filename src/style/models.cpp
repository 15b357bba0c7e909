// SPDX-License-Identifier: MIT
#include "style/models.h"

#include <algorithm>
#include <iterator>

#include "base/nearest_name.h"
#include "base/quoted.h"
#include "base/syntax_error.h"

namespace edaha {
namespace {

constexpr std::string_view kBlank = " \t\r\n";

Model parse_model(std::string_view word, std::size_t offset) {
    const auto found = std::ranges::find(kModelNames, word);
    if (found != std::end(kModelNames)) return static_cast<Model>(found - kModelNames);
    const std::vector<std::string> names(std::begin(kModelNames), std::end(kModelNames));
    throw SyntaxError(offset, quoted(word) +
                                  " is not known (expected energy, prism, prop-root or surface)" +
                                  did_you_mean(word, names));
}

}  // namespace

bool has_model(std::span<const Model> models, Model model) {
    return std::ranges::find(models, model) != models.end();
}

std::string models_text(std::span<const Model> models) {
    std::string text;
    for (const Model model : models) {
        if (!text.empty()) text += ' ';
        text += kModelNames[static_cast<std::size_t>(model)];
    }
    return text;
}

std::vector<Model> parse_models(std::string_view text) {
    std::vector<Model> models;
    std::size_t at = text.find_first_not_of(kBlank);
    while (at != std::string_view::npos) {
        const std::size_t end = std::min(text.find_first_of(kBlank, at), text.size());
        const std::string_view word = text.substr(at, end - at);
        const Model model = parse_model(word, at);
        if (has_model(models, model)) throw SyntaxError(at, quoted(word) + " is given twice");
        models.push_back(model);
        if (has_model(models, Model::energy) && has_model(models, Model::prism))
            throw SyntaxError(at, "energy and prism don't go together");
        if (has_model(models, Model::surface) && models.size() > 1)
            throw SyntaxError(at, "surface goes with no other model");
        at = text.find_first_not_of(kBlank, end);
    }
    if (models.empty())
        throw SyntaxError(0, "names no model (expected energy, prism, prop-root or surface)");
    return models;
}

}  // namespace edaha
