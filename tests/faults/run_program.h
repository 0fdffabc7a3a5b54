// SPDX-License-Identifier: Apache-2.0
#pragma once

// The program dewbow as its users see it: run in a folder of its own, with what it said and left
// behind.

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace dewbow::faults {

/// How a run of the program ended.
struct Outcome {
    int exit_code = -1;  ///< -1: it did not end by itself
    int signal = 0;      ///< that ended it; SIGKILL where it ran for longer than kPatience
    double cpu_seconds = 0.0;
    std::string standard_output, standard_error;
};

/// In seconds of the wall. Much above what a run may take, because the machine may be busy.
inline constexpr double kPatience = 60.0;

/// How it is started.
struct Start {
    bool as_nobody = false;  ///< with other users' rights, where this process may take them
    std::vector<std::string> environment = {};  ///< NAME=value, beside this process's own
    /// Called in the new process last of all, to take its limits or streams away. False: do not
    /// start.
    std::function<bool()> prepare = {};
};

/// A program that runs in `folder`, without input, until it ends or is killed with this object.
class Program {
public:
    Program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
            const std::filesystem::path& folder, const Start& start = {});
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    int pid() const { return pid_; }
    /// Only before wait().
    void send(int signal) const;
    bool runs() const;
    Outcome wait();

private:
    struct Pipes;
    std::unique_ptr<Pipes> pipes_;
    int pid_ = -1;
};

/// Runs `program` with `arguments` in `folder`, without input, to its end.
Outcome run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                    const std::filesystem::path& folder, const Start& start = {});

/// The program of this name that a shell would find; empty if there is none.
std::filesystem::path find_tool(const std::string& name);

/// A temporary folder that is gone at the end.
class Folder {
public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// Folders on the way to `name` are made.
    void put(const std::string& name, std::string_view bytes) const;
    /// All that is in it: files with their bytes, links with their target.
    std::map<std::string, std::string> snapshot() const;

private:
    std::filesystem::path path_;
};

/// What is wrong with how the program answered wrong input, a line for each fault; empty if it
/// ended with `exit_code` soon and by itself, and said so in one short error that is fit for a
/// terminal and contains `phrases`.
std::string faults_of_answer(const Outcome& outcome, int exit_code,
                             const std::vector<std::string>& phrases);

}  // namespace dewbow::faults
