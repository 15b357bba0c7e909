// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include "write/sink.h"

namespace edaha {

// Packs what is written into one gzip member (RFC 1952) and passes it on. No date, no name,
// "unknown" system: the bytes depend on the input and on zlib's version alone.
class Gzip {
  public:
    explicit Gzip(Sink sink);
    ~Gzip();
    Gzip(Gzip&&) noexcept;

    void write(std::string_view bytes);
    void finish();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

bool is_gzip(std::string_view bytes);

// Errors: IoError if `packed` is damaged or would unpack to more than `max_bytes`.
std::string gunzip(std::string_view packed, std::size_t max_bytes);

}  // namespace edaha
