// SPDX-License-Identifier: MIT
#include "base/atomic_file.h"

#include <csignal>
#include <cstdlib>
#include <filesystem>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.h"
#include "support/run.h"

namespace edaha {
namespace {

namespace fs = std::filesystem;
using Scratch = AtomicFile::Scratch;
using test::read_whole;
using test::TemporaryFolder;
using test::write_whole;

std::size_t files_in(const std::string& folder) {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator{}));
}

mode_t mode_of(const std::string& path) {
    struct stat status {};
    EXPECT_EQ(::stat(path.c_str(), &status), 0);
    return status.st_mode & 07777;
}

void write_file(const std::string& path, const std::string& bytes,
                Scratch scratch = Scratch::nameless) {
    AtomicFile file(path, scratch);
    file.write(bytes);
    file.commit();
}

std::string error_of(const std::string& path, const std::string& bytes = "x") {
    try {
        write_file(path, bytes);
    } catch (const IoError& error) {
        return error.what();
    }
    return "";
}

class AtomicFileBothWays : public testing::TestWithParam<Scratch> {};
INSTANTIATE_TEST_SUITE_P(, AtomicFileBothWays, testing::Values(Scratch::nameless, Scratch::hidden),
                         [](const auto& tested) {
                             return tested.param == Scratch::nameless ? "Nameless" : "Hidden";
                         });

TEST_P(AtomicFileBothWays, AppearsOnlyWhenCommitted) {
    const TemporaryFolder folder;
    const std::string path = folder / "tree.svg";
    AtomicFile file(path, GetParam());
    file.write("<svg/>");
    EXPECT_FALSE(fs::exists(path));
    file.commit();
    EXPECT_EQ(read_whole(path), "<svg/>");
    EXPECT_EQ(files_in(folder.path()), 1u);
}

TEST_P(AtomicFileBothWays, WithoutCommitTheOldFileStaysAndNothingElse) {
    const TemporaryFolder folder;
    const std::string path = folder / "tree.svg";
    write_whole(path, "old");
    {
        AtomicFile file(path, GetParam());
        file.write(std::string(1 << 20, 'x'));
        EXPECT_EQ(read_whole(path), "old");
    }
    EXPECT_EQ(read_whole(path), "old");
    EXPECT_EQ(files_in(folder.path()), 1u);
}

TEST_P(AtomicFileBothWays, ReplacesAFileThatCameMeanwhile) {
    const TemporaryFolder folder;
    AtomicFile file(folder / "tree.svg", GetParam());
    file.write("new");
    write_whole(folder / "tree.svg", "old");
    file.commit();
    EXPECT_EQ(read_whole(folder / "tree.svg"), "new");
    EXPECT_EQ(files_in(folder.path()), 1u);
}

// Whether a file without a name can be made in a folder here, and named afterwards.
bool knows_nameless_files(const std::string& folder) {
    const int descriptor = ::open(folder.c_str(), O_WRONLY | O_TMPFILE, 0666);
    if (descriptor >= 0) ::close(descriptor);
    return descriptor >= 0 && fs::exists("/proc/self/fd");
}

TEST(AtomicFile, AKilledWriterLeavesNoFile) {
    const TemporaryFolder folder;
    if (!knows_nameless_files(folder.path())) GTEST_SKIP() << "files here always have a name";
    const pid_t child = ::fork();
    if (child == 0) {
        AtomicFile file(folder / "tree.svg");
        file.write(std::string(1 << 20, 'x'));
        ::kill(::getpid(), SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(files_in(folder.path()), 0u);
}

TEST(AtomicFile, KeepsTheOrderOfSmallAndLargePieces) {
    const TemporaryFolder folder;
    std::string expected;
    AtomicFile file(folder / "a");
    for (std::size_t size : {1u, 70000u, 0u, 3u, 65536u, 65535u, 2u}) {
        const std::string piece(size, static_cast<char>('a' + size % 26));
        file.write(piece);
        expected += piece;
    }
    file.commit();
    EXPECT_EQ(read_whole(folder / "a"), expected);
}

TEST_P(AtomicFileBothWays, TwoWritersOfOneNameDoNotMix) {
    const TemporaryFolder folder;
    AtomicFile first(folder / "a", GetParam());
    AtomicFile second(folder / "a", GetParam());
    first.write("first");
    second.write("second");
    first.commit();
    second.commit();
    EXPECT_EQ(read_whole(folder / "a"), "second");
    EXPECT_EQ(files_in(folder.path()), 1u);
}

TEST_P(AtomicFileBothWays, PermissionsAreTheUmasksOrTheReplacedFiles) {
    const TemporaryFolder folder;
    const mode_t before = ::umask(027);
    write_file(folder / "new", "x", GetParam());
    ::umask(before);
    EXPECT_EQ(mode_of(folder / "new"), 0640u);
    ::chmod((folder / "new").c_str(), 0755);
    write_file(folder / "new", "y", GetParam());
    EXPECT_EQ(mode_of(folder / "new"), 0755u);
}

TEST(AtomicFile, LinksStay) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "sub");
    write_whole(folder / "sub/real", "old");
    fs::create_symlink("sub/real", folder / "link");
    fs::create_symlink(folder / "sub/missing", folder / "dangling");
    write_file(folder / "link", "new");
    write_file(folder / "dangling", "newer");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_TRUE(fs::is_symlink(folder / "dangling"));
    EXPECT_EQ(read_whole(folder / "sub/real"), "new");
    EXPECT_EQ(read_whole(folder / "sub/missing"), "newer");
}

TEST(AtomicFile, LinksInACircleAreRefused) {
    const TemporaryFolder folder;
    fs::create_symlink("b", folder / "a");
    fs::create_symlink("a", folder / "b");
    EXPECT_EQ(error_of(folder / "a"),
              "cannot write '" + (folder / "a") + "': Too many levels of symbolic links");
}

TEST(AtomicFile, SaysWhyItCannotWrite) {
    const TemporaryFolder folder;
    EXPECT_EQ(error_of(folder / "no/such/tree.svg"),
              "cannot write '" + (folder / "no/such/tree.svg") + "': No such file or directory");
    EXPECT_EQ(error_of(folder.path()), "cannot write '" + folder.path() + "': Is a directory");
    EXPECT_EQ(error_of("/dev/full"), "cannot write '/dev/full': No space left on device");
    EXPECT_EQ(error_of("/dev/full", std::string(1 << 20, 'x')),
              "cannot write '/dev/full': No space left on device");
    EXPECT_EQ(error_of(""), "cannot write '': No such file or directory");
}

TEST(AtomicFile, DevicesAreWrittenThrough) {
    EXPECT_EQ(error_of("/dev/null"), "");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

// Root may write anywhere: for a while be nobody.
class AsNobody {
  public:
    explicit AsNobody(const std::string& folder) {
        if (::geteuid() != 0) return;
        constexpr uid_t kNobody = 65534;
        if (::chown(folder.c_str(), kNobody, kNobody) == 0) changed_ = ::seteuid(kNobody) == 0;
    }
    ~AsNobody() {
        if (changed_ && ::seteuid(0) != 0) std::abort();
    }

  private:
    bool changed_ = false;
};

TEST(AtomicFile, AUserWithoutRightsIsRefused) {
    const TemporaryFolder folder;
    const AsNobody nobody(folder.path());
    write_whole(folder / "kept", "old");
    ::chmod((folder / "kept").c_str(), 0444);
    EXPECT_EQ(error_of(folder / "kept"),
              "cannot write '" + (folder / "kept") + "': Permission denied");
    EXPECT_EQ(read_whole(folder / "kept"), "old");
    ::chmod(folder.path().c_str(), 0555);
    EXPECT_EQ(error_of(folder / "new"),
              "cannot write '" + (folder / "new") + "': Permission denied");
    ::chmod(folder.path().c_str(), 0755);
}

// A real full disk: one megabyte of memory, mounted where the user may.
TEST(AtomicFile, OnAFullDiskTheOldFileStays) {
    const TemporaryFolder folder;
    const std::string mount =
        "mount -t tmpfs -o size=1m none " + test::quoted(folder.path()) + " 2>/dev/null";
    if (::geteuid() != 0 || test::run(mount).exit_code != 0) GTEST_SKIP() << "cannot mount";
    write_whole(folder / "tree.svg", "old");
    EXPECT_EQ(error_of(folder / "tree.svg", std::string(4 << 20, 'x')),
              "cannot write '" + (folder / "tree.svg") + "': No space left on device");
    EXPECT_EQ(read_whole(folder / "tree.svg"), "old");
    EXPECT_EQ(files_in(folder.path()), 1u);
    test::run("umount " + test::quoted(folder.path()));
}

TEST(ReadFile, GivesTheWholeFileUpToTheLimit) {
    const TemporaryFolder folder;
    std::string bytes(200000, 'x');
    bytes.append(1, '\0').append("end");
    write_whole(folder / "a", bytes);
    EXPECT_EQ(read_file(folder / "a", 1 << 20), bytes);
    EXPECT_EQ(read_file(folder / "a", bytes.size()), bytes);
    EXPECT_EQ(read_file("/dev/null", 0), "");
}

TEST(ReadFile, SaysWhyItCannot) {
    const TemporaryFolder folder;
    write_whole(folder / "a", "12345");
    const auto error = [](const std::string& path) -> std::string {
        try {
            read_file(path, 4);
        } catch (const IoError& caught) {
            return caught.what();
        }
        return "";
    };
    EXPECT_EQ(error(folder / "a"),
              "cannot read '" + (folder / "a") + "': it is larger than the limit of 4 bytes");
    EXPECT_EQ(error("/dev/zero"),
              "cannot read '/dev/zero': it is larger than the limit of 4 bytes");
    EXPECT_EQ(error(folder / "b"),
              "cannot read '" + (folder / "b") + "': No such file or directory");
    EXPECT_EQ(error(folder.path()), "cannot read '" + folder.path() + "': Is a directory");
}

}  // namespace
}  // namespace edaha
