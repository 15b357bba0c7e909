// SPDX-License-Identifier: MIT
#include "support/image_diff.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <vector>

#include <cairo.h>

namespace edaha::test {
namespace {

struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> pixels;  // 0x00rrggbb
};

constexpr std::uint32_t kPaper = 0xffffff;

int channel(std::uint32_t pixel, int index) {
    return static_cast<int>(pixel >> (8 * index)) & 0xff;
}

Image copy_pixels(cairo_surface_t* surface) {
    Image image{
        cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {}};
    cairo_surface_flush(surface);
    const auto* bytes = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    for (int y = 0; y < image.height; ++y) {
        const auto* row = reinterpret_cast<const std::uint32_t*>(bytes + y * stride);
        for (int x = 0; x < image.width; ++x)
            image.pixels.push_back(row[x] & 0xffffff);
    }
    return image;
}

Image read_over_white(const std::string& path) {
    cairo_surface_t* source = cairo_image_surface_create_from_png(path.c_str());
    if (cairo_surface_status(source) != CAIRO_STATUS_SUCCESS) {
        throw std::runtime_error("not a PNG file: " + path);
    }
    cairo_surface_t* paper =
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, cairo_image_surface_get_width(source),
                                   cairo_image_surface_get_height(source));
    cairo_t* context = cairo_create(paper);
    cairo_set_source_rgb(context, 1, 1, 1);
    cairo_paint(context);
    cairo_set_source_surface(context, source, 0, 0);
    cairo_paint(context);
    Image image = copy_pixels(paper);
    cairo_destroy(context);
    cairo_surface_destroy(paper);
    cairo_surface_destroy(source);
    return image;
}

double pixel_difference(std::uint32_t a, std::uint32_t b) {
    int sum = 0;
    for (int i = 0; i < 3; ++i)
        sum += std::abs(channel(a, i) - channel(b, i));
    return sum / (3 * 255.0);
}

ImageDifference compare(const Image& a, const Image& b) {
    ImageDifference result;
    if (a.width != b.width || a.height != b.height) {
        result.note = std::to_string(a.width) + " x " + std::to_string(a.height) + " against " +
                      std::to_string(b.width) + " x " + std::to_string(b.height);
        return result;
    }
    double sum = 0, worst = 0;
    std::size_t inked = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double difference = pixel_difference(a.pixels[i], b.pixels[i]);
        sum += difference;
        worst = std::max(worst, difference);
        inked += a.pixels[i] != kPaper || b.pixels[i] != kPaper;
    }
    result.mean = sum / static_cast<double>(std::max<std::size_t>(a.pixels.size(), 1));
    result.inked_mean = sum / static_cast<double>(std::max<std::size_t>(inked, 1));
    result.worst = worst;
    result.inked =
        static_cast<double>(inked) / static_cast<double>(std::max<std::size_t>(a.pixels.size(), 1));
    return result;
}

// The difference is drawn dark on white; the square root makes small ones visible.
std::uint32_t difference_pixel(const Image& a, const Image& b, int x, int y) {
    if (x >= std::min(a.width, b.width) || y >= std::min(a.height, b.height)) return 0xff0000;
    const auto at = [&](const Image& image) { return image.pixels[y * image.width + x]; };
    const double shade = 255 * (1 - std::sqrt(pixel_difference(at(a), at(b))));
    return static_cast<std::uint32_t>(shade) * 0x010101;
}

void write_comparison(const Image& a, const Image& b, const std::string& path) {
    const int width = std::max(a.width, b.width);
    const int height = std::max(a.height, b.height);
    cairo_surface_t* sheet = cairo_image_surface_create(CAIRO_FORMAT_RGB24, 3 * width, height);
    auto* bytes = cairo_image_surface_get_data(sheet);
    const int stride = cairo_image_surface_get_stride(sheet);
    const auto pixel = [](const Image& image, int x, int y) {
        return x < image.width && y < image.height ? image.pixels[y * image.width + x] : 0x808080;
    };
    for (int y = 0; y < height; ++y) {
        auto* row = reinterpret_cast<std::uint32_t*>(bytes + y * stride);
        for (int x = 0; x < width; ++x) {
            row[x] = pixel(a, x, y);
            row[width + x] = difference_pixel(a, b, x, y);
            row[2 * width + x] = pixel(b, x, y);
        }
    }
    cairo_surface_mark_dirty(sheet);
    cairo_surface_write_to_png(sheet, path.c_str());
    cairo_surface_destroy(sheet);
}

}  // namespace

ImageDifference compare_images(const std::string& expected_png, const std::string& actual_png) {
    return compare(read_over_white(expected_png), read_over_white(actual_png));
}

std::string image_complaint(const std::string& expected_png, const std::string& actual_png,
                            double most, const std::string& picture) {
    const Image expected = read_over_white(expected_png);
    const Image actual = read_over_white(actual_png);
    const ImageDifference difference = compare(expected, actual);
    if (difference.inked_mean <= most) return "";
    write_comparison(expected, actual, picture);
    const std::string what = difference.note.empty()
                                 ? std::to_string(100 * difference.inked_mean) + " % apart"
                                 : difference.note;
    return actual_png + " is not like " + expected_png + ": " + what + "; see " + picture;
}

}  // namespace edaha::test
