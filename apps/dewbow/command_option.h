// SPDX-License-Identifier: Apache-2.0
#pragma once

// Options as all subcommands have them. Values are kept as text, which option_value.h reads.

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace dewbow {

void add_flag(CLI::App& app, const std::string& name, bool& flag, const std::string& what);

/// Of one that is given twice the last counts.   @param form  of the value in help: "N", "a|b".
void add_option(CLI::App& app, const std::string& name, std::string& text, const std::string& what,
                const std::string& form);
void add_option(CLI::App& app, const std::string& name, std::optional<std::string>& text,
                const std::string& what, const std::string& form);

/// Takes one value each time that it is given.
void add_repeatable(CLI::App& app, const std::string& name, std::vector<std::string>& texts,
                    const std::string& what, const std::string& form);

/// "a|b|c"
std::string alternatives(const std::vector<std::string>& words);

}  // namespace dewbow
