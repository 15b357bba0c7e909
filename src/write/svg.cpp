// SPDX-License-Identifier: MIT
#include "write/svg.h"

#include <algorithm>
#include <string>
#include <string_view>

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
#include "write/xml_writer.h"

namespace edaha {
namespace {

constexpr int kOpacityDecimals = 3;  // finer than the 1/255 of a screen

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

// What is asked of a symbol at each of its instances.
struct SymbolLink {
    std::string attribute;  // that names it
    bool strokes;           // any of its shapes
};

SymbolLink link_to(const Symbol& symbol) {
    SymbolLink link{" xlink:href=\"#",
                    std::any_of(symbol.shapes.begin(), symbol.shapes.end(),
                                [](const Shape& shape) { return strokes(shape.paint); })};
    append_xml(link.attribute, symbol.id, XmlPlace::attribute);
    link.attribute += '"';
    return link;
}

class SvgWriter {
  public:
    SvgWriter(const Drawing& drawing, const SvgParams& params, const Sink& sink);
    SvgReport write();

  private:
    bool has_strokes(const std::vector<Element>& elements) const;

    void open_root();
    void write_definitions();
    void write_swatches();
    void write_symbol(const Symbol& symbol, int decimals);
    void write_layer(const Layer& layer);
    void write_elements(const std::vector<Element>& elements, const InheritedPaint& inherited);
    void write_group(const Group& group, const InheritedPaint& inherited);
    void write_use(const Use& use, const InheritedPaint& inherited);
    void write_expanded(const Use& use, const InheritedPaint& inherited);
    void write_shape(const Shape& shape, const InheritedPaint& inherited);
    template <class AddPaint>
    void write_path(const std::string& id, const Path& path, int decimals,
                    const AddPaint& add_own_paint);
    void write_parts(const Path& path, int decimals);
    void add_colour(std::string_view name, const std::optional<Colour>& colour);
    void add_paint(const InheritedPaint& own, const InheritedPaint& inherited);
    void add_symbol_paint(const Paint& paint, int decimals);
    void add_number(std::string_view name, double value, int decimals);

    const Drawing& drawing_;
    const SvgParams& params_;
    int decimals_;
    std::vector<SymbolPrecision> precision_;
    std::vector<SymbolLink> links_;
    XmlWriter xml_;
    std::string data_;  // of one path, reused
    SvgReport report_;
};

SvgWriter::SvgWriter(const Drawing& drawing, const SvgParams& params, const Sink& sink)
    : drawing_(drawing),
      params_(params),
      decimals_(params.decimals == SvgParams::kAutomatic
                    ? page_decimals(drawing.width_mm, drawing.height_mm)
                    : std::clamp(params.decimals, 0, kMostDecimals)),
      precision_(symbol_precision(drawing, decimals_)),
      xml_(sink, params.compact) {
    for (const Symbol& symbol : drawing.symbols)
        links_.push_back(link_to(symbol));
}

bool SvgWriter::has_strokes(const std::vector<Element>& elements) const {
    return std::any_of(elements.begin(), elements.end(), [&](const Element& element) {
        if (const auto* shape = std::get_if<Shape>(&element)) return strokes(shape->paint);
        if (const auto* use = std::get_if<Use>(&element)) {
            return strokes(use->paint) || links_[use->symbol].strokes;
        }
        const auto& group = std::get<Group>(element);
        return strokes(group.paint) || has_strokes(group.children);
    });
}

void SvgWriter::open_root() {
    xml_.declare();
    xml_.open("svg");
    xml_.attribute("xmlns", "http://www.w3.org/2000/svg");
    xml_.attribute("xmlns:xlink", "http://www.w3.org/1999/xlink");
    xml_.attribute("xmlns:inkscape", "http://www.inkscape.org/namespaces/inkscape");
    xml_.attribute("version", "1.1");
    const std::string width = number_text(drawing_.width_mm, kMostDecimals);
    const std::string height = number_text(drawing_.height_mm, kMostDecimals);
    xml_.attribute("width", width + "mm");
    xml_.attribute("height", height + "mm");
    xml_.attribute("viewBox", "0 0 " + width + ' ' + height);
    write_metadata(xml_, drawing_.metadata);
}

void SvgWriter::write_definitions() {
    const bool symbols = !params_.expand && !drawing_.symbols.empty();
    const bool swatches = params_.swatches && !drawing_.swatches.empty();
    if (!symbols && !swatches) return;
    xml_.open("defs");
    if (swatches) write_swatches();
    for (std::size_t i = 0; symbols && i < drawing_.symbols.size(); ++i)
        write_symbol(drawing_.symbols[i], precision_[i].points);
    xml_.close();
}

void SvgWriter::write_swatches() {
    std::size_t number = 0;
    for (const Swatch& swatch : drawing_.swatches) {
        xml_.open("linearGradient");
        xml_.attribute("id",
                       "swatch-" + std::to_string(++number) + '-' + id_from_label(swatch.name));
        xml_.attribute("inkscape:swatch", "solid");
        xml_.attribute("inkscape:label", swatch.name);
        xml_.open("stop");
        xml_.attribute("offset", "0");
        add_colour("stop-color", swatch.colour);
        xml_.close();
        xml_.close();
    }
}

// Without a viewBox the symbol's units are the instance's; visible overflow, since leaves grow out
// of the origin in all directions and readers clip symbols to their viewport by default.
void SvgWriter::write_symbol(const Symbol& symbol, int decimals) {
    xml_.open("symbol");
    xml_.attribute("id", symbol.id);
    xml_.attribute("overflow", "visible");
    for (const Shape& shape : symbol.shapes) {
        write_path(shape.id, shape.path, decimals,
                   [&] { add_symbol_paint(shape.paint, decimals); });
    }
    xml_.close();
}

void SvgWriter::add_number(std::string_view name, double value, int decimals) {
    char text[kLongestNumber];
    const char* const end = write_units(text, to_units(value, decimals), decimals);
    xml_.plain_attribute(name, {text, static_cast<std::size_t>(end - text)});
}

void SvgWriter::add_colour(std::string_view name, const std::optional<Colour>& colour) {
    xml_.plain_attribute(name, hex(colour));
}

// What surrounds a symbol differs from instance to instance: all that is set is said.
void SvgWriter::add_symbol_paint(const Paint& paint, int decimals) {
    const auto add_ink = [&](const Ink& ink, float opacity, std::string_view name,
                             std::string_view opacity_name) {
        const bool colour = ink.kind == Ink::Kind::colour;
        if (colour) add_colour(name, ink.colour);
        if (ink.kind == Ink::Kind::none) add_colour(name, std::nullopt);
        if (colour || opacity != 1) add_number(opacity_name, opacity, kOpacityDecimals);
    };
    add_ink(paint.fill, paint.fill_opacity, "fill", "fill-opacity");
    add_ink(paint.stroke, paint.stroke_opacity, "stroke", "stroke-opacity");
    if (paint.stroke_width_mm > 0) {
        const int finer = std::min(decimals + 1, kMostDecimals);
        add_number("stroke-width", paint.stroke_width_mm, finer);
    }
}

void SvgWriter::add_paint(const InheritedPaint& own, const InheritedPaint& inherited) {
    if (own.fill != inherited.fill) add_colour("fill", own.fill);
    if (own.fill_opacity != inherited.fill_opacity)
        add_number("fill-opacity", own.fill_opacity, kOpacityDecimals);
    if (own.stroke != inherited.stroke) add_colour("stroke", own.stroke);
    if (own.stroke_opacity != inherited.stroke_opacity)
        add_number("stroke-opacity", own.stroke_opacity, kOpacityDecimals);
    if (own.stroke_width_mm != inherited.stroke_width_mm) {
        // One decimal more than for places: a twig's stroke is only a few steps wide.
        const int finer = std::min(decimals_ + 1, kMostDecimals);
        add_number("stroke-width", own.stroke_width_mm, finer);
    }
    if (own.dash_mm != inherited.dash_mm) {
        const int finer = std::min(decimals_ + 1, kMostDecimals);
        const bool solid = to_units(own.dash_mm, finer) == 0;
        xml_.plain_attribute("stroke-dasharray", solid ? "none" : number_text(own.dash_mm, finer));
    }
}

void SvgWriter::write_layer(const Layer& layer) {
    xml_.open("g");
    xml_.attribute("id", layer.id());
    xml_.attribute("inkscape:groupmode", "layer");
    xml_.attribute("inkscape:label", layer.label);
    const InheritedPaint own = inherit({}, layer.paint);
    if (!own.fill) add_colour("fill", std::nullopt);  // SVG's own default is black
    add_paint(own, {});
    if (strokes(layer.paint) || has_strokes(layer.children)) {
        xml_.attribute("stroke-linecap", "round");
        xml_.attribute("stroke-linejoin", "round");
    }
    write_elements(layer.children, own);
    xml_.close();
}

void SvgWriter::write_elements(const std::vector<Element>& elements,
                               const InheritedPaint& inherited) {
    for (const Element& element : elements) {
        if (const auto* shape = std::get_if<Shape>(&element)) {
            write_shape(*shape, inherited);
        } else if (const auto* use = std::get_if<Use>(&element)) {
            if (params_.expand) {
                write_expanded(*use, inherited);
            } else {
                write_use(*use, inherited);
            }
        } else {
            write_group(std::get<Group>(element), inherited);
        }
    }
}

void SvgWriter::write_group(const Group& group, const InheritedPaint& inherited) {
    xml_.open("g");
    if (!group.id.empty()) xml_.attribute("id", group.id);
    const InheritedPaint own = inherit(inherited, group.paint);
    add_paint(own, inherited);
    write_elements(group.children, own);
    xml_.close();
}

void SvgWriter::write_use(const Use& use, const InheritedPaint& inherited) {
    xml_.open("use", links_[use.symbol].attribute);
    const TransformText transform =
        transform_text(use.page_from_symbol, precision_[use.symbol].matrices, decimals_);
    if (transform.size > 0) xml_.plain_attribute("transform", {transform.text, transform.size});
    if (use.paint != Paint{}) add_paint(inherit(inherited, use.paint), inherited);
    xml_.close();
}

void SvgWriter::write_expanded(const Use& use, const InheritedPaint& inherited) {
    const Symbol& symbol = drawing_.symbols[use.symbol];
    const InheritedPaint own = inherit(inherited, use.paint);
    const bool several = symbol.shapes.size() > 1;
    const InheritedPaint& around = several ? own : inherited;
    if (several) {
        xml_.open("g");
        add_paint(own, inherited);
    }
    for (const Shape& shape : symbol.shapes) {
        InheritedPaint drawn = inherit(own, shape.paint);
        drawn.stroke_width_mm *= mean_scale(use.page_from_symbol);
        if (!drawn.stroke) drawn.stroke_width_mm = around.stroke_width_mm;
        const Path path = transformed(use.page_from_symbol, shape.path);
        write_path("", path, decimals_, [&] { add_paint(drawn, around); });
    }
    if (several) xml_.close();
}

void SvgWriter::write_shape(const Shape& shape, const InheritedPaint& inherited) {
    write_path(shape.id, shape.path, decimals_, [&] {
        if (shape.paint != Paint{}) add_paint(inherit(inherited, shape.paint), inherited);
    });
}

// Calls add_own_paint() while the element that takes it is open; not if nothing remains of the
// path.
template <class AddPaint>
void SvgWriter::write_path(const std::string& id, const Path& path, int decimals,
                           const AddPaint& add_own_paint) {
    const bool split = path.verbs.size() > kMostPathNodes && node_count(path) > kMostPathNodes;
    data_.clear();
    if (!split) append_path_data(data_, path, decimals);
    if (!split && data_.empty()) {
        ++report_.vanished_shapes;
        return;
    }
    xml_.open(split ? "g" : "path");
    if (!id.empty()) xml_.attribute("id", id);
    if (!split) xml_.plain_attribute("d", data_);
    add_own_paint();
    if (split) write_parts(path, decimals);
    xml_.close();
}

void SvgWriter::write_parts(const Path& path, int decimals) {
    std::size_t number = 0;
    for (const Path& part : split_path(path)) {
        if (node_count(part) > kMostPathNodes) ++report_.oversized_paths;
        data_.clear();
        append_path_data(data_, part, decimals);
        if (data_.empty()) continue;
        ++number;
        xml_.open("path");
        xml_.plain_attribute("d", data_);
        xml_.close();
    }
    if (number > 1) ++report_.split_paths;
}

SvgReport SvgWriter::write() {
    open_root();
    write_definitions();
    for (const Layer& layer : drawing_.layers)
        write_layer(layer);
    xml_.close();
    report_.bytes = xml_.finish();
    return report_;
}

}  // namespace

SvgReport write_svg(const Drawing& drawing, const SvgParams& params, const Sink& sink) {
    return SvgWriter(drawing, params, sink).write();
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
