// SPDX-License-Identifier: MIT
#include "readers/pictures.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "app/leaf_shelf.h"
#include "style/style_xml.h"

namespace edaha::test {

std::vector<std::string> built_in_styles() {
    std::vector<std::string> names = Catalogue().style_names();
    std::erase_if(names, [](const std::string& name) {
        return name.starts_with("paper/surface-") && name != "paper/surface-fig24b";
    });
    return names;
}

bool grows_surface(const std::string& style) {
    const Catalogue catalogue;
    return has_model(read_style(catalogue.find_style(style), catalogue).models, Model::surface);
}

std::string style_test_name(const testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::ranges::replace_if(
        name, [](char c) { return c == '/' || c == '-'; }, '_');
    return name;
}

std::vector<std::uint64_t> seeds(const std::string& style, std::size_t last) {
    const char* const count = std::getenv("EDAHA_SEEDS");
    const std::size_t usual = grows_surface(style) ? 1 : last;
    std::vector<std::uint64_t> all(count == nullptr ? usual : std::stoul(count));
    std::iota(all.begin(), all.end(), 1);
    return all;
}

Picture draw_tree(const std::string& style_name, std::uint64_t seed) {
    const Catalogue catalogue;
    Style style = read_style(catalogue.find_style(style_name), catalogue);
    style.energy.variant.seed = seed;
    return draw_picture(style, LeafShelf(catalogue).loader());
}

std::string in_format(const Drawing& drawing, Format format) {
    std::string bytes;
    write_drawing(drawing, format, {}, [&](std::string_view piece) { bytes += piece; });
    return bytes;
}

}  // namespace edaha::test
