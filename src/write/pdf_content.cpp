// SPDX-License-Identifier: MIT
#include "write/pdf_content.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "base/number_text.h"
#include "drawing/inherit.h"
#include "write/path_operators.h"
#include "write/precision.h"

namespace edaha {
namespace {

constexpr int kChannelDecimals = 3;  // tells the 256 steps of a channel apart
constexpr int kScaleDecimals = 6;

struct Stream : PdfOperators {
    void colour(Colour colour, const char* op) {
        for (const int channel : {colour.r, colour.g, colour.b}) {
            append_number(text, channel / 255.0, kChannelDecimals);
            text += ' ';
        }
        text += op;
    }

    void opacity(char kind, float opacity) {
        const std::string state =
            kind + std::to_string(std::lround(static_cast<double>(opacity) * 1000));
        states.insert(state);
        text += '/' + state + " gs\n";
    }
};

// A symbol's shapes, for instances that do, or don't, fill and stroke what is left to them. They
// are drawn in the state that the instance has set.
class StampWriter {
  public:
    StampWriter(bool filled, bool stroked, int decimals)
        : filled_(filled), stroked_(stroked), decimals_(decimals) {}

    PdfForm write(const Symbol& symbol) {
        for (const Shape& shape : symbol.shapes)
            add(shape, &shape == &symbol.shapes.back());
        // Some air, so that no edge is cut by rounding; much of it for a pen of unknown width.
        const double air = extent(symbol) * (takes_pen_ ? 1 : 0.05);
        box_.min -= air;
        box_.max += air;
        return {std::move(stream_), box_, decimals_};
    }

  private:
    static bool drawn(const Ink& ink, bool by_instance) {
        return ink.kind == Ink::Kind::colour || (ink.kind == Ink::Kind::inherit && by_instance);
    }

    // What a shape sets must not reach the next one.
    void add(const Shape& shape, bool last) {
        const Paint& paint = shape.paint;
        const bool fills = drawn(paint.fill, filled_), strokes = drawn(paint.stroke, stroked_);
        std::string path;
        if (!fills && !strokes) return;
        if (!append_path_operators(path, shape.path, decimals_)) return;
        const bool apart = !last && !(paint == Paint{});
        if (apart) stream_.text += "q\n";
        if (fills) {
            set(paint.fill, paint.fill_opacity, "rg\n", 'f');
            stream_.text += path + "f\n";
        }
        if (strokes) {
            set(paint.stroke, paint.stroke_opacity, "RG\n", 's');
            if (paint.stroke_width_mm != 0)
                append_width_operator(stream_.text, paint.stroke_width_mm, decimals_);
            stream_.text += path + "S\n";
        }
        if (apart) stream_.text += "Q\n";
        include(shape, strokes);
    }

    void include(const Shape& shape, bool strokes) {
        takes_pen_ |= strokes && shape.paint.stroke_width_mm == 0;
        const double pen = strokes ? shape.paint.stroke_width_mm / 2 : 0;
        const Bounds path = bounds(shape.path);
        box_.include(Bounds{path.min - pen, path.max + pen});
    }

    // Who sets the ink sets the opacity with it.
    void set(const Ink& ink, float opacity, const char* op, char kind) {
        if (ink.kind == Ink::Kind::colour) stream_.colour(ink.colour, op);
        if (ink.kind == Ink::Kind::colour || opacity != 1) stream_.opacity(kind, opacity);
    }

    bool filled_, stroked_;
    int decimals_;
    Stream stream_;
    Bounds box_;
    bool takes_pen_ = false;
};

// What a symbol leaves to its instances.
struct Needs {
    bool fill = false, stroke = false, pen = false;
};

Needs needs_of(const Symbol& symbol) {
    Needs needs;
    for (const Shape& shape : symbol.shapes) {
        needs.fill |= shape.paint.fill.kind == Ink::Kind::inherit;
        needs.stroke |= shape.paint.stroke.kind == Ink::Kind::inherit;
        needs.pen |= shape.paint.stroke.kind != Ink::Kind::none && shape.paint.stroke_width_mm == 0;
    }
    return needs;
}

class ContentWriter {
  public:
    ContentWriter(const Drawing& drawing, PdfInstances instances)
        : drawing_(drawing),
          instances_(instances),
          decimals_(page_decimals(drawing.width_mm, drawing.height_mm)),
          precision_(symbol_precision(drawing, decimals_)) {
        for (const Symbol& symbol : drawing.symbols)
            needs_.push_back(needs_of(symbol));
    }

    PdfContent write() {
        const Affine points_from_page(kPointsPerMm, 0, 0, -kPointsPerMm, 0,
                                      drawing_.height_mm * kPointsPerMm);
        append_map_operator(page_.text, points_from_page, kScaleDecimals, kScaleDecimals);
        page_.text += "1 J\n1 j\n";
        for (std::size_t i = 0; i < drawing_.layers.size(); ++i) {
            page_.text += "/OC /L" + std::to_string(i) + " BDC\nq\n";
            now_ = {};
            add(drawing_.layers[i]);
            page_.text += "Q\nEMC\n";
        }
        return {std::move(page_), std::move(forms_)};
    }

  private:
    void add(const Layer& layer) {
        for_each_painted(
            layer.children, inherit({}, layer.paint),
            [this](const auto& mark, const InheritedPaint& paint) { add(mark, paint); });
    }

    void add(const Shape& shape, const InheritedPaint& paint) {
        if (!paint.fill && !paint.stroke) return;
        path_.clear();
        if (!append_path_operators(path_, shape.path, decimals_)) return;
        if (paint.fill) set_fill(*paint.fill, paint.fill_opacity);
        if (paint.stroke) {
            set_stroke(*paint.stroke, paint.stroke_opacity);
            set_width(paint.stroke_width_mm);
            set_dash(paint.dash_mm);
        }
        page_.text += path_;
        if (!paint.fill) {
            page_.text += "S\n";
        } else if (!paint.stroke) {
            page_.text += "f\n";
        } else if (paint.fill_opacity == 1 && paint.stroke_opacity == 1) {
            page_.text += "B\n";
        } else {  // B would knock the fill out beneath a translucent stroke
            page_.text += "f\n" + path_ + "S\n";
        }
    }

    void add(const Use& use, const InheritedPaint& paint) {
        const Needs& needs = needs_[use.symbol];
        const bool filled = paint.fill && needs.fill, stroked = paint.stroke && needs.stroke;
        if (filled) set_fill(*paint.fill, paint.fill_opacity);
        if (stroked) set_stroke(*paint.stroke, paint.stroke_opacity);
        if (needs.pen && paint.stroke_width_mm > 0) set_width(paint.stroke_width_mm);
        set_dash(0);
        page_.text += "q\n";
        append_map_operator(page_.text, use.page_from_symbol, precision_[use.symbol].matrices,
                            decimals_);
        page_.text += stamp(use.symbol, filled, stroked);
        page_.text += "Q\n";
    }

    // What draws a symbol once the state and the map are set.
    const std::string& stamp(std::uint32_t symbol, bool filled, bool stroked) {
        const auto [known, added] = stamps_.try_emplace({symbol, filled, stroked});
        if (added) {
            StampWriter writer(filled, stroked, precision_[symbol].points);
            PdfForm form = writer.write(drawing_.symbols[symbol]);
            if (instances_ == PdfInstances::forms) {
                known->second = "/F" + std::to_string(forms_.size()) + " Do\n";
                forms_.push_back(std::move(form));
            } else {
                page_.states.merge(form.operators.states);
                known->second = std::move(form.operators.text);
            }
        }
        return known->second;
    }

    void set_fill(Colour colour, float opacity) {
        if (now_.fill != colour) page_.colour(colour, "rg\n");
        if (now_.fill_opacity != opacity) page_.opacity('f', opacity);
        now_.fill = colour;
        now_.fill_opacity = opacity;
    }

    void set_stroke(Colour colour, float opacity) {
        if (now_.stroke != colour) page_.colour(colour, "RG\n");
        if (now_.stroke_opacity != opacity) page_.opacity('s', opacity);
        now_.stroke = colour;
        now_.stroke_opacity = opacity;
    }

    void set_width(double mm) {
        if (now_.stroke_width_mm != mm) append_width_operator(page_.text, mm, decimals_);
        now_.stroke_width_mm = mm;
    }

    void set_dash(double mm) {
        if (now_.dash_mm != mm) append_dash_operator(page_.text, mm, decimals_);
        now_.dash_mm = mm;
    }

    const Drawing& drawing_;
    PdfInstances instances_;
    int decimals_;
    std::vector<SymbolPrecision> precision_;
    std::vector<Needs> needs_;
    std::map<std::tuple<std::uint32_t, bool, bool>, std::string> stamps_;
    InheritedPaint now_;  // the graphics state, as far as it was set
    Stream page_;
    std::vector<PdfForm> forms_;
    std::string path_;  // of one shape, reused
};

}  // namespace

PdfContent pdf_content(const Drawing& drawing, PdfInstances instances) {
    return ContentWriter(drawing, instances).write();
}

}  // namespace edaha
