// SPDX-License-Identifier: MIT
#include "write/path_text.h"

#include <algorithm>
#include <cstdint>

#include "base/number_text.h"

namespace edaha {
namespace {

// A point in whole units of the last decimal.
struct Unit {
    std::int64_t x = 0, y = 0;
    bool operator==(const Unit&) const = default;
    Unit operator-(Unit other) const { return {x - other.x, y - other.y}; }
};

// One command being written: letter and up to six numbers of up to kLongestNumber.
struct Command {
    char text[1 + 6 * (kLongestNumber + 1)];
    char* end = text;
    char letter = 0;        // what a following command without a letter would repeat
    std::int64_t last = 0;  // its last number: ".5" may follow at once if that has a point too

    std::size_t size() const { return static_cast<std::size_t>(end - text); }
};

class PathWriter {
  public:
    PathWriter(std::string& text, int decimals) : text_(text), decimals_(decimals) {
        for (int i = 0; i < decimals; ++i)
            one_ *= 10;
    }

    void write(const Path& path);

  private:
    Unit rounded(Vec2 p) const { return {to_units(p.x, decimals_), to_units(p.y, decimals_)}; }
    // A path starts with M, by its grammar and by custom.
    bool first() const { return letter_ == 0; }
    void line(Unit to);
    void cubic(Unit c1, Unit c2, Unit to);
    void close();
    void begin_segment();
    void put(char letter, const Unit* points, int count);
    void put_straight(char letter, std::int64_t offset, std::int64_t absolute);
    Command start(char letter) const;
    void add_number(Command& command, std::int64_t units) const;
    std::size_t least_size(std::int64_t units) const;
    void take_shorter(const Command& relative, const Command& absolute);
    void take(const Command& command);

    std::string& text_;
    int decimals_;
    std::int64_t one_ = 1;  // the number 1 in units

    Unit at_, start_;           // of the pen; of the subpath
    Unit mirrored_;             // the control point that s stands for
    bool pending_move_ = true;  // the subpath has nothing yet
    char letter_ = 0;           // of the last command
    std::int64_t last_ = 0;     // and its last number
};

void PathWriter::write(const Path& path) {
    const Vec2* p = path.points.data();
    for (std::size_t i = 0; i < path.verbs.size(); ++i) {
        const Verb verb = path.verbs[i];
        const bool closes_next = i + 1 < path.verbs.size() && path.verbs[i + 1] == Verb::close;
        if (verb == Verb::move) {
            start_ = rounded(*p++);
            pending_move_ = true;
        } else if (verb == Verb::line) {
            const Unit to = rounded(*p++);
            if (!closes_next || !(to == start_) || pending_move_) line(to);
        } else if (verb == Verb::cubic) {
            cubic(rounded(p[0]), rounded(p[1]), rounded(p[2]));
            p += 3;
        } else {
            close();
        }
    }
}

// The move is written before the first segment that remains.
void PathWriter::begin_segment() {
    if (!pending_move_) return;
    put('m', &start_, 1);
    at_ = mirrored_ = start_;
    pending_move_ = false;
}

void PathWriter::line(Unit to) {
    if (to == (pending_move_ ? start_ : at_)) return;
    begin_segment();
    if (to.y == at_.y) {
        put_straight('h', to.x - at_.x, to.x);
    } else if (to.x == at_.x) {
        put_straight('v', to.y - at_.y, to.y);
    } else {
        put('l', &to, 1);
    }
    at_ = mirrored_ = to;
}

void PathWriter::cubic(Unit c1, Unit c2, Unit to) {
    const Unit from = pending_move_ ? start_ : at_;
    if (c1 == from && c2 == to) return line(to);
    begin_segment();
    const Unit points[3] = {c1, c2, to};
    if (c1 == mirrored_) {
        put('s', points + 1, 2);
    } else {
        put('c', points, 3);
    }
    at_ = to;
    mirrored_ = {2 * to.x - c2.x, 2 * to.y - c2.y};
}

void PathWriter::close() {
    if (pending_move_) return;
    text_ += 'z';
    letter_ = 'z';
    at_ = start_;
    pending_move_ = true;  // the grammar lets a path go on from here; the contract does not
}

Command PathWriter::start(char letter) const {
    Command command;
    const bool repeats = letter == letter_ && letter != 'm' && letter != 'M';
    const bool line_after_move =
        (letter == 'l' && letter_ == 'm') || (letter == 'L' && letter_ == 'M');
    command.letter = letter;
    command.last = last_;
    if (!repeats && !line_after_move) *command.end++ = letter;
    return command;
}

void PathWriter::add_number(Command& command, std::int64_t units) const {
    const bool after_letter = command.end != command.text && command.end[-1] >= 'A';
    const bool starts_with_point = units > 0 && units < one_;
    const bool parts_itself = units < 0 || (starts_with_point && command.last % one_ != 0);
    if (!after_letter && !parts_itself) *command.end++ = ' ';
    char* const first = command.end;
    command.end = write_units(first, units, decimals_);
    command.last = units;
}

// What a number takes at least, with what parts it from the one before; all of it, in most cases.
std::size_t PathWriter::least_size(std::int64_t units) const {
    if (units % 10 == 0) return 2;
    const std::int64_t magnitude = units < 0 ? -units : units;
    const auto decimals = static_cast<std::size_t>(decimals_ > 0 ? 1 + decimals_ : 0);
    if (magnitude < one_) return decimals + (units < 0);
    return decimals + 2 + (magnitude >= 10 * one_) + (magnitude >= 100 * one_);
}

void PathWriter::put(char letter, const Unit* points, int count) {
    Command relative = start(letter);
    Command absolute = start(static_cast<char>(letter - 'a' + 'A'));
    std::size_t least = 0;
    for (int i = 0; i < count; ++i) {
        const Unit offset = points[i] - at_;
        add_number(relative, offset.x), add_number(relative, offset.y);
        least += least_size(points[i].x) + least_size(points[i].y);
    }
    // Mostly the absolute one is known to be longer; next to its letter a number needs no blank.
    if (!first() && absolute.size() + least > relative.size() + 1) return take(relative);
    for (int i = 0; i < count; ++i)
        add_number(absolute, points[i].x), add_number(absolute, points[i].y);
    take_shorter(relative, absolute);
}

void PathWriter::put_straight(char letter, std::int64_t offset, std::int64_t absolute_units) {
    Command relative = start(letter);
    Command absolute = start(static_cast<char>(letter - 'a' + 'A'));
    add_number(relative, offset);
    add_number(absolute, absolute_units);
    take_shorter(relative, absolute);
}

void PathWriter::take_shorter(const Command& relative, const Command& absolute) {
    take(relative.size() <= absolute.size() && !first() ? relative : absolute);
}

void PathWriter::take(const Command& command) {
    text_.append(command.text, command.size());
    letter_ = command.letter;
    last_ = command.last;
}

}  // namespace

void append_path_data(std::string& text, const Path& path, int decimals) {
    PathWriter(text, decimals).write(path);
}

}  // namespace edaha
