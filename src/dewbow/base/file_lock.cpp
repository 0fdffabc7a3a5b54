// SPDX-License-Identifier: Apache-2.0
#include "dewbow/base/file_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "dewbow/base/error.h"
#include "dewbow/base/file.h"
#include "dewbow/base/hash.h"
#include "dewbow/base/parse_number.h"
#include "dewbow/base/process_identity.h"
#include "dewbow/base/temporary_file.h"

namespace dewbow {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 255;  // of ext4, XFS, Btrfs, NFS
constexpr std::uint64_t kMostLockBytes = 4096;
/// Each try ends at once; a lock that changes hands at every one of them does not exist.
constexpr int kTries = 100;

[[noreturn]] void fail(const fs::path& path, const std::string& what) {
    throw InputError(SourcePlace{path.string(), 0, 0, {}}, what);
}

/// What a lock file says.
struct Owner {
    ProcessIdentity process;
    std::string since;  ///< date and time, UTC
};

std::string now_utc() {
    const std::time_t now = std::time(nullptr);
    std::tm t{};
    gmtime_r(&now, &t);
    return fmt::format("{:04}-{:02}-{:02} {:02}:{:02}:{:02} UTC", t.tm_year + 1900, t.tm_mon + 1,
                       t.tm_mday, t.tm_hour, t.tm_min, t.tm_sec);
}

std::string text_of(const Owner& owner) {
    const ProcessIdentity& p = owner.process;
    return fmt::format(
        "dewbow lock 1\npid {}\nhost {}\nsince {}\nboot {}\npid_namespace {}\nstart_ticks {}\n",
        p.pid, p.host, owner.since, p.boot, p.pid_namespace, p.start_ticks);
}

/// The rest of the line that begins with `key` and a space; empty without one.
std::string_view value_of(std::string_view text, std::string_view key) {
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        if (line.starts_with(key) && line.substr(key.size()).starts_with(' '))
            return line.substr(key.size() + 1);
        text.remove_prefix(std::min(text.size(), line.size() + 1));
    }
    return {};
}

/// What is missing or damaged is empty or 0.
Owner owner_from(std::string_view text) {
    const auto word = [&](std::string_view key) { return std::string(value_of(text, key)); };
    Owner owner{{word("host"), word("boot"), word("pid_namespace")}, word("since")};
    owner.process.pid = parse_number<std::int64_t>(value_of(text, "pid")).value_or(0);
    owner.process.start_ticks =
        parse_number<std::uint64_t>(value_of(text, "start_ticks")).value_or(0);
    return owner;
}

std::string described(const Owner& owner) {
    if (owner.process.pid <= 0) return "one that left no name";
    return fmt::format("number {} on {}, since {}", owner.process.pid, owner.process.host,
                       owner.since);
}

bool is_same_file(const Descriptor& file, const fs::path& path) {
    struct stat held, named;
    return ::fstat(file.number(), &held) == 0 && ::lstat(path.c_str(), &named) == 0 &&
           held.st_dev == named.st_dev && held.st_ino == named.st_ino;
}

enum class Flock { held, held_by_another, not_supported };

Flock try_flock(const Descriptor& file) {
    if (not_interrupted([&] { return ::flock(file.number(), LOCK_EX | LOCK_NB); }) == 0)
        return Flock::held;
    return errno == EWOULDBLOCK ? Flock::held_by_another : Flock::not_supported;
}

/// For writing where that is allowed: some file systems lend flock to writers only.
Descriptor open_to_lock(const fs::path& lock_file) {
    Descriptor file = open_retrying(lock_file, O_RDWR | O_NOFOLLOW);
    if (file.is_open() || (errno != EACCES && errno != EROFS)) return file;
    return open_retrying(lock_file, O_RDONLY | O_NOFOLLOW);
}

Owner owner_of(const fs::path& lock_file) {
    try {
        return owner_from(read_file(lock_file, kMostLockBytes));
    } catch (const InputError&) {
        return {};
    }
}

[[noreturn]] void fail_to_lock(const fs::path& path, const fs::path& lock_file, int error) {
    fail(path, "cannot make the lock file \"" + lock_file.string() +
                   "\": " + std::generic_category().message(error));
}

[[noreturn]] void refuse(const fs::path& path, const fs::path& lock_file, const Owner& owner,
                         Life life) {
    std::string what = "another process writes this file: " + described(owner);
    if (life == Life::unknown)
        what += "; if it does not run any more, remove \"" + lock_file.string() + "\"";
    fail(path, what);
}

/// A file system that has neither renames without replacing nor hard links.
bool lacks_means(int error) {
    return error == EPERM || error == EOPNOTSUPP || error == ENOSYS || error == EMLINK;
}

}  // namespace

FileLock::FileLock(const fs::path& path) : lock_file_(lock_file_of(path)) {
    for (int i = 0; i < kTries && !lock_file_.empty(); ++i)
        if (try_to_take(path)) return;
    if (!lock_file_.empty()) fail(path, "its lock changes hands without end");
}

FileLock::~FileLock() {
    if (held_.is_open() && is_same_file(held_, lock_file_)) ::unlink(lock_file_.c_str());
}

/// False: it changed hands meanwhile.
bool FileLock::try_to_take(const fs::path& path) {
    // Made whole and locked under another name: nobody ever sees a lock that says nothing.
    TemporaryFile mine(lock_file_.parent_path());
    if (!mine.is_open()) fail_to_lock(path, lock_file_, errno);
    if (const int error = mine.write(text_of({this_process(), now_utc()})))
        fail_to_lock(path, lock_file_, error);
    const bool has_flock = try_flock(mine.file()) == Flock::held;
    const int error = mine.take_new_name(lock_file_);
    if (lacks_means(error)) {
        remark_ = path.string() + ": cannot be locked against other processes here: " +
                  std::generic_category().message(error);
        lock_file_.clear();
        return true;
    }
    if (error != 0 && error != EEXIST) fail_to_lock(path, lock_file_, error);
    if (error == EEXIST && !try_to_take_over(path, mine, has_flock)) return false;
    held_ = std::move(mine.file());
    return true;
}

/// There is a lock file. False: it changed hands meanwhile.
bool FileLock::try_to_take_over(const fs::path& path, TemporaryFile& mine, bool has_flock) {
    const Descriptor theirs = open_to_lock(lock_file_);
    if (!theirs.is_open() && errno == ENOENT) return false;
    if (!theirs.is_open()) fail_to_lock(path, lock_file_, errno);
    const Owner owner = owner_of(lock_file_);
    const Flock flock = has_flock ? try_flock(theirs) : Flock::not_supported;
    const Life life = flock == Flock::held              ? Life::ended
                      : flock == Flock::held_by_another ? Life::lives
                                                        : life_of(owner.process);
    if (life != Life::ended) refuse(path, lock_file_, owner, life);
    if (!is_same_file(theirs, lock_file_)) return false;
    if (const int error = mine.replace(lock_file_)) fail_to_lock(path, lock_file_, error);
    if (!is_same_file(mine.file(), lock_file_)) return false;  // two took it over, the other last
    remove_temporary_files(lock_file_.parent_path(), owner.process);
    remark_ = path.string() + ": " + described(owner) + ", left this file without finishing it";
    return true;
}

std::vector<FileLock> lock_files(const std::vector<fs::path>& paths) {
    std::vector<FileLock> locks;
    std::set<fs::path> seen;
    for (const fs::path& path : paths) {
        const fs::path lock_file = lock_file_of(path);
        if (lock_file.empty()) continue;
        std::error_code error;  // a folder that cannot be looked at is found by FileLock
        const fs::path one_name = fs::weakly_canonical(fs::absolute(lock_file), error);
        if (error || seen.insert(one_name).second) locks.emplace_back(path);
    }
    return locks;
}

fs::path lock_file_of(const fs::path& path) {
    const fs::path file = replaced_file(path);
    if (file.empty()) return {};
    const std::string name = file.filename().string();
    const std::string lock_name = fmt::format(".{}.lock", name);
    const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    return folder / (lock_name.size() <= kLongestName
                         ? lock_name
                         : fmt::format(".{:016x}.lock", hash_of_text(name)));
}

}  // namespace dewbow
