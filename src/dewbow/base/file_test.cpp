// SPDX-License-Identifier: Apache-2.0
#include "dewbow/base/file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <functional>
#include <thread>
#include <vector>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

namespace fs = std::filesystem;

// Root may write anywhere; tests of permissions become this user ("nobody" on most systems).
constexpr uid_t kNobody = 65534;

class FileTest : public testing::Test {
protected:
    FileTest() {
        std::string pattern = (fs::temp_directory_path() / "dewbow_file_test_XXXXXX").string();
        folder_ = mkdtemp(pattern.data());
    }
    ~FileTest() override {
        fs::permissions(folder_, fs::perms::owner_all);
        fs::remove_all(folder_);
    }

    fs::path at(const std::string& name) const { return folder_ / name; }
    static void put(const fs::path& path, const std::string& text) {
        std::ofstream(path, std::ios::binary) << text;
    }
    static std::string get(const fs::path& path) {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    /// Number of entries of the folder: tells temporary files that were left behind.
    std::ptrdiff_t entries() const {
        return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
    }
    static mode_t mode_of(const fs::path& path) {
        struct stat info {};
        EXPECT_EQ(::stat(path.c_str(), &info), 0);
        return info.st_mode & 07777;
    }

    fs::path folder_;
};

/// What the InputError thrown by `action` says; empty if it throws none.
std::string error_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

/// What `action` says, run in a process of its own that changed something for itself beforehand.
/// "skip" if that was not allowed.
std::string error_in_child(const std::function<bool()>& prepare,
                           const std::function<void()>& action) {
    int ends[2];
    EXPECT_EQ(pipe(ends), 0);
    const pid_t child = fork();
    if (child == 0) {
        const std::string said = prepare() ? error_of(action) : "skip";
        const bool sent = write(ends[1], said.data(), said.size()) >= 0;
        _exit(sent ? 0 : 1);
    }
    close(ends[1]);
    std::string said;
    char buffer[4096];
    for (ssize_t n; (n = read(ends[0], buffer, sizeof buffer)) > 0;)
        said.append(buffer, static_cast<std::size_t>(n));
    close(ends[0]);
    int status = 0;
    EXPECT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "the child died";
    return said;
}

bool become_nobody() { return geteuid() != 0 || (setgid(kNobody) == 0 && setuid(kNobody) == 0); }

#define EXPECT_SAYS(text, part) EXPECT_NE(std::string(text).find(part), std::string::npos) << text

// ---- reading -----------------------------------------------------------------------------------

TEST_F(FileTest, ReadsBytesAsTheyAre) {
    for (const std::size_t size : {0u, 1u, 4095u, 4096u, 4097u, 1'000'000u}) {
        std::string bytes(size, '\0');
        for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<char>(i * 37 + i / 251);
        put(at("a"), bytes);
        EXPECT_TRUE(read_file(at("a")) == bytes) << size;
    }
}

TEST_F(FileTest, ReadsFilesOfUnknownSize) { EXPECT_FALSE(read_file("/proc/self/maps").empty()); }

TEST_F(FileTest, ReadLimitIsExact) {
    put(at("a"), "12345");
    EXPECT_EQ(read_file(at("a"), 5), "12345");
    EXPECT_SAYS(error_of([&] { read_file(at("a"), 4); }), "limit of 4 bytes");
    EXPECT_SAYS(error_of([&] { read_file("/proc/self/maps", 10); }), "limit of 10 bytes");
}

TEST_F(FileTest, HugeFileIsRefusedBeforeMemoryIsTaken) {
    put(at("huge"), "x");
    fs::resize_file(at("huge"), std::uintmax_t{1} << 40);  // sparse
    EXPECT_SAYS(error_of([&] { read_file(at("huge")); }), "1099511627776 bytes are larger");
}

TEST_F(FileTest, ReadRefusesWhatIsNoFileWithoutWaiting) {
    ASSERT_EQ(mkfifo(at("fifo").c_str(), 0600), 0);
    EXPECT_SAYS(error_of([&] { read_file(at("fifo")); }), "it is a FIFO");
    EXPECT_SAYS(error_of([&] { read_file(folder_); }), "it is a folder");
    EXPECT_SAYS(error_of([&] { read_file("/dev/zero"); }), "it is a device");
    const std::string missing = error_of([&] { read_file(at("missing")); });
    EXPECT_SAYS(missing, "No such file");
    EXPECT_SAYS(missing, at("missing").string());
    EXPECT_SAYS(error_of([&] { read_file(""); }), "no file name");
}

TEST_F(FileTest, NameWithNulIsNotCutShort) {
    put(at("a"), "secret");
    const fs::path path = at(std::string("a\0b", 3));
    EXPECT_SAYS(error_of([&] { read_file(path); }), "NUL");
    EXPECT_SAYS(error_of([&] { write_file_atomically(path, "x"); }), "NUL");
    EXPECT_EQ(get(at("a")), "secret");
}

TEST_F(FileTest, ReadNamesMissingPermission) {
    put(at("a"), "x");
    ASSERT_EQ(chmod(folder_.c_str(), 0755), 0);
    ASSERT_EQ(chmod(at("a").c_str(), 0), 0);
    EXPECT_SAYS(error_in_child(become_nobody, [&] { read_file(at("a")); }), "Permission denied");
}

// ---- writing -----------------------------------------------------------------------------------

TEST_F(FileTest, WritesNewAndOverOld) {
    const std::string bytes = std::string("a\0b", 3) + std::string(3'000'000, 'c');
    for (int i = 0; i < 2; ++i) {
        write_file_atomically(at("a"), bytes);
        EXPECT_TRUE(get(at("a")) == bytes);
    }
    write_file_atomically(at("a"), "");
    EXPECT_EQ(get(at("a")), "");
    EXPECT_EQ(entries(), 1);
}

TEST_F(FileTest, ReadersSeeOldOrNewNeverAPart) {
    const std::string one(200'000, '1'), two(200'000, '2');
    write_file_atomically(at("a"), one);
    std::atomic<bool> stop{false};
    int parts = 0;
    std::thread reader([&] {
        while (!stop) {
            const std::string seen = read_file(at("a"));
            if (seen != one && seen != two) ++parts;
        }
    });
    for (int i = 0; i < 50; ++i) write_file_atomically(at("a"), i % 2 ? one : two);
    stop = true;
    reader.join();
    EXPECT_EQ(parts, 0);
}

TEST_F(FileTest, RelativeNamesWork) {
    const fs::path before = fs::current_path();
    fs::current_path(folder_);
    write_file_atomically("bare", "x");
    fs::current_path(before);
    EXPECT_EQ(get(at("bare")), "x");
}

TEST_F(FileTest, LongestNameWorks) {
    const std::string name(255, 'n');
    write_file_atomically(at(name), "x");
    EXPECT_EQ(get(at(name)), "x");
    EXPECT_SAYS(error_of([&] { write_file_atomically(at(name + "n"), "x"); }), "too long");
    EXPECT_EQ(entries(), 1);
}

TEST_F(FileTest, ModeFollowsUmaskThenStays) {
    const mode_t before = umask(027);
    write_file_atomically(at("a"), "x");
    EXPECT_EQ(mode_of(at("a")), 0640u);
    ASSERT_EQ(chmod(at("a").c_str(), 0604), 0);
    write_file_atomically(at("a"), "y");
    EXPECT_EQ(mode_of(at("a")), 0604u);
    umask(before);
}

TEST_F(FileTest, SymbolicLinksAreFollowedAndStay) {
    fs::create_directory(at("d"));
    put(at("d/real"), "old");
    fs::create_symlink("d/real", at("link"));
    fs::create_symlink("link", at("link2"));
    write_file_atomically(at("link2"), "new");
    EXPECT_TRUE(fs::is_symlink(at("link")) && fs::is_symlink(at("link2")));
    EXPECT_EQ(get(at("d/real")), "new");

    fs::create_symlink("d/created", at("dangling"));
    write_file_atomically(at("dangling"), "made");
    EXPECT_EQ(get(at("d/created")), "made");
    EXPECT_TRUE(fs::is_symlink(at("dangling")));

    fs::create_symlink("circle", at("circle"));
    EXPECT_SAYS(error_of([&] { write_file_atomically(at("circle"), "x"); }), "symbolic link");
}

TEST_F(FileTest, FullDeviceIsAnError) {
    if (access("/dev/full", W_OK) != 0) GTEST_SKIP() << "no /dev/full here";
    EXPECT_SAYS(error_of([] { write_file_atomically("/dev/full", "x"); }), "No space left");
    EXPECT_EQ(error_of([] { write_file_atomically("/dev/null", "x"); }), "");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(FileTest, FifoReceivesTheBytesAndStaysAFifo) {
    ASSERT_EQ(mkfifo(at("fifo").c_str(), 0600), 0);
    std::string seen;
    std::thread reader([&] { seen = get(at("fifo")); });
    const std::string bytes(300'000, 'x');  // more than a pipe holds
    write_file_atomically(at("fifo"), bytes);
    reader.join();
    EXPECT_TRUE(seen == bytes);
    EXPECT_TRUE(fs::is_fifo(at("fifo")));
}

TEST_F(FileTest, ReaderThatGoesAwayIsAnErrorNotASignal) {
    ASSERT_EQ(mkfifo(at("fifo").c_str(), 0600), 0);
    std::thread reader([&] {
        const int fd = open(at("fifo").c_str(), O_RDONLY);
        char byte;
        EXPECT_EQ(read(fd, &byte, 1), 1);
        close(fd);
    });
    const std::string bytes(3'000'000, 'x');
    const std::string said = error_of([&] { write_file_atomically(at("fifo"), bytes); });
    reader.join();
    EXPECT_SAYS(said, "Broken pipe");
    sigset_t pending;
    sigpending(&pending);
    EXPECT_EQ(sigismember(&pending, SIGPIPE), 0);
}

TEST_F(FileTest, OpenFileOfTheProcessIsAppendedTo) {
    put(at("redirected"), "before ");
    const int fd = open(at("redirected").c_str(), O_WRONLY);
    write_file_atomically("/proc/self/fd/" + std::to_string(fd), "after");
    close(fd);
    EXPECT_EQ(get(at("redirected")), "before after");
}

// ---- every failure names path and reason, keeps the old file, leaves nothing behind
// ---------------

TEST_F(FileTest, WrongTargetsAreRefusedBeforehandToo) {
    put(at("file"), "old");
    fs::create_directory(at("d"));
    const std::vector<std::pair<fs::path, std::string>> cases{
        {at("missing/a"), "No such file"}, {at("file/a"), "is not a folder"},
        {at("d"), "it is a folder"},       {at("d/"), "it is a folder"},
        {at("new/"), "ends in a slash"},   {"", "no file name"}};
    for (const auto& [path, reason] : cases) {
        const std::string said = error_of([&] { write_file_atomically(path, "x"); });
        EXPECT_SAYS(said, reason);
        EXPECT_SAYS(said, path.string());
        EXPECT_EQ(error_of([&] { check_writable(path); }), said);
    }
    EXPECT_EQ(get(at("file")), "old");
    EXPECT_EQ(entries(), 2);
}

TEST_F(FileTest, CheckWritableWritesNothing) {
    put(at("file"), "old");
    check_writable(at("file"));
    check_writable(at("new"));
    check_writable("/dev/null");
    EXPECT_EQ(get(at("file")), "old");
    EXPECT_EQ(entries(), 1);
}

TEST_F(FileTest, ReadOnlyFolderIsRefused) {
    put(at("file"), "old");
    ASSERT_EQ(chmod(at("file").c_str(), 0666), 0);
    ASSERT_EQ(chmod(folder_.c_str(), 0555), 0);
    for (const char* name : {"file", "new"}) {
        const auto write = [&] { write_file_atomically(at(name), "x"); };
        const auto check = [&] { check_writable(at(name)); };
        EXPECT_SAYS(error_in_child(become_nobody, write), "Permission denied");
        EXPECT_SAYS(error_in_child(become_nobody, check), "Permission denied");
    }
    EXPECT_EQ(get(at("file")), "old");
    EXPECT_EQ(entries(), 1);
}

TEST_F(FileTest, WriteProtectedFileIsRefused) {
    put(at("file"), "old");
    ASSERT_EQ(chmod(at("file").c_str(), 0444), 0);
    ASSERT_EQ(chmod(folder_.c_str(), 0777), 0);
    const auto write = [&] { write_file_atomically(at("file"), "x"); };
    EXPECT_SAYS(error_in_child(become_nobody, write), "Permission denied");
    EXPECT_EQ(get(at("file")), "old");
    EXPECT_EQ(entries(), 1);
}

TEST_F(FileTest, FileSizeLimitIsAnError) {
    put(at("file"), "old");
    const auto limit_files = [] {
        std::signal(SIGXFSZ, SIG_IGN);  // as main does
        const rlimit limit{1000, 1000};
        return setrlimit(RLIMIT_FSIZE, &limit) == 0;
    };
    const auto write = [&] { write_file_atomically(at("file"), std::string(5000, 'x')); };
    EXPECT_SAYS(error_in_child(limit_files, write), "File too large");
    EXPECT_EQ(get(at("file")), "old");
    EXPECT_EQ(entries(), 1);
}

TEST_F(FileTest, FullDiskIsAnError) {
    // A file system of 64 kB, in a mount namespace of the child's own.
    const auto mount_small = [&] {
        if (unshare(CLONE_NEWNS) != 0 && unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return false;
        mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr);
        return mount("tmpfs", folder_.c_str(), "tmpfs", 0, "size=64k") == 0;
    };
    const auto write = [&] {
        write_file_atomically(at("file"), "old");
        const std::string said =
            error_of([&] { write_file_atomically(at("file"), std::string(1'000'000, 'x')); });
        throw InputError(said + (get(at("file")) == "old" ? " kept" : "") +
                         (entries() == 1 ? " clean" : ""));
    };
    const std::string said = error_in_child(mount_small, write);
    if (said == "skip") GTEST_SKIP() << "mounting is not allowed here";
    EXPECT_SAYS(said, "No space left on device kept clean");
}

// ---- references --------------------------------------------------------------------------------

class ResolveTest : public FileTest {
protected:
    ResolveTest() {
        fs::create_directories(at("scene/textures"));
        put(at("scene/textures/wood.png"), "wood");
        put(at("secret"), "secret");
        put(at("scene-other"), "a folder whose name begins alike");
    }
    std::string said(std::string_view reference) const {
        return error_of([&] { resolve_inside(at("scene"), reference); });
    }
    fs::path real(const std::string& name) const { return fs::canonical(folder_) / name; }
};

TEST_F(ResolveTest, FindsWhatLiesInside) {
    const fs::path wood = real("scene/textures/wood.png");
    for (const char* reference : {"textures/wood.png", "./textures/wood.png",
                                  "textures/../textures/wood.png", "textures//wood.png"})
        EXPECT_EQ(resolve_inside(at("scene"), reference), wood) << reference;
    EXPECT_EQ(resolve_inside(at("scene/"), "textures/wood.png"), wood);
    EXPECT_EQ(resolve_inside(at("scene"), "missing.png"), real("scene/missing.png"));
    EXPECT_EQ(resolve_inside(at("scene"), "textures/a:b"), real("scene/textures/a:b"));
    EXPECT_EQ(resolve_inside(at("scene"), "..."), real("scene/..."));
    EXPECT_EQ(resolve_inside(at("scene"), "%2e%2e/secret"), real("scene/%2e%2e/secret"));

    const fs::path before = fs::current_path();
    fs::current_path(at("scene"));
    EXPECT_EQ(resolve_inside("", "textures/wood.png"), wood);
    EXPECT_EQ(resolve_inside(".", "textures/wood.png"), wood);
    fs::current_path(before);
}

TEST_F(ResolveTest, RefusesWhatLeadsOut) {
    EXPECT_SAYS(said(""), "is empty");
    EXPECT_SAYS(said("/etc/passwd"), "is absolute");
    EXPECT_SAYS(said("//host/share"), "is absolute");
    EXPECT_SAYS(said("file:///etc/passwd"), "has a scheme");
    EXPECT_SAYS(said("http://example.org/a.png"), "has a scheme");
    EXPECT_SAYS(said("FILE:a"), "has a scheme");
    EXPECT_SAYS(said("C:a"), "has a scheme");
    EXPECT_SAYS(said("..\\secret"), "backslash");
    EXPECT_SAYS(said(std::string_view("a\0b", 3)), "NUL");
    for (const char* reference :
         {"..", "../secret", "textures/../../secret", "./../scene-other", "a/../../scene/x"})
        EXPECT_SAYS(said(reference), "leads out of the scene's folder");
}

TEST_F(ResolveTest, RefusesSymbolicLinksOut) {
    fs::create_symlink("../secret", at("scene/link"));
    fs::create_symlink("/", at("scene/root"));
    fs::create_symlink("../scene-other", at("scene/other"));
    fs::create_symlink("textures/wood.png", at("scene/inside"));
    for (const char* reference : {"link", "root/etc/passwd", "other", "root/missing"})
        EXPECT_SAYS(said(reference), "by a symbolic link");
    EXPECT_EQ(resolve_inside(at("scene"), "inside"), real("scene/textures/wood.png"));

    fs::create_symlink("circle", at("scene/circle"));
    EXPECT_SAYS(said("circle"), "circle");
}

TEST_F(ResolveTest, FolderMustExist) {
    EXPECT_SAYS(error_of([&] { resolve_inside(at("missing"), "a"); }), "No such file");
}

}  // namespace
}  // namespace dewbow
