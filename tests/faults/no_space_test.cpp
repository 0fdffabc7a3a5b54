// SPDX-License-Identifier: Apache-2.0

// No space (rows F4 to F6): a file system that is full at any byte, a limit of the size of files,
// /dev/full. Never an exit code of 0 with a short file, and never an older file lost.

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <sstream>

#include "tiny_render.h"

namespace dewbow::faults {
namespace {

namespace fs = std::filesystem;

/// A command that writes one file.
struct Writer {
    std::string file;
    Words words;
};

/// One for each kind of file that the program writes.
std::vector<Writer> writers() {
    const Words bow{"rainbow", "--radius", "0.5mm", "--model", "airy", "--quiet", "-o"};
    std::vector<Writer> all;
    for (const char* file : {"ring.png", "ring.exr"})
        all.push_back({file, tiny_render({"--quiet", "-o", file})});
    for (const char* file : {"bow.csv", "bow.json", "bow.exr", "bow.png", "bow.svg"})
        all.push_back({file, bow + Words{file}});
    all.push_back({"glass.svg", {"glass", "show", "N-BK7", "--plot", "glass.svg"}});
    for (const char* file : {"curves.csv", "curves.json", "curves.svg", "strip.png"})
        all.push_back({file, {"spectrum", "-o", file}});
    return all;
}

/// How long the program's file is, where nothing is wrong.
std::size_t whole_size(const Writer& writer) {
    const RenderFolder folder;
    const Outcome outcome = run_program(DEWBOW_BINARY, writer.words, folder.path());
    EXPECT_EQ(outcome.exit_code, 0) << writer.file << ": " << outcome.standard_error;
    return bytes_of(folder.path() / writer.file).size();
}

std::function<bool()> with_size_limit(std::size_t bytes) {
    return [bytes] {
        const rlimit limit{bytes, bytes};
        return ::setrlimit(RLIMIT_FSIZE, &limit) == 0;
    };
}

/// By so many bytes at most files of the same words differ: pictures say how many seconds they
/// took, in as many digits as that needs.
constexpr std::size_t kDigitsOfSeconds = 24;

/// A quota is such a limit: a write is cut short where it is met, and the next one fails.
void check_size_limits(const std::vector<Writer>& writers, int steps) {
    for (const Writer& writer : writers) {
        const std::size_t size = whole_size(writer);
        ASSERT_GT(size, 100u) << writer.file;
        for (int step = 0; step < steps; ++step) {
            const std::size_t limit =
                (size - kDigitsOfSeconds) * std::size_t(step) / std::size_t(steps - 1);
            SCOPED_TRACE(fmt::format("{}, {} of {} bytes", writer.file, limit, size));
            const RenderFolder folder;
            folder.put(writer.file, "an older file");
            const auto before = folder.snapshot();
            const Outcome outcome = run_program(DEWBOW_BINARY, writer.words, folder.path(),
                                                {.prepare = with_size_limit(limit)});
            EXPECT_EQ(faults_of_answer(outcome, 1, {writer.file + ": ", "File too large"}), "");
            EXPECT_EQ(folder.snapshot(), before);
        }
    }
}

TEST(NoSpace, LimitOfFileSize) {
    std::vector<Writer> quick = writers();  // pictures of bows take a second each
    std::erase_if(quick,
                  [](const Writer& w) { return w.file == "bow.exr" || w.file == "bow.png"; });
    check_size_limits(quick, 5);
}
TEST(LongNoSpace, LimitOfFileSize) { check_size_limits(writers(), 60); }

TEST(NoSpace, FullDeviceBehindALink) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
    for (const Writer& writer : writers()) {
        SCOPED_TRACE(writer.file);
        const RenderFolder folder;
        fs::create_symlink("/dev/full", folder.path() / writer.file);
        const auto before = folder.snapshot();
        const Outcome outcome = run_program(DEWBOW_BINARY, writer.words, folder.path());
        EXPECT_EQ(faults_of_answer(outcome, 1, {writer.file + ": ", "No space left on device"}),
                  "");
        EXPECT_EQ(folder.snapshot(), before);
    }
}

// ---- standard output ---------------------------------------------------------------------------

const std::vector<Words>& talkers() {
    static const std::vector<Words> all{
        tiny_render({"--quiet", "--json", "-o", "ring.png"}),
        {"rainbow", "--radius", "0.5mm", "--model", "airy", "--json"},
        {"rainbow", "--radius", "0.5mm", "--model", "airy"},
        {"scene", "check", kTinyScene, "--json"},
        {"glass", "show", "N-BK7"},
        {"--help"},
    };
    return all;
}

std::function<bool()> with_output_to(const fs::path& path, int flags) {
    return [path, flags] { return ::dup2(::open(path.c_str(), flags, 0666), 1) == 1; };
}

TEST(NoSpace, StandardOutputIsAFullDevice) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
    for (const Words& words : talkers()) {
        const RenderFolder folder;
        const Outcome outcome = run_program(DEWBOW_BINARY, words, folder.path(),
                                            {.prepare = with_output_to("/dev/full", O_WRONLY)});
        EXPECT_EQ(faults_of_answer(outcome, 1, {"standard output", "No space left on device"}), "")
            << words[0];
    }
}

TEST(NoSpace, StandardOutputIsAFileOfLimitedSize) {
    constexpr std::size_t kLimit = 100;
    for (const Words& words : talkers()) {
        const RenderFolder folder;
        const auto prepare = [&] {
            return with_output_to(folder.path() / "said", O_WRONLY | O_CREAT)() &&
                   with_size_limit(kLimit)();
        };
        const Outcome outcome =
            run_program(DEWBOW_BINARY, words, folder.path(), {.prepare = prepare});
        EXPECT_EQ(outcome.exit_code, 1) << words[0];
        EXPECT_LE(bytes_of(folder.path() / "said").size(), kLimit);
    }
}

// ---- a full file system ------------------------------------------------------------------------

/// Renders over old pictures on file systems of more and more pages, until there is room. Prints a
/// line for each: pages, exit code, what became of the old picture, other files; the last picture
/// is kept as whole.EXT.
constexpr const char* kGrowingDisk = R"(
    mkdir disk || exit 99
    for pages in $(seq 2 64); do
        mount -t tmpfs -o size=$((pages * 4096)) none disk || exit 99
        printf 'an older picture' >disk/ring.$2
        "$1" render tiny.toml --size 32x32 --spp 1 --quiet -o disk/ring.$2 2>said
        code=$?
        cp disk/ring.$2 ring.$2
        said='nothing'
        grep -q 'No space left on device' said && said='no space'
        echo "$pages $code $(cmp -s ring.$2 old && echo old || echo new) $(ls -A disk | wc -l) $said"
        umount disk
        test $code = 0 && exit 0
    done
    exit 98
)";

class FullDisk : public testing::TestWithParam<std::string> {};

TEST_P(FullDisk, OldPictureStaysUntilThereIsRoom) {
    const fs::path unshare = find_tool("unshare");
    if (unshare.empty()) GTEST_SKIP() << "there is no unshare to mount a small file system with";
    const RenderFolder folder;
    folder.put("old", "an older picture");
    const Outcome outcome =
        run_program(unshare, {"-Urm", "sh", "-c", kGrowingDisk, "sh", DEWBOW_BINARY, GetParam()},
                    folder.path());
    if (outcome.exit_code == 99 || outcome.standard_output.empty())
        GTEST_SKIP() << "no small file system may be mounted here: " << outcome.standard_error;
    ASSERT_EQ(outcome.exit_code, 0) << outcome.standard_output;

    std::istringstream lines(outcome.standard_output);
    int full = 0, whole = 0;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        int pages = 0, code = -1, files = 0;
        std::string picture, said;
        words >> pages >> code >> picture >> files >> said;
        EXPECT_EQ(files, 1) << line;
        EXPECT_EQ(picture, code == 0 ? "new" : "old") << line;
        EXPECT_EQ(said, code == 0 ? "nothing" : "no") << line;
        full += code == 1;
        whole += code == 0;
    }
    EXPECT_GE(full, 1) << "the disk was never full";
    EXPECT_EQ(whole, 1);
    EXPECT_EQ(pixels_of(folder.path() / ("ring." + GetParam())),
              true_pixels("ring." + GetParam(), {"--size", "32x32", "--spp", "1"}));
}

/// A state that cannot be kept is a warning; the picture is what counts.
constexpr const char* kFullStateDisk = R"(
    mkdir disk && mount -t tmpfs -o size=64k none disk || exit 99
    "$1" render tiny.toml --size 48x48 --spp 60 --checkpoint disk/ring.dewbow \
         --checkpoint-every 0.01s -o ring.exr
    code=$?
    ls -A disk
    exit $code
)";

TEST(NoSpace, FullDiskOfTheState) {
    const fs::path unshare = find_tool("unshare");
    if (unshare.empty()) GTEST_SKIP() << "there is no unshare to mount a small file system with";
    const RenderFolder folder;
    const Outcome outcome = run_program(
        unshare, {"-Urm", "sh", "-c", kFullStateDisk, "sh", DEWBOW_BINARY}, folder.path());
    if (outcome.exit_code == 99 || outcome.standard_error.starts_with("unshare:"))
        GTEST_SKIP() << "no small file system may be mounted here: " << outcome.standard_error;
    EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
    const std::string warning = "warning: the state of the render is not kept";
    const std::size_t at = outcome.standard_error.find(warning);
    ASSERT_NE(at, std::string::npos) << outcome.standard_error;
    EXPECT_NE(outcome.standard_error.find("No space left on device", at), std::string::npos);
    EXPECT_EQ(outcome.standard_error.find(warning, at + 1), std::string::npos) << "said once";
    EXPECT_EQ(outcome.standard_output, "") << "something is left on the full disk";
    EXPECT_EQ(pixels_of(folder.path() / "ring.exr"),
              true_pixels("ring.exr", {"--size", "48x48", "--spp", "60"}));
}

/// The state beside a picture that cannot be written is kept, and gives the picture later.
TEST(NoSpace, StateStaysWhereThePictureFails) {
    const RenderFolder folder;
    fs::create_symlink("/dev/full", folder.path() / "ring.exr");
    const Words words = tiny_render({"-o", "ring.exr", "--checkpoint", "kept.dewbow"});
    const Outcome full = run_program(DEWBOW_BINARY, words, folder.path());
    EXPECT_EQ(full.exit_code, 1);
    EXPECT_NE(full.standard_error.find("No space left on device"), std::string::npos);
    ASSERT_TRUE(fs::exists(folder.path() / "kept.dewbow")) << full.standard_error;
    fs::remove(folder.path() / "ring.exr");
    const Outcome again = run_program(DEWBOW_BINARY, words + Words{"--resume"}, folder.path());
    EXPECT_EQ(again.exit_code, 0) << again.standard_error;
    EXPECT_EQ(pixels_of(folder.path() / "ring.exr"), true_pixels("ring.exr"));
    EXPECT_FALSE(fs::exists(folder.path() / "kept.dewbow"));
}

INSTANTIATE_TEST_SUITE_P(Formats, FullDisk, testing::Values("png", "exr"));

}  // namespace
}  // namespace dewbow::faults
