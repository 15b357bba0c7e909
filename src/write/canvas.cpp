// SPDX-License-Identifier: MIT
#include "write/canvas.h"

#include <algorithm>
#include <cmath>

#include <cairo-pdf.h>
#include <cairo-ps.h>
#include <cairo.h>

#include "base/error.h"
#include "drawing/inherit.h"

namespace edaha {
namespace {

cairo_status_t append_bytes(void* text, const unsigned char* bytes, unsigned int size) {
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), size);
    return CAIRO_STATUS_SUCCESS;
}

void require(cairo_status_t status) {
    if (status != CAIRO_STATUS_SUCCESS) {
        throw IoError(std::string("cannot draw: ") + cairo_status_to_string(status));
    }
}

// `ink` laid over `paper`.
Colour mixed(Colour ink, Colour paper, float opacity) {
    const auto mix = [&](std::uint8_t a, std::uint8_t b) {
        return static_cast<std::uint8_t>(std::lround(b + (a - b) * static_cast<double>(opacity)));
    };
    return {mix(ink.r, paper.r), mix(ink.g, paper.g), mix(ink.b, paper.b)};
}

// Draws elements on a context, with the rules of Paint.
class Brush {
  public:
    Brush(cairo_t* context, const Drawing& drawing, const std::optional<Colour>& paper)
        : context_(context), drawing_(drawing), paper_(paper) {}

    void draw(const std::vector<Element>& elements, const InheritedPaint& parent);

  private:
    void draw(const Use& use, const InheritedPaint& parent);
    void draw(const Shape& shape, const InheritedPaint& paint);
    void add_path(const Path& path);
    void set_ink(Colour colour, float opacity);

    cairo_t* context_;
    const Drawing& drawing_;
    std::optional<Colour> paper_;
};

void Brush::draw(const std::vector<Element>& elements, const InheritedPaint& parent) {
    for (const Element& element : elements) {
        if (const auto* shape = std::get_if<Shape>(&element)) {
            draw(*shape, inherit(parent, shape->paint));
        } else if (const auto* use = std::get_if<Use>(&element)) {
            draw(*use, inherit(parent, use->paint));
        } else {
            const auto& group = std::get<Group>(element);
            draw(group.children, inherit(parent, group.paint));
        }
    }
}

void Brush::draw(const Use& use, const InheritedPaint& parent) {
    const Affine& map = use.page_from_symbol;
    const cairo_matrix_t matrix{map[0].x, map[0].y, map[1].x, map[1].y, map[2].x, map[2].y};
    cairo_save(context_);
    cairo_transform(context_, &matrix);
    const std::optional<Colour> paper = paper_;
    for (const Shape& shape : drawing_.symbols[use.symbol].shapes) {
        const InheritedPaint paint = inherit(parent, shape.paint);
        draw(shape, paint);
        // What comes next (veins, a shine) lies on the blade: it is mixed with that.
        if (paper && paper_ == paper && paint.fill) {
            paper_ = mixed(*paint.fill, *paper, paint.fill_opacity);
        }
    }
    paper_ = paper;
    cairo_restore(context_);
}

void Brush::draw(const Shape& shape, const InheritedPaint& paint) {
    const bool stroked = paint.stroke && paint.stroke_width_mm > 0;
    if (!paint.fill && !stroked) return;
    add_path(shape.path);
    if (paint.fill) {
        set_ink(*paint.fill, paint.fill_opacity);
        cairo_fill_preserve(context_);
    }
    if (stroked) {
        set_ink(*paint.stroke, paint.stroke_opacity);
        cairo_set_line_width(context_, paint.stroke_width_mm);
        cairo_stroke_preserve(context_);
    }
    cairo_new_path(context_);
}

void Brush::add_path(const Path& path) {
    const Vec2* p = path.points.data();
    for (const Verb verb : path.verbs) {
        if (verb == Verb::move) {
            cairo_move_to(context_, p[0].x, p[0].y);
            ++p;
        } else if (verb == Verb::line) {
            cairo_line_to(context_, p[0].x, p[0].y);
            ++p;
        } else if (verb == Verb::cubic) {
            cairo_curve_to(context_, p[0].x, p[0].y, p[1].x, p[1].y, p[2].x, p[2].y);
            p += 3;
        } else {
            cairo_close_path(context_);
        }
    }
}

void Brush::set_ink(Colour colour, float opacity) {
    if (paper_) {
        colour = mixed(colour, *paper_, opacity);
        opacity = 1;
    }
    // Opacities to the three decimals of the SVG, so that all formats are the same.
    const double alpha = std::round(static_cast<double>(opacity) * 1000) / 1000;
    cairo_set_source_rgba(context_, colour.r / 255.0, colour.g / 255.0, colour.b / 255.0, alpha);
}

}  // namespace

struct Canvas::State {
    Kind kind;
    std::string bytes;
    cairo_surface_t* surface = nullptr;
    cairo_t* context = nullptr;

    ~State() {
        cairo_destroy(context);
        cairo_surface_destroy(surface);
    }
};

Canvas::Canvas(Kind kind, double width, double height) : state_(std::make_unique<State>()) {
    State& state = *state_;
    state.kind = kind;
    if (kind == Kind::picture) {
        state.surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, static_cast<int>(width),
                                                   static_cast<int>(height));
    } else if (kind == Kind::pdf) {
        state.surface =
            cairo_pdf_surface_create_for_stream(append_bytes, &state.bytes, width, height);
    } else {
        state.surface =
            cairo_ps_surface_create_for_stream(append_bytes, &state.bytes, width, height);
        cairo_ps_surface_set_eps(state.surface, 1);
    }
    require(cairo_surface_status(state.surface));
    state.context = cairo_create(state.surface);
    cairo_set_line_cap(state.context, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(state.context, CAIRO_LINE_JOIN_ROUND);
}

Canvas::~Canvas() = default;
Canvas::Canvas(Canvas&&) noexcept = default;

void Canvas::paint_background(Colour colour) {
    cairo_set_source_rgb(state_->context, colour.r / 255.0, colour.g / 255.0, colour.b / 255.0);
    cairo_paint(state_->context);
}

void Canvas::draw(const Drawing& drawing, const Layer& layer, double scale,
                  const std::optional<Colour>& paper) {
    cairo_save(state_->context);
    cairo_scale(state_->context, scale, scale);
    Brush(state_->context, drawing, paper).draw(layer.children, inherit({}, layer.paint));
    cairo_restore(state_->context);
}

std::string Canvas::finish() {
    State& state = *state_;
    require(cairo_status(state.context));
    if (state.kind == Kind::picture) {
        require(cairo_surface_write_to_png_stream(state.surface, append_bytes, &state.bytes));
    } else {
        cairo_show_page(state.context);
    }
    cairo_surface_finish(state.surface);
    require(cairo_surface_status(state.surface));
    return std::move(state.bytes);
}

}  // namespace edaha
