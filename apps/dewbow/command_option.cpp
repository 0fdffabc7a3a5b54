// SPDX-License-Identifier: Apache-2.0
#include "command_option.h"

#include <CLI/CLI.hpp>

namespace dewbow {
namespace {

template <class Text>
void add_last(CLI::App& app, const std::string& name, Text& text, const std::string& what,
              const std::string& form) {
    app.add_option(name, text, what)
        ->type_name(form)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

}  // namespace

void add_flag(CLI::App& app, const std::string& name, bool& flag, const std::string& what) {
    app.add_flag(name, flag, what)->disable_flag_override();
}

void add_option(CLI::App& app, const std::string& name, std::string& text, const std::string& what,
                const std::string& form) {
    add_last(app, name, text, what, form);
}

void add_option(CLI::App& app, const std::string& name, std::optional<std::string>& text,
                const std::string& what, const std::string& form) {
    add_last(app, name, text, what, form);
}

void add_repeatable(CLI::App& app, const std::string& name, std::vector<std::string>& texts,
                    const std::string& what, const std::string& form) {
    app.add_option(name, texts, what)->type_name(form)->allow_extra_args(false);
}

std::string alternatives(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : "|") + word;
    return text;
}

}  // namespace dewbow
