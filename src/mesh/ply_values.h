// SPDX-License-Identifier: MIT
#pragma once
#include <bit>
#include <cstring>
#include <string_view>
#include <utility>

#include "mesh/ply_header.h"
#include "mesh/text_cursor.h"

namespace edaha {

// The numbers of a PLY file after its header, one by one, whatever the format. Whole numbers of 32
// bits are exact as doubles. Throws SyntaxError where the file ends too soon.
class PlyValues {
  public:
    PlyValues(std::string_view bytes, const PlyHeader& header)
        : bytes_(bytes), text_(bytes, header.size), at_(header.size), format_(header.format) {}

    double next(PlyType type) {
        if (format_ == PlyFormat::text) return next_of_text();
        const std::size_t size = size_of(type);
        if (bytes_.size() - at_ < size) throw SyntaxError(bytes_.size(), "the file ends too soon");
        const char* const at = bytes_.data() + at_;
        at_ += size;
        switch (type) {
            case PlyType::int8:
                return as<std::int8_t>(at);
            case PlyType::uint8:
                return as<std::uint8_t>(at);
            case PlyType::int16:
                return as<std::int16_t>(at);
            case PlyType::uint16:
                return as<std::uint16_t>(at);
            case PlyType::int32:
                return as<std::int32_t>(at);
            case PlyType::uint32:
                return as<std::uint32_t>(at);
            case PlyType::float32:
                return as<float>(at);
            case PlyType::float64:
                break;
        }
        return as<double>(at);
    }

    // Bytes that are left.
    std::size_t left() const {
        return format_ == PlyFormat::text ? text_.left() : bytes_.size() - at_;
    }

    // Of the number that comes next.
    std::size_t offset() const { return format_ == PlyFormat::text ? text_.offset() : at_; }

    // Passes values of one size, as many as are left at most; only in binary files.
    void skip_bytes(std::size_t count) { at_ += count; }
    bool is_text() const { return format_ == PlyFormat::text; }

  private:
    double next_of_text() {
        while (text_.line_ends()) {
            if (text_.at_end()) throw SyntaxError(bytes_.size(), "the file ends too soon");
            text_.next_line();
        }
        return text_.number();
    }

    template <typename T>
    double as(const char* at) const {
        char copy[sizeof(T)];
        std::memcpy(copy, at, sizeof(T));
        const bool is_big = format_ == PlyFormat::big_endian;
        if (is_big == (std::endian::native == std::endian::little)) {
            for (std::size_t i = 0; i < sizeof(T) / 2; ++i)
                std::swap(copy[i], copy[sizeof(T) - 1 - i]);
        }
        T value;
        std::memcpy(&value, copy, sizeof(T));
        return static_cast<double>(value);
    }

    std::string_view bytes_;
    TextCursor text_;
    std::size_t at_;
    PlyFormat format_;
};

}  // namespace edaha
