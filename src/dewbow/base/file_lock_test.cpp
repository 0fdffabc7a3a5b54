// SPDX-License-Identifier: Apache-2.0
#include "dewbow/base/file_lock.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <functional>
#include <iterator>
#include <thread>
#include <vector>

#include "dewbow/base/error.h"
#include "dewbow/base/process_identity.h"
#include "dewbow/base/temporary_file.h"

namespace dewbow {
namespace {

namespace fs = std::filesystem;

class FileLockTest : public testing::Test {
protected:
    void SetUp() override {
        std::string pattern = (fs::path(testing::TempDir()) / "dewbow_lock_XXXXXX").string();
        ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
        folder_ = pattern;
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path at(const std::string& name) const { return folder_ / name; }
    int entries() const {
        return static_cast<int>(
            std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }
    std::string text_of(const std::string& name) const {
        std::ifstream file(at(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    fs::path folder_;
};

std::string refusal_of(const fs::path& path) {
    try {
        const FileLock lock(path);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

bool says(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Runs `work` in another process, which then waits to be killed; gives its number and stands for
/// its end.
class OtherProcess {
public:
    explicit OtherProcess(const std::function<void()>& work) {
        int ends[2];
        EXPECT_EQ(::pipe(ends), 0);
        pid_ = ::fork();
        if (pid_ == 0) {
            work();
            if (::write(ends[1], "x", 1) == 1) ::pause();
            ::_exit(1);
        }
        char byte = 0;
        EXPECT_EQ(::read(ends[0], &byte, 1), 1);
        ::close(ends[0]);
        ::close(ends[1]);
    }
    ~OtherProcess() { kill_and_wait(); }
    pid_t pid() const { return pid_; }
    void kill_only() const { ::kill(pid_, SIGKILL); }
    void kill_and_wait() {
        if (pid_ > 0) ::kill(pid_, SIGKILL), ::waitpid(pid_, nullptr, 0);
        pid_ = -1;
    }

private:
    pid_t pid_;
};

TEST_F(FileLockTest, NamesItsProcessAndIsGoneAtTheEnd) {
    {
        const FileLock lock(at("ring.exr"));
        EXPECT_EQ(lock.remark(), "");
        EXPECT_EQ(lock_file_of(at("ring.exr")), at(".ring.exr.lock"));
        EXPECT_TRUE(says(text_of(".ring.exr.lock"), "pid " + std::to_string(::getpid()) + "\n"));
        EXPECT_EQ(entries(), 1);
    }
    EXPECT_EQ(entries(), 0);
}

TEST_F(FileLockTest, SecondProcessIsRefusedUntilTheFirstEnds) {
    OtherProcess first([&] { new FileLock(at("ring.exr")); });
    const std::string refusal = refusal_of(at("ring.exr"));
    EXPECT_TRUE(says(refusal, at("ring.exr").string())) << refusal;
    EXPECT_TRUE(says(refusal, "number " + std::to_string(first.pid()))) << refusal;
    EXPECT_TRUE(says(refusal, "on " + this_process().host + ", since 2")) << refusal;
    EXPECT_EQ(refusal_of(at("other.exr")), "");
    EXPECT_EQ(entries(), 1);

    const pid_t pid = first.pid();
    first.kill_and_wait();
    EXPECT_EQ(entries(), 1);
    const FileLock second(at("ring.exr"));
    EXPECT_TRUE(says(second.remark(), "number " + std::to_string(pid))) << second.remark();
    EXPECT_TRUE(says(text_of(".ring.exr.lock"), "pid " + std::to_string(::getpid()) + "\n"));
}

TEST_F(FileLockTest, LinksToOneFileAreOneFile) {
    fs::create_directory(at("d"));
    fs::create_symlink("d/ring.exr", at("link.exr"));
    const FileLock lock(at("link.exr"));
    EXPECT_TRUE(says(refusal_of(at("d/ring.exr")), "another process writes"));
    EXPECT_EQ(refusal_of(at("ring.exr")), "");
    fs::current_path(folder_);
    EXPECT_EQ(lock_files({"a.exr", "./a.exr"}).size(), 1u);
    fs::current_path("/");
    EXPECT_EQ(lock_files({at("a.exr"), at("d/../a.exr"), at("b.exr")}).size(), 2u);
}

TEST_F(FileLockTest, DevicesAndFifosAreNotLocked) {
    ASSERT_EQ(::mkfifo(at("fifo").c_str(), 0600), 0);
    fs::create_symlink("/dev/null", at("null"));
    for (const char* name : {"fifo", "null"}) {
        const FileLock first(at(name)), second(at(name));
        EXPECT_EQ(lock_file_of(at(name)), "");
    }
    EXPECT_EQ(lock_files({at("null"), at("fifo")}).size(), 0u);
    EXPECT_EQ(entries(), 2);
}

TEST_F(FileLockTest, WhatAKilledProcessLeftIsRemovedAndNothingElse) {
    const fs::path before = fs::current_path();
    fs::current_path(folder_);
    for (const fs::path& name : {at("ring.exr"), fs::path("ring.exr")}) {
        OtherProcess first([&] {
            new FileLock(name);
            new TemporaryFile(folder_);
        });
        const TemporaryFile alive(folder_);
        first.kill_and_wait();
        EXPECT_EQ(entries(), 3);
        const FileLock second(name);
        EXPECT_EQ(entries(), 2);
    }
    fs::current_path(before);
}

TEST_F(FileLockTest, WhatAKilledProcessLeftInTheCurrentFolderIsRemoved) {
    fs::current_path(folder_);
    OtherProcess first([&] {
        new FileLock("ring.exr");
        new TemporaryFile("");
    });
    first.kill_and_wait();
    EXPECT_EQ(entries(), 2);
    { const FileLock second("ring.exr"); }
    EXPECT_EQ(entries(), 0);
    fs::current_path("/");
}

TEST_F(FileLockTest, DamagedLockFilesLockNothing) {
    for (const std::string text :
         {"", "pid", "pid x\nhost\n", "\n\n", "pid 99999999999999999999\n"}) {
        std::ofstream(at(".ring.exr.lock"), std::ios::binary) << text;
        EXPECT_EQ(refusal_of(at("ring.exr")), "") << text;
        EXPECT_EQ(entries(), 0);
    }
}

TEST_F(FileLockTest, DamagedLockFileOfALivingProcessStillLocks) {
    std::ofstream(at(".ring.exr.lock")) << "nonsense";
    const Descriptor file = open_retrying(at(".ring.exr.lock"), O_RDWR);
    ASSERT_EQ(::flock(file.number(), LOCK_EX | LOCK_NB), 0);
    EXPECT_TRUE(says(refusal_of(at("ring.exr")), "left no name"));
}

TEST_F(FileLockTest, WhatIsNoLockFileIsNotTouched) {
    fs::create_directory(at(".ring.exr.lock"));
    EXPECT_TRUE(says(refusal_of(at("ring.exr")), "cannot make the lock file"));
    fs::remove(at(".ring.exr.lock"));
    fs::create_symlink("precious", at(".ring.exr.lock"));
    std::ofstream(at("precious")) << "old";
    EXPECT_TRUE(says(refusal_of(at("ring.exr")), "cannot make the lock file"));
    EXPECT_EQ(text_of("precious"), "old");
}

TEST_F(FileLockTest, NamesAsLongAsNamesCanBe) {
    const std::string a(255, 'n'), b(255, 'm');
    const FileLock lock(at(a));
    EXPECT_EQ(lock.remark(), "");
    EXPECT_TRUE(says(refusal_of(at(a)), "another process writes"));
    EXPECT_EQ(refusal_of(at(b)), "");
}

/// flock belongs to the open file, so that threads contend as processes do.
TEST_F(FileLockTest, NeverTwoAtOnce) {
    constexpr int kThreads = 4, kRounds = 150;
    std::atomic<int> inside{0}, most{0}, taken{0};
    const auto contend = [&] {
        for (int round = 0; round < kRounds; ++round) {
            try {
                const FileLock lock(at("ring.exr"));
                const int now = ++inside;
                if (now > 1) most = now;
                ++taken;
                std::this_thread::yield();
                --inside;
            } catch (const InputError&) {
            }
        }
    };
    std::vector<std::thread> threads;
    for (int i = 0; i < kThreads; ++i) threads.emplace_back(contend);
    for (std::thread& thread : threads) thread.join();
    EXPECT_LE(most, 1);
    EXPECT_GE(taken, kRounds / 5);
}

TEST(ProcessIdentity, LifeOfProcesses) {
    const ProcessIdentity here = this_process();
    EXPECT_EQ(here.pid, ::getpid());
    EXPECT_NE(here.start_ticks, 0u);
    EXPECT_EQ(life_of(here), Life::lives);

    ProcessIdentity other = here;
    other.start_ticks += 1;  // the number was given to another process
    EXPECT_EQ(life_of(other), Life::ended);
    other = here, other.boot = "an earlier start of the kernel";
    EXPECT_EQ(life_of(other), Life::ended);
    other = here, other.host += "2";
    EXPECT_EQ(life_of(other), Life::unknown);
    other = here, other.pid_namespace = "pid:[1]";
    EXPECT_EQ(life_of(other), Life::unknown);
    EXPECT_EQ(life_of({}), Life::unknown);
}

TEST(ProcessIdentity, KilledProcessHasEndedEvenBeforeItsParentKnows) {
    OtherProcess child([] {});
    ProcessIdentity identity = this_process();
    identity.pid = child.pid();
    identity.start_ticks = 0;
    EXPECT_EQ(life_of(identity), Life::lives);
    child.kill_only();
    siginfo_t info;
    ASSERT_EQ(::waitid(P_PID, id_t(child.pid()), &info, WEXITED | WNOWAIT), 0);
    EXPECT_EQ(life_of(identity), Life::ended);
    child.kill_and_wait();
    EXPECT_EQ(life_of(identity), Life::ended);
}

}  // namespace
}  // namespace dewbow
