// SPDX-License-Identifier: Apache-2.0

// Places where a picture may be asked to go (rows F9, F20): folders that cannot be written, FIFOs,
// links, files of others, and names that only a file system could love.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <thread>

#include "tiny_render.h"

namespace dewbow::faults {
namespace {

namespace fs = std::filesystem;

Outcome render_to(const Folder& folder, const std::string& file, const Start& start = {}) {
    return run_program(DEWBOW_BINARY, tiny_render({"--quiet", "-o", file}), folder.path(), start);
}

// ---- FIFOs and links ---------------------------------------------------------------------------

TEST(OddPlaces, FifoGivesItsReaderTheWholePicture) {
    for (const std::string name : {"ring.png", "ring.exr"}) {
        const RenderFolder folder;
        const fs::path fifo = folder.path() / name;
        ASSERT_EQ(::mkfifo(fifo.c_str(), 0666), 0);
        std::string read;
        std::thread reader([&] { read = bytes_of(fifo); });
        const Outcome outcome = render_to(folder, name);
        reader.join();
        EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
        EXPECT_EQ(pixels_of_bytes(read, name), true_pixels(name));
        EXPECT_TRUE(fs::is_fifo(fifo));
        EXPECT_EQ(folder.snapshot().size(), 2u);
    }
}

TEST(OddPlaces, FifoWhoseReaderLeavesIsAnError) {
    const RenderFolder folder;
    const fs::path fifo = folder.path() / "ring.exr";
    ASSERT_EQ(::mkfifo(fifo.c_str(), 0666), 0);
    std::size_t bytes_read = 0;
    std::thread reader([&] {
        const int file = ::open(fifo.c_str(), O_RDONLY);
        char byte;
        bytes_read = std::size_t(::read(file, &byte, 1));
        ::close(file);
    });
    // More than the 64 KiB that a pipe holds when nobody reads.
    const Outcome outcome = run_program(DEWBOW_BINARY,
                                        {"render", kTinyScene, "--size", "160x160", "--spp", "1",
                                         "--quiet", "--spectral-bins", "8", "-o", "ring.exr"},
                                        folder.path());
    reader.join();
    EXPECT_EQ(bytes_read, 1u);
    EXPECT_EQ(faults_of_answer(outcome, 1, {"ring.exr: ", "Broken pipe"}), "");
}

TEST(OddPlaces, LinkToStandardOutput) {
    const RenderFolder folder;
    fs::create_symlink("/dev/stdout", folder.path() / "ring.png");
    const Outcome outcome = render_to(folder, "ring.png");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
    EXPECT_EQ(pixels_of_bytes(outcome.standard_output, "ring.png"), true_pixels("ring.png"));
    EXPECT_TRUE(fs::is_symlink(folder.path() / "ring.png"));
    EXPECT_EQ(folder.snapshot().size(), 2u);
}

TEST(OddPlaces, LinksAreFollowedAndStay) {
    const RenderFolder folder;
    folder.put("far/away/picture.of.a.ring", "an older picture");
    fs::create_symlink("far/away", folder.path() / "near");
    fs::create_symlink("near/picture.of.a.ring", folder.path() / "ring.png");
    const Outcome outcome = render_to(folder, "ring.png");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
    EXPECT_TRUE(fs::is_symlink(folder.path() / "ring.png"));
    EXPECT_EQ(pixels_of(folder.path() / "ring.png"), true_pixels("ring.png"));
    EXPECT_EQ(folder.snapshot().size(), 6u);
}

// ---- what others own ---------------------------------------------------------------------------

class OthersFiles : public testing::Test {
protected:
    void SetUp() override {
        if (::geteuid() != 0) GTEST_SKIP() << "only root can make files of two owners";
        if (render_to(folder_, "probe.png", {.as_nobody = true}).exit_code != 0)
            GTEST_SKIP() << "the program cannot be run as another user";
        fs::remove(folder_.path() / "probe.png");
    }
    RenderFolder folder_;
};

/// As in /tmp: who owns a file may replace it, and nobody else.
TEST_F(OthersFiles, StickyFolder) {
    folder_.put("shared/ring.png", "an older picture");
    ::chmod((folder_.path() / "shared/ring.png").c_str(), 0666);
    ::chmod((folder_.path() / "shared").c_str(), 01777);
    fs::create_symlink("shared/ring.png", folder_.path() / "ring.png");
    const auto before = folder_.snapshot();
    const Outcome outcome = render_to(folder_, "ring.png", {.as_nobody = true});
    EXPECT_EQ(faults_of_answer(outcome, 1, {"ring.png: ", "Operation not permitted"}), "");
    EXPECT_EQ(bytes_of(folder_.path() / "shared/ring.png"), "an older picture");
    EXPECT_EQ(losses(before, folder_, outcome, {}), "") << "more than a state is there";
}

TEST_F(OthersFiles, WriteProtectedFile) {
    folder_.put("ring.png", "an older picture");
    ::chmod((folder_.path() / "ring.png").c_str(), 0444);
    const auto before = folder_.snapshot();
    const Outcome outcome = render_to(folder_, "ring.png", {.as_nobody = true});
    EXPECT_EQ(faults_of_answer(outcome, 1, {"ring.png: ", "Permission denied"}), "");
    EXPECT_EQ(folder_.snapshot(), before);
}

TEST_F(OthersFiles, LockLeftByAnother) {
    folder_.put(".ring.png.lock", "dewbow lock 1\npid 999999999\nhost elsewhere\n");
    const Outcome outcome = render_to(folder_, "ring.png", {.as_nobody = true});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
    EXPECT_FALSE(fs::exists(folder_.path() / ".ring.png.lock"));
}

TEST(OddPlaces, FileSystemMountedReadOnly) {
    const fs::path unshare = find_tool("unshare");
    if (unshare.empty()) GTEST_SKIP() << "there is no unshare to mount with";
    const RenderFolder folder;
    folder.put("disk/ring.png", "an older picture");
    const auto before = folder.snapshot();
    const std::string script =
        "mount --bind disk disk && mount -o remount,ro,bind disk || exit 99\n"
        "if touch disk/new 2>/dev/null; then exit 98; fi\n"
        "exec \"$1\" render tiny.toml --size 8x8 --spp 1 -o disk/ring.png";
    const Outcome outcome =
        run_program(unshare, {"-Urm", "sh", "-c", script, "sh", DEWBOW_BINARY}, folder.path());
    if (outcome.exit_code == 99 || outcome.standard_error.starts_with("unshare:"))
        GTEST_SKIP() << "nothing may be mounted here: " << outcome.standard_error;
    EXPECT_EQ(faults_of_answer(outcome, 1, {"disk/ring.png: ", "Read-only file system"}), "");
    EXPECT_EQ(folder.snapshot(), before);
}

// ---- names -------------------------------------------------------------------------------------

TEST(OddPlaces, NamesOfAllKinds) {
    const std::string pixels = true_pixels("ring.png");
    for (const std::string stem :
         {"r\xc3\xa4inb\xc3\xb6w \xf0\x9f\x8c\x88", "two  words", "new\nline", "quote's \"$HOME\"",
          "no-utf8-\xff\xfe", "..", ".hidden", "a;rm -rf b", "%s%n", "back\\slash", "{}*?[x]",
          "~"}) {
        const RenderFolder folder;
        folder.put(stem + "/" + stem + ".toml", kTinySceneText);
        const std::string name = stem + "/" + stem + ".png";
        Words words = tiny_render({"-o", name});
        words[1] = stem + "/" + stem + ".toml";
        const Outcome outcome = run_program(DEWBOW_BINARY, words, folder.path());
        EXPECT_EQ(outcome.exit_code, 0) << stem << ": " << outcome.standard_error;
        EXPECT_EQ(pixels_of(folder.path() / name), pixels) << stem;
    }
}

TEST(OddPlaces, NamesThatBeginWithADash) {
    const RenderFolder folder;
    folder.put("-dash.toml", kTinySceneText);
    Words words = tiny_render({"-o", "./-o.png"});
    words.erase(words.begin() + 1);
    const Outcome outcome =
        run_program(DEWBOW_BINARY, words + Words{"--", "-dash.toml"}, folder.path());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
    EXPECT_EQ(pixels_of(folder.path() / "-o.png"), true_pixels("ring.png"));
}

/// 255 bytes for a name and 4095 for a path are what Linux takes.
TEST(OddPlaces, NamesAsLongAsNamesCanBe) {
    const RenderFolder folder;
    const std::string name = std::string(251, 'n') + ".png";
    std::string path = name;
    for (const char c : std::string("abcdefghijklmno")) path = std::string(250, c) + "/" + path;
    ASSERT_GT(path.size(), 4000u);
    fs::create_directories((folder.path() / path).parent_path());
    for (const std::string& output : {name, path}) {
        const Outcome outcome = render_to(folder, output);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
        EXPECT_EQ(pixels_of(folder.path() / output), true_pixels(name));
    }
}

}  // namespace
}  // namespace dewbow::faults
