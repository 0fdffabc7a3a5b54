// SPDX-License-Identifier: Apache-2.0
#include "run_program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

namespace dewbow::faults {
namespace {

namespace fs = std::filesystem;

/// Of the processor, which other programs do not use up. Refusing takes a hundredth of it; a build
/// with sanitizers is slower.
constexpr double kMostCpuSeconds = 2.0;
constexpr int kMostLines = 12;
constexpr std::size_t kMostBytes = 4000;
/// "nobody" on Debian.
constexpr uid_t kNobody = 65534;
constexpr int kCannotStart = 127;

struct Pipe {
    Pipe() {
        int both[2];
        if (::pipe2(both, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
        read_end = both[0];
        write_end = both[1];
    }
    ~Pipe() {
        close_write_end();
        ::close(read_end);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    void close_write_end() {
        if (write_end >= 0) ::close(write_end);
        write_end = -1;
    }

    int read_end = -1, write_end = -1;
};

[[noreturn]] void become(const fs::path& program, std::vector<char*>& arguments,
                         const fs::path& folder, const Start& start, const Pipe& out,
                         const Pipe& err) {
    const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    for (const std::string& variable : start.environment)
        ::putenv(const_cast<char*>(variable.c_str()));
    const bool ready = ::dup2(nothing, 0) == 0 && ::dup2(out.write_end, 1) == 1 &&
                       ::dup2(err.write_end, 2) == 2 && ::chdir(folder.c_str()) == 0 &&
                       (!start.as_nobody || ::geteuid() != 0 || ::setuid(kNobody) == 0) &&
                       (!start.prepare || start.prepare());
    if (ready) ::execv(program.c_str(), arguments.data());
    ::_exit(kCannotStart);
}

/// Reads both pipes until the program closes them; false when patience is at its end.
bool collect(const Pipe& out, const Pipe& err, Outcome& outcome) {
    const auto deadline =
        std::chrono::steady_clock::now() + std::chrono::duration<double>(kPatience);
    std::array<pollfd, 2> ends{{{out.read_end, POLLIN, 0}, {err.read_end, POLLIN, 0}}};
    const std::array<std::string*, 2> texts{&outcome.standard_output, &outcome.standard_error};
    while (ends[0].fd >= 0 || ends[1].fd >= 0) {
        if (std::chrono::steady_clock::now() > deadline) return false;
        constexpr int kLookAgain_ms = 100;
        if (::poll(ends.data(), ends.size(), kLookAgain_ms) < 0 && errno != EINTR) return false;
        for (std::size_t i = 0; i < ends.size(); ++i) {
            if (ends[i].fd < 0 || ends[i].revents == 0) continue;
            std::array<char, 4096> buffer;
            const ssize_t count = ::read(ends[i].fd, buffer.data(), buffer.size());
            if (count > 0) texts[i]->append(buffer.data(), std::size_t(count));
            if (count == 0) ends[i].fd = -1;
        }
    }
    return true;
}

/// The number of lines that begin with `beginning`, of all if it is empty.
int count_lines(const std::string& text, std::string_view beginning) {
    int count = 0;
    for (std::size_t at = 0; at < text.size();) {
        if (text.compare(at, beginning.size(), beginning) == 0) ++count;
        const std::size_t end = text.find('\n', at);
        at = end == std::string::npos ? text.size() : end + 1;
    }
    return count;
}

/// By an independent way: the pattern of leading bits alone.
bool fit_for_terminal(const std::string& text) {
    int open = 0;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        const bool continues = (byte & 0xc0) == 0x80;
        if (continues != (open > 0)) return false;
        if (continues)
            --open;
        else if (byte < 0x80 ? byte < 0x20 && c != '\n' && c != '\t' : byte > 0xf4)
            return false;
        else
            open = byte < 0x80 ? 0 : byte < 0xe0 ? 1 : byte < 0xf0 ? 2 : 3;
    }
    return open == 0;
}

}  // namespace

struct Program::Pipes {
    Pipe out, err;
};

Program::Program(const fs::path& program, const std::vector<std::string>& arguments,
                 const fs::path& folder, const Start& start)
    : pipes_(std::make_unique<Pipes>()) {
    std::vector<std::string> words{program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);

    pid_ = ::fork();
    if (pid_ < 0) throw std::runtime_error("cannot fork");
    if (pid_ == 0) become(program, pointers, folder, start, pipes_->out, pipes_->err);
    pipes_->out.close_write_end();
    pipes_->err.close_write_end();
}

Program::~Program() {
    if (pid_ < 0) return;
    send(SIGKILL);
    ::waitpid(pid_, nullptr, 0);
}

void Program::send(int signal) const { ::kill(pid_, signal); }

bool Program::runs() const {
    siginfo_t info{};
    return pid_ > 0 && ::waitid(P_PID, id_t(pid_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           info.si_pid == 0;
}

Outcome Program::wait() {
    Outcome outcome;
    if (!collect(pipes_->out, pipes_->err, outcome)) send(SIGKILL);
    int status = 0;
    rusage usage{};
    while (::wait4(pid_, &status, 0, &usage) < 0 && errno == EINTR) continue;
    pid_ = -1;
    if (WIFEXITED(status)) outcome.exit_code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) outcome.signal = WTERMSIG(status);
    for (const timeval& time : {usage.ru_utime, usage.ru_stime})
        outcome.cpu_seconds += double(time.tv_sec) + 1e-6 * double(time.tv_usec);
    return outcome;
}

Outcome run_program(const fs::path& program, const std::vector<std::string>& arguments,
                    const fs::path& folder, const Start& start) {
    return Program(program, arguments, folder, start).wait();
}

fs::path find_tool(const std::string& name) {
    const char* variable = std::getenv("PATH");
    std::string_view folders = variable ? variable : "";
    while (!folders.empty()) {
        const std::string_view folder = folders.substr(0, folders.find(':'));
        const fs::path path = fs::path(folder) / name;
        if (::access(path.c_str(), X_OK) == 0) return path;
        folders.remove_prefix(std::min(folders.size(), folder.size() + 1));
    }
    return {};
}

Folder::Folder() {
    std::string pattern = (fs::path(testing::TempDir()) / "dewbow_faults_XXXXXX").string();
    if (!::mkdtemp(pattern.data())) throw std::runtime_error(std::strerror(errno));
    path_ = pattern;
    ::chmod(path_.c_str(), 0777);
}

Folder::~Folder() {
    std::error_code error;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path_, error))
        if (!entry.is_symlink() && entry.is_directory()) ::chmod(entry.path().c_str(), 0777);
    fs::remove_all(path_, error);
}

void Folder::put(const std::string& name, std::string_view bytes) const {
    fs::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << bytes;
}

std::map<std::string, std::string> Folder::snapshot() const {
    std::map<std::string, std::string> entries;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path_)) {
        std::string& what = entries[entry.path().string()];
        if (entry.is_symlink()) {
            what = "link to " + fs::read_symlink(entry.path()).string();
        } else if (entry.is_regular_file()) {
            std::ifstream file(entry.path(), std::ios::binary);
            what.assign(std::istreambuf_iterator<char>(file), {});
        } else {
            what = entry.is_directory() ? "folder" : "no file";
        }
    }
    return entries;
}

std::string faults_of_answer(const Outcome& outcome, int exit_code,
                             const std::vector<std::string>& phrases) {
    std::string faults;
    const auto fault = [&](bool is_one, const std::string& text) {
        if (is_one) faults += "  * " + text + "\n";
    };
    const std::string& error = outcome.standard_error;
    fault(outcome.signal != 0, fmt::format("it was ended by signal {}", outcome.signal));
    fault(outcome.exit_code != exit_code,
          fmt::format("it ended with {}, not with {}", outcome.exit_code, exit_code));
    fault(outcome.cpu_seconds > kMostCpuSeconds,
          fmt::format("it took {:.2f} s of the processor", outcome.cpu_seconds));
    fault(!outcome.standard_output.empty(), "it wrote to standard output");
    fault(count_lines(error, "dewbow: ") != 1, "its errors are not exactly one");
    fault(count_lines(error, "") > kMostLines || error.size() > kMostBytes, "its error is long");
    fault(!error.ends_with('\n') || error.ends_with("\n\n"),
          "its error does not end with its line");
    fault(!fit_for_terminal(error), "its error is not fit for a terminal");
    for (const char* word : {"terminate", "what()", "std::", "Sanitizer", "runtime error", "#0 ",
                             "dewbow::", "Assertion"})
        fault(error.find(word) != std::string::npos, fmt::format("it says \"{}\"", word));
    for (const std::string& phrase : phrases)
        fault(error.find(phrase) == std::string::npos, fmt::format("it does not say: {}", phrase));
    constexpr std::size_t kShown = 2000;
    return faults.empty() ? "" : faults + "It said:\n" + error.substr(0, kShown);
}

}  // namespace dewbow::faults
