// SPDX-License-Identifier: Apache-2.0
#include "interrupt.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

namespace dewbow {

namespace {

std::atomic<bool> stop{false};
std::atomic<int> first_signal{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free,
              "only such may be touched in a signal handler");

extern "C" void on_stop_signal(int number) {
    int none = 0;
    if (!first_signal.compare_exchange_strong(none, number)) _exit(128 + number);
    stop.store(true);
}

void keep_standard_streams_open() {
    for (int stream = 0; stream <= 2; ++stream) {
        if (fcntl(stream, F_GETFD) >= 0) continue;
        // open() takes the lowest free number, which is this one.
        [[maybe_unused]] const int opened = open("/dev/null", stream == 0 ? O_RDONLY : O_WRONLY);
    }
}

}  // namespace

void prepare_signals() {
    keep_standard_streams_open();
    struct sigaction action {};
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    action.sa_handler = on_stop_signal;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    action.sa_handler = SIG_IGN;
    sigaction(SIGPIPE, &action, nullptr);
    sigaction(SIGXFSZ, &action, nullptr);
}

const std::atomic<bool>& stop_requested() { return stop; }

int interrupt_exit_code() {
    const int number = first_signal.load();
    return number == 0 ? 0 : 128 + number;
}

}  // namespace dewbow
