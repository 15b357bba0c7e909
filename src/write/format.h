// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "drawing/drawing.h"
#include "write/eps.h"
#include "write/png.h"
#include "write/sink.h"
#include "write/svg.h"

namespace edaha {

enum class Format { svg, svgz, pdf, png, eps };

inline constexpr std::array kFormats{Format::svg, Format::svgz, Format::pdf, Format::png,
                                     Format::eps};

// "svg": the ending of its files, without the point.
std::string_view name(Format format);

// By the ending, in capitals or not: "out/Tree.SVG". Nothing for another one, or none.
std::optional<Format> format_of_file(std::string_view file_name);

struct WriteParams {
    SvgParams svg;  // of svgz too
    PngParams png;
    EpsParams eps;
};

struct WriteReport {
    std::size_t bytes = 0;
    SvgReport svg;  // of svg and svgz
};

// The recipe that a file in this format records, even if an editor has saved it anew; empty if
// there is none, or if it is no sound file of this format.
std::string recorded_recipe(std::string_view bytes, Format format);

// Writes the drawing in any of the formats. Errors: IoError (see the writers) and what `sink`
// throws.
WriteReport write_drawing(const Drawing& drawing, Format format, const WriteParams& params,
                          const Sink& sink);

}  // namespace edaha
