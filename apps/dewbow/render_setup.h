// SPDX-License-Identifier: Apache-2.0
#pragma once

// What `dewbow render` has before it renders: on every rank the same.

#include <string>

#include "command.h"
#include "dewbow/render/estimator_choice.h"
#include "dewbow/render/session.h"

namespace dewbow {

/// A scene, and a hash of the files and options that it was made from: of the files their contents
/// and not their names.
struct LoadedScene {
    Scene scene;
    std::uint64_t hash = 0;
};

/// Throws InputError.
/// @param silent  what the importer could not honour is not printed
LoadedScene load(const RenderCommand& command, bool silent = false);

/// The command that replays a sample, but for --pixel, --sample and --seed: all that a sample
/// depends on.
std::string replay_command(const RenderCommand& command);

/// What --estimator names, or what suits the scene; then it is said why.
/// @param silent  it is not said
EstimatorChoice estimator_of(const RenderCommand& command, const Scene& scene, bool silent = false);

/// The name of its file, without folders.
std::string scene_name(const RenderCommand& command);

SessionOptions session_options(const RenderCommand& command);

/// Throws UsageError.
void check_crop(const PixelRect& crop, const Film& film);
/// Throws InputError.
void check_memory_of(const Scene& scene, const SessionOptions& options, const Estimator& estimator);

RenderIdentity identity_of(const RenderCommand& command, const LoadedScene& loaded,
                           const SessionOptions& options, const EstimatorChoice& chosen);

}  // namespace dewbow
