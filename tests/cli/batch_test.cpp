// SPDX-License-Identifier: MIT
// edaha batch, as its users run it: stopped, killed, resumed, shared out.
#include <csignal>
#include <map>
#include <thread>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/program.h"

namespace edaha {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::RunResult;

// Small trees, drawn in a millisecond or two.
constexpr const char* kStyle =
    "<tree name='sapling' extends='cherry'><growth energy='12'/>"
    "<palette name='night' leaf='#404040'/></tree>";

class Batch : public test::Program {
  protected:
    Batch() { write("my.xml", kStyle); }

    // All files below a folder, hidden ones too.
    std::map<std::string, std::string> files_of(const std::string& name) const {
        std::map<std::string, std::string> files;
        for (const auto& entry : fs::recursive_directory_iterator(folder_ / name)) {
            if (!entry.is_regular_file()) continue;
            const std::string path = fs::relative(entry.path(), folder_ / name).string();
            files[path] = test::read_whole(entry.path().string());
        }
        return files;
    }

    std::vector<std::string> names_of(const std::string& folder) const {
        std::vector<std::string> names;
        for (const auto& [name, bytes] : files_of(folder))
            names.push_back(name);
        return names;
    }

    // Runs it and expects success.
    RunResult good(const std::string& line) const {
        RunResult result = sh(line);
        EXPECT_EQ(result.exit_code, 0) << line << '\n' << result.err;
        return result;
    }

    // Starts the program by itself, without a shell, its messages in "err".
    pid_t start(const std::string& words) const {
        std::vector<std::string> arguments{EDAHA_BINARY};
        std::istringstream in(words);
        for (std::string word; in >> word;)
            arguments.push_back(word);
        std::vector<char*> pointers;
        for (std::string& argument : arguments)
            pointers.push_back(argument.data());
        pointers.push_back(nullptr);
        const std::string err = folder_ / "err";
        const std::string folder = folder_.path();
        const pid_t child = ::fork();
        if (child != 0) return child;
        const int descriptor = ::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
        if (::dup2(descriptor, 2) == 2 && ::chdir(folder.c_str()) == 0)
            ::execv(EDAHA_BINARY, pointers.data());
        ::_exit(127);
    }

    void wait_for(const std::string& file) const {
        for (int i = 0; i < 10000 && !exists(file); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        ASSERT_TRUE(exists(file));
    }
};

int wait_status(pid_t child) {
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    return status;
}

// RFC 4180.
std::vector<std::vector<std::string>> parse_csv(const std::string& text) {
    std::vector<std::vector<std::string>> rows{{""}};
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        std::string& cell = rows.back().back();
        if (quoted && text[i] == '"' && text.substr(i + 1, 1) == "\"") {
            cell += text[++i];
        } else if (text[i] == '"') {
            quoted = !quoted;
        } else if (!quoted && text[i] == ',') {
            rows.back().emplace_back();
        } else if (!quoted && text.substr(i, 2) == "\r\n") {
            rows.push_back({""});
            ++i;
        } else {
            cell += text[i];
        }
    }
    rows.pop_back();  // after the last line end
    return rows;
}

TEST_F(Batch, WrongUseIsCodeTwoAndMakesNothing) {
    const std::string batch = "edaha batch my.xml -o out ";
    const std::string help = "\nTry 'edaha batch --help'.\n";
    expect("edaha batch -n 3 -o out", 2, "", "edaha: batch: STYLE is missing" + help);
    expect("edaha batch my.xml -n 3", 2, "", "edaha: batch: -o is missing" + help);
    expect(batch, 2, "", "edaha: batch: -n is missing" + help);
    expect(batch + "-n 0", 2, "", "edaha: -n: '0' is out of range (expected 1 … 1000000)\n");
    expect(batch + "-n 3 --seed 7", 2, "",
           "edaha: batch: there is no option '--seed' (did you mean '--seed-from'?)" + help);
    expect(batch + "-n 3 --set growth.energy=0..5", 2, "",
           "edaha: --set: growth.energy: '0' is out of range (expected 1 … 1e6)\n");
    expect(batch + "-n 3 --set growth.energy=9..5", 2, "",
           "edaha: --set: growth.energy: '9..5' is a reversed range\n");
    expect(batch + "-n 3 --sweep growth.energy=7", 2, "",
           "edaha: --sweep: growth.energy: '7' is one value (expected a|b|c or a..b)\n");
    expect(batch + "-n 3 --palette 'main|nihgt'", 2, "",
           "edaha: 'sapling' has no palette 'nihgt' (did you mean 'night'?)\n");
    expect(batch + "-n 3 --name '{style}'", 2, "",
           "edaha: --name: sapling with seed 1 and sapling with seed 2 would both be 'sapling'\n");
    expect(batch + "-n 3 --name '../{seed}'", 2, "",
           "edaha: --name: '../1' is no path within the folder of -o\n");
    expect(batch + "-n 3 --shard 4/3", 2, "",
           "edaha: --shard: '4/3' is no share (expected i/n, 1 <= i <= n <= 1000, as 2/8)\n");
    expect(batch + "-n 3 --jobs 0", 2, "",
           "edaha: --jobs: '0' is out of range (expected 1 … 1024)\n");
    expect("edaha batch my.xml none -n 3 -o out", 1, "", "edaha: there is no style 'none'\n");
    EXPECT_FALSE(exists("out"));
}

TEST_F(Batch, ManifestsTellTheSameAsMeasure) {
    good(
        "edaha batch my.xml oak -n 3 --seed-from 7 -o out --format svg,png --set "
        "growth.energy=10..15 --palette 'main|dark' --name '{style}/{seed:02}' --width 40");
    EXPECT_EQ(names_of("out"),
              (std::vector<std::string>{"manifest.csv", "manifest.json", "oak/07.png", "oak/07.svg",
                                        "oak/08.png", "oak/08.svg", "oak/09.png", "oak/09.svg",
                                        "sapling/07.png", "sapling/07.svg", "sapling/08.png",
                                        "sapling/08.svg", "sapling/09.png", "sapling/09.svg"}));
    const json manifest = json::parse(test::read_whole(folder_ / "out/manifest.json"));
    const auto csv = parse_csv(test::read_whole(folder_ / "out/manifest.csv"));
    ASSERT_EQ(csv.size(), 13u);
    ASSERT_EQ(manifest.at("files").size(), 12u);
    EXPECT_EQ(json(csv[0]), manifest.at("columns"));
    for (std::size_t i = 0; i < 12; ++i) {
        const json& row = manifest.at("files").at(i);
        ASSERT_EQ(csv[i + 1].size(), csv[0].size());
        ASSERT_EQ(row.size(), csv[0].size());
        for (std::size_t column = 0; column < csv[0].size(); ++column) {
            const json& cell = row.at(csv[0][column]);
            EXPECT_EQ(csv[i + 1][column], cell.is_string() ? cell.get<std::string>() : cell.dump());
        }
        const std::string file = "out/" + row.at("file").get<std::string>();
        EXPECT_EQ(row.at("bytes"), fs::file_size(folder_ / file));
        if (!file.ends_with(".svg")) continue;
        const json measured = json::parse(good("edaha measure " + file + " --json").out);
        for (const char* key : {"style", "seed", "branches", "leaves", "nodes"})
            EXPECT_EQ(row.at(key), measured.at(key)) << file << ' ' << key;
        EXPECT_EQ(row.at("overlap"), measured.at("overlap_ratio"));
        EXPECT_EQ(row.at("width_mm"), measured.at("width_mm"));
    }
    EXPECT_EQ(manifest.at("files").at(0).at("file"), "sapling/07.svg");
    EXPECT_EQ(manifest.at("files").at(11).at("file"), "oak/09.png");
}

TEST_F(Batch, TheRecordedCommandDrawsTheSameBytes) {
    good(
        "edaha batch my.xml -n 4 -o out --set growth.energy=10..20 --set 'growth.type=A|B' "
        "--sweep palette.leaf='#204020..#80a040' --vary 0..1 --look 'solid|outline' "
        "--palette 'main|night' --size 9cm --background");
    for (const char* name : {"sapling-0001", "sapling-0002", "sapling-0003", "sapling-0004"}) {
        const std::string svg = test::read_whole(folder_ / ("out/" + std::string(name) + ".svg"));
        const std::size_t begin = svg.find("<dc:source>") + 11;
        const std::string command = svg.substr(begin, svg.find('<', begin) - begin);
        EXPECT_TRUE(command.starts_with("edaha draw my.xml --seed ")) << command;
        good(command + " -o again.svg");
        EXPECT_EQ(test::read_whole(folder_ / "again.svg"), svg) << command;
    }
}

TEST_F(Batch, AnyNumberOfJobsGivesTheSameBytes) {
    good("edaha batch my.xml -n 20 -o one --jobs 1 --format svg,pdf");
    good("edaha batch my.xml -n 20 -o many --jobs 5 --format svg,pdf");
    EXPECT_EQ(files_of("one").size(), 42u);
    EXPECT_EQ(files_of("one"), files_of("many"));
}

TEST_F(Batch, SharesMergeToTheWhole) {
    const std::string batch = "edaha batch my.xml -n 10 --sweep growth.energy=8..20 ";
    good(batch + "-o whole");
    for (const char* share : {"2/3", "1/3"})
        good(batch + "-o parts --shard " + share);
    expect("edaha batch --merge -o parts", 1, "", "edaha: shares are missing: 3/3\n");
    good(batch + "-o parts --shard 3/3");
    expect("edaha batch --merge -o parts", 0, "", "edaha: merged the manifests of 10 variants\n");
    auto parts = files_of("parts");
    EXPECT_EQ(
        std::erase_if(
            parts, [](const auto& file) { return file.first.find("-of-3.") != std::string::npos; }),
        6u);
    EXPECT_EQ(parts, files_of("whole"));
    // The whole goes on from the shares.
    expect(batch + "-o parts --resume --quiet", 0, "", "");
    EXPECT_EQ(files_of("parts").at("manifest.json"), files_of("whole").at("manifest.json"));
}

TEST_F(Batch, MergingReplacesOnlyTheManifestOfItsOwnRun) {
    for (const char* share : {"1/2", "2/2"})
        good(std::string("edaha batch my.xml -n 4 -o parts --shard ") + share);
    write("parts/manifest.csv", "my own list");
    expect("edaha batch --merge -o parts", 1, "",
           "edaha: 'parts/manifest.csv' is there already, and not of this run (--force "
           "overwrites)\n");
    EXPECT_EQ(test::read_whole(folder_ / "parts/manifest.csv"), "my own list");
    good("edaha batch my.xml -n 2 -o other");
    fs::copy_file(folder_ / "other/manifest.json", folder_ / "parts/manifest.json");
    expect("edaha batch --merge -o parts", 1, "",
           "edaha: 'parts/manifest.json' is there already, and not of this run (--force "
           "overwrites)\n");
    good("edaha batch --merge -o parts --force");
    good("edaha batch --merge -o parts");
}

TEST_F(Batch, GnuParallelDrawsShares) {
    if (sh("parallel --version").exit_code != 0) GTEST_SKIP() << "there is no parallel";
    good("edaha batch my.xml -n 9 -o whole");
    good("parallel -j2 " EDAHA_BINARY
         " batch my.xml -n 9 -o parts --shard {}/4 ::: 1 2 3 4 && edaha batch --merge -o parts");
    auto parts = files_of("parts");
    std::erase_if(parts,
                  [](const auto& file) { return file.first.find("-of-4.") != std::string::npos; });
    EXPECT_EQ(parts, files_of("whole"));
}

TEST_F(Batch, FilesThatAreThereStayWithoutForce) {
    const std::string batch = "edaha batch my.xml -n 3 -o out ";
    good(batch);
    expect(batch, 1, "",
           "edaha: 'out/sapling-0001.svg' is there already, and 4 more files (--resume keeps what "
           "is still right, --force overwrites)\n");
    write("out/sapling-0002.svg", "<svg/>");
    expect(batch + "--resume", 1, "",
           "edaha: 'out/sapling-0002.svg' is none of edaha's files (--force overwrites it)\n");
    EXPECT_EQ(test::read_whole(folder_ / "out/sapling-0002.svg"), "<svg/>");
    good(batch + "--force");
    EXPECT_GT(fs::file_size(folder_ / "out/sapling-0002.svg"), 1000u);
}

TEST_F(Batch, ResumingDrawsOnlyWhatIsMissingOrDamaged) {
    const std::string batch = "edaha batch my.xml -n 6 -o out --format svg,png ";
    good(batch);
    const auto whole = files_of("out");
    fs::remove(folder_ / "out/sapling-0002.png");
    write("out/sapling-0004.svg", whole.at("sapling-0004.svg").substr(0, 5000));
    write("out/sapling-0005.png", "");
    std::map<std::string, struct stat> before;
    for (const std::string& name : names_of("out"))
        ::stat((folder_ / ("out/" + name)).c_str(), &before[name]);
    const RunResult again = good(batch + "--resume");
    EXPECT_TRUE(again.err.starts_with("edaha: drew 3 of 6 variants (3 files) in ")) << again.err;
    EXPECT_TRUE(again.err.ends_with("; 3 were right already\n")) << again.err;
    EXPECT_EQ(files_of("out"), whole);
    for (const auto& [name, old] : before) {
        struct stat now {};
        ::stat((folder_ / ("out/" + name)).c_str(), &now);
        const bool drawn = name == "sapling-0004.svg" || name == "sapling-0005.png" ||
                           name.starts_with("manifest");
        EXPECT_EQ(now.st_ino != old.st_ino, drawn) << name;
    }
    // Without a manifest, files are measured again, not written.
    fs::remove(folder_ / "out/manifest.json");
    const RunResult measured = good(batch + "--resume");
    EXPECT_TRUE(measured.err.starts_with("edaha: drew 0 of 6 variants")) << measured.err;
    EXPECT_EQ(files_of("out"), whole);
}

TEST_F(Batch, ResumingFollowsTheStyleAndTheCommand) {
    good("edaha batch my.xml -n 4 -o out");
    write("my.xml", std::string(kStyle).replace(std::string(kStyle).find("12"), 2, "14"));
    EXPECT_TRUE(good("edaha batch my.xml -n 4 -o out --resume")
                    .err.starts_with("edaha: drew 4 of 4 variants"));
    EXPECT_TRUE(good("edaha batch my.xml -n 4 -o out --resume --set leaf.size=3")
                    .err.starts_with("edaha: drew 4 of 4 variants"));
    EXPECT_TRUE(good("edaha batch my.xml -n 6 -o out --resume --set leaf.size=3")
                    .err.starts_with("edaha: drew 2 of 6 variants"));
    good("edaha batch my.xml -n 6 -o fresh --set leaf.size=3");
    EXPECT_EQ(files_of("out"), files_of("fresh"));
}

TEST_F(Batch, KilledAtAnyMomentItLeavesWholeFilesAndGoesOn) {
    const std::string words = "batch my.xml -n 80 --format svg,pdf --set growth.energy=10..20 ";
    good("edaha " + words + "-o whole");
    const auto whole = files_of("whole");
    for (const int milliseconds : {5, 20, 45, 30, 60, 25}) {
        const pid_t child = start(words + "-o out --resume");
        std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
        ::kill(child, SIGKILL);
        wait_status(child);
        if (!exists("out")) continue;
        for (const auto& [name, bytes] : files_of("out")) {
            // A hidden name may stand only for the journal.
            if (name == ".manifest.journal") continue;
            ASSERT_TRUE(whole.contains(name)) << name;
            EXPECT_EQ(bytes, whole.at(name)) << name;
        }
    }
    good("edaha " + words + "-o out --resume");
    EXPECT_EQ(files_of("out"), whole);
}

TEST_F(Batch, InterruptedItTellsAndEndsByTheSignal) {
    const std::string words = "batch my.xml -n 3000 -o out ";
    for (const int signal : {SIGINT, SIGTERM}) {
        const pid_t child = start(words + "--force");
        wait_for("out/sapling-0003.svg");
        ::kill(child, signal);
        const int status = wait_status(child);
        ASSERT_TRUE(WIFSIGNALED(status));
        EXPECT_EQ(WTERMSIG(status), signal);
        const json manifest = json::parse(test::read_whole(folder_ / "out/manifest.json"));
        const std::size_t done = manifest.at("files").size();
        EXPECT_GE(done, 1u);
        EXPECT_EQ(test::read_whole(folder_ / "err"), "edaha: stopped after " +
                                                         std::to_string(done) +
                                                         " of 3000 variants; --resume goes on\n");
        EXPECT_FALSE(exists("out/.manifest.journal"));
        // All that was drawn is listed.
        EXPECT_EQ(files_of("out").size(), done + 2);
        fs::remove_all(folder_ / "out");
    }
}

TEST_F(Batch, StoppingAResumedRunForgetsNothing) {
    good("edaha batch my.xml -n 400 -o out");
    const auto whole = files_of("out");
    fs::remove(folder_ / "out/sapling-0001.svg");
    const pid_t child = start("batch my.xml -n 400 -o out --resume --jobs 1");
    wait_for("out/sapling-0001.svg");
    ::kill(child, SIGINT);
    const int status = wait_status(child);
    if (WIFSIGNALED(status)) {
        EXPECT_TRUE(exists("out/.manifest.journal"));
    }
    EXPECT_TRUE(good("edaha batch my.xml -n 400 -o out --resume")
                    .err.starts_with("edaha: drew 0 of 400 variants (0 files)"));
    EXPECT_EQ(files_of("out"), whole);
}

TEST_F(Batch, AFileAboveTheLimitIsOneError) {
    good("edaha batch my.xml -n 5 -o whole --jobs 1");
    expect("(ulimit -f 8; edaha batch my.xml -n 5 -o out --jobs 1)", 1, "",
           "edaha: cannot write 'out/sapling-0001.svg': File too large\n");
    EXPECT_EQ(names_of("out"), (std::vector<std::string>{"manifest.csv", "manifest.json"}));
    good("edaha batch my.xml -n 5 -o out --resume");
    EXPECT_EQ(files_of("out"), files_of("whole"));
}

// A file system for the time of a test, where the user may mount one.
class Mounted {
  public:
    Mounted(const std::string& options, const std::string& folder) : folder_(folder) {
        fs::create_directories(folder);
        mounted_ = ::geteuid() == 0 &&
                   test::run("mount " + options + ' ' + test::quoted(folder)).exit_code == 0;
    }
    ~Mounted() {
        if (mounted_) test::run("umount " + test::quoted(folder_));
    }
    bool mounted() const { return mounted_; }

  private:
    std::string folder_;
    bool mounted_ = false;
};

TEST_F(Batch, AFullDiskIsOneErrorAndItGoesOnLater) {
    const Mounted disk("-t tmpfs -o size=600k none", folder_ / "disk");
    if (!disk.mounted()) GTEST_SKIP() << "cannot mount";
    const RunResult full = sh("edaha batch my.xml -n 60 -o disk/out");
    EXPECT_EQ(full.exit_code, 1);
    EXPECT_EQ(full.out, "");
    EXPECT_TRUE(full.err.starts_with("edaha: cannot write 'disk/out/")) << full.err;
    EXPECT_TRUE(full.err.ends_with("': No space left on device\n")) << full.err;
    EXPECT_EQ(std::ranges::count(full.err, '\n'), 1) << full.err;
    good("edaha batch my.xml -n 60 -o whole");
    const auto whole = files_of("whole");
    std::size_t pictures = 0;
    for (const auto& [name, bytes] : files_of("disk/out")) {
        if (!name.ends_with(".svg")) continue;
        EXPECT_EQ(bytes, whole.at(name)) << name;
        ++pictures;
    }
    EXPECT_GE(pictures, 1u);
    ASSERT_EQ(sh("mount -o remount,size=20m disk").exit_code, 0);
    good("edaha batch my.xml -n 60 -o disk/out --resume");
    EXPECT_EQ(files_of("disk/out"), whole);
}

TEST_F(Batch, AnUnwritableFolderIsOneError) {
    write("file", "");
    expect("edaha batch my.xml -n 3 -o file", 1, "",
           "edaha: cannot make the folder 'file': Not a directory\n");
    expect("edaha batch my.xml -n 3 -o file/out", 1, "",
           "edaha: cannot make the folder 'file/out': Not a directory\n");
    const Mounted disk("-t tmpfs -o ro none", folder_ / "disk");
    if (!disk.mounted()) GTEST_SKIP() << "cannot mount";
    expect("edaha batch my.xml -n 3 -o disk", 1, "",
           "edaha: cannot write 'disk/.manifest.journal': Read-only file system\n");
    expect("edaha batch my.xml -n 3 -o disk/out", 1, "",
           "edaha: cannot make the folder 'disk/out': Read-only file system\n");
}

TEST_F(Batch, ATerminalSeesABarThatIsGoneInTheEnd) {
    const RunResult run =
        good("script -qec 'stty cols 60; " EDAHA_BINARY
             " batch my.xml -n 150 --set growth.energy=100 -o out --jobs 1' /dev/null");
    const std::string clear = "\r\x1b[K";
    const std::size_t bar = run.out.find(clear + "[");
    ASSERT_NE(bar, std::string::npos) << run.out;
    const std::string line = run.out.substr(bar + 4, run.out.find('\r', bar + 4) - bar - 4);
    EXPECT_LT(line.size(), 60u);
    EXPECT_NE(line.find("/150  "), std::string::npos) << line;
    EXPECT_NE(line.find(" left"), std::string::npos) << line;
    const std::string last = run.out.substr(run.out.rfind(clear));
    EXPECT_TRUE(last.starts_with(clear + "edaha: drew 150 of 150 variants (150 files) in "))
        << last;
    // Without a terminal there is nothing to clear.
    EXPECT_EQ(good("edaha batch my.xml -n 5 -o plain").err.find('\x1b'), std::string::npos);
}

TEST_F(Batch, SheetsShowAllVariantsAndAreDrawnOnlyWhenSomethingChanged) {
    const std::string batch = "edaha batch my.xml -n 26 --set growth.energy=5 --sheet -o ";
    good(batch + "whole");
    const auto whole = files_of("whole");
    for (const char* file : {"sheet-01.svg", "sheet-02.svg", "sheet.pdf"})
        EXPECT_TRUE(whole.contains(file)) << file;
    // Without sheets first, then with them: nothing is written twice.
    good("edaha batch my.xml -n 26 --set growth.energy=5 -o out");
    EXPECT_TRUE(good(batch + "out --resume").err.starts_with("edaha: drew 0 of 26 variants"));
    EXPECT_EQ(files_of("out"), whole);
    const auto written = fs::last_write_time(folder_ / "out/sheet.pdf");
    good(batch + "out --resume");
    EXPECT_EQ(fs::last_write_time(folder_ / "out/sheet.pdf"), written);
    fs::remove(folder_ / "out/sheet-02.svg");
    good(batch + "out --resume");
    EXPECT_EQ(files_of("out"), whole);
    expect(batch + "out --shard 1/2", 2, "",
           "edaha: --sheet shows all variants, not a share: after --merge, --resume --sheet draws "
           "it\n");
    expect(batch + "new --name 'sheet-{seed}'", 2, "",
           "edaha: --name: 'sheet-1' is a contact sheet's name\n");
    expect("edaha batch my.xml -n 2 -o new --sheet=png", 2, "",
           "edaha: --sheet: 'png' is not known (expected svg or pdf)\n");
    good("edaha batch my.xml -n 2 -o new --sheet=svg --set growth.energy=5");
    EXPECT_TRUE(exists("new/sheet-01.svg"));
    EXPECT_FALSE(exists("new/sheet.pdf"));
}

TEST_F(Batch, ReportsAsJson) {
    const RunResult run = good("edaha batch my.xml -n 3 -o out --json --quiet --format svg,pdf");
    EXPECT_EQ(run.err, "");
    const json report = json::parse(run.out);
    EXPECT_EQ(report.at("folder"), "out");
    EXPECT_EQ(report.at("manifest"), "out/manifest.json");
    EXPECT_EQ(report.at("variants"), 3);
    EXPECT_EQ(report.at("drawn"), 3);
    EXPECT_EQ(report.at("files"), 6);
}

}  // namespace
}  // namespace edaha
