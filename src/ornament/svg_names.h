// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace edaha::svg {

// What we make of the names of SVG and of the programs that write it.

enum class ElementRole {
    shape,  // drawn
    group,  // its children are drawn
    use,
    choice,  // <switch>: one child is drawn
    silent,  // draws nothing by itself, or only when something refers to it
    lost,    // would be seen, and is not kept
    unknown,
};
ElementRole element_role(std::string_view name);

enum class PropertyRole {
    applied,
    harmless,  // changes nothing that leaves have
    lost,      // changes what is seen, unless its value is neutral
    unknown,
};
PropertyRole property_role(std::string_view name);

// Whether a lost property's value is one that changes nothing ("none", "normal").
bool is_neutral(std::string_view property, std::string_view value);

// Attributes that are not properties: geometry, references, and what carries no looks.
bool is_plain_attribute(std::string_view name);

// " (did you mean 'rect'?)", or nothing.
std::string meant_element(std::string_view name);
std::string meant_property(std::string_view name);

}  // namespace edaha::svg
