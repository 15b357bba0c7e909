// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

namespace edaha::test {

struct RunResult {
    std::string out;
    std::string err;
    int exit_code = -1;  // 128 + n where signal n ended it
};

// Runs a command line by /bin/sh, without input, and waits for it.
RunResult run(const std::string& command);

// `text` as one word of a command line.
std::string quoted(const std::string& text);

// An empty folder of its own, removed with everything in it at the end of the scope.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::string path() const { return path_.string(); }
    std::string operator/(const std::string& name) const { return (path_ / name).string(); }

  private:
    std::filesystem::path path_;
};

void write_whole(const std::string& path, const std::string& bytes);
std::string read_whole(const std::string& path);

}  // namespace edaha::test
