// SPDX-License-Identifier: MIT
#include "drawing/drawing.h"

#include <cctype>

namespace edaha {

std::string Layer::id() const {
    std::string id = label;
    for (char& c : id) {
        const bool kept = std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '_';
        if (!kept) c = '-';
    }
    return id;
}

}  // namespace edaha
