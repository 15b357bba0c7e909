// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "support/run.h"

namespace edaha::test {

// Each test runs the program in an empty folder of its own, which is also its home.
class Program : public testing::Test {
  protected:
    // By /bin/sh, in the folder; `edaha` in the line is the program.
    RunResult sh(const std::string& line) const {
        return run("cd " + quoted(folder_.path()) +
                   " && unset XDG_DATA_HOME && export HOME=\"$PWD\" && "
                   "edaha() { " EDAHA_BINARY " \"$@\"; } && " +
                   line);
    }

    // Standard output and error to the letter.
    void expect(const std::string& line, int code, const std::string& out,
                const std::string& err) const {
        const RunResult result = sh(line);
        EXPECT_EQ(result.exit_code, code) << line;
        EXPECT_EQ(result.out, out) << line;
        EXPECT_EQ(result.err, err) << line;
    }

    void write(const std::string& name, const std::string& text) const {
        write_whole(folder_ / name, text);
    }
    std::string read(const std::string& name) const { return read_whole(folder_ / name); }
    bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }

    TemporaryFolder folder_;
};

}  // namespace edaha::test
