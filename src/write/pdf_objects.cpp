// SPDX-License-Identifier: MIT
#include "write/pdf_objects.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <new>
#include <utility>

#include <fmt/format.h>
#include <zlib.h>

#include "base/utf8.h"
#include "write/xml_text.h"

namespace edaha {
namespace {

constexpr std::size_t kUnwritten = 0;

// zlib's own choice (above it, the files of trees get no smaller) and its quickest.
constexpr int kSmall = 6, kQuick = 1;

// 1.5 has layers. Bytes above 127 tell programs that the file is not text: 7.5.2.
constexpr std::string_view kHead = "%PDF-1.5\n%\xe6\x9e\x9d\xe8\x91\x89\n";

std::string deflated(std::string_view content, int level) {
    std::string packed(compressBound(content.size()), '\0');
    uLongf size = packed.size();
    const int status =
        compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                  reinterpret_cast<const Bytef*>(content.data()), content.size(), level);
    if (status != Z_OK) throw std::bad_alloc();
    packed.resize(size);
    return packed;
}

void append_utf16(std::string& digits, std::int32_t code) {
    if (code >= 0x10000) {
        const std::int32_t rest = code - 0x10000;
        digits += fmt::format("{:04x}{:04x}", 0xd800 + (rest >> 10), 0xdc00 + (rest & 0x3ff));
    } else {
        digits += fmt::format("{:04x}", code);
    }
}

}  // namespace

PdfObjects::PdfObjects(Sink sink) : sink_(std::move(sink)) {
    put(kHead);
}

void PdfObjects::put(std::string_view bytes) {
    fingerprint_.add(bytes);
    size_ += bytes.size();
    sink_(bytes);
}

int PdfObjects::reserve() {
    places_.push_back(kUnwritten);
    return static_cast<int>(places_.size());
}

void PdfObjects::begin(int number) {
    places_[static_cast<std::size_t>(number) - 1] = size_;
    put(std::to_string(number) + " 0 obj\n");
}

void PdfObjects::write(int number, std::string_view object) {
    begin(number);
    put(object);
    put("\nendobj\n");
}

int PdfObjects::write(std::string_view object) {
    const int number = reserve();
    write(number, object);
    return number;
}

void PdfObjects::write_stream(int number, const Stream& stream) {
    const int level = stream.packing == Packing::small ? kSmall : kQuick;
    const std::string packed = deflated(stream.content, level);
    begin(number);
    put(fmt::format("<<{}/Filter/FlateDecode/Length {}>>\nstream\n", stream.entries,
                    packed.size()));
    put(packed);
    put("\nendstream\nendobj\n");
}

// 7.5.4 and 7.5.5: entries of the table are 20 bytes each.
void PdfObjects::finish(int catalogue, int information) {
    const std::size_t table = size_;
    const std::size_t count = places_.size() + 1;
    std::string end = fmt::format("xref\n0 {}\n0000000000 65535 f \n", count);
    for (const std::size_t place : places_) {
        assert(place != kUnwritten);
        end += fmt::format("{:010} 00000 n \n", place);
    }
    put(end);
    const std::string id = fingerprint_.text();
    put(fmt::format("trailer\n<</Size {}/Root {}/Info {}/ID[({})({})]>>\nstartxref\n{}\n%%EOF\n",
                    count, pdf_reference(catalogue), pdf_reference(information), id, id, table));
}

std::string pdf_reference(int number) {
    return std::to_string(number) + " 0 R";
}

std::string pdf_text(std::string_view text) {
    const std::string safe = xml_safe(text);
    const bool ascii = std::all_of(safe.begin(), safe.end(),
                                   [](char c) { return (c >= ' ' && c <= '~') || c == '\n'; });
    if (!ascii) {
        std::string digits = "<feff";
        for (std::string_view rest = safe; !rest.empty();) {
            const auto [code, bytes] = first_character(rest);
            append_utf16(digits, code);
            rest.remove_prefix(bytes);
        }
        return digits + '>';
    }
    std::string result = "(";
    for (const char c : safe) {
        if (c == '(' || c == ')' || c == '\\') result += '\\';
        result += c;
    }
    return result + ')';
}

}  // namespace edaha
