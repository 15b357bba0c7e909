// SPDX-License-Identifier: MIT
#pragma once
#include <stdexcept>
#include <string>
#include <vector>

namespace edaha {

// Where something stands in a text: lines and columns from 1; 0 where there is none (a command
// line's argument has a file, "--set", and no line).
struct Place {
    std::string file;
    int line = 0;
    int column = 0;
};

// One thing that is wrong (or, as a warning, not kept) in a text that somebody gave us.
struct Problem {
    Place place;
    std::string message;
};

// "file:line:column: message", without the parts that are 0 or empty.
std::string to_string(const Problem& problem);

// What was read is not what it should be. Holds every problem of the text, in its order; what()
// is one line a problem.
class InputError : public std::runtime_error {
  public:
    explicit InputError(std::vector<Problem> problems);
    const std::vector<Problem>& problems() const { return problems_; }

  private:
    std::vector<Problem> problems_;
};

// The system refused: a file that can't be read or written, a limit that would be passed.
class IoError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace edaha
