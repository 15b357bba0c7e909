// SPDX-License-Identifier: MIT
#include "write/gzip.h"

#include <algorithm>
#include <new>

#include <zlib.h>

#include "base/error.h"

namespace edaha {
namespace {

constexpr int kGzipWindow = 15 + 16;  // zlib's largest window, in gzip's wrapping
constexpr int kMemoryLevel = 8;       // zlib's own default
constexpr int kUnknownSystem = 255;
constexpr std::size_t kPieceBytes = 1 << 16;
constexpr std::size_t kMostInputBytes = 1 << 30;  // zlib counts in unsigned int

Bytef* bytes_of(std::string_view text) {
    // zlib does not write to its input; its interface predates const.
    return reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
}

}  // namespace

struct Gzip::State {
    Sink sink;
    z_stream stream{};
    gz_header header{};
    std::string piece = std::string(kPieceBytes, '\0');

    ~State() { deflateEnd(&stream); }
    void run(std::string_view bytes, int flush);
};

Gzip::Gzip(Sink sink) : state_(std::make_unique<State>()) {
    state_->sink = std::move(sink);
    state_->header.os = kUnknownSystem;
    const int status = deflateInit2(&state_->stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kGzipWindow,
                                    kMemoryLevel, Z_DEFAULT_STRATEGY);
    if (status != Z_OK) throw std::bad_alloc();
    deflateSetHeader(&state_->stream, &state_->header);
}

Gzip::~Gzip() = default;
Gzip::Gzip(Gzip&&) noexcept = default;

void Gzip::State::run(std::string_view bytes, int flush) {
    stream.next_in = bytes_of(bytes);
    stream.avail_in = static_cast<uInt>(bytes.size());
    do {
        stream.next_out = bytes_of(piece);
        stream.avail_out = static_cast<uInt>(piece.size());
        deflate(&stream, flush);
        sink(std::string_view(piece).substr(0, piece.size() - stream.avail_out));
    } while (stream.avail_out == 0);
}

void Gzip::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const std::string_view now = bytes.substr(0, kMostInputBytes);
        state_->run(now, Z_NO_FLUSH);
        bytes.remove_prefix(now.size());
    }
}

void Gzip::finish() {
    state_->run({}, Z_FINISH);
}

bool is_gzip(std::string_view bytes) {
    return bytes.substr(0, 2) == "\x1f\x8b";
}

std::string gunzip(std::string_view packed, std::size_t max_bytes) {
    struct Stream : z_stream {
        Stream() : z_stream{} {}
        ~Stream() { inflateEnd(this); }
    } stream;
    if (packed.size() > kMostInputBytes) throw IoError("the packed file is too large");
    if (inflateInit2(&stream, kGzipWindow) != Z_OK) throw std::bad_alloc();
    stream.next_in = bytes_of(packed);
    stream.avail_in = static_cast<uInt>(packed.size());
    std::string text;
    std::string piece(kPieceBytes, '\0');
    int status = Z_OK;
    while (status != Z_STREAM_END) {
        stream.next_out = bytes_of(piece);
        stream.avail_out = static_cast<uInt>(piece.size());
        status = inflate(&stream, Z_NO_FLUSH);
        if (status != Z_OK && status != Z_STREAM_END) throw IoError("the packed file is damaged");
        text.append(piece, 0, piece.size() - stream.avail_out);
        if (text.size() > max_bytes) {
            throw IoError("the packed file unpacks to more than the limit of " +
                          std::to_string(max_bytes) + " bytes");
        }
    }
    return text;
}

}  // namespace edaha
