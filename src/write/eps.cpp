// SPDX-License-Identifier: MIT
#include "write/eps.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/number_text.h"
#include "drawing/inherit.h"
#include "drawing/palette.h"
#include "write/path_operators.h"
#include "write/precision.h"

namespace edaha {
namespace {

constexpr std::string_view kRecipe = "%EdahaRecipe: ";
constexpr std::size_t kMostTitleBytes = 200;  // a line of these comments has 255 at most

// Printable ASCII as a PostScript string; other characters become '?'.
std::string postscript_text(std::string_view text) {
    std::string result = "(";
    for (const char c : text.substr(0, kMostTitleBytes)) {
        if (c == '(' || c == ')' || c == '\\') {
            result += '-';
        } else {
            result += c >= ' ' && c <= '~' ? c : '?';
        }
    }
    return result + ')';
}

// The head that Adobe's "Document Structuring Conventions" 3.0 ask for.
std::string head(const Drawing& drawing) {
    const double width = drawing.width_mm * kPointsPerMm;
    const double height = drawing.height_mm * kPointsPerMm;
    std::string text = "%!PS-Adobe-3.0 EPSF-3.0\n";
    text += fmt::format("%%Title: {}\n", postscript_text(drawing.metadata.title));
    text += fmt::format("%%Creator: {}\n", postscript_text("edaha " + drawing.metadata.version));
    text += fmt::format("%%BoundingBox: 0 0 {:.0f} {:.0f}\n", std::ceil(width), std::ceil(height));
    text +=
        "%%HiResBoundingBox: 0 0 " + number_text(width, 4) + ' ' + number_text(height, 4) + '\n';
    if (!drawing.metadata.recipe.empty())
        text += std::string(kRecipe) + postscript_text(drawing.metadata.recipe) + '\n';
    return text + "%%Pages: 1\n%%DocumentData: Clean7Bit\n%%LanguageLevel: 2\n%%EndComments\n";
}

// PDF's operators in PostScript's words.
constexpr std::string_view kProlog = R"(%%BeginProlog
32 dict begin
/q{gsave}bind def
/Q{grestore}bind def
/cm{6 array astore concat}bind def
/m{moveto}bind def
/l{lineto}bind def
/c{curveto}bind def
/v{currentpoint 6 2 roll curveto}bind def
/y{2 copy curveto}bind def
/h{closepath}bind def
/f{fill}bind def
/S{stroke}bind def
/k{setrgbcolor}bind def
/w{setlinewidth}bind def
/d{setdash}bind def
%%EndProlog
%%Page: 1 1
1 setlinecap
1 setlinejoin
)";

// `ink` laid over `paper`.
Colour over(Colour ink, Colour paper, float opacity) {
    return mixed(paper, ink, static_cast<double>(opacity));
}

// Operators, with the ink that is set so far.
struct Marks {
    std::string text;
    std::optional<Colour> ink;

    void set(Colour colour) {
        if (ink == colour) return;
        ink = colour;
        for (const int channel : {colour.r, colour.g, colour.b}) {
            append_number(text, channel / 255.0, 3);
            text += ' ';
        }
        text += "k\n";
    }

    // There is one ink for both: the stroke's comes last.
    void paint(const std::string& path, std::optional<Colour> fill, std::optional<Colour> stroke) {
        if (fill) {
            set(*fill);
            text += path + "f\n";
        }
        if (stroke) {
            set(*stroke);
            text += path + "S\n";
        }
    }
};

class EpsWriter {
  public:
    EpsWriter(const Drawing& drawing, Colour paper)
        : drawing_(drawing),
          paper_(paper),
          decimals_(page_decimals(drawing.width_mm, drawing.height_mm)),
          precision_(symbol_precision(drawing, decimals_)) {}

    std::string write() {
        for (const Layer& layer : drawing_.layers)
            add(layer);
        std::string page = head(drawing_) + std::string(kProlog);
        const Affine points_from_page(kPointsPerMm, 0, 0, -kPointsPerMm, 0,
                                      drawing_.height_mm * kPointsPerMm);
        append_map_operator(page, points_from_page, kMostDecimals, kMostDecimals);
        return page + procedures_ + marks_.text + "showpage\nend\n%%EOF\n";
    }

  private:
    struct Stamp {
        std::uint32_t symbol;
        InheritedPaint paint;  // without the pen
        std::string name;
    };

    void add(const Layer& layer) {
        for_each_painted(
            layer.children, inherit({}, layer.paint),
            [this](const auto& mark, const InheritedPaint& paint) { add(mark, paint); });
    }

    void add(const Shape& shape, const InheritedPaint& paint) {
        std::string path;
        if (!append_path_operators(path, shape.path, decimals_)) return;
        if (paint.stroke) set_width(paint.stroke_width_mm);
        if (paint.stroke) set_dash(paint.dash_mm);
        marks_.paint(path, fill_of(paint, paper_), stroke_of(paint, paper_));
    }

    void add(const Use& use, const InheritedPaint& paint) {
        if (paint.stroke_width_mm > 0) set_width(paint.stroke_width_mm);
        set_dash(0);
        const std::string& name = stamp(use.symbol, paint);
        marks_.text += "q\n";
        append_map_operator(marks_.text, use.page_from_symbol, precision_[use.symbol].matrices,
                            decimals_);
        marks_.text += name + "\nQ\n";
    }

    // The procedure that draws a symbol in an instance's inks.
    const std::string& stamp(std::uint32_t symbol, InheritedPaint paint) {
        paint.stroke_width_mm = paint.dash_mm = 0;
        const auto known = std::find_if(stamps_.begin(), stamps_.end(), [&](const Stamp& one) {
            return one.symbol == symbol && one.paint == paint;
        });
        if (known != stamps_.end()) return known->name;
        const std::string name = fmt::format("P{}", stamps_.size());
        procedures_ += '/' + name + "{\n" + body(symbol, paint) + "}bind def\n";
        return stamps_.emplace_back(Stamp{symbol, paint, name}).name;
    }

    std::string body(std::uint32_t symbol, const InheritedPaint& parent) const {
        Marks marks;
        Colour below = paper_;
        bool bare = true;
        const int decimals = precision_[symbol].points;
        for (const Shape& shape : drawing_.symbols[symbol].shapes) {
            const InheritedPaint paint = inherit(parent, shape.paint);
            const auto fill = fill_of(paint, below);
            const auto stroke = stroke_of(paint, below);
            std::string path;
            if (!append_path_operators(path, shape.path, decimals)) continue;
            const bool own_width = stroke && shape.paint.stroke_width_mm > 0;
            if (own_width) {
                marks.text += "currentlinewidth\n";
                append_width_operator(marks.text, shape.paint.stroke_width_mm, decimals);
            }
            marks.paint(path, fill, stroke);
            if (own_width) marks.text += "w\n";
            // What comes next (veins, a shine) lies on the blade: it is mixed with that.
            if (fill && bare) below = *fill;
            bare &= !fill;
        }
        return marks.text;
    }

    static std::optional<Colour> fill_of(const InheritedPaint& paint, Colour below) {
        if (!paint.fill) return std::nullopt;
        return over(*paint.fill, below, paint.fill_opacity);
    }

    static std::optional<Colour> stroke_of(const InheritedPaint& paint, Colour below) {
        if (!paint.stroke) return std::nullopt;
        return over(*paint.stroke, below, paint.stroke_opacity);
    }

    void set_width(double mm) {
        if (width_mm_ != mm) append_width_operator(marks_.text, mm, decimals_);
        width_mm_ = mm;
    }

    void set_dash(double mm) {
        if (dash_mm_ != mm) append_dash_operator(marks_.text, mm, decimals_);
        dash_mm_ = mm;
    }

    const Drawing& drawing_;
    Colour paper_;
    int decimals_;
    std::vector<SymbolPrecision> precision_;
    std::deque<Stamp> stamps_;
    std::string procedures_;
    Marks marks_;
    double width_mm_ = 0, dash_mm_ = 0;  // as set so far
};

}  // namespace

std::string eps_bytes(const Drawing& drawing, const EpsParams& params) {
    return EpsWriter(drawing, params.paper).write();
}

std::string eps_recipe(std::string_view eps) {
    if (eps.find("%%EOF") == std::string_view::npos) return "";  // it is not whole
    const std::size_t at = eps.substr(0, eps.find("%%EndComments")).find(kRecipe);
    if (at == std::string_view::npos) return "";
    const std::string_view text = eps.substr(at + kRecipe.size() + 1);
    return std::string(text.substr(0, text.find(')')));
}

}  // namespace edaha
