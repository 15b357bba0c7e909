// SPDX-License-Identifier: MIT
#include "ornament/svg_style.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include <fmt/format.h>

#include "base/nearest_name.h"
#include "ornament/scan.h"
#include "ornament/svg_names.h"

namespace edaha::svg {
namespace {

Spot moved(Spot spot, std::size_t by) {
    spot.index += by;
    return spot;
}

// Colours beyond sRGB and variables: programs write them behind a plain one, as a better choice.
bool is_optional_value(std::string_view value) {
    const std::string word = lower_case(trimmed(value));
    return word.starts_with("color(") || word.starts_with("var(") || word.starts_with("-") ||
           word.starts_with("device-");
}

bool same_colour(const SvgColour& a, const SvgColour& b) {
    return a.colour == b.colour && a.opacity == b.opacity;
}

// fill, stroke, markers: true if the stroke comes before the fill (SVG 2, 13.8).
bool stroke_before_fill(std::string_view order) {
    const std::size_t stroke = order.find("stroke");
    return stroke != std::string_view::npos && stroke < order.find("fill");
}

std::string keyword(const std::string& value, const std::vector<std::string>& known) {
    std::string word(trimmed(value));
    if (std::find(known.begin(), known.end(), word) != known.end()) return word;
    const std::optional<std::string> meant = nearest_name(word, known);
    const std::string expected = fmt::format("{}", fmt::join(known, ", "));
    throw SyntaxError(0, quoted(word) + " is not a known value (" +
                             (meant ? "did you mean '" + *meant + "'?" : "expected " + expected) +
                             ')');
}

double stroke_width(const std::string& value) {
    const SvgLength length = read_length(value);
    if (length.percent)
        throw SyntaxError(0, quoted(value) + " is a percentage (expected a length)");
    if (length.value < 0) throw SyntaxError(0, quoted(value) + " is negative (expected 0 or more)");
    return length.value;
}

}  // namespace

std::vector<std::string_view> class_tokens(std::string_view text) {
    std::vector<std::string_view> tokens;
    for (Scanner scanner(text); !scanner.at_end();) {
        scanner.skip_space();
        const std::size_t begin = scanner.offset();
        const std::size_t end = std::min(text.find_first_of(" \t\r\n\f", begin), text.size());
        if (end > begin) tokens.push_back(text.substr(begin, end - begin));
        while (scanner.offset() < end)
            scanner.take();
    }
    return tokens;
}

StyleResolver::StyleResolver(const SvgDocument& document, Report& report)
    : document_(document), report_(report) {
    for (const pugi::xml_node sheet : document.sheets()) {
        for (const pugi::xml_node text : sheet.children()) {
            if (text.type() != pugi::node_pcdata && text.type() != pugi::node_cdata) continue;
            // Offsets are the sheet's own, carried in the source's numbering: as good as exact,
            // since a sheet has references only in strings.
            for (const CssComplaint& c : sheet_.add(text.value(), offset_of(text))) {
                report_.warn({c.offset, {}, false, 0}, c.message);
            }
        }
    }
}

void StyleResolver::add_attributes(std::vector<Declared>& declared, pugi::xml_node node) const {
    for (const pugi::xml_attribute attribute : node.attributes()) {
        const std::string_view name = attribute.name();
        if (is_plain_attribute(name)) continue;
        if (property_role(name) == PropertyRole::unknown) {
            if (report_.is_full()) continue;
            report_.warn(attribute_spot(offset_of(node), std::string(name)),
                         fmt::format("{}: attribute {} is unknown, and left out{}", node.name(),
                                     quoted(name), meant_property(name)));
            continue;
        }
        declared.push_back({std::string(name), attribute.value(),
                            value_spot(offset_of(node), std::string(name)), false});
    }
}

void StyleResolver::add_style_attribute(std::vector<Declared>& declared,
                                        pugi::xml_node node) const {
    const Spot spot = value_spot(offset_of(node), "style");
    std::vector<CssComplaint> complaints;
    for (CssDeclaration& d : read_declarations(node.attribute("style").value(), complaints)) {
        declared.push_back({d.property, d.value, moved(spot, d.offset), d.important});
    }
    for (const CssComplaint& c : complaints)
        report_.warn(moved(spot, c.offset), c.message);
}

std::vector<StyleResolver::Declared> StyleResolver::cascade(pugi::xml_node node) const {
    std::vector<Declared> declared;
    add_attributes(declared, node);
    const CssSubject subject{document_.element(node), node.attribute("id").value(),
                             class_tokens(node.attribute("class").value())};
    work_ += sheet_.candidates(subject);
    if (work_ > kMostWork / 64) return declared;  // the caller gives up
    for (const CssDeclaration* d : sheet_.match(subject)) {
        declared.push_back({d->property, d->value, {d->offset, {}, false, 0}, d->important});
    }
    add_style_attribute(declared, node);
    work_ += declared.size();
    std::stable_partition(declared.begin(), declared.end(),
                          [](const Declared& d) { return !d.important; });
    return declared;
}

SvgStyle StyleResolver::resolve(const SvgStyle& parent, pugi::xml_node node) const {
    SvgStyle style = parent;
    style.own_opacity = 1;
    bool has_fill = false, has_stroke = false;
    for (const Declared& declared : cascade(node)) {
        const bool is_fill = declared.property == "fill";
        const bool is_ink = is_fill || declared.property == "stroke";
        bool& has_ink = is_fill ? has_fill : has_stroke;
        if (is_ink && is_optional_value(declared.value)) {
            if (has_ink) continue;
            report_.warn(declared.spot, fmt::format("{}: {} is not kept", declared.property,
                                                    quoted(declared.value)));
            continue;
        }
        has_ink |= is_ink;
        apply(style, declared);
    }
    style.opacity = parent.opacity * style.own_opacity;
    if (const pugi::xml_attribute named = node.attribute("class")) {
        const std::vector<std::string_view> tokens = class_tokens(named.value());
        style.takes_leaf_colour =
            std::find(tokens.begin(), tokens.end(), "recolour") != tokens.end();
    }
    return style;
}

void StyleResolver::apply(SvgStyle& style, const Declared& declared) const {
    const std::string& property = declared.property;
    const std::string value(trimmed(declared.value));
    if (value == "inherit") return;
    switch (property_role(property)) {
        case PropertyRole::harmless:
            return;
        case PropertyRole::unknown:
            report_.warn(declared.spot, fmt::format("property {} is unknown, and left out{}",
                                                    quoted(property), meant_property(property)));
            return;
        case PropertyRole::lost:
            if (is_neutral(property, value)) return;
            report_.warn(declared.spot, fmt::format("{}: {} is not kept", property, quoted(value)));
            return;
        case PropertyRole::applied:
            break;
    }
    try {
        set(style, declared);
    } catch (const SyntaxError& fault) {
        report_.error(moved(declared.spot, fault.offset()), property + ": " + fault.what());
    }
}

void StyleResolver::set(SvgStyle& style, const Declared& declared) const {
    const std::string& property = declared.property;
    const std::string& value = declared.value;
    if (property == "fill" || property == "stroke") {
        (property == "fill" ? style.fill : style.stroke) = ink(declared);
    } else if (property == "stroke-width") {
        style.stroke_width = stroke_width(value);
    } else if (property == "fill-opacity") {
        style.fill_opacity = read_opacity(value);
    } else if (property == "stroke-opacity") {
        style.stroke_opacity = read_opacity(value);
    } else if (property == "opacity") {
        style.own_opacity = read_opacity(value);
    } else if (property == "display") {
        style.is_displayed = style.is_displayed && trimmed(value) != "none";
    } else if (property == "visibility") {
        style.is_visible = keyword(value, {"visible", "hidden", "collapse"}) == "visible";
    } else if (property == "fill-rule") {
        style.even_odd = keyword(value, {"nonzero", "evenodd"}) == "evenodd";
        style.fill_rule_spot = declared.spot;
    } else if (property == "paint-order") {
        style.stroke_below = stroke_before_fill(value);
    }
}

SvgInk StyleResolver::ink(const Declared& declared) const {
    const SvgPaint paint = read_paint(declared.value);
    switch (paint.kind) {
        case SvgPaint::Kind::none:
            return {};
        case SvgPaint::Kind::current:
            return {SvgInk::Kind::leaf, {}, 1};
        case SvgPaint::Kind::colour:
            return {SvgInk::Kind::colour, paint.colour.colour, paint.colour.opacity};
        case SvgPaint::Kind::reference:
            break;
    }
    return server_ink(paint, declared);
}

SvgInk StyleResolver::server_ink(const SvgPaint& paint, const Declared& declared) const {
    const pugi::xml_node server = document_.find(paint.reference);
    std::vector<SvgColour> colours;
    for (const pugi::xml_node stop : stops(server))
        colours.push_back(stop_colour(stop));
    const bool is_flat =
        !colours.empty() && std::all_of(colours.begin(), colours.end(), [&](const SvgColour& c) {
            return same_colour(c, colours.front());
        });
    if (!is_flat) {
        const std::string what = server ? std::string(document_.element(server)) : "paint";
        report_.warn(
            declared.spot,
            fmt::format("{}: {} {} is not kept{}", declared.property, what, quoted(paint.reference),
                        colours.empty() && !paint.has_fallback ? "" : ", a flat colour is"));
    }
    if (!colours.empty()) {
        return {SvgInk::Kind::colour, colours.front().colour, colours.front().opacity};
    }
    if (!paint.has_fallback) return {SvgInk::Kind::leaf, {}, 1};
    return {SvgInk::Kind::colour, paint.colour.colour, paint.colour.opacity};
}

// Its own, or those of the gradient that it refers to, and so on.
std::vector<pugi::xml_node> StyleResolver::stops(pugi::xml_node gradient) const {
    constexpr int kLongestChain = 32;  // ends circles; programs make chains of two
    for (int i = 0; i < kLongestChain && gradient; ++i) {
        if (!document_.element(gradient).ends_with("Gradient")) return {};
        std::vector<pugi::xml_node> found;
        for (const pugi::xml_node child : gradient.children()) {
            if (document_.element(child) == "stop") found.push_back(child);
        }
        if (!found.empty()) return found;
        const pugi::xml_attribute plain = gradient.attribute("href");
        const pugi::xml_attribute href = plain ? plain : gradient.attribute("xlink:href");
        gradient = document_.find(read_reference(href.value()).value_or(""));
    }
    return {};
}

SvgColour StyleResolver::stop_colour(pugi::xml_node stop) const {
    SvgColour colour;
    double opacity = 1;
    for (const Declared& declared : cascade(stop)) {
        const bool is_colour = declared.property == "stop-color";
        if (!is_colour && declared.property != "stop-opacity") continue;
        if (trimmed(declared.value) == "inherit" || is_optional_value(declared.value)) continue;
        try {
            if (is_colour) {
                const SvgPaint paint = read_paint(declared.value);
                if (paint.kind == SvgPaint::Kind::colour) colour = paint.colour;
            } else {
                opacity = read_opacity(declared.value);
            }
        } catch (const SyntaxError& fault) {
            report_.error(moved(declared.spot, fault.offset()),
                          declared.property + ": " + fault.what());
        }
    }
    colour.opacity *= opacity;
    return colour;
}

}  // namespace edaha::svg
