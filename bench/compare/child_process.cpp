// SPDX-License-Identifier: Apache-2.0
#include "child_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <sstream>

#include "dewbow/base/error.h"
#include "dewbow/base/file.h"
#include "scratch_folder.h"

extern char** environ;

namespace dewbow::bench {
namespace {

constexpr const char* kLog = "log.txt";
/// Linux counts resident memory in KiB.
constexpr double kMiB_per_KiB = 1.0 / 1024.0;

class SpawnActions {
public:
    explicit SpawnActions(const std::filesystem::path& folder) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
        posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, kLog,
                                         O_WRONLY | O_CREAT | O_TRUNC, 0644);
        posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
    }
    ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }
    SpawnActions(const SpawnActions&) = delete;
    SpawnActions& operator=(const SpawnActions&) = delete;
    const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
    posix_spawn_file_actions_t actions_{};
};

double seconds(timeval t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); }

}  // namespace

ChildUsage run_child(const std::vector<std::string>& words, const std::filesystem::path& folder) {
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const SpawnActions actions(folder);

    const auto start = std::chrono::steady_clock::now();
    pid_t child = 0;
    const int failure = posix_spawn(&child, arguments[0], actions.get(), nullptr, arguments.data(), environ);
    if (failure != 0)
        throw InputError("cannot start '" + words[0] + "': " + std::strerror(failure));
    int status = 0;
    rusage usage{};
    while (wait4(child, &status, 0, &usage) < 0)
        if (errno != EINTR) throw InputError("cannot wait for '" + words[0] + "'");
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    return {seconds(usage.ru_utime) + seconds(usage.ru_stime), wall.count(),
            double(usage.ru_maxrss) * kMiB_per_KiB,
            WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status)};
}

std::string log_tail(const std::filesystem::path& folder) {
    constexpr std::size_t kMost = 600;
    const std::string log = read_file(folder / kLog);
    return log.size() <= kMost ? log : log.substr(log.size() - kMost);
}

std::string first_line_of(const std::vector<std::string>& words) {
    const ScratchFolder folder;
    run_child(words, folder.path());
    std::istringstream log(read_file(folder.path() / kLog));
    std::string line;
    while (std::getline(log, line) && line.empty()) {
    }
    return line;
}

}  // namespace dewbow::bench
