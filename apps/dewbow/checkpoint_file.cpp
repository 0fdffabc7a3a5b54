// SPDX-License-Identifier: Apache-2.0
#include "checkpoint_file.h"

#include <fmt/format.h>

#include <system_error>

#include "console.h"
#include "dewbow/base/error.h"
#include "dewbow/base/file.h"

namespace dewbow {

namespace {

namespace fs = std::filesystem;

std::string with_ending(const fs::path& path, std::string_view ending) {
    return path.string() + std::string(ending);
}

/// Beside a device or FIFO nobody looks for a file.
fs::path default_path(const fs::path& first_output) {
    std::error_code error;
    const fs::file_status status = fs::status(first_output, error);
    if (fs::exists(status) && !fs::is_regular_file(status)) return {};
    return with_ending(first_output, kStateExtension);
}

void warn(const std::string& text) { print_message(presentable("warning: " + text)); }

}  // namespace

CheckpointFile::CheckpointFile(const CheckpointWish& wish, const fs::path& first_output)
    : wish_(wish), path_(wish.file.empty() ? default_path(first_output) : fs::path(wish.file)) {
    if (wish_.resume && wish_.resume_file.empty()) wish_.resume_file = path_.string();
    if (wish_.resume && wish_.resume_file.empty())
        throw UsageError("--resume wants the name of a file here: there is none beside " +
                         first_output.string());
    if (wish_.wanted && !wish_.file.empty()) check_writable(path_);
    std::error_code error;
    if (wish_.resume && fs::equivalent(wish_.resume_file, path_, error)) ours_ = true;
    earlier_state_ = !ours_ && wish_.wanted && !path_.empty() && fs::is_regular_file(path_, error);
    if (earlier_state_)
        warn(
            fmt::format("{0} is the state of an earlier render, which --resume goes on with; this "
                        "one begins anew, and will move it to {0}.old when it keeps its own",
                        path_.string()));
}

RenderState CheckpointFile::begin(RenderIdentity identity) const {
    if (!wish_.resume) return RenderState(std::move(identity));
    const std::string& name = wish_.resume_file;
    std::error_code error;
    if (fs::status(name, error).type() == fs::file_type::not_found)
        throw InputError(SourcePlace{name, 0, 0, {}}, "there is no such state to resume", {},
                         "without --resume the render begins anew");
    RenderState state = load_state(name);
    if (const auto difference = mismatch(state.identity, name, identity, "this render"))
        throw InputError(SourcePlace{name, 0, 0, {}},
                         "cannot resume the state of another render: " + *difference, {},
                         "render with the options that it was made with, or without --resume");
    state.identity = std::move(identity);
    return state;
}

std::optional<Checkpoints> CheckpointFile::checkpoints() {
    if (!wish_.wanted || path_.empty()) return std::nullopt;
    return Checkpoints{wish_.interval, [this](const StateOfTheMoment& state) {
                           static_cast<void>(try_to_write(state));
                       }};
}

bool CheckpointFile::keep(const RenderState& state) {
    if (!wish_.wanted || path_.empty()) return false;
    return try_to_write([&](const ByteSink& sink) { write_state(state, sink); });
}

std::string CheckpointFile::way_on() const {
    std::string option = "--resume";
    if (wish_.resume && wish_.resume_file != path_.string())
        option = fmt::format("--resume={}", path_.string());
    return presentable(fmt::format("{} keeps what was rendered; the same command with {} goes on",
                                   path_.string(), option));
}

void CheckpointFile::remove() {
    if (!wish_.wanted || !ours_) return;
    std::error_code error;
    fs::remove(path_, error);
    if (error) warn(path_.string() + ": cannot remove: " + error.message());
}

void CheckpointFile::set_aside_earlier_state() {
    if (!earlier_state_) return;
    std::error_code error;
    fs::rename(path_, with_ending(path_, ".old"), error);
    if (error)
        throw InputError(
            SourcePlace{path_.string(), 0, 0, {}},
            "cannot move it to " + with_ending(path_, ".old") + ": " + error.message());
    earlier_state_ = false;
}

void CheckpointFile::write(const StateOfTheMoment& state) {
    set_aside_earlier_state();
    write_file_atomically(path_, state);
    ours_ = true;
    last_warning_.clear();
}

bool CheckpointFile::try_to_write(const StateOfTheMoment& state) {
    std::string failure;
    try {
        write(state);
        return true;
    } catch (const InputError& error) {
        failure = error.what();
    } catch (const std::bad_alloc&) {
        failure = path_.string() + ": there is not memory enough to write it";
    }
    if (failure != last_warning_)
        warn("the state of the render is not kept, and this will be tried again: " + failure);
    last_warning_ = failure;
    return false;
}

}  // namespace dewbow
