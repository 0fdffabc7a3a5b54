// SPDX-License-Identifier: Apache-2.0
#include "child_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <thread>

#include "dewbow/base/error.h"
#include "dewbow/base/file.h"
#include "scratch_folder.h"

extern char** environ;

namespace dewbow::bench {
namespace {

constexpr const char* kLog = "log.txt";

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

/// This program's environment, but for the folder: some programs believe PWD.
std::vector<std::string> environment_in(const std::filesystem::path& folder) {
    std::vector<std::string> variables{"PWD=" + folder.string()};
    for (char** variable = environ; *variable; ++variable)
        if (std::strncmp(*variable, "PWD=", 4) != 0) variables.emplace_back(*variable);
    return variables;
}

std::vector<char*> pointers_to(std::vector<std::string>& words) {
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    return pointers;
}

/// Asks again and again how much memory a process has had at most. (What wait4 says of it is of no
/// use: there a child begins with the peak of its parent.)
class PeakMemory {
public:
    explicit PeakMemory(pid_t process)
        : watch_([this, process](const std::stop_token& stop) {
              while (!stop.stop_requested()) {
                  look(process);
                  std::this_thread::sleep_for(std::chrono::milliseconds(5));
              }
          }) {}
    double stop_MiB() {
        watch_.request_stop();
        watch_.join();
        return double(peak_KiB_) / 1024.0;
    }

private:
    void look(pid_t process) {
        std::ifstream status("/proc/" + std::to_string(process) + "/status");
        for (std::string line; std::getline(status, line);)
            if (line.rfind("VmHWM:", 0) == 0)
                peak_KiB_ = std::max(peak_KiB_, std::atol(line.c_str() + 6));
    }
    long peak_KiB_ = 0;
    std::jthread watch_;
};

double seconds(timeval t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); }

}  // namespace

ChildUsage run_child(const std::vector<std::string>& words, const std::filesystem::path& folder) {
    std::vector<std::string> own_words = words, variables = environment_in(folder);
    const std::vector<char*> arguments = pointers_to(own_words),
                             environment = pointers_to(variables);
    const SpawnActions actions(folder);

    const auto start = std::chrono::steady_clock::now();
    pid_t child = 0;
    const int failure = posix_spawn(&child, arguments[0], actions.get(), nullptr, arguments.data(),
                                    environment.data());
    if (failure != 0)
        throw InputError("cannot start '" + words[0] + "': " + std::strerror(failure));
    PeakMemory peak(child);
    int status = 0;
    rusage usage{};
    while (wait4(child, &status, 0, &usage) < 0)
        if (errno != EINTR) throw InputError("cannot wait for '" + words[0] + "'");
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    return {seconds(usage.ru_utime) + seconds(usage.ru_stime), wall.count(), peak.stop_MiB(),
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
