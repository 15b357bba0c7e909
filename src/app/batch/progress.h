// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <deque>
#include <iosfwd>
#include <string>

namespace edaha {

// How far a run is.
struct Advance {
    std::size_t done = 0;
    std::size_t total = 0;
    double per_second = 0;
};

// "[######----]  432/1000  128/s  5 s left", at most `columns` wide.
std::string progress_line(const Advance& advance, std::size_t columns);

// "5 s", "3 min 20 s", "2 h 5 min".
std::string duration_text(double seconds);

// Tells of a run on a stream. On a terminal by one line that is drawn again, at most ten times a
// second; elsewhere by a line of its own every few seconds, so that logs stay short. Times are
// seconds of any one clock, never decreasing.
class Progress {
  public:
    // `columns` of the terminal; 0: no terminal.
    Progress(std::ostream& out, std::size_t total, std::size_t columns, double now);

    void advance(std::size_t done, double now);
    void say(const std::string& line);  // above the line
    void clear();                       // at the end

  private:
    struct Mark {
        double time;
        std::size_t done;
    };

    std::ostream& out_;
    std::size_t total_;
    std::size_t columns_;
    double shown_;
    bool visible_ = false;
    std::deque<Mark> marks_;  // of the last seconds: the rate is theirs
};

}  // namespace edaha
