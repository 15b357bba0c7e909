// SPDX-License-Identifier: MIT
#include "write/png_pixels.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include <cairo.h>

namespace edaha {
namespace {

// Offsets in a PNG file: signature, length and type of IHDR, then its data.
constexpr std::size_t kTypeOfFirst = 12;
constexpr std::size_t kWidth = 16;
constexpr std::size_t kHeaderEnd = 24;

int read_number(std::string_view bytes) {
    unsigned number = 0;
    for (const char byte : bytes)
        number = number << 8U | static_cast<unsigned char>(byte);
    return static_cast<int>(number);
}

// A PNG file as Cairo's pixels: 4 bytes each, whatever the file has.
class Pixels {
  public:
    explicit Pixels(std::string_view png) : rest_(png) {
        cairo_surface_t* const file = cairo_image_surface_create_from_png_stream(read, this);
        if (cairo_surface_status(file) == CAIRO_STATUS_SUCCESS) copy(file);
        cairo_surface_destroy(file);
    }
    ~Pixels() { cairo_surface_destroy(surface_); }
    Pixels(const Pixels&) = delete;
    Pixels& operator=(const Pixels&) = delete;

    bool good() const { return good_; }
    PixelSize size() const {
        return {cairo_image_surface_get_width(surface_), cairo_image_surface_get_height(surface_)};
    }
    const unsigned char* row(int y) const {
        return cairo_image_surface_get_data(surface_) +
               static_cast<std::ptrdiff_t>(y) * cairo_image_surface_get_stride(surface_);
    }

  private:
    void copy(cairo_surface_t* file) {
        const int width = cairo_image_surface_get_width(file);
        const int height = cairo_image_surface_get_height(file);
        surface_ = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height);
        cairo_t* const context = cairo_create(surface_);
        cairo_set_source_surface(context, file, 0, 0);
        cairo_paint(context);
        good_ = cairo_status(context) == CAIRO_STATUS_SUCCESS;
        cairo_destroy(context);
        cairo_surface_flush(surface_);
    }

    static cairo_status_t read(void* self, unsigned char* data, unsigned length) {
        std::string_view& rest = static_cast<Pixels*>(self)->rest_;
        if (rest.size() < length) return CAIRO_STATUS_READ_ERROR;
        std::memcpy(data, rest.data(), length);
        rest.remove_prefix(length);
        return CAIRO_STATUS_SUCCESS;
    }

    std::string_view rest_;
    cairo_surface_t* surface_ = nullptr;
    bool good_ = false;
};

}  // namespace

PixelSize png_size(std::string_view png) {
    if (png.size() < kHeaderEnd || png.substr(kTypeOfFirst, 4) != "IHDR") return {};
    return {read_number(png.substr(kWidth, 4)), read_number(png.substr(kWidth + 4, 4))};
}

bool are_alike(const std::string& png, const std::string& other_png, int most) {
    const Pixels a(png), b(other_png);
    if (!a.good() || !b.good() || a.size() != b.size()) return false;
    const auto is_near = [&](unsigned char x, unsigned char y) { return std::abs(x - y) <= most; };
    for (int y = 0; y < a.size().height; ++y) {
        const unsigned char* const row = a.row(y);
        if (!std::equal(row, row + 4 * static_cast<std::ptrdiff_t>(a.size().width), b.row(y),
                        is_near))
            return false;
    }
    return true;
}

}  // namespace edaha
