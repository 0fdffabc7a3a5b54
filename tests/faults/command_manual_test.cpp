// SPDX-License-Identifier: Apache-2.0

// docs/rainbow.md and docs/spectrum.md tell the truth: every command in them does what it says, and
// every option that `dewbow rainbow --help` or `dewbow spectrum --help` lists is in its manual.

#include <gtest/gtest.h>

#include <sstream>

#include "dewbow/base/file.h"
#include "run_program.h"

namespace dewbow::faults {
namespace {

using Words = std::vector<std::string>;

std::string manual_of(const std::string& subcommand) {
    return read_file(std::string(DEWBOW_SOURCE_DIR) + "/docs/" + subcommand + ".md");
}

/// The commands of the manual, in words, without what stands behind a #.
std::vector<Words> commands_of(const std::string& subcommand) {
    std::vector<Words> all;
    std::istringstream lines(manual_of(subcommand));
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("    dewbow " + subcommand)) continue;
        std::istringstream text(line.substr(0, line.find(" #")));
        Words words;
        for (std::string word; text >> word;) words.push_back(word);
        words.erase(words.begin());
        if (subcommand == "rainbow") words.push_back("--no-cache");
        all.push_back(words);
    }
    return all;
}

/// The files that a command writes.
Words files_of(const Words& words) {
    Words files;
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        if (words[i] == "-o") files.push_back(words[i + 1]);
        if (words[i] == "--plot") files.push_back(words[i + 1].substr(words[i + 1].find('=') + 1));
    }
    return files;
}

bool takes_seconds(const Words& words) {
    for (const std::string& word : words)
        if (word.starts_with("lee=") || word == "oblate") return true;
    return false;
}

void check_commands(const std::string& subcommand, std::size_t fewest) {
    const std::string storm =
        read_file(std::string(DEWBOW_SOURCE_DIR) + "/examples/rainbow/storm.toml");
    const std::vector<Words> all = commands_of(subcommand);
    EXPECT_GE(all.size(), fewest);
    for (const Words& words : all) {
        if (takes_seconds(words)) continue;
        const Folder folder;
        folder.put("examples/rainbow/storm.toml", storm);
        const Outcome outcome = run_program(DEWBOW_BINARY, words, folder.path());
        std::string shown;
        for (const std::string& word : words) shown += word + ' ';
        EXPECT_EQ(outcome.exit_code, 0) << shown << outcome.standard_error;
        for (const std::string& file : files_of(words))
            EXPECT_TRUE(std::filesystem::exists(folder.path() / file)) << shown;
        EXPECT_EQ(files_of(words).empty(), !outcome.standard_output.empty()) << shown;
    }
}

void check_options(const std::string& subcommand, std::size_t fewest) {
    const Folder folder;
    const std::string help =
        run_program(DEWBOW_BINARY, {subcommand, "--help"}, folder.path()).standard_output;
    const std::string text = manual_of(subcommand);
    std::size_t options = 0;
    std::istringstream lines(help);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t name = line.find("--");
        if (!line.starts_with("  -") || name == std::string::npos) continue;
        const std::string option = line.substr(name, line.find(' ', name) - name);
        const bool everywhere = option == "--help" || option == "--output";
        EXPECT_TRUE(everywhere || text.find("`" + option) != std::string::npos) << option;
        ++options;
    }
    EXPECT_GE(options, fewest);
}

TEST(RainbowManual, CommandsDoWhatTheySay) { check_commands("rainbow", 12); }
TEST(RainbowManual, HasEveryOption) { check_options("rainbow", 25); }

TEST(SpectrumManual, CommandsDoWhatTheySay) { check_commands("spectrum", 6); }
TEST(SpectrumManual, HasEveryOption) { check_options("spectrum", 14); }

}  // namespace
}  // namespace dewbow::faults
