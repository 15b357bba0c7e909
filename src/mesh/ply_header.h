// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace edaha {

enum class PlyFormat { text, little_endian, big_endian };
enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t size_of(PlyType type);
bool is_whole(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;
    bool is_list = false;
    PlyType count_type = PlyType::uint8;  // of a list
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
    std::size_t offset = 0;  // of its line in the header

    // Of one record, lists being empty: bytes, or numbers of a text.
    std::size_t least_bytes() const;
    std::size_t least_numbers() const { return properties.size(); }
    bool has_lists() const;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::text;
    std::vector<PlyElement> elements;
    std::vector<std::string> comments;
    std::size_t size = 0;  // bytes up to the first record
};

// Throws SyntaxError. Elements' counts are as promised: nothing is reserved for them.
PlyHeader read_ply_header(std::string_view bytes);

}  // namespace edaha
