// SPDX-License-Identifier: Apache-2.0
#pragma once

// The program dewbow as its users see it: run in a folder of its own, with what it said and left
// behind.

#include <filesystem>
#include <map>
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

/// Runs `program` with `arguments` in `folder`, without input. Other users' rights are those of
/// "nobody", where this process may take them.
Outcome run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                    const std::filesystem::path& folder, bool as_nobody = false);

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
