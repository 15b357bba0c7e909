// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace edaha {

// A file that appears whole or not at all. What is written goes to a hidden name in the same
// folder; commit() renames it into place; without commit() (an exception, say) it is removed and
// whatever stood there before stays.
//   - A new file has the permissions that the umask gives, a replaced one keeps its own; one that
//     may not be written is not replaced.
//   - A symbolic link stays and its target is replaced, even where the target is still missing.
//   - Devices, pipes and sockets (/dev/null) are written straight through.
// Errors: IoError, "cannot write 'tree.svg': No space left on device". Not for two threads at once.
class AtomicFile {
  public:
    explicit AtomicFile(std::string path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(std::string_view bytes);
    void commit();

  private:
    void open_temporary();
    void flush();
    void write_through(std::string_view bytes);
    void abandon() noexcept;
    [[noreturn]] void fail(int error);

    std::string path_;       // as the user named it: for messages
    std::string target_;     // with links followed
    std::string temporary_;  // empty: written straight through
    std::string buffer_;
    int descriptor_ = -1;
};

// The whole of a file of at most `max_bytes`. Errors: IoError, "cannot read 'oak.xml': No such file
// or directory", or that it is larger than the limit.
std::string read_file(const std::string& path, std::size_t max_bytes);

}  // namespace edaha
