// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace edaha {

// A file that appears whole or not at all. Until commit() its bytes have no name, where the system
// can do that: Linux, on most local disks. Elsewhere they have a hidden name in the same folder,
// from which commit() renames them. Without commit() (an exception, say) they are gone, and
// whatever stood there before stays.
//   - Even a killed process (SIGKILL) leaves nothing; where names are hidden, it may leave one such
//     file.
//   - A new file has the permissions that the umask gives, a replaced one keeps its own; one that
//     may not be written is not replaced.
//   - A symbolic link stays and its target is replaced, even where the target is still missing.
//   - Devices, pipes and sockets (/dev/null) are written straight through.
// Errors: IoError, "cannot write 'tree.svg': No space left on device". Not for two threads at once.
class AtomicFile {
  public:
    enum class Scratch { nameless, hidden };  // nameless: hidden where there is no other way

    explicit AtomicFile(std::string path, Scratch scratch = Scratch::nameless);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(std::string_view bytes);
    void commit();

  private:
    bool open_nameless();
    void open_hidden();
    void link_nameless();
    void flush();
    void write_through(std::string_view bytes);
    void abandon() noexcept;
    [[noreturn]] void fail(int error);

    std::string path_;       // as the user named it: for messages
    std::string target_;     // with links followed
    std::string temporary_;  // hidden name; empty while there is none
    bool nameless_ = false;
    std::string buffer_;
    int descriptor_ = -1;
};

// The whole of a file of at most `max_bytes`. Errors: IoError, "cannot read 'oak.xml': No such file
// or directory", or that it is larger than the limit.
std::string read_file(const std::string& path, std::size_t max_bytes);

}  // namespace edaha
