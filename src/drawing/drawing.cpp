// SPDX-License-Identifier: MIT
#include "drawing/drawing.h"

namespace edaha {

std::string id_from_label(std::string_view label) {
    std::string id(label);
    for (char& c : id) {
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        const bool kept = letter || (c >= '0' && c <= '9') || c == '.' || c == '_';
        if (!kept) c = '-';
    }
    return id;
}

}  // namespace edaha
