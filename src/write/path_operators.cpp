// SPDX-License-Identifier: MIT
#include "write/path_operators.h"

#include <algorithm>
#include <cstdint>

#include "base/number_text.h"

namespace edaha {
namespace {

struct Unit {
    std::int64_t x = 0, y = 0;
    bool operator==(const Unit&) const = default;
};

class OperatorWriter {
  public:
    OperatorWriter(std::string& text, int decimals) : text_(text), decimals_(decimals) {}

    void write(const Path& path) {
        const Vec2* p = path.points.data();
        for (const Verb verb : path.verbs) {
            if (verb == Verb::move) {
                start_ = at_ = rounded(*p++);
                pending_move_ = true;
            } else if (verb == Verb::line) {
                line(rounded(*p++));
            } else if (verb == Verb::cubic) {
                cubic(rounded(p[0]), rounded(p[1]), rounded(p[2]));
                p += 3;
            } else if (!pending_move_) {
                text_ += "h\n";
            }
        }
    }

  private:
    Unit rounded(Vec2 p) const { return {to_units(p.x, decimals_), to_units(p.y, decimals_)}; }

    // The move is written before the first segment that remains.
    void begin_segment() {
        if (!pending_move_) return;
        put(start_);
        text_ += "m\n";
        pending_move_ = false;
    }

    void line(Unit to) {
        if (to == at_) return;
        begin_segment();
        put(to);
        text_ += "l\n";
        at_ = to;
    }

    void cubic(Unit first, Unit second, Unit to) {
        if (first == at_ && second == to) return line(to);
        begin_segment();
        const bool from_start = first == at_, to_end = second == to;
        if (!from_start) put(first);
        if (!to_end) put(second);
        put(to);
        text_ += from_start ? "v\n" : to_end ? "y\n" : "c\n";
        at_ = to;
    }

    void put(Unit point) {
        for (const std::int64_t units : {point.x, point.y}) {
            char number[kLongestNumber + 1];
            char* end = write_units(number, units, decimals_);
            *end++ = ' ';
            text_.append(number, static_cast<std::size_t>(end - number));
        }
    }

    std::string& text_;
    int decimals_;
    Unit at_, start_;
    bool pending_move_ = true;
};

}  // namespace

bool append_path_operators(std::string& text, const Path& path, int decimals) {
    const std::size_t before = text.size();
    OperatorWriter(text, decimals).write(path);
    return text.size() > before;
}

void append_map_operator(std::string& text, const Affine& map, int fine, int coarse) {
    for (const double number : {map[0].x, map[0].y, map[1].x, map[1].y}) {
        append_number(text, number, fine);
        text += ' ';
    }
    for (const double number : {map[2].x, map[2].y}) {
        append_number(text, number, coarse);
        text += ' ';
    }
    text += "cm\n";
}

void append_width_operator(std::string& text, double mm, int decimals) {
    append_number(text, mm, std::min(decimals + 1, kMostDecimals));
    text += " w\n";
}

void append_dash_operator(std::string& text, double mm, int decimals) {
    const int finer = std::min(decimals + 1, kMostDecimals);
    text += '[';
    if (to_units(mm, finer) > 0) append_number(text, mm, finer);
    text += "] 0 d\n";
}

}  // namespace edaha
