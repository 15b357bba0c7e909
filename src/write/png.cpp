// SPDX-License-Identifier: MIT
#include "write/png.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

#include <fmt/format.h>
#include <zlib.h>

#include "base/error.h"
#include "write/canvas.h"
#include "write/xml_text.h"

namespace edaha {
namespace {

constexpr int kMostSide = 32767;  // Cairo's
constexpr double kMillimetresPerInch = 25.4;

// Where chunks of our own go: after the signature (8 bytes) and IHDR, the first chunk (25).
constexpr std::size_t kAfterHeader = 33;
constexpr std::size_t kSignature = 8;
constexpr std::size_t kLengthAndType = 8;
constexpr std::size_t kCheckSum = 4;

// Between the keyword of an international text and its text, where both say nothing: the keyword's
// end, two flags, the ends of a language and of a translated keyword.
constexpr std::size_t kTextFlags = 5;
constexpr std::string_view kRecipeKeyword = "Recipe";

std::string big_endian(std::uint32_t number) {
    std::string bytes(4, '\0');
    for (int i = 0; i < 4; ++i)
        bytes[3 - i] = static_cast<char>(number >> (8 * i) & 0xff);
    return bytes;
}

std::size_t read_big_endian(std::string_view bytes) {
    std::size_t number = 0;
    for (const char byte : bytes)
        number = number << 8 | static_cast<unsigned char>(byte);
    return number;
}

// Length, type, data, check sum of type and data: PNG specification, 5.3.
std::string chunk(std::string_view type, std::string_view data) {
    const std::string body = std::string(type) + std::string(data);
    const uLong sum =
        crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
    return big_endian(static_cast<std::uint32_t>(data.size())) + body +
           big_endian(static_cast<std::uint32_t>(sum));
}

// International text, UTF-8, not packed: keyword, 0, 0, 0, language, 0, translated keyword, 0,
// text.
std::string text_chunk(std::string_view keyword, const std::string& text) {
    if (text.empty()) return "";
    return chunk("iTXt", std::string(keyword) + std::string(kTextFlags, '\0') + xml_safe(text));
}

std::string size_chunk(double pixels_per_mm) {
    const auto per_metre = static_cast<std::uint32_t>(std::lround(pixels_per_mm * 1000));
    return chunk("pHYs", big_endian(per_metre) + big_endian(per_metre) + '\1');
}

std::string own_chunks(const Metadata& metadata, double pixels_per_mm) {
    std::string chunks = size_chunk(pixels_per_mm) + text_chunk("Title", metadata.title);
    if (!metadata.version.empty()) chunks += text_chunk("Software", "edaha " + metadata.version);
    return chunks + text_chunk("Comment", metadata.command) +
           text_chunk(kRecipeKeyword, metadata.recipe);
}

// Whole pixels; a page that is a hair above a whole number (of rounding) does not get one more.
double whole_pixels(double pixels) {
    return std::max(1.0, std::ceil(pixels - 1e-3));
}

}  // namespace

std::string png_bytes(const Drawing& drawing, const PngParams& params) {
    const double scale =
        params.width_px ? *params.width_px / drawing.width_mm : params.dpi / kMillimetresPerInch;
    const double width = whole_pixels(drawing.width_mm * scale);
    const double height = whole_pixels(drawing.height_mm * scale);
    if (width * height > static_cast<double>(params.most_pixels)) {
        throw IoError(
            fmt::format("a picture of {:.0f} x {:.0f} pixels is above the limit of {} pixels",
                        width, height, params.most_pixels));
    }
    if (std::max(width, height) > kMostSide) {
        throw IoError(fmt::format("a picture of {:.0f} x {:.0f} pixels has a side above {} pixels",
                                  width, height, kMostSide));
    }
    Canvas canvas(static_cast<int>(width), static_cast<int>(height));
    if (params.background) canvas.paint_background(*params.background);
    for (const Layer& layer : drawing.layers)
        canvas.draw(drawing, layer, scale);
    std::string bytes = canvas.finish();
    bytes.insert(kAfterHeader, own_chunks(drawing.metadata, scale));
    return bytes;
}

std::string png_recipe(std::string_view png) {
    const std::string head = "iTXt" + std::string(kRecipeKeyword) + std::string(kTextFlags, '\0');
    std::string_view recipe;
    for (std::size_t i = kSignature; i + kLengthAndType < png.size();) {
        const std::size_t length = read_big_endian(png.substr(i, 4));
        const std::string_view typed = png.substr(i + 4, 4 + length);
        if (typed == "IEND") return std::string(recipe);
        if (typed.starts_with(head)) recipe = typed.substr(head.size());
        i += kLengthAndType + length + kCheckSum;
    }
    return "";  // it is not whole
}

}  // namespace edaha
