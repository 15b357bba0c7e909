// SPDX-License-Identifier: MIT
#include "write/canvas.h"

#include <cmath>

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

// Draws elements on a context, with the rules of Paint.
class Brush {
  public:
    Brush(cairo_t* context, const Drawing& drawing) : context_(context), drawing_(drawing) {}

    void draw(const Layer& layer);

  private:
    void draw(const Use& use, const InheritedPaint& parent);
    void draw(const Shape& shape, const InheritedPaint& paint);
    void add_path(const Path& path);
    void set_ink(Colour colour, float opacity);

    cairo_t* context_;
    const Drawing& drawing_;
};

void Brush::draw(const Layer& layer) {
    for_each_painted(layer.children, inherit({}, layer.paint),
                     [this](const auto& mark, const InheritedPaint& paint) { draw(mark, paint); });
}

void Brush::draw(const Use& use, const InheritedPaint& parent) {
    const Affine& map = use.page_from_symbol;
    const cairo_matrix_t matrix{map[0].x, map[0].y, map[1].x, map[1].y, map[2].x, map[2].y};
    cairo_save(context_);
    cairo_transform(context_, &matrix);
    for (const Shape& shape : drawing_.symbols[use.symbol].shapes)
        draw(shape, inherit(parent, shape.paint));
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
        cairo_set_dash(context_, &paint.dash_mm, paint.dash_mm > 0 ? 1 : 0, 0);
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
    // Opacities to the three decimals of the SVG, so that all formats are the same.
    const double alpha = std::round(static_cast<double>(opacity) * 1000) / 1000;
    cairo_set_source_rgba(context_, colour.r / 255.0, colour.g / 255.0, colour.b / 255.0, alpha);
}

}  // namespace

struct Canvas::State {
    std::string bytes;
    cairo_surface_t* surface = nullptr;
    cairo_t* context = nullptr;

    ~State() {
        cairo_destroy(context);
        cairo_surface_destroy(surface);
    }
};

Canvas::Canvas(int width, int height) : state_(std::make_unique<State>()) {
    State& state = *state_;
    state.surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height);
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

void Canvas::draw(const Drawing& drawing, const Layer& layer, double scale) {
    cairo_save(state_->context);
    cairo_scale(state_->context, scale, scale);
    Brush(state_->context, drawing).draw(layer);
    cairo_restore(state_->context);
}

std::string Canvas::finish() {
    State& state = *state_;
    require(cairo_status(state.context));
    require(cairo_surface_write_to_png_stream(state.surface, append_bytes, &state.bytes));
    cairo_surface_finish(state.surface);
    require(cairo_surface_status(state.surface));
    return std::move(state.bytes);
}

}  // namespace edaha
