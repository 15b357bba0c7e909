// SPDX-License-Identifier: MIT
#include "base/fingerprint.h"

#include <algorithm>

namespace edaha {

void Fingerprint::add(std::string_view text) {
    constexpr std::size_t kWord = sizeof(Key);
    state_ = step(state_, text.size());
    for (std::size_t i = 0; i < text.size(); i += kWord) {
        Key word = 0;
        for (std::size_t j = i; j < std::min(i + kWord, text.size()); ++j)
            word = word << 8 | static_cast<unsigned char>(text[j]);
        state_ = mix(state_ ^ word) + 0x9e3779b97f4a7c15;
    }
}

std::string Fingerprint::text() const {
    constexpr char kDigits[] = "0123456789abcdef";
    const Key bits = mix(state_);
    std::string digits;
    for (int shift = 60; shift >= 0; shift -= 4)
        digits += kDigits[bits >> shift & 0xf];
    return digits;
}

}  // namespace edaha
