// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>

#include "drawing/drawing.h"
#include "write/sink.h"

namespace edaha {

// A PDF 1.5 of any number of pages, written page by page: true vectors, opacities kept, symbols as
// forms. Each layer is an optional content group of its label, listed from the top one down as
// programs show them; pages that have a label in common share the group. Title, description
// (subject), program, command (keywords) and recipe of `metadata` are in the document's
// information; its dates are fixed and its identifier follows from the content: the same drawings,
// the same bytes. Memory: one page's operators, and a few bytes for each page before. Errors: what
// `sink` throws.
class PdfBook {
  public:
    PdfBook(Sink sink, const Metadata& metadata);
    ~PdfBook();
    PdfBook(PdfBook&&) noexcept;

    void add_page(const Drawing& drawing);

    // Without it, the file is none.
    void finish();

  private:
    friend std::string pdf_bytes(const Drawing& drawing);
    struct State;
    std::unique_ptr<State> state_;
};

// The drawing as the bytes of a PDF of one page, to be edited: the same, but with instances as
// plain paths, since editors give each form a clipping path.
std::string pdf_bytes(const Drawing& drawing);

}  // namespace edaha
