// SPDX-License-Identifier: MIT
#include "app/batch/journal.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "base/error.h"

namespace edaha {
namespace {

constexpr std::size_t kPieceBytes = 1 << 12;

[[noreturn]] void fail(const std::string& path, int error) {
    throw IoError("cannot write '" + path + "': " + std::strerror(error));
}

}  // namespace

Journal::Journal(std::string path, bool keep) : path_(std::move(path)) {
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0) fail(path_, errno);
    // Where there are no locks (some network disks), nobody is refused.
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        ::close(descriptor_);
        throw IoError("cannot write '" + path_ + "': another edaha batch writes there");
    }
    if (!keep && ::ftruncate(descriptor_, 0) != 0) fail(path_, errno);
    if (keep) cut_torn_line();
}

Journal::~Journal() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

void Journal::cut_torn_line() {
    std::uint64_t offset = 0;
    while (const auto line = line_at(offset))
        offset += line->size() + 1;
    size_ = offset;
    if (::ftruncate(descriptor_, static_cast<off_t>(size_)) != 0) fail(path_, errno);
}

std::optional<std::string> Journal::line_at(std::uint64_t offset) const {
    std::string line;
    char piece[kPieceBytes];
    while (true) {
        const ssize_t got =
            ::pread(descriptor_, piece, sizeof piece, static_cast<off_t>(offset + line.size()));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return std::nullopt;
        const std::string_view text(piece, static_cast<std::size_t>(got));
        const std::size_t end = text.find('\n');
        line += text.substr(0, end);
        if (end != std::string_view::npos) return line;
    }
}

void Journal::append(std::string_view line) {
    std::string text(line);
    text += '\n';
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t written = ::pwrite(descriptor_, text.data() + done, text.size() - done,
                                         static_cast<off_t>(size_ + done));
        if (written < 0 && errno != EINTR) fail(path_, errno);
        if (written > 0) done += static_cast<std::size_t>(written);
    }
    size_ += text.size();
}

void Journal::begin_run() {
    read_known();
    begin_ = next_ = size_;
}

void Journal::read_known() {
    for (std::uint64_t offset = 0; offset < size_;) {
        const auto line = line_at(offset);
        if (!line) break;
        if (const auto row = parse_row(*line)) known_.push_back({name_key(row->file), offset});
        offset += line->size() + 1;
    }
    std::ranges::sort(known_);
}

std::optional<FileRow> Journal::find(const std::string& file, const std::string& recipe) const {
    const Key hash = name_key(file);
    for (auto known = std::ranges::lower_bound(known_, hash, {}, &Known::hash);
         known != known_.end() && known->hash == hash; ++known) {
        const auto line = line_at(known->offset);
        auto row = line ? parse_row(*line) : std::nullopt;
        if (row && row->file == file && row->recipe == recipe) return row;
    }
    return std::nullopt;
}

std::optional<std::string> Journal::next_line() {
    if (next_ >= size_) return std::nullopt;
    auto line = line_at(next_);
    if (line) next_ += line->size() + 1;
    return line;
}

void Journal::remove() {
    ::unlink(path_.c_str());
}

}  // namespace edaha
