// SPDX-License-Identifier: Apache-2.0
#include "dewbow/base/file.h"

#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <iterator>
#include <new>
#include <optional>
#include <system_error>

#include "dewbow/base/descriptor.h"
#include "dewbow/base/error.h"
#include "dewbow/base/read_record.h"
#include "dewbow/base/temporary_file.h"

namespace dewbow {

namespace {

namespace fs = std::filesystem;

// Linux moves at most 0x7ffff000 bytes by one call.
constexpr std::size_t kMostBytesPerCall = std::size_t{1} << 30;
// As the kernel: a longer chain of symbolic links is a circle.
constexpr int kMostLinks = 40;

[[noreturn]] void fail(const fs::path& path, const std::string& what) {
    throw InputError(SourcePlace{path.string(), 0, 0, {}}, what);
}
[[noreturn]] void fail(const fs::path& path, const std::string& what, int error_number) {
    fail(path, what + ": " + std::generic_category().message(error_number));
}

/// The system's calls end a path at a NUL, and would open another file than the one that was
/// checked.
void check_name(const fs::path& path) {
    if (path.empty()) throw InputError("no file name given");
    if (path.native().find('\0') != std::string::npos) fail(path, "a file name cannot contain NUL");
}

const char* kind_of(mode_t mode) {
    if (S_ISDIR(mode)) return "a folder";
    if (S_ISFIFO(mode)) return "a FIFO";
    if (S_ISSOCK(mode)) return "a socket";
    return "a device";
}

// O_NONBLOCK: opening a FIFO without a writer must not wait. It changes nothing for a file.
Descriptor open_to_read(const fs::path& path) { return open_retrying(path, O_RDONLY | O_NONBLOCK); }

std::uint64_t size_of_regular(const fs::path& path, const Descriptor& file) {
    if (!file.is_open()) fail(path, "cannot read", errno);
    struct stat info;
    if (::fstat(file.number(), &info) != 0) fail(path, "cannot read", errno);
    if (!S_ISREG(info.st_mode))
        fail(path, std::string("cannot read: it is ") + kind_of(info.st_mode) + ", not a file");
    return static_cast<std::uint64_t>(info.st_size);
}

/// Reads up to `size` bytes; fewer only at the end of the file.
std::size_t read_some(const fs::path& path, const Descriptor& file, char* to, std::size_t size) {
    std::size_t have = 0;
    while (have < size) {
        const ssize_t got = not_interrupted([&] {
            return ::read(file.number(), to + have, std::min(size - have, kMostBytesPerCall));
        });
        if (got < 0) fail(path, "cannot read", errno);
        if (got == 0) break;
        have += static_cast<std::size_t>(got);
    }
    return have;
}

/// 0, or the number of the error. A file system that cannot flush says so, and is none.
int flush(const Descriptor& file) {
    if (not_interrupted([&] { return ::fsync(file.number()); }) == 0) return 0;
    return errno == EINVAL || errno == ENOSYS || errno == ENOTSUP ? 0 : errno;
}

/// While it lives, a reader that goes away is an error of write and not the end of the program.
class IgnoreBrokenPipe {
public:
    IgnoreBrokenPipe() {
        sigemptyset(&pipe_);
        sigaddset(&pipe_, SIGPIPE);
        sigset_t pending;
        sigpending(&pending);
        was_pending_ = sigismember(&pending, SIGPIPE) == 1;
        pthread_sigmask(SIG_BLOCK, &pipe_, &saved_);
    }
    ~IgnoreBrokenPipe() {
        const timespec now{};
        if (!was_pending_) sigtimedwait(&pipe_, nullptr, &now);
        pthread_sigmask(SIG_SETMASK, &saved_, nullptr);
    }
    IgnoreBrokenPipe(const IgnoreBrokenPipe&) = delete;
    IgnoreBrokenPipe& operator=(const IgnoreBrokenPipe&) = delete;

private:
    sigset_t pipe_, saved_;
    bool was_pending_;
};

/// Where the bytes for a path go.
struct Target {
    fs::path path;  ///< after symbolic links
    fs::path folder;
    std::optional<struct stat> existing;
    bool direct =
        false;  ///< a device, a FIFO or an open file of this process: nothing to rename over
};

/// The end of the chain of symbolic links at `path`, which need not exist. Stops at links of /proc
/// (/dev/stdout is one): what they lead to has no name.
fs::path follow_links(const fs::path& path, bool& into_proc) {
    fs::path at = path;
    for (int links = 0; links <= kMostLinks; ++links) {
        into_proc = at.native().starts_with("/proc/");
        std::error_code error;
        if (into_proc || !fs::is_symlink(fs::symlink_status(at, error))) return at;
        const fs::path next = fs::read_symlink(at, error);
        if (error) fail(path, "cannot follow the symbolic link", error.value());
        at = at.parent_path() / next;  // an absolute `next` replaces what stands before it
    }
    fail(path, "cannot follow the symbolic link", ELOOP);
}

void check_folder(const fs::path& path, const fs::path& folder) {
    struct stat info;
    if (::stat(folder.c_str(), &info) != 0)
        fail(path, "cannot write: folder \"" + folder.string() + "\"", errno);
    if (!S_ISDIR(info.st_mode))
        fail(path, "cannot write: \"" + folder.string() + "\" is not a folder");
    if (::faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) != 0)
        fail(path, "cannot write: folder \"" + folder.string() + "\"", errno);
}

/// Finds where `path` leads and refuses what is known not to work.
Target find_target(const fs::path& path) {
    check_name(path);
    Target target;
    struct stat info;
    if (::stat(path.c_str(), &info) == 0) target.existing = info;
    if (target.existing && S_ISDIR(info.st_mode)) fail(path, "cannot write: it is a folder");
    if (!path.has_filename()) fail(path, "cannot write: the path ends in a slash");

    bool into_proc = false;
    target.path = follow_links(path, into_proc);
    target.direct = target.existing && (into_proc || !S_ISREG(info.st_mode));
    target.folder = target.path.has_parent_path() ? target.path.parent_path() : fs::path(".");
    if (!target.direct) check_folder(path, target.folder);
    // A rename would replace a write-protected file all the same; its owner meant otherwise.
    if (target.existing && ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0)
        fail(path, "cannot write", errno);
    return target;
}

using Writer = std::function<void(const ByteSink&)>;

ByteSink sink_to(const fs::path& path, const Descriptor& file) {
    return [&](std::string_view bytes) {
        if (const int error = write_all(file, bytes)) fail(path, "cannot write", error);
    };
}

void write_directly(const fs::path& path, const Writer& writer) {
    const IgnoreBrokenPipe ignore;
    // To the end of what a shell redirected to a file; a device or FIFO has no end.
    Descriptor file = open_retrying(path, O_WRONLY | O_APPEND);
    if (!file.is_open()) fail(path, "cannot write", errno);
    writer(sink_to(path, file));
    if (const int error = file.close()) fail(path, "cannot write", error);
}

/// The new file is for whom the old one was. The owner changes back only if we may, which is no
/// error; bits that give the rights of the owner to whoever runs it are not for a picture.
int keep_mode(const Descriptor& file, const struct stat& old) {
    if ((old.st_uid != ::geteuid() || old.st_gid != ::getegid()) &&
        ::fchown(file.number(), old.st_uid, old.st_gid) != 0)
        errno = 0;
    const auto set_mode = [&] { return ::fchmod(file.number(), old.st_mode & 0777); };
    return not_interrupted(set_mode) == 0 ? 0 : errno;
}

/// A file is durable once its folder is. The new file is in place by now and cannot be taken back,
/// so that a failure here is not reported as one of the write.
void flush_folder(const fs::path& folder) {
    const Descriptor file = open_retrying(folder, O_RDONLY | O_DIRECTORY);
    if (file.is_open()) ::fsync(file.number());
}

void write_and_replace(const fs::path& path, const Target& target, const Writer& writer) {
    TemporaryFile temporary(target.folder);
    if (!temporary.is_open())
        fail(path, "cannot create a file in \"" + target.folder.string() + "\"", errno);
    int error = target.existing ? keep_mode(temporary.file(), *target.existing) : 0;
    if (error) fail(path, "cannot write", error);
    writer(sink_to(path, temporary.file()));
    error = flush(temporary.file());
    if (!error) error = temporary.file().close();
    if (!error) error = temporary.replace(target.path);
    if (error) fail(path, "cannot write", error);
    flush_folder(target.folder);
}

/// "http:", "data:" and the like. [RFC 3986, §3.1 and §4.2: a relative path has no colon in its
/// first segment]
bool has_scheme(std::string_view reference) {
    return reference.substr(0, reference.find('/')).find(':') != std::string_view::npos;
}

bool leads_out(const fs::path& relative) {
    int depth = 0;
    for (const fs::path& part : relative) {
        if (part == "..")
            --depth;
        else if (!part.empty() && part != ".")
            ++depth;
        if (depth < 0) return true;
    }
    return false;
}

bool lies_inside(const fs::path& folder, const fs::path& path) {
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
           folder.end();
}

const char* fault_of(std::string_view reference) {
    if (reference.empty()) return "is empty";
    if (reference.find('\0') != std::string_view::npos) return "contains NUL";
    if (reference.find('\\') != std::string_view::npos)
        return "contains a backslash; folders are separated by /";
    if (reference.front() == '/') return "is absolute; files are named relative to the scene";
    if (has_scheme(reference)) return "has a scheme; only files beside the scene are read";
    if (leads_out(fs::path(reference))) return "leads out of the scene's folder";
    return nullptr;
}

std::string quoted(std::string_view text) { return "\"" + std::string(text) + "\""; }

}  // namespace

class FileSource::File {
public:
    explicit File(const fs::path& path)
        : path_(path), file_(open_to_read(path)), size_(size_of_regular(path_, file_)) {}
    std::uint64_t size() const { return size_; }
    void read(char* to, std::size_t size) {
        if (read_some(path_, file_, to, size) < size) fail(path_, "cannot read: it ends too early");
    }

private:
    fs::path path_;
    Descriptor file_;
    std::uint64_t size_;
};

FileSource::FileSource(const fs::path& path) {
    check_name(path);
    file_ = std::make_unique<File>(path);
    left_ = file_->size();
}
FileSource::~FileSource() = default;

void FileSource::read(char* to, std::size_t size) {
    file_->read(to, size);
    left_ -= size;
}

std::string read_file(const fs::path& path, std::uint64_t max_bytes) {
    check_name(path);
    const Descriptor file = open_to_read(path);
    const std::uint64_t size = size_of_regular(path, file);
    const std::string limit = "larger than the limit of " + std::to_string(max_bytes) + " bytes";
    if (size > max_bytes)
        fail(path, "cannot read: " + std::to_string(size) + " bytes are " + limit);

    try {
        std::string bytes(static_cast<std::size_t>(size), '\0');
        bytes.resize(read_some(path, file, bytes.data(), bytes.size()));
        // The files of /proc are said to be empty, and any file may grow while it is read.
        constexpr std::size_t kMore = 4096;
        for (std::size_t end = bytes.size(); end == bytes.size(); end += kMore) {
            bytes.resize(end + kMore);
            bytes.resize(end + read_some(path, file, bytes.data() + end, kMore));
            if (bytes.size() > max_bytes) fail(path, "cannot read: it is " + limit);
            if (bytes.size() < end + kMore) break;
        }
        ReadRecord::note(bytes);
        return bytes;
    } catch (const std::bad_alloc&) {
        fail(path, "cannot read: not enough memory for " + std::to_string(size) + " bytes");
    }
}

void write_file_atomically(const fs::path& path, std::string_view bytes) {
    write_file_atomically(path, [bytes](const ByteSink& sink) { sink(bytes); });
}

void write_file_atomically(const fs::path& path, const Writer& writer) {
    const Target target = find_target(path);
    if (target.direct)
        write_directly(path, writer);
    else
        write_and_replace(path, target, writer);
}

void check_writable(const fs::path& path) { find_target(path); }

fs::path replaced_file(const fs::path& path) {
    Target target = find_target(path);
    return target.direct ? fs::path() : target.path;
}

fs::path resolve_inside(const fs::path& folder, std::string_view reference) {
    if (const char* fault = fault_of(reference))
        throw InputError("reference " + quoted(reference) + " " + fault);
    std::error_code error;
    const fs::path inside = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
    if (error) fail(folder, "cannot read the folder", error.value());
    const fs::path path = fs::weakly_canonical(inside / fs::path(reference), error);
    if (error) throw InputError("reference " + quoted(reference) + ": " + error.message());
    if (!lies_inside(inside, path))
        throw InputError("reference " + quoted(reference) +
                         " leads out of the scene's folder by a symbolic link");
    return path;
}

}  // namespace dewbow
