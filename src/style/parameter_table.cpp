// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>

#include "base/nearest_name.h"
#include "style/parameter_rows.h"

namespace edaha {
namespace {

struct Table {
    std::vector<Parameter> rows;
    std::vector<ParameterGroup> groups;
};

Table make_table() {
    struct Source {
        const char* name;
        const char* help;
        std::vector<Parameter> (*rows)();
        bool of_model = false;
    };
    const Source sources[] = {
        {"growth", "how the energy is spent", growth_rows},
        {"branch", "how far branches turn at a fork", branch_rows},
        {"space", "how branches compete for space", space_rows},
        {"variant", "which tree of its kind", variant_rows},
        {"prism", "trees of prisms", prism_rows, true},
        {"foliage", "masses of leaves on prisms", foliage_rows, true},
        {"proproot", "prop roots of mangroves", proproot_rows, true},
        {"surface", "trees whose surface grows", surface_rows, true},
        {"flatten", "how meshes become drawings", flatten_rows, true},
        {"look", "how the wood is drawn", look_rows},
        {"leaf", "leaves", leaf_rows},
        {"blossom", "blossom", blossom_rows},
        {"fruit", "fruit", fruit_rows},
        {"palette", "colours", palette_rows},
        {"page", "the page", page_rows},
    };
    Table table;
    std::vector<std::size_t> begins;
    for (const Source& source : sources) {
        begins.push_back(table.rows.size());
        std::ranges::move(source.rows(), std::back_inserter(table.rows));
    }
    begins.push_back(table.rows.size());
    for (std::size_t i = 0; i + 1 < begins.size(); ++i) {
        const std::span<const Parameter> rows(table.rows);
        const auto own = rows.subspan(begins[i], begins[i + 1] - begins[i]);
        table.groups.push_back({sources[i].name, sources[i].help, own, sources[i].of_model});
    }
    return table;
}

const Table& table() {
    static const Table kTable = make_table();
    return kTable;
}

}  // namespace

std::span<const ParameterGroup> parameter_groups() {
    return table().groups;
}

std::span<const Parameter> parameters() {
    return table().rows;
}

std::span<const ParameterList> parameter_lists() {
    static const std::vector<ParameterList> kLists = surface_lists();
    return kLists;
}

const ParameterGroup* find_group(std::string_view name) {
    const auto found = std::ranges::find(table().groups, name, &ParameterGroup::name);
    return found == table().groups.end() ? nullptr : &*found;
}

const Parameter* find_parameter(std::string_view key) {
    const auto found = std::ranges::find(table().rows, key, &Parameter::key);
    return found == table().rows.end() ? nullptr : &*found;
}

const ParameterList* find_list(std::string_view name) {
    const auto found = std::ranges::find(parameter_lists(), name, &ParameterList::name);
    return found == parameter_lists().end() ? nullptr : &*found;
}

std::string unknown_parameter(std::string_view key) {
    std::vector<std::string> keys;
    std::ranges::transform(parameters(), std::back_inserter(keys), &Parameter::key);
    for (const ParameterList& list : parameter_lists())
        std::ranges::transform(list.parameters, std::back_inserter(keys), &Parameter::key);
    std::string message = std::string(key) + ": no such parameter";
    if (const auto nearest = nearest_name(key, keys)) {
        message += " (did you mean '" + *nearest + "'?)";
    }
    return message;
}

}  // namespace edaha
