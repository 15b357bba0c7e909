// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "drawing/drawing.h"

namespace edaha {

// The drawing as the bytes of a one-page PDF 1.5: true vectors, opacities kept, each layer an
// optional content group of its name, listed from the top one down as programs show them. Cairo
// cannot make such groups: it draws each layer as a page of its own, which becomes a form inside
// the group. Title, description (subject), program and command (keywords) and the recipe are in the
// document's information; its dates are fixed and its identifier follows from the content: the same
// drawing, the same bytes. Cost: all layers stand in memory. Errors: IoError.
std::string pdf_bytes(const Drawing& drawing);

}  // namespace edaha
