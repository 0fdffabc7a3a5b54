// SPDX-License-Identifier: Apache-2.0
#pragma once

// How far a long job has come: a bar with the time left on a terminal, whole lines elsewhere, JSON
// lines for programs.

#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <mutex>
#include <string>

namespace dewbow {

enum class ProgressStyle { automatic, bar, plain, json, none };

class Progress {
public:
    /// @param title  what is being done ("render ring.glb").  @param total  units of work; > 0.
    /// `automatic` is a bar if `stream` is a terminal and TERM is not "dumb", else plain.
    Progress(std::string title, std::uint64_t total, ProgressStyle style,
             std::FILE* stream = stderr);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Adds finished units; any thread. Prints at most ten times a second (plain and JSON: every 5
    /// % and at most every second).
    void advance(std::uint64_t units = 1);
    /// Counts units that were finished before: they say nothing about the time that is left.
    void skip(std::uint64_t units);
    /// Ends the display with what is done by then; called by the destructor if it was not. A job
    /// that was given up so ends below 100 %.
    void finish();

private:
    void print(bool last);

    using Clock = std::chrono::steady_clock;
    const std::string title_;
    const std::uint64_t total_;
    ProgressStyle style_;
    std::FILE* stream_;
    const Clock::time_point start_ = Clock::now();
    std::atomic<std::uint64_t> done_{0}, skipped_{0};
    std::mutex printing_;
    Clock::time_point last_print_{};
    int last_percent_ = -1;
    bool finished_ = false;
};

/// "1:02:03" or "4:05"
std::string format_duration(std::chrono::duration<double> duration);

}  // namespace dewbow
