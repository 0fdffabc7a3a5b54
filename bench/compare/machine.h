// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the benchmark runs on.

#include <string>

namespace dewbow::bench {

struct Machine {
    std::string processor;  ///< as /proc/cpuinfo names it
    int threads = 1;        ///< of the hardware, that this process may use
    double memory_GiB = 0.0;
    std::string system;  ///< kernel and release
    std::string time;    ///< UTC, ISO 8601
};
Machine this_machine();

/// Processes that want to run, mean of the last minute (/proc/loadavg); 0 where that is not known.
double load_average();

}  // namespace dewbow::bench
