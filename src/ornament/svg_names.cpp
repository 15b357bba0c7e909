// SPDX-License-Identifier: MIT
#include "ornament/svg_names.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "base/nearest_name.h"

namespace edaha::svg {
namespace {

using Names = std::span<const std::string_view>;

constexpr std::array<std::string_view, 7> kShapes{"path", "rect",     "circle", "ellipse",
                                                  "line", "polyline", "polygon"};
constexpr std::array<std::string_view, 3> kGroups{"g", "svg", "a"};
constexpr std::array<std::string_view, 17> kSilent{
    "defs",           "symbol",         "title", "desc",    "metadata",     "style",
    "linearGradient", "radialGradient", "stop",  "pattern", "marker",       "clipPath",
    "mask",           "filter",         "view",  "cursor",  "color-profile"};
constexpr std::array<std::string_view, 27> kLost{
    "text",          "tspan",      "textPath",  "tref",         "altGlyph",      "image",
    "foreignObject", "script",     "animate",   "animateColor", "animateMotion", "animateTransform",
    "set",           "font",       "font-face", "flowRoot",     "flowPara",      "flowSpan",
    "video",         "audio",      "canvas",    "iframe",       "mesh",          "meshgradient",
    "hatch",         "solidcolor", "discard"};

constexpr std::array<std::string_view, 12> kApplied{
    "fill",    "stroke",     "stroke-width", "fill-opacity", "stroke-opacity", "opacity",
    "display", "visibility", "fill-rule",    "paint-order",  "stop-color",     "stop-opacity"};

struct LostProperty {
    std::string_view name;
    std::array<std::string_view, 3> neutral;
};
constexpr std::array<LostProperty, 16> kLostProperties{{
    {"clip-path", {"none"}},
    {"mask", {"none"}},
    {"filter", {"none"}},
    {"marker", {"none"}},
    {"marker-start", {"none"}},
    {"marker-mid", {"none"}},
    {"marker-end", {"none"}},
    {"stroke-dasharray", {"none", "0"}},
    {"stroke-linecap", {"butt", "round"}},
    {"vector-effect", {"none"}},
    {"mix-blend-mode", {"normal"}},
    {"background-color", {"none", "transparent", "white"}},
    {"transform", {"none"}},
    {"animation", {"none"}},
    {"transition", {"none"}},
    {"offset-path", {"none"}},
}};

// A name ending in * stands for all that begin so.
constexpr std::array<std::string_view, 62> kHarmless{
    "-*",
    "font*",
    "text-*",
    "letter-spacing",
    "word-spacing",
    "word-break",
    "writing-mode",
    "line-height",
    "white-space",
    "baseline-shift",
    "dominant-baseline",
    "alignment-baseline",
    "direction",
    "unicode-bidi",
    "shape-*",
    "inline-size",
    "kerning",
    "glyph-orientation-*",
    "block-progression",
    "color",
    "color-*",
    "image-rendering",
    "solid-*",
    "enable-background",
    "flood-*",
    "lighting-color",
    "pointer-events",
    "cursor",
    "clip",
    "clip-rule",
    "overflow",
    "overflow-x",
    "overflow-y",
    "stroke-linejoin",
    "stroke-miterlimit",
    "stroke-dashoffset",
    "isolation",
    "mask-type",
    "transform-origin",
    "transform-box",
    "transition-*",
    "animation-*",
    "will-change",
    "user-select",
    "width",
    "height",
    "max-width",
    "max-height",
    "min-width",
    "min-height",
    "margin*",
    "padding*",
    "background",
    "border*",
    "float",
    "position",
    "left",
    "top",
    "vertical-align",
    "z-index",
    "outline*",
    "buffered-rendering",
};

constexpr std::array<std::string_view, 48> kPlainAttributes{"id",
                                                            "class",
                                                            "style",
                                                            "transform",
                                                            "d",
                                                            "points",
                                                            "x",
                                                            "y",
                                                            "x1",
                                                            "y1",
                                                            "x2",
                                                            "y2",
                                                            "cx",
                                                            "cy",
                                                            "r",
                                                            "rx",
                                                            "ry",
                                                            "width",
                                                            "height",
                                                            "viewBox",
                                                            "preserveAspectRatio",
                                                            "version",
                                                            "baseProfile",
                                                            "href",
                                                            "space",
                                                            "lang",
                                                            "role",
                                                            "aria-*",
                                                            "data-*",
                                                            "on*",
                                                            "tabindex",
                                                            "requiredExtensions",
                                                            "requiredFeatures",
                                                            "systemLanguage",
                                                            "externalResourcesRequired",
                                                            "zoomAndPan",
                                                            "contentScriptType",
                                                            "contentStyleType",
                                                            "pathLength",
                                                            "focusable",
                                                            "target",
                                                            "xmlns",
                                                            "type",
                                                            "media",
                                                            "offset",
                                                            "name",
                                                            "title",
                                                            "slot"};

bool is_in(Names names, std::string_view name) {
    return std::any_of(names.begin(), names.end(), [&](std::string_view known) {
        return known.ends_with('*') ? name.starts_with(known.substr(0, known.size() - 1))
                                    : name == known;
    });
}

const LostProperty* find_lost(std::string_view name) {
    const auto found = std::find_if(kLostProperties.begin(), kLostProperties.end(),
                                    [&](const LostProperty& p) { return p.name == name; });
    return found == kLostProperties.end() ? nullptr : &*found;
}

}  // namespace

ElementRole element_role(std::string_view name) {
    if (is_in(kShapes, name)) return ElementRole::shape;
    if (is_in(kGroups, name)) return ElementRole::group;
    if (name == "use") return ElementRole::use;
    if (name == "switch") return ElementRole::choice;
    if (is_in(kSilent, name)) return ElementRole::silent;
    return is_in(kLost, name) ? ElementRole::lost : ElementRole::unknown;
}

PropertyRole property_role(std::string_view name) {
    if (is_in(kApplied, name)) return PropertyRole::applied;
    if (find_lost(name)) return PropertyRole::lost;
    return is_in(kHarmless, name) ? PropertyRole::harmless : PropertyRole::unknown;
}

bool is_neutral(std::string_view property, std::string_view value) {
    const LostProperty* lost = find_lost(property);
    return !lost || value.empty() || is_in(lost->neutral, value);
}

bool is_plain_attribute(std::string_view name) {
    return name.find(':') != std::string_view::npos || is_in(kPlainAttributes, name);
}

std::string meant_element(std::string_view name) {
    std::vector<std::string> known{"use", "switch", "defs", "symbol", "style"};
    for (const std::string_view shape : kShapes)
        known.emplace_back(shape);
    for (const std::string_view group : kGroups)
        known.emplace_back(group);
    return did_you_mean(name, known);
}

std::string meant_property(std::string_view name) {
    std::vector<std::string> known(kApplied.begin(), kApplied.end());
    for (const std::string_view attribute : kPlainAttributes) {
        if (attribute.size() > 2 && !attribute.ends_with('*')) known.emplace_back(attribute);
    }
    return did_you_mean(name, known);
}

}  // namespace edaha::svg
