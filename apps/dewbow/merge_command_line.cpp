// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>

#include "dewbow/base/error.h"
#include "dewbow/render/output.h"
#include "dewbow/render/state.h"
#include "merge_command.h"
#include "option_value.h"

namespace dewbow {

namespace {

constexpr const char* kExamples = R"(Examples:
  dewbow render ring.glb --slice 1/3 -o ring-1.dewbow    and 2/3, 3/3, on any machines
  dewbow merge ring-*.dewbow -o ring.exr -o ring.png     the very pixels of the whole render
  dewbow merge ring-1.dewbow ring-2.dewbow -o ring.png --allow-missing

Exit codes: 0 done, 1 failed (nothing is written), 2 used wrongly, 3 done but more than one sample in
a million was invalid.)";

std::vector<std::string> output_endings() {
    std::vector<std::string> endings = picture_extensions();
    endings.emplace_back(kStateExtension);
    return endings;
}

std::vector<std::string> checked(const char* option, const std::vector<std::string>& files,
                                 const std::vector<std::string>& endings) {
    std::vector<std::string> names;
    for (const std::string& file : files) names.push_back(parse_file_name(option, file, endings));
    return names;
}

}  // namespace

MergeCommandLine::MergeCommandLine(CLI::App& app) {
    merge_ =
        app.add_subcommand("merge", "Add slices of a render, and interrupted ones, to its picture");
    merge_->allow_extras();
    merge_->footer(kExamples);
    merge_
        ->add_option("states", given_.states,
                     "States of one render (.dewbow), in any order; one that is given twice counts "
                     "once")
        ->type_name("FILE");
    merge_
        ->add_option("-o,--output", given_.outputs,
                     "A picture to write, or a state with all that is in these; repeatable")
        ->type_name("FILE")
        ->allow_extra_args(false);
    const auto add_flag = [this](const char* name, bool& flag, const char* what) {
        merge_->add_flag(name, flag, what)->disable_flag_override();
    };
    add_flag("--allow-missing", given_.allow_missing,
             "Make a picture even if parts of it are missing; it says so");
    add_flag("-q,--quiet", given_.quiet, "Say nothing but warnings and errors");
    add_flag("--json", given_.json, "Print one JSON object on standard output at the end");
}

std::optional<MergeCommand> MergeCommandLine::command() const {
    if (!merge_->parsed()) return std::nullopt;
    MergeCommand command = given_;
    if (command.states.empty())
        throw UsageError("the states to merge are missing",
                         "`dewbow merge --help` tells how it is used");
    if (command.outputs.empty())
        throw UsageError("-o is missing: the picture to write",
                         "`dewbow merge --help` tells how it is used");
    command.states = checked("a state", given_.states, {std::string(kStateExtension)});
    command.outputs = checked("--output", given_.outputs, output_endings());
    return command;
}

}  // namespace dewbow
