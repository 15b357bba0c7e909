// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

#include "base/keyed_random.h"

namespace edaha {

// Tells whether texts are still what they were: equal ones, in the same order, have equal
// fingerprints on every machine, others differ but for one chance in 2^64. Nobody is kept from
// making an equal one on purpose. O(bytes).
class Fingerprint {
  public:
    void add(std::string_view text);
    std::string text() const;  // 16 hexadecimal digits

  private:
    Key state_ = 0;
};

}  // namespace edaha
