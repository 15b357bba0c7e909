// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/fingerprint.h"
#include "write/sink.h"

namespace edaha {

// The objects of a PDF file, written as they come (ISO 32000-1, 7.5): only their places stay in
// memory. The file's identifier follows from what is written, so the same objects are the same
// bytes (of one version of zlib).
class PdfObjects {
  public:
    // What says the same again and again gets far smaller by the first; for numbers that never
    // repeat, the second takes a quarter of the time, and a sixth more bytes.
    enum class Packing { small, quick };

    explicit PdfObjects(Sink sink);

    // A number for an object that is written later, to refer to it.
    int reserve();
    void write(int number, std::string_view object);
    int write(std::string_view object);

    // `entries` stand in the stream's dictionary beside its length and filter.
    struct Stream {
        std::string_view entries;
        std::string_view content;
        Packing packing = Packing::small;
    };
    void write_stream(int number, const Stream& stream);

    // Every reserved number must have been written. Nothing may follow.
    void finish(int catalogue, int information);

  private:
    void put(std::string_view bytes);
    void begin(int number);

    Sink sink_;
    std::size_t size_ = 0;
    std::vector<std::size_t> places_;  // of object 1 and so on
    Fingerprint fingerprint_;
};

// "12 0 R".
std::string pdf_reference(int number);

// UTF-8 as a text string object (7.9.2.2), printable ASCII as it is; what XML would not hold is
// replaced.
std::string pdf_text(std::string_view text);

}  // namespace edaha
