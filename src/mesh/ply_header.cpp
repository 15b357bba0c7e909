// SPDX-License-Identifier: MIT
#include "mesh/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

#include "base/quoted.h"
#include "mesh/text_cursor.h"

namespace edaha {
namespace {

struct TypeName {
    std::string_view name;
    PlyType type;
};

constexpr std::array<TypeName, 16> kTypes = {{{"char", PlyType::int8},
                                              {"int8", PlyType::int8},
                                              {"uchar", PlyType::uint8},
                                              {"uint8", PlyType::uint8},
                                              {"short", PlyType::int16},
                                              {"int16", PlyType::int16},
                                              {"ushort", PlyType::uint16},
                                              {"uint16", PlyType::uint16},
                                              {"int", PlyType::int32},
                                              {"int32", PlyType::int32},
                                              {"uint", PlyType::uint32},
                                              {"uint32", PlyType::uint32},
                                              {"float", PlyType::float32},
                                              {"float32", PlyType::float32},
                                              {"double", PlyType::float64},
                                              {"float64", PlyType::float64}}};

// Reads the header line by line; a line ends in LF, CR LF or CR.
class HeaderReader {
  public:
    explicit HeaderReader(std::string_view bytes) : bytes_(bytes) {}

    PlyHeader run() {
        if (next_line() != "ply") throw SyntaxError(0, "this is no PLY file (expected 'ply')");
        bool has_format = false;
        while (true) {
            if (at_ >= bytes_.size()) throw SyntaxError(at_, "the header has no end_header");
            rest_ = next_line();
            const std::string_view keyword = word();
            if (keyword == "end_header") break;
            if (keyword == "format") {
                read_format();
                has_format = true;
            } else if (keyword == "element") {
                read_element();
            } else if (keyword == "property") {
                read_property();
            } else if (keyword == "comment") {
                header_.comments.emplace_back(trimmed(rest_));
            } else if (keyword != "obj_info" && !keyword.empty()) {
                fail(quoted(keyword) + " is not known in a PLY header");
            }
        }
        if (!has_format) throw SyntaxError(0, "the header names no format");
        header_.size = at_;
        return std::move(header_);
    }

  private:
    // Where the file breaks its lines in CR alone, a record's first byte may be LF.
    std::string_view next_line() {
        line_ = at_;
        const std::size_t end = std::min(bytes_.find_first_of("\r\n", at_), bytes_.size());
        at_ = std::min(end + 1, bytes_.size());
        const bool cr = end < bytes_.size() && bytes_[end] == '\r';
        if (line_ == 0) ends_in_cr_lf_ = cr && bytes_.substr(at_).starts_with('\n');
        if (cr && ends_in_cr_lf_ && at_ < bytes_.size() && bytes_[at_] == '\n') ++at_;
        return bytes_.substr(line_, end - line_);
    }

    std::string_view word() {
        rest_ = trimmed(rest_);
        const std::string_view found = rest_.substr(0, rest_.find_first_of(" \t"));
        rest_.remove_prefix(found.size());
        return found;
    }

    void read_format() {
        const std::string_view name = word();
        if (name == "ascii") {
            header_.format = PlyFormat::text;
        } else if (name == "binary_little_endian") {
            header_.format = PlyFormat::little_endian;
        } else if (name == "binary_big_endian") {
            header_.format = PlyFormat::big_endian;
        } else {
            fail(quoted(name) +
                 " is no format (expected ascii, binary_little_endian or binary_big_endian)");
        }
        if (const std::string_view version = word(); version != "1.0")
            fail("the version is " + quoted(version) + " (expected 1.0)");
    }

    void read_element() {
        PlyElement element;
        element.offset = line_;
        element.name = word();
        const std::string_view count = word();
        const char* const end = count.data() + count.size();
        const auto [stop, error] = std::from_chars(count.data(), end, element.count);
        if (error != std::errc{} || stop != end || element.count >= kMostRecords)
            fail(quoted(count) + " is no number of records (expected 0 to 999999999999)");
        header_.elements.push_back(std::move(element));
    }

    void read_property() {
        if (header_.elements.empty()) fail("a property comes before its element");
        PlyProperty property;
        std::string_view name = word();
        if (name == "list") {
            property.is_list = true;
            property.count_type = type(word());
            if (!is_whole(property.count_type)) fail("a list's length is no whole number");
            name = word();
        }
        property.type = type(name);
        property.name = word();
        header_.elements.back().properties.push_back(std::move(property));
    }

    PlyType type(std::string_view name) const {
        const auto found = std::find_if(kTypes.begin(), kTypes.end(),
                                        [&](const TypeName& known) { return known.name == name; });
        if (found == kTypes.end())
            fail(quoted(name) +
                 " is no type (expected char, uchar, short, ushort, int, uint, "
                 "float or double)");
        return found->type;
    }

    [[noreturn]] void fail(const std::string& message) const { throw SyntaxError(line_, message); }

    static constexpr std::uint64_t kMostRecords = 1'000'000'000'000;  // sums of sizes stay exact

    std::string_view bytes_;
    std::string_view rest_;  // of the line
    std::size_t line_ = 0;   // where it begins
    std::size_t at_ = 0;     // where the next one does
    bool ends_in_cr_lf_ = false;
    PlyHeader header_;
};

}  // namespace

std::size_t size_of(PlyType type) {
    constexpr std::array<std::size_t, 8> kSizes = {1, 1, 2, 2, 4, 4, 4, 8};
    return kSizes[static_cast<std::size_t>(type)];
}

bool is_whole(PlyType type) {
    return type != PlyType::float32 && type != PlyType::float64;
}

std::size_t PlyElement::least_bytes() const {
    std::size_t bytes = 0;
    for (const PlyProperty& property : properties)
        bytes += size_of(property.is_list ? property.count_type : property.type);
    return bytes;
}

bool PlyElement::has_lists() const {
    return std::any_of(properties.begin(), properties.end(),
                       [](const PlyProperty& property) { return property.is_list; });
}

PlyHeader read_ply_header(std::string_view bytes) {
    return HeaderReader(bytes).run();
}

}  // namespace edaha
