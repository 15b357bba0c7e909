// SPDX-License-Identifier: MIT
#include "base/atomic_file.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"

namespace edaha {
namespace {

namespace fs = std::filesystem;

// Large enough that the calls cost nothing, small enough for hundreds of files at once.
constexpr std::size_t kBufferBytes = 1 << 16;

// A hidden name may be left over from a killed process with the same number: the next one is tried.
constexpr int kMostNames = 100;

// As many links as Linux follows before it says ELOOP.
constexpr int kMostLinks = 40;

std::string describe(const char* what, const std::string& path, int error) {
    return std::string(what) + " '" + path + "': " + std::strerror(error);
}

// Follows links by hand, so that one whose target is missing yet leads to where it should be.
std::optional<fs::path> follow_links(fs::path path) {
    for (int links = 0; links < kMostLinks; ++links) {
        std::error_code error;
        if (!fs::is_symlink(path, error)) return path;
        const fs::path next = fs::read_symlink(path, error);
        if (error) return path;
        path = path.parent_path() / next;  // an absolute `next` replaces the folder
    }
    return std::nullopt;
}

// Unique among running processes by the process number, within one by the counter. The name is cut
// so that it fits where the target's own name only just does (255 bytes).
std::string temporary_name(const fs::path& target) {
    static std::atomic<unsigned> counter{0};
    const std::string suffix =
        '.' + std::to_string(::getpid()) + '-' + std::to_string(counter++) + ".tmp";
    const std::string name = '.' + target.filename().string().substr(0, 200) + suffix;
    return (target.parent_path() / name).string();
}

// By this name the system reaches an open file that has no other.
std::string name_of_open_file(int descriptor) {
    return "/proc/self/fd/" + std::to_string(descriptor);
}

}  // namespace

AtomicFile::AtomicFile(std::string path, Scratch scratch) : path_(std::move(path)) {
    buffer_.reserve(kBufferBytes);
    const std::optional<fs::path> target = follow_links(path_);
    if (!target) fail(ELOOP);
    target_ = target->string();
    struct stat status {};
    const bool exists = ::stat(target_.c_str(), &status) == 0;
    if (exists && S_ISDIR(status.st_mode)) fail(EISDIR);
    const bool refused = ::faccessat(AT_FDCWD, target_.c_str(), W_OK, AT_EACCESS) != 0;
    if (exists && refused) fail(errno);
    if (exists && !S_ISREG(status.st_mode)) {
        descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
        if (descriptor_ < 0) fail(errno);
    } else {
        nameless_ = scratch == Scratch::nameless && open_nameless();
        if (!nameless_) open_hidden();
        if (exists && ::fchmod(descriptor_, status.st_mode & 07777) != 0) fail(errno);
    }
}

AtomicFile::~AtomicFile() {
    abandon();
}

// False if the system, the file system or the container knows no such files; whatever else is wrong
// shows again with a name.
bool AtomicFile::open_nameless() {
#ifdef O_TMPFILE
    const std::string folder = fs::path(target_).parent_path().string();
    descriptor_ =
        ::open(folder.empty() ? "." : folder.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
    if (descriptor_ < 0) return false;
    const std::string open_file = name_of_open_file(descriptor_);
    if (::faccessat(AT_FDCWD, open_file.c_str(), F_OK, AT_EACCESS) == 0) return true;
    ::close(descriptor_);
    descriptor_ = -1;
#endif
    return false;
}

void AtomicFile::open_hidden() {
    for (int attempt = 0; attempt < kMostNames && descriptor_ < 0; ++attempt) {
        const std::string name = temporary_name(target_);
        descriptor_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor_ >= 0) temporary_ = name;
        if (descriptor_ < 0 && errno != EEXIST) break;
    }
    if (descriptor_ < 0) fail(errno);
}

// Gives the file its own name, or a hidden one for renaming where another has that name.
void AtomicFile::link_nameless() {
    const std::string open_file = name_of_open_file(descriptor_);
    const auto link_to = [&](const std::string& name) {
        return ::linkat(AT_FDCWD, open_file.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW);
    };
    if (link_to(target_) == 0) return;
    for (int attempt = 0; attempt < kMostNames && errno == EEXIST; ++attempt) {
        const std::string name = temporary_name(target_);
        if (link_to(name) != 0) continue;
        temporary_ = name;
        return;
    }
    fail(errno);
}

void AtomicFile::write(std::string_view bytes) {
    if (descriptor_ < 0) fail(EBADF);
    if (buffer_.size() + bytes.size() > kBufferBytes) flush();
    if (bytes.size() >= kBufferBytes) {
        write_through(bytes);
    } else {
        buffer_ += bytes;
    }
}

void AtomicFile::commit() {
    if (descriptor_ < 0) fail(EBADF);
    flush();
    if (nameless_) link_nameless();
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) fail(errno);  // network file systems report a full disk only here
    if (temporary_.empty()) return;
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
    temporary_.clear();
}

void AtomicFile::flush() {
    write_through(buffer_);
    buffer_.clear();
}

void AtomicFile::write_through(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) fail(errno);
        if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

void AtomicFile::abandon() noexcept {
    if (descriptor_ >= 0) ::close(descriptor_);
    descriptor_ = -1;
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
    temporary_.clear();
}

void AtomicFile::fail(int error) {
    abandon();
    throw IoError(describe("cannot write", path_, error));
}

std::string read_file(const std::string& path, std::size_t max_bytes) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) throw IoError(describe("cannot read", path, errno));
    std::string text;
    std::size_t used = 0;
    ssize_t got = 0;
    do {
        text.resize(std::min(max_bytes, std::max(2 * used, kBufferBytes)) + 1);
        got = ::read(descriptor, text.data() + used, text.size() - used);
        if (got > 0) used += static_cast<std::size_t>(got);
    } while (used <= max_bytes && (got > 0 || (got < 0 && errno == EINTR)));
    const int error = errno;
    ::close(descriptor);
    if (got < 0) throw IoError(describe("cannot read", path, error));
    if (used > max_bytes) {
        throw IoError("cannot read '" + path + "': it is larger than the limit of " +
                      std::to_string(max_bytes) + " bytes");
    }
    text.resize(used);
    return text;
}

}  // namespace edaha
