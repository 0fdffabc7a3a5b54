// SPDX-License-Identifier: Apache-2.0
#pragma once

// `dewbow merge`: states of one render become its picture.

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace dewbow {

struct MergeCommand {
    std::vector<std::string> states;   ///< files, at least one
    std::vector<std::string> outputs;  ///< pictures and states, at least one
    bool allow_missing = false;
    bool quiet = false, json = false;
};

/// Returns the program's exit code.
int run(const MergeCommand& command);

/// The options of `dewbow merge`.
class MergeCommandLine {
public:
    explicit MergeCommandLine(CLI::App& app);
    /// What was asked for, if `dewbow merge` was given. Throws UsageError.
    std::optional<MergeCommand> command() const;

private:
    CLI::App* merge_ = nullptr;
    MergeCommand given_;
};

}  // namespace dewbow
