// SPDX-License-Identifier: Apache-2.0
#pragma once

// The file that keeps the state of a render until its pictures are written.

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "dewbow/render/session.h"

namespace dewbow {

/// What the command line says of checkpoints.
struct CheckpointWish {
    bool wanted = true;
    std::string file;  ///< empty: beside the first output
    std::chrono::duration<double> interval{60.0};
    bool resume = false;
    std::string resume_file;  ///< empty: the checkpoint's file
};

/// Messages go to standard error.
class CheckpointFile {
public:
    /// Beside a device or FIFO there is none unless its file is named. A state that an earlier
    /// render has left there, and that this one does not go on with, is told of.
    CheckpointFile(const CheckpointWish& wish, const std::filesystem::path& first_output);

    /// The state to begin with: an empty one, or that of the file to resume. Throws InputError if
    /// there is no such file, if it is damaged or if it is of another render, naming what differs.
    RenderState begin(RenderIdentity identity) const;

    /// For SessionOptions. A state that cannot be kept is a warning, and tried again.
    std::optional<Checkpoints> checkpoints();
    /// Keeps the state as it is in the end; false if it is not wanted or cannot be.
    bool keep(const RenderState& state);
    /// The pictures are written: removes what this render has kept or gone on with.
    void remove();

    /// "ring.exr.dewbow keeps what was rendered; the same command with --resume goes on"
    std::string way_on() const;

private:
    /// Throws InputError.
    void write(const StateOfTheMoment& state);
    /// Warns if that fails.
    bool try_to_write(const StateOfTheMoment& state);
    void set_aside_earlier_state();

    CheckpointWish wish_;
    std::filesystem::path path_;  // empty: none
    bool earlier_state_ = false;  // of another render lies there
    bool ours_ = false;           // what lies there is of this render
    std::string last_warning_;    // each is said once
};

}  // namespace dewbow
