// SPDX-License-Identifier: MIT
#include "app/batch/plan.h"

#include <algorithm>

#include <fmt/core.h>

#include "app/batch/plan_command.h"
#include "app/batch/shard.h"
#include "app/picture_file.h"
#include "app/version.h"
#include "base/fingerprint.h"
#include "base/keyed_random.h"
#include "style/style_xml.h"
#include "style/value.h"

namespace edaha {
namespace {

// More are a mistake; twice as many would still fit.
constexpr std::size_t kMostVariants = 1'000'000;

constexpr const char* kDefaultName = "{style}-{seed:04}";
constexpr const char* kMainPalette = "main";

bool has_palette(const Style& style, const std::string& name) {
    return std::ranges::count(style.palettes, name, &NamedPalette::name) > 0;
}

// "main" chooses none, but in a style that has one of that name.
std::string palette_option(const Style& style, const std::string& name) {
    return name == kMainPalette && !has_palette(style, name) ? "" : name;
}

bool names_drawings(const Variation& variation) {
    return variation.parameter != nullptr &&
           std::holds_alternative<Reference>(variation.parameter->field);
}

// "sheet", "sheet-01".
bool is_sheet_name(const std::string& name) {
    return name == "sheet" || (name.starts_with("sheet-") && name.size() > 6 &&
                               name.find_first_not_of("0123456789", 6) == std::string::npos);
}

std::size_t read_first_seed(const std::string& text, std::size_t count) {
    const auto most = static_cast<std::size_t>(find_parameter("variant.seed")->limits.most);
    return text.empty() ? 1 : parse_count("--seed-from", text, 0, most - (count - 1));
}

// Sorted, equal names stand together.
struct HashedName {
    Key hash;
    std::size_t index;
    auto operator<=>(const HashedName&) const = default;
};

}  // namespace

std::vector<Format> parse_formats(const std::string& text) {
    if (text.empty()) return {Format::svg};
    std::vector<Format> formats;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const Format format = parse_format(text.substr(begin, end - begin));
        if (std::ranges::count(formats, format) > 0)
            throw UsageError(fmt::format("--format: {} is given twice", name(format)));
        formats.push_back(format);
        begin = end + 1;
    }
    return formats;
}

BatchPlan::BatchPlan(const Options& options, const Catalogue& catalogue, LeafShelf& leaves,
                     Console& console)
    : per_style_(parse_count("-n", options.batch.count, 1, kMostVariants)),
      first_seed_(read_first_seed(options.batch.seed_from, per_style_)),
      size_(options.tree.size),
      background_(options.tree.background),
      write_(options.write),
      formats_(parse_formats(options.format)),
      pattern_(options.batch.name.empty() ? kDefaultName : options.batch.name),
      has_sheets_(!options.batch.sheet.empty()),
      command_(plan_command(options)) {
    read_variations(options);
    read_styles(options.batch.sources, catalogue, console);
    check_styles(leaves);
    check_names();
    find_differing();
    recipe_ = make_recipe(leaves);
}

void BatchPlan::read_variations(const Options& options) {
    for (const Setting& setting : options.tree.settings)
        variations_.push_back(parse_variation(setting, false));
    for (const std::string& text : options.tree.assignments)
        variations_.push_back(parse_variation(parse_assignment("--set", text), false));
    for (const std::string& text : options.batch.sweeps)
        variations_.push_back(parse_variation(parse_assignment("--sweep", text), true));
    const std::string& palette = options.tree.palette;
    if (!palette.empty())
        variations_.push_back(parse_variation({"--palette", "palette", palette}, false));
}

void BatchPlan::read_styles(const std::vector<std::string>& names, const Catalogue& catalogue,
                            Console& console) {
    for (const std::string& name : names)
        bases_.push_back(read_unchanged_style(name, catalogue, console));
}

void BatchPlan::check_styles(LeafShelf& leaves) const {
    for (const Variation& variation : variations_)
        check_names_in(variation, leaves);
    for (std::size_t i = 0; i < bases_.size(); ++i) {
        const Style style = tree(i * per_style_).style;
        write_params(write_, style);
        for (const OrnamentParams* ornament : {&style.leaf, &style.blossom, &style.fruit}) {
            if (!ornament->shape.empty()) leaves.leaf(ornament->shape);
        }
        if (!style.flatten.bark_tile.empty()) leaves.bark(style.flatten.bark_tile);
    }
}

// Palettes and leaf drawings, which its values may name.
void BatchPlan::check_names_in(const Variation& variation, LeafShelf& leaves) const {
    const bool is_palette = variation.parameter == nullptr;
    if (!is_palette && !names_drawings(variation)) return;
    for (const std::string& value : variation.values) {
        const bool is_bark = !is_palette && variation.parameter->key() == "flatten.bark-tile";
        if (is_bark && !value.empty()) leaves.bark(value);
        if (!is_palette && !is_bark && !value.empty()) leaves.leaf(value);
        for (const TreeStyle& base : bases_) {
            TreeOptions change;
            if (is_palette) change.palette = palette_option(base.style, value);
            change_style(base, change);
        }
    }
}

// Sixteen bytes a variant: names themselves would be the largest thing in memory.
void BatchPlan::check_names() const {
    std::vector<HashedName> names;
    names.reserve(variants());
    for (std::size_t i = 0; i < variants(); ++i)
        names.push_back({name_key(checked_name(i)), i});
    std::ranges::sort(names);
    std::size_t first = 0, second = variants();
    for (std::size_t i = 1; i < names.size(); ++i) {
        const bool same = names[i].hash == names[i - 1].hash && names[i].index < second &&
                          name(names[i].index) == name(names[i - 1].index);
        if (same) first = names[i - 1].index, second = names[i].index;
    }
    if (second == variants()) return;
    throw UsageError(fmt::format("--name: {} and {} would both be {}", describe(first),
                                 describe(second), in_quotes(name(second))));
}

void BatchPlan::find_differing() {
    for (const Parameter& parameter : parameters()) {
        const std::string key = parameter.key();
        if (key == "variant.seed") continue;
        const bool set = std::ranges::count(variations_, &parameter, &Variation::parameter) > 0 ||
                         (key == "page.size" && !size_.empty()) ||
                         (key == "page.background" && background_);
        const std::string first = value_text(bases_.front().style, parameter);
        const bool differs = std::ranges::any_of(bases_, [&](const TreeStyle& base) {
            return value_text(base.style, parameter) != first;
        });
        if (set || differs) differing_.push_back(&parameter);
    }
}

std::string BatchPlan::make_recipe(LeafShelf& leaves) const {
    Fingerprint recipe;
    recipe.add(kVersion);
    recipe.add(command_);
    for (std::size_t i = 0; i < bases_.size(); ++i) {
        const TreeStyle first = tree(i * per_style_);
        recipe.add(metadata_of(first, write_params(write_, first.style), leaves).recipe);
        recipe.add(to_xml(bases_[i].style));
    }
    for (const Variation& variation : variations_) {
        if (!names_drawings(variation)) continue;
        for (const std::string& value : variation.values)
            if (!value.empty()) recipe.add(leaves.fingerprint(value));
    }
    return recipe.text();
}

bool BatchPlan::varies_palette() const {
    return std::ranges::count(variations_, nullptr, &Variation::parameter) > 0;
}

Position BatchPlan::position(std::size_t index) const {
    const std::size_t place = index % per_style_;
    return {first_seed_ + place, place, per_style_};
}

TreeOptions BatchPlan::changes(std::size_t index) const {
    const Position here = position(index);
    TreeOptions options;
    options.settings.push_back({"--seed", "variant.seed", std::to_string(here.seed)});
    for (const Variation& variation : variations_) {
        const std::string value = value_at(variation, here);
        if (variation.parameter == nullptr) {
            options.palette = palette_option(bases_[index / per_style_].style, value);
        } else if (variation.option == "--set" || variation.option == "--sweep") {
            options.assignments.push_back(variation.key() + '=' + value);
        } else {
            options.settings.push_back({variation.option, variation.key(), value});
        }
    }
    options.size = size_;
    options.background = background_;
    return options;
}

TreeStyle BatchPlan::tree(std::size_t index) const {
    return change_style(bases_[index / per_style_], changes(index));
}

std::string BatchPlan::palette(std::size_t index) const {
    std::string name = kMainPalette;
    for (const Variation& variation : variations_)
        if (variation.parameter == nullptr) name = value_at(variation, position(index));
    return name;
}

std::string BatchPlan::field_text(const std::string& field, std::size_t index) const {
    if (field == "style") return bases_[index / per_style_].style.name;
    if (field == "seed") return std::to_string(position(index).seed);
    if (field == "index") return std::to_string(index + 1);
    if (field == "palette") return palette(index);
    const std::string key = field == "family" ? "variant.family" : field;
    return value_text(tree(index).style, *find_parameter(key));
}

std::string BatchPlan::name(std::size_t index) const {
    return pattern_.name([&](const std::string& field) { return field_text(field, index); });
}

std::string BatchPlan::checked_name(std::size_t index) const {
    std::string checked = name(index);
    if (has_sheets_ && is_sheet_name(checked))
        throw UsageError(fmt::format("--name: {} is a contact sheet's name", in_quotes(checked)));
    return checked;
}

std::string BatchPlan::describe(std::size_t index) const {
    return fmt::format("{} with seed {}", bases_[index / per_style_].style.name,
                       position(index).seed);
}

bool BatchPlan::varies_paper() const {
    const Parameter* const paper = find_parameter("palette.paper");
    for (const Variation& variation : variations_) {
        const bool colours = variation.parameter == nullptr || variation.parameter == paper;
        if (colours && variation.kind != Variation::Kind::fixed) return true;
    }
    const Colour first = tree(0).style.palette.paper;
    for (std::size_t i = 0; i < variants(); i += per_style_)
        if (tree(i).style.palette.paper != first) return true;
    return false;
}

std::string BatchPlan::title() const {
    std::string names;
    for (const TreeStyle& base : bases_)
        names += (names.empty() ? "" : ", ") + base.style.name;
    return fmt::format("{}, seeds {} to {}", names, first_seed_, first_seed_ + per_style_ - 1);
}

Variant BatchPlan::variant(std::size_t index) const {
    return {name(index), palette(index), tree(index)};
}

}  // namespace edaha
