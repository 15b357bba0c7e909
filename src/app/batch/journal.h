// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/batch/row.h"
#include "base/keyed_random.h"

namespace edaha {

// The rows of a batch while it runs, a line each, in a file: so they survive whatever ends the
// program, and memory holds 16 bytes a row. A line that is torn at the end is cut off on opening.
// Errors: IoError, "cannot write 'out/.manifest.journal': …".
class Journal {
  public:
    // Opens the file or makes it. Without `keep` it starts empty. Refuses a file in which another
    // process writes.
    Journal(std::string path, bool keep);
    ~Journal();
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    void append(std::string_view line);  // without line end

    // From here on, rows count as those of this run; those before are known from earlier ones.
    void begin_run();

    // What an earlier run told of a file that has this recipe. For any thread.
    std::optional<FileRow> find(const std::string& file, const std::string& recipe) const;

    // The whole lines of this run, one after the other; then nothing.
    std::optional<std::string> next_line();

    bool knows_earlier_rows() const { return begin_ > 0; }
    void remove();

  private:
    struct Known {
        Key hash;
        std::uint64_t offset;
        auto operator<=>(const Known&) const = default;
    };
    void cut_torn_line();
    void read_known();
    std::optional<std::string> line_at(std::uint64_t offset) const;

    std::string path_;
    int descriptor_ = -1;
    std::uint64_t size_ = 0;    // of its whole lines
    std::uint64_t begin_ = 0;   // of this run
    std::uint64_t next_ = 0;    // to read
    std::vector<Known> known_;  // sorted
};

}  // namespace edaha
