// SPDX-License-Identifier: Apache-2.0
#include "dewbow/base/process_identity.h"

#include <signal.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "dewbow/base/error.h"
#include "dewbow/base/file.h"

namespace dewbow {

namespace {

/// Empty where the kernel does not tell.
std::string proc_text(const std::string& path) {
    constexpr std::uint64_t kMostBytes = 1 << 16;
    try {
        std::string text = read_file(path, kMostBytes);
        while (text.ends_with('\n')) text.pop_back();
        return text;
    } catch (const InputError&) {
        return {};
    }
}

struct ProcessStat {
    char state = '?';  ///< 'Z' has ended and is waited for by its parent, 'X' is about to vanish
    std::uint64_t start_ticks = 0;
};

/// Fields 3 and 22 of /proc/PID/stat, counted from 1. [proc(5)]
ProcessStat stat_of(std::int64_t pid) {
    const std::string text = proc_text("/proc/" + std::to_string(pid) + "/stat");
    // The second field is a name in parentheses that may itself hold spaces and parentheses.
    const std::size_t name_end = text.rfind(')');
    if (name_end == std::string::npos || name_end + 2 >= text.size()) return {};
    std::string_view rest = std::string_view(text).substr(name_end + 2);
    ProcessStat stat{rest.front(), 0};
    for (int field = 3; field < 22; ++field) {
        const std::size_t space = rest.find(' ');
        if (space == std::string_view::npos) return stat;
        rest.remove_prefix(space + 1);
    }
    std::from_chars(rest.data(), rest.data() + rest.size(), stat.start_ticks);
    return stat;
}

std::string own_pid_namespace() {
    std::error_code error;
    return std::filesystem::read_symlink("/proc/self/ns/pid", error).string();
}

}  // namespace

ProcessIdentity this_process() {
    utsname names{};
    ::uname(&names);
    return {names.nodename, proc_text("/proc/sys/kernel/random/boot_id"), own_pid_namespace(),
            ::getpid(), stat_of(::getpid()).start_ticks};
}

Life life_of(const ProcessIdentity& process) {
    const ProcessIdentity here = this_process();
    if (process.host != here.host || process.pid <= 0) return Life::unknown;
    if (process.boot != here.boot) return Life::ended;
    if (process.pid_namespace != here.pid_namespace) return Life::unknown;
    if (::kill(static_cast<pid_t>(process.pid), 0) != 0 && errno == ESRCH) return Life::ended;
    const ProcessStat now = stat_of(process.pid);
    if (now.state == 'Z' || now.state == 'X') return Life::ended;
    const bool another =
        now.start_ticks != 0 && process.start_ticks != 0 && now.start_ticks != process.start_ticks;
    return another ? Life::ended : Life::lives;
}

}  // namespace dewbow
