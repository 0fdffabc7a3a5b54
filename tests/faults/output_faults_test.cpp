// SPDX-License-Identifier: Apache-2.0
// Writing a picture where it cannot be written: the error is an InputError that names path and
// reason, the old file is as it was, and nothing is left beside it. Each test first sees with plain
// system calls that its fault is really there.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>

#include "dewbow/base/error.h"
#include "dewbow/base/file.h"
#include "dewbow/image/exr.h"
#include "dewbow/image/png.h"

namespace dewbow {
namespace {

namespace fs = std::filesystem;

constexpr int kSide = 48;
/// Limits of the file size that are tried for each format, from nothing to all but one byte.
constexpr std::size_t kSizeSteps = 60;
/// "nobody" on Debian: a user whom permissions stop, as they do not stop root.
constexpr uid_t kUnprivileged = 65534;
const std::string kWritten = "written";

/// Noise: its files do not shrink to a few bytes.
std::uint8_t noise(int i) { return static_cast<std::uint8_t>((i * 2654435761u) >> 24); }

std::string exr_bytes() {
    Image image{kSide, kSide, {{"R", {}}, {"G", {}}, {"B", {}}}};
    for (int i = 0; i < 3 * kSide * kSide; ++i)
        image.channels[std::size_t(i % 3)].values.push_back(float(noise(i)) / 255.0f);
    return encode_exr(image, {}, {});
}

std::string png_bytes() {
    Image8 image{kSide, kSide, {}};
    for (int i = 0; i < 3 * kSide * kSide; ++i) image.rgb.push_back(noise(i));
    return encode_png(image, {});
}

struct Picture {
    std::string file_name, bytes;
};
std::vector<Picture> pictures() { return {{"out.exr", exr_bytes()}, {"out.png", png_bytes()}}; }

std::string content_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// A folder of its own for each test, open to other users, gone at the end.
class OutputFaults : public testing::Test {
protected:
    void SetUp() override {
        std::string pattern = (fs::path(testing::TempDir()) / "dewbow_faults_XXXXXX").string();
        ASSERT_TRUE(::mkdtemp(pattern.data())) << std::strerror(errno);
        folder_ = pattern;
        ASSERT_EQ(::chmod(pattern.c_str(), 0777), 0);
    }
    void TearDown() override {
        ::chmod((folder_ / "read_only").c_str(), 0777);
        fs::remove_all(folder_);
    }

    /// All that is in the folder: files with their content, links with their target.
    std::map<std::string, std::string> snapshot() const {
        std::map<std::string, std::string> entries;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_)) {
            std::string& what = entries[entry.path().string()];
            if (entry.is_symlink())
                what = "link to " + fs::read_symlink(entry.path()).string();
            else
                what = entry.is_directory() ? "folder" : content_of(entry.path());
        }
        return entries;
    }
    fs::path put(const fs::path& name, const std::string& content) const {
        std::ofstream(folder_ / name, std::ios::binary) << content;
        return folder_ / name;
    }

    fs::path folder_;
};

/// The whole message, or kWritten. Names of paths are checked here.
std::string write(const fs::path& path, const std::string& bytes) {
    try {
        write_file_atomically(path, bytes);
    } catch (const InputError& error) {
        return error.place().file == path.string() ? error.what() : "the path is not named";
    }
    return kWritten;
}

/// The errno that plain system calls end with, 0 if they write all of `bytes`.
int plain_write(const fs::path& path, const std::string& bytes) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT, 0666);
    if (file < 0) return errno;
    std::size_t written = 0;
    int error = 0;
    while (written < bytes.size() && error == 0) {
        const ssize_t count = ::write(file, bytes.data() + written, bytes.size() - written);
        if (count < 0)
            error = errno;
        else
            written += static_cast<std::size_t>(count);
    }
    ::close(file);
    return error;
}

/// Runs `work` in a forked child, whose limits and rights it may change, and returns its text.
std::string in_child(const std::function<std::string()>& work) {
    int ends[2];
    if (::pipe(ends) != 0) return "no pipe";
    const pid_t child = ::fork();
    if (child == 0) {
        ::close(ends[0]);
        std::string text = "another exception escaped";
        try {
            text = work();
        } catch (...) {
        }
        const bool sent =
            ::write(ends[1], text.data(), text.size()) == static_cast<ssize_t>(text.size());
        ::_exit(sent ? 0 : 1);
    }
    ::close(ends[1]);
    std::string text;
    char buffer[512];
    for (ssize_t count; (count = ::read(ends[0], buffer, sizeof buffer)) > 0;)
        text.append(buffer, static_cast<std::size_t>(count));
    ::close(ends[0]);
    int status = -1;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? text : "the child died";
}

bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != text.npos;
}

TEST_F(OutputFaults, NothingIsWrongWithoutAFault) {
    for (const Picture& picture : pictures()) {
        const fs::path path = put(picture.file_name, "old");
        EXPECT_EQ(write(path, picture.bytes), kWritten);
        EXPECT_EQ(content_of(path), picture.bytes);
    }
    EXPECT_EQ(snapshot().size(), pictures().size());
}

TEST_F(OutputFaults, FullDevice) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
    fs::create_symlink("/dev/full", folder_ / "link.exr");
    const auto before = snapshot();
    for (const Picture& picture : pictures()) {
        ASSERT_EQ(plain_write("/dev/full", picture.bytes), ENOSPC);
        for (const fs::path& path : {fs::path("/dev/full"), folder_ / "link.exr"})
            EXPECT_TRUE(contains(write(path, picture.bytes), "No space left on device")) << path;
    }
    EXPECT_EQ(snapshot(), before);
}

TEST_F(OutputFaults, MissingFolder) {
    const auto before = snapshot();
    for (const Picture& picture : pictures()) {
        const fs::path path = folder_ / "missing" / picture.file_name;
        ASSERT_EQ(plain_write(path, picture.bytes), ENOENT);
        EXPECT_TRUE(contains(write(path, picture.bytes), "No such file or directory"));
        EXPECT_THROW(check_writable(path), InputError);
    }
    EXPECT_EQ(snapshot(), before);
}

TEST_F(OutputFaults, TargetIsAFolder) {
    fs::create_directory(folder_ / "out.exr");
    put("out.exr/inside", "old");
    const auto before = snapshot();
    for (const Picture& picture : pictures()) {
        ASSERT_EQ(plain_write(folder_ / "out.exr", picture.bytes), EISDIR);
        EXPECT_TRUE(contains(write(folder_ / "out.exr", picture.bytes), "folder"));
        EXPECT_THROW(check_writable(folder_ / "out.exr"), InputError);
    }
    EXPECT_EQ(snapshot(), before);
}

TEST_F(OutputFaults, ReadOnlyFolder) {
    fs::create_directory(folder_ / "read_only");
    put("read_only/out.exr", "old");
    ASSERT_EQ(::chmod((folder_ / "read_only").c_str(), 0555), 0);
    const auto before = snapshot();
    for (const Picture& picture : pictures()) {
        const std::string message = in_child([&]() -> std::string {
            if (::geteuid() == 0 && ::setuid(kUnprivileged) != 0) return "cannot give up root";
            if (plain_write(folder_ / "read_only" / "new", "x") != EACCES)
                return "the fault is not there";
            return write(folder_ / "read_only" / picture.file_name, picture.bytes);
        });
        EXPECT_TRUE(contains(message, "Permission denied")) << message;
    }
    EXPECT_EQ(snapshot(), before);
}

/// Writes in a child that may write files of `limit` bytes only.
std::string write_limited(const fs::path& path, const std::string& bytes, std::size_t limit) {
    return in_child([&]() -> std::string {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limits{limit, limit};
        if (::setrlimit(RLIMIT_FSIZE, &limits) != 0) return "cannot set the limit";
        const fs::path probe = path.parent_path() / "probe";
        const int expected = limit < bytes.size() ? EFBIG : 0;
        const int found = plain_write(probe, bytes);
        ::unlink(probe.c_str());
        if (found != expected) return "the fault is not there";
        return write(path, bytes);
    });
}

/// A quota, or a disk that fills while the file is being written, at every part of it.
TEST_F(OutputFaults, FileSizeLimit) {
    for (const Picture& picture : pictures()) {
        const fs::path path = put(picture.file_name, "old");
        const auto before = snapshot();
        for (std::size_t step = 0; step <= kSizeSteps; ++step) {
            const std::size_t limit = (picture.bytes.size() - 1) * step / kSizeSteps;
            const std::string message = write_limited(path, picture.bytes, limit);
            ASSERT_TRUE(contains(message, "File too large")) << message << " at " << limit;
            ASSERT_EQ(snapshot(), before) << "at " << limit;
        }
        EXPECT_EQ(write_limited(path, picture.bytes, picture.bytes.size()), kWritten);
        EXPECT_EQ(content_of(path), picture.bytes);
    }
}

}  // namespace
}  // namespace dewbow
