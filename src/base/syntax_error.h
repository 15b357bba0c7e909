// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <stdexcept>
#include <string>

namespace edaha {

// A text that does not follow its grammar, and at which byte.
class SyntaxError : public std::runtime_error {
  public:
    SyntaxError(std::size_t offset, const std::string& message)
        : std::runtime_error(message), offset_(offset) {}
    std::size_t offset() const { return offset_; }

  private:
    std::size_t offset_;
};

}  // namespace edaha
