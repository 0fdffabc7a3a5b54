// SPDX-License-Identifier: Apache-2.0
#pragma once

// The options of `dewbow glass`.

#include <optional>
#include <string>
#include <vector>

#include "glass_command.h"

namespace CLI {
class App;
}

namespace dewbow {

class GlassCommandLine {
public:
    explicit GlassCommandLine(CLI::App& app);
    /// The subcommand that was given, or nothing. Throws UsageError.
    std::optional<GlassCommand> command() const;

private:
    void add_list(CLI::App& glass);
    void add_show(CLI::App& glass);
    void add_compare(CLI::App& glass);
    void add_import(CLI::App& glass);
    void add_convert(CLI::App& glass);
    void add_paper(CLI::App& glass);
    std::vector<double> at_nm() const;
    GlassShowCommand show_command() const;
    GlassShowCommand compare_command() const;
    GlassImportCommand import_command() const;
    GlassConvertCommand convert_command() const;
    GlassPaperCommand paper_command() const;

    CLI::App *list_ = nullptr, *show_ = nullptr, *compare_ = nullptr, *import_ = nullptr,
             *convert_ = nullptr, *paper_ = nullptr;
    std::vector<std::string> names_, at_;
    std::string only_, n_d_, eta_red_, w_;
    std::optional<std::string> plot_, rows_, spacing_;
    std::vector<std::string> values_;  ///< of units, in the order of dispersion_units()
    bool json_ = false;
};

}  // namespace dewbow
