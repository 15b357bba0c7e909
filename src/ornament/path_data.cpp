// SPDX-License-Identifier: MIT
#include "ornament/path_data.h"

#include <optional>
#include <string>
#include <utility>

#include "ornament/arc.h"
#include "ornament/scan.h"

namespace edaha {
namespace {

bool is_small(char c) {
    return c >= 'a' && c <= 'z';
}
char capital(char c) {
    return is_small(c) ? static_cast<char>(c - 'a' + 'A') : c;
}

// For messages.
std::string_view arguments(char command) {
    switch (command) {
        case 'H':
            return "x";
        case 'V':
            return "y";
        case 'C':
            return "x1 y1 x2 y2 x y";
        case 'S':
            return "x2 y2 x y";
        case 'Q':
            return "x1 y1 x y";
        case 'A':
            return "rx ry angle large sweep x y";
        default:
            return "x y";
    }
}

class PathReader {
  public:
    explicit PathReader(std::string_view text) : scanner_(text) {}

    Path read() {
        for (scanner_.skip_space(); !scanner_.at_end(); scanner_.skip_space()) {
            read_command();
        }
        return std::move(path_);
    }

  private:
    void read_command() {
        command_ = capital(scanner_.peek());
        relative_ = is_small(scanner_.peek());
        if (std::string_view("MZLHVCSQTA").find(command_) == std::string_view::npos) {
            fail("is not a command (expected one of M Z L H V C S Q T A)");
        }
        if (path_.empty() && command_ != 'M') fail("comes first (expected M or m)");
        scanner_.take();
        if (command_ == 'Z') return close();
        scanner_.skip_space();
        do {
            read_segment();
        } while (scanner_.skip_comma() || scanner_.number_follows());
    }

    void close() {
        if (is_open_) path_.close();
        is_open_ = false;
        current_ = control_ = start_;
        previous_ = 'Z';
    }

    void read_segment() {
        if (command_ == 'M') return read_move();
        if (!is_open_) path_.move_to(start_);
        is_open_ = true;
        switch (command_) {
            case 'L':
                line(point());
                break;
            case 'H':
                line({number() + (relative_ ? current_.x : 0), current_.y});
                break;
            case 'V':
                line({current_.x, number() + (relative_ ? current_.y : 0)});
                break;
            case 'C':
                read_cubic(next_point());
                break;
            case 'S':
                read_cubic(reflected('C'));
                break;
            case 'Q':
                quadratic(next_point());
                break;
            case 'T':
                quadratic(reflected('Q'));
                break;
            default:
                read_arc();
        }
        if (command_ == 'S')
            previous_ = 'C';
        else if (command_ == 'T')
            previous_ = 'Q';
        else
            previous_ = command_;
    }

    void read_move() {
        start_ = current_ = point();
        path_.move_to(start_);
        is_open_ = true;
        previous_ = 'M';
        command_ = 'L';  // what further pairs mean
    }

    void line(Vec2 to) {
        path_.line_to(to);
        current_ = to;
    }

    void read_cubic(Vec2 control1) {
        control_ = next_point();
        const Vec2 to = point();
        path_.cubic_to(control1, control_, to);
        current_ = to;
    }

    void quadratic(Vec2 control) {
        const Vec2 to = point();
        path_.cubic_to(current_ + (control - current_) * (2.0 / 3.0),
                       to + (control - to) * (2.0 / 3.0), to);
        control_ = control;
        current_ = to;
    }

    void read_arc() {
        EllipseArc arc;
        arc.from = current_;
        arc.radii.x = number();
        scanner_.skip_comma();
        arc.radii.y = number();
        scanner_.skip_comma();
        arc.x_axis_deg = number();
        scanner_.skip_comma();
        arc.large = flag();
        scanner_.skip_comma();
        arc.sweep = flag();
        scanner_.skip_comma();
        arc.to = point();
        add_arc(path_, arc);
        current_ = arc.to;
    }

    // The last control point mirrored in the current point, if the last command was of that kind.
    Vec2 reflected(char kind) const {
        return previous_ == kind ? 2.0 * current_ - control_ : current_;
    }

    Vec2 point() {
        const double x = number();
        scanner_.skip_comma();
        const double y = number();
        return relative_ ? current_ + Vec2(x, y) : Vec2(x, y);
    }

    Vec2 next_point() {
        const Vec2 p = point();
        scanner_.skip_comma();
        return p;
    }

    double number() {
        const std::optional<double> value = scanner_.take_number();
        if (!value) {
            fail("is not a number (expected " + std::string(arguments(command_)) + ')');
        }
        return *value;
    }

    bool flag() {
        if (scanner_.take('0')) return false;
        if (scanner_.take('1')) return true;
        fail("is not a flag (expected 0 or 1)");
    }

    [[noreturn]] void fail(const std::string& why) const {
        throw SyntaxError(scanner_.offset(), scanner_.sign_here() + ' ' + why);
    }

    Scanner scanner_;
    Path path_;
    Vec2 start_{0}, current_{0}, control_{0};
    char command_ = 'M';   // capital
    char previous_ = 'M';  // the last segment's, S being C and T being Q
    bool relative_ = false;
    bool is_open_ = false;  // since the last close something was drawn
};

}  // namespace

Path read_path_data(std::string_view text) {
    return PathReader(text).read();
}

}  // namespace edaha
