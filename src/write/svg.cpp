// SPDX-License-Identifier: MIT
#include "write/svg.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include <pugixml.hpp>

#include "base/number_text.h"
#include "drawing/inherit.h"
#include "drawing/subpaths.h"
#include "geometry/measure.h"
#include "write/gzip.h"
#include "write/path_text.h"
#include "write/precision.h"
#include "write/split_path.h"
#include "write/svg_metadata.h"
#include "write/xml_text.h"

namespace edaha {
namespace {

constexpr int kOpacityDecimals = 3;  // finer than the 1/255 of a screen

void set(pugi::xml_node node, const char* name, std::string_view value) {
    node.append_attribute(name).set_value(value.data(), value.size());
}

std::string hex(const std::optional<Colour>& colour) {
    if (!colour) return "none";
    constexpr const char* kDigits = "0123456789abcdef";
    std::string text = "#";
    for (const unsigned channel : {colour->r, colour->g, colour->b}) {
        text += kDigits[channel >> 4];
        text += kDigits[channel & 15];
    }
    return text;
}

// An attribute's text, made in place: there are as many as leaves.
struct TransformText {
    char text[16 + 6 * (kLongestNumber + 1)];
    std::size_t size = 0;
};

// matrix() with `fine` decimals for its linear part and `coarse` ones for the shift, or translate()
// where that says the same; empty for the identity. Numbers are parted by blanks throughout: the
// grammar of SVG 1.1 asks for them here, other than in path data.
TransformText transform_text(const Affine& map, int fine, int coarse) {
    const std::int64_t one = to_units(1, fine);
    const std::int64_t linear[4] = {to_units(map[0].x, fine), to_units(map[0].y, fine),
                                    to_units(map[1].x, fine), to_units(map[1].y, fine)};
    const std::int64_t right = to_units(map[2].x, coarse), down = to_units(map[2].y, coarse);
    const bool only_shifts =
        linear[0] == one && linear[1] == 0 && linear[2] == 0 && linear[3] == one;
    TransformText result;
    if (only_shifts && right == 0 && down == 0) return result;
    char* end = result.text;
    const auto add_name = [&](std::string_view name) {
        end = std::copy(name.begin(), name.end(), end);
    };
    if (only_shifts) {
        add_name("translate(");
    } else {
        add_name("matrix(");
        for (const std::int64_t number : linear) {
            end = write_units(end, number, fine);
            *end++ = ' ';
        }
    }
    end = write_units(end, right, coarse);
    if (!only_shifts || down != 0) {
        *end++ = ' ';
        end = write_units(end, down, coarse);
    }
    *end++ = ')';
    result.size = static_cast<std::size_t>(end - result.text);
    return result;
}

bool strokes(const Paint& paint) {
    return paint.stroke.kind == Ink::Kind::colour;
}

bool any_stroke(const Symbol& symbol) {
    return std::any_of(symbol.shapes.begin(), symbol.shapes.end(),
                       [](const Shape& shape) { return strokes(shape.paint); });
}

// What there are thousands of: pugixml lets copies of what it has parsed share their text.
struct Templates {
    pugi::xml_node all;
    std::vector<pugi::xml_node> uses;  // of the symbols, with an attribute for the transform
};

struct StringWriter : pugi::xml_writer {
    void write(const void* data, std::size_t size) override {
        text.append(static_cast<const char*>(data), size);
    }
    std::string text;
};

Templates load_templates(pugi::xml_document& document, const std::vector<Symbol>& symbols) {
    pugi::xml_document written;
    pugi::xml_node node = written.append_child("templates");
    for (const Symbol& symbol : symbols) {
        pugi::xml_node use = node.append_child("use");
        set(use, "xlink:href", '#' + symbol.id);
        use.append_attribute("transform");
    }
    StringWriter writer;
    written.save(writer, "", pugi::format_raw | pugi::format_no_declaration);
    document.load_buffer(writer.text.data(), writer.text.size(), pugi::parse_default,
                         pugi::encoding_utf8);
    Templates templates{document.first_child(), {}};
    for (const pugi::xml_node use : templates.all.children())
        templates.uses.push_back(use);
    return templates;
}

class SvgWriter {
  public:
    SvgWriter(const Drawing& drawing, const SvgParams& params);
    SvgReport write(const Sink& sink);

  private:
    bool has_strokes(const std::vector<Element>& elements) const;

    void add_root();
    void add_definitions();
    void add_swatches(pugi::xml_node definitions);
    void add_symbol(pugi::xml_node definitions, const Symbol& symbol, int decimals);
    void add_layer(const Layer& layer);
    void add_elements(pugi::xml_node parent, const std::vector<Element>& elements,
                      const InheritedPaint& inherited);
    void add_group(pugi::xml_node parent, const Group& group, const InheritedPaint& inherited);
    void add_use(pugi::xml_node parent, const Use& use, const InheritedPaint& inherited);
    void add_expanded(pugi::xml_node parent, const Use& use, const InheritedPaint& inherited);
    void add_shape(pugi::xml_node parent, const Shape& shape, const InheritedPaint& inherited);
    pugi::xml_node add_path(pugi::xml_node parent, const std::string& id, const Path& path,
                            int decimals);
    pugi::xml_node add_split(pugi::xml_node parent, const std::string& id, const Path& path,
                             int decimals);
    void add_paint(pugi::xml_node node, const InheritedPaint& own, const InheritedPaint& inherited);
    void add_symbol_paint(pugi::xml_node node, const Paint& paint, int decimals);

    const Drawing& drawing_;
    const SvgParams& params_;
    int decimals_;
    std::vector<SymbolPrecision> precision_;
    pugi::xml_document document_;
    Templates templates_;  // in the document
    pugi::xml_node svg_;
    std::string data_;  // of one path, reused
    SvgReport report_;
};

SvgWriter::SvgWriter(const Drawing& drawing, const SvgParams& params)
    : drawing_(drawing),
      params_(params),
      decimals_(params.decimals == SvgParams::kAutomatic
                    ? page_decimals(drawing.width_mm, drawing.height_mm)
                    : std::clamp(params.decimals, 0, kMostDecimals)),
      precision_(symbol_precision(drawing, decimals_)),
      templates_(load_templates(document_, drawing.symbols)) {}

bool SvgWriter::has_strokes(const std::vector<Element>& elements) const {
    return std::any_of(elements.begin(), elements.end(), [&](const Element& element) {
        if (const auto* shape = std::get_if<Shape>(&element)) return strokes(shape->paint);
        if (const auto* use = std::get_if<Use>(&element)) {
            return strokes(use->paint) || any_stroke(drawing_.symbols[use->symbol]);
        }
        const auto& group = std::get<Group>(element);
        return strokes(group.paint) || has_strokes(group.children);
    });
}

void SvgWriter::add_root() {
    pugi::xml_node declaration = document_.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    declaration.append_attribute("encoding") = "UTF-8";
    svg_ = document_.append_child("svg");
    svg_.append_attribute("xmlns") = "http://www.w3.org/2000/svg";
    svg_.append_attribute("xmlns:xlink") = "http://www.w3.org/1999/xlink";
    svg_.append_attribute("xmlns:inkscape") = "http://www.inkscape.org/namespaces/inkscape";
    svg_.append_attribute("version") = "1.1";
    const std::string width = number_text(drawing_.width_mm, kMostDecimals);
    const std::string height = number_text(drawing_.height_mm, kMostDecimals);
    set(svg_, "width", width + "mm");
    set(svg_, "height", height + "mm");
    set(svg_, "viewBox", "0 0 " + width + ' ' + height);
    append_metadata(svg_, drawing_.metadata);
}

void SvgWriter::add_definitions() {
    const bool symbols = !params_.expand && !drawing_.symbols.empty();
    const bool swatches = params_.swatches && !drawing_.swatches.empty();
    if (!symbols && !swatches) return;
    pugi::xml_node definitions = svg_.append_child("defs");
    if (swatches) add_swatches(definitions);
    for (std::size_t i = 0; symbols && i < drawing_.symbols.size(); ++i) {
        add_symbol(definitions, drawing_.symbols[i], precision_[i].points);
    }
}

void SvgWriter::add_swatches(pugi::xml_node definitions) {
    std::size_t number = 0;
    for (const Swatch& swatch : drawing_.swatches) {
        pugi::xml_node gradient = definitions.append_child("linearGradient");
        set(gradient, "id",
            "swatch-" + std::to_string(++number) + '-' + id_from_label(swatch.name));
        gradient.append_attribute("inkscape:swatch") = "solid";
        set(gradient, "inkscape:label", xml_safe(swatch.name));
        pugi::xml_node stop = gradient.append_child("stop");
        stop.append_attribute("offset") = "0";
        set(stop, "stop-color", hex(swatch.colour));
    }
}

// Without a viewBox the symbol's units are the instance's; visible overflow, since leaves grow out
// of the origin in all directions and readers clip symbols to their viewport by default.
void SvgWriter::add_symbol(pugi::xml_node definitions, const Symbol& symbol, int decimals) {
    pugi::xml_node node = definitions.append_child("symbol");
    set(node, "id", symbol.id);
    node.append_attribute("overflow") = "visible";
    for (const Shape& shape : symbol.shapes) {
        pugi::xml_node path = add_path(node, shape.id, shape.path, decimals);
        if (path) add_symbol_paint(path, shape.paint, decimals);
    }
}

// What surrounds a symbol differs from instance to instance: all that is set is said.
void SvgWriter::add_symbol_paint(pugi::xml_node node, const Paint& paint, int decimals) {
    const auto add_ink = [&](const Ink& ink, float opacity, const char* name,
                             const char* opacity_name) {
        const bool colour = ink.kind == Ink::Kind::colour;
        if (colour) set(node, name, hex(ink.colour));
        if (ink.kind == Ink::Kind::none) set(node, name, "none");
        if (colour || opacity != 1) set(node, opacity_name, number_text(opacity, kOpacityDecimals));
    };
    add_ink(paint.fill, paint.fill_opacity, "fill", "fill-opacity");
    add_ink(paint.stroke, paint.stroke_opacity, "stroke", "stroke-opacity");
    if (paint.stroke_width_mm > 0) {
        const int finer = std::min(decimals + 1, kMostDecimals);
        set(node, "stroke-width", number_text(paint.stroke_width_mm, finer));
    }
}

void SvgWriter::add_paint(pugi::xml_node node, const InheritedPaint& own,
                          const InheritedPaint& inherited) {
    const auto opacity = [](float value) { return number_text(value, kOpacityDecimals); };
    if (own.fill != inherited.fill) set(node, "fill", hex(own.fill));
    if (own.fill_opacity != inherited.fill_opacity) {
        set(node, "fill-opacity", opacity(own.fill_opacity));
    }
    if (own.stroke != inherited.stroke) set(node, "stroke", hex(own.stroke));
    if (own.stroke_opacity != inherited.stroke_opacity) {
        set(node, "stroke-opacity", opacity(own.stroke_opacity));
    }
    if (own.stroke_width_mm != inherited.stroke_width_mm) {
        // One decimal more than for places: a twig's stroke is only a few steps wide.
        const int finer = std::min(decimals_ + 1, kMostDecimals);
        set(node, "stroke-width", number_text(own.stroke_width_mm, finer));
    }
    if (own.dash_mm != inherited.dash_mm) {
        const int finer = std::min(decimals_ + 1, kMostDecimals);
        const bool solid = to_units(own.dash_mm, finer) == 0;
        set(node, "stroke-dasharray", solid ? "none" : number_text(own.dash_mm, finer));
    }
}

void SvgWriter::add_layer(const Layer& layer) {
    pugi::xml_node node = svg_.append_child("g");
    set(node, "id", layer.id());
    node.append_attribute("inkscape:groupmode") = "layer";
    set(node, "inkscape:label", xml_safe(layer.label));
    const InheritedPaint own = inherit({}, layer.paint);
    if (!own.fill) node.append_attribute("fill") = "none";  // SVG's own default is black
    add_paint(node, own, {});
    if (strokes(layer.paint) || has_strokes(layer.children)) {
        node.append_attribute("stroke-linecap") = "round";
        node.append_attribute("stroke-linejoin") = "round";
    }
    add_elements(node, layer.children, own);
}

void SvgWriter::add_elements(pugi::xml_node parent, const std::vector<Element>& elements,
                             const InheritedPaint& inherited) {
    for (const Element& element : elements) {
        if (const auto* shape = std::get_if<Shape>(&element)) {
            add_shape(parent, *shape, inherited);
        } else if (const auto* use = std::get_if<Use>(&element)) {
            if (params_.expand) {
                add_expanded(parent, *use, inherited);
            } else {
                add_use(parent, *use, inherited);
            }
        } else {
            add_group(parent, std::get<Group>(element), inherited);
        }
    }
}

void SvgWriter::add_group(pugi::xml_node parent, const Group& group,
                          const InheritedPaint& inherited) {
    pugi::xml_node node = parent.append_child("g");
    if (!group.id.empty()) set(node, "id", group.id);
    const InheritedPaint own = inherit(inherited, group.paint);
    add_paint(node, own, inherited);
    add_elements(node, group.children, own);
}

void SvgWriter::add_use(pugi::xml_node parent, const Use& use, const InheritedPaint& inherited) {
    pugi::xml_node node = parent.append_copy(templates_.uses[use.symbol]);
    const TransformText transform =
        transform_text(use.page_from_symbol, precision_[use.symbol].matrices, decimals_);
    if (transform.size > 0) {
        node.last_attribute().set_value(transform.text, transform.size);
    } else {
        node.remove_attribute(node.last_attribute());
    }
    if (use.paint != Paint{}) add_paint(node, inherit(inherited, use.paint), inherited);
}

void SvgWriter::add_expanded(pugi::xml_node parent, const Use& use,
                             const InheritedPaint& inherited) {
    const Symbol& symbol = drawing_.symbols[use.symbol];
    const InheritedPaint own = inherit(inherited, use.paint);
    const bool several = symbol.shapes.size() > 1;
    const pugi::xml_node place = several ? parent.append_child("g") : parent;
    const InheritedPaint& around = several ? own : inherited;
    if (several) add_paint(place, own, inherited);
    for (const Shape& shape : symbol.shapes) {
        InheritedPaint drawn = inherit(own, shape.paint);
        drawn.stroke_width_mm *= mean_scale(use.page_from_symbol);
        if (!drawn.stroke) drawn.stroke_width_mm = around.stroke_width_mm;
        const Path path = transformed(use.page_from_symbol, shape.path);
        const pugi::xml_node node = add_path(place, "", path, decimals_);
        if (node) add_paint(node, drawn, around);
    }
}

void SvgWriter::add_shape(pugi::xml_node parent, const Shape& shape,
                          const InheritedPaint& inherited) {
    pugi::xml_node path = add_path(parent, shape.id, shape.path, decimals_);
    if (path && shape.paint != Paint{}) add_paint(path, inherit(inherited, shape.paint), inherited);
}

// Returns the node that takes the paint; none if nothing remains of the path.
pugi::xml_node SvgWriter::add_path(pugi::xml_node parent, const std::string& id, const Path& path,
                                   int decimals) {
    if (path.verbs.size() > kMostPathNodes && node_count(path) > kMostPathNodes) {
        return add_split(parent, id, path, decimals);
    }
    data_.clear();
    append_path_data(data_, path, decimals);
    if (data_.empty()) {
        ++report_.vanished_shapes;
        return {};
    }
    pugi::xml_node node = parent.append_child("path");
    if (!id.empty()) set(node, "id", id);
    set(node, "d", data_);
    return node;
}

pugi::xml_node SvgWriter::add_split(pugi::xml_node parent, const std::string& id, const Path& path,
                                    int decimals) {
    pugi::xml_node group = parent.append_child("g");
    if (!id.empty()) set(group, "id", id);
    std::size_t number = 0;
    for (const Path& part : split_path(path)) {
        if (node_count(part) > kMostPathNodes) ++report_.oversized_paths;
        data_.clear();
        append_path_data(data_, part, decimals);
        if (data_.empty()) continue;
        ++number;
        set(group.append_child("path"), "d", data_);
    }
    if (number > 1) ++report_.split_paths;
    return group;
}

SvgReport SvgWriter::write(const Sink& sink) {
    struct Counter : pugi::xml_writer {
        Counter(const Sink& to, std::size_t& counted) : out(to), bytes(counted) {}
        void write(const void* data, std::size_t size) override {
            bytes += size;
            out(std::string_view(static_cast<const char*>(data), size));
        }
        const Sink& out;
        std::size_t& bytes;
    } counter(sink, report_.bytes);

    add_root();
    add_definitions();
    for (const Layer& layer : drawing_.layers)
        add_layer(layer);
    document_.remove_child(templates_.all);
    const unsigned format = params_.compact ? pugi::format_raw : pugi::format_indent;
    document_.save(counter, " ", format, pugi::encoding_utf8);
    return report_;
}

}  // namespace

SvgReport write_svg(const Drawing& drawing, const SvgParams& params, const Sink& sink) {
    return SvgWriter(drawing, params).write(sink);
}

SvgReport write_svgz(const Drawing& drawing, const SvgParams& params, const Sink& sink) {
    std::size_t packed = 0;
    Gzip gzip([&](std::string_view bytes) {
        packed += bytes.size();
        sink(bytes);
    });
    SvgReport report = write_svg(drawing, params, [&](std::string_view text) { gzip.write(text); });
    gzip.finish();
    report.bytes = packed;
    return report;
}

}  // namespace edaha
