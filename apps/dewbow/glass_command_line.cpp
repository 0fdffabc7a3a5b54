// SPDX-License-Identifier: Apache-2.0
#include "glass_command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "command_option.h"
#include "dewbow/base/error.h"
#include "dewbow/base/parse_number.h"
#include "dewbow/optics/equivalents.h"
#include "option_value.h"

namespace dewbow {
namespace {

/// Beyond this glass catalogues say nothing.
constexpr double kShortest_nm = 200.0, kLongest_nm = 3000.0;
constexpr double kLeastIndex = 1.0001, kMostIndex = 10.0, kLeastValue = 1e-9, kMostValue = 1e6;
constexpr double kMostPower = 1e3;
constexpr std::size_t kMostCompared = 24;

constexpr const char* kExamples = R"(Examples:
  dewbow glass list flint
  dewbow glass show N-BK7 --at 500nm --plot n-bk7.svg
  dewbow glass show maker.agf#N-BK7
  dewbow glass compare N-BK7 F2 SF10 diamond water@25C --plot glasses.svg
  dewbow glass import maker.agf --rows maker.csv
  dewbow glass convert N-SF11
  dewbow glass convert --n-d 1.5 --gltf 0.4
  dewbow glass paper N-BK7 --plot n-bk7.svg
  dewbow glass paper --eta-red 4.2 --w 0.5)";

CLI::App* add_subcommand(CLI::App& glass, const char* name, const char* what) {
    CLI::App* app = glass.add_subcommand(name, what);
    app->allow_extras();
    app->footer(kExamples);
    return app;
}

/// "500nm", "0.5um", "500", or the name of a line such as "D".
double wavelength_nm(const std::string& text) {
    if (const auto line = fraunhofer_line(text))
        return vacuum_wavelength(line->air_nm).to(unit::nm);
    std::string_view number = text;
    double nm_per_unit = 1.0;
    if (number.ends_with("nm")) {
        number.remove_suffix(2);
    } else if (number.ends_with("um") || number.ends_with("µm")) {
        number.remove_suffix(number.ends_with("um") ? 2 : 3);
        nm_per_unit = 1e3;
    }
    const auto value = parse_number<double>(number);
    if (value && *value * nm_per_unit >= kShortest_nm && *value * nm_per_unit <= kLongest_nm)
        return *value * nm_per_unit;
    throw UsageError(
        fmt::format("--at is \"{}\"; it must be a vacuum wavelength of {} to {} nm such as 500nm, "
                    "or a line such as D",
                    text, kShortest_nm, kLongest_nm));
}

/// The file of an option that was given.
std::string checked_file(const std::string& option, const std::optional<std::string>& text,
                         const std::string& ending) {
    const std::vector<std::string> endings{ending};
    return text ? parse_file_name(option, *text, endings) : std::string();
}

}  // namespace

GlassCommandLine::GlassCommandLine(CLI::App& app) : values_(dispersion_units().size()) {
    CLI::App* glass = app.add_subcommand(
        "glass", "Glasses, gems and fluids: list, show, compare, import, convert, paper");
    glass->allow_extras();
    glass->footer(kExamples);
    add_list(*glass);
    add_show(*glass);
    add_compare(*glass);
    add_import(*glass);
    add_convert(*glass);
    add_paper(*glass);
}

void GlassCommandLine::add_list(CLI::App& glass) {
    list_ = add_subcommand(glass, "list", "List all names, or those that have a text in them");
    add_option(*list_, "text", only_, "Part of a name or description", "TEXT");
    add_flag(*list_, "--json", json_, "Print JSON");
}

void GlassCommandLine::add_show(CLI::App& glass) {
    show_ = add_subcommand(glass, "show", "Show all that is known of one");
    add_option(*show_, "name", only_,
               "Name (the maker may be left out where the rest is unique), or FILE.agf#NAME",
               "NAME");
    add_repeatable(*show_, "--at", at_,
                   "Show the index at this vacuum wavelength or line; repeatable", "500nm|D");
    add_option(*show_, "--plot", plot_, "Write n over the wavelength and the Abbe diagram here",
               "FILE.svg");
    add_flag(*show_, "--json", json_, "Print JSON");
}

void GlassCommandLine::add_compare(CLI::App& glass) {
    compare_ = add_subcommand(glass, "compare", "Show several side by side");
    compare_->add_option("names", names_, "Names or FILE.agf#NAME")->type_name("NAME ...");
    add_repeatable(*compare_, "--at", at_,
                   "Show the index at this vacuum wavelength or line; repeatable", "500nm|D");
    add_option(*compare_, "--plot", plot_, "Write n over the wavelength and the Abbe diagram here",
               "FILE.svg");
    add_flag(*compare_, "--json", json_, "Print JSON");
}

void GlassCommandLine::add_import(CLI::App& glass) {
    import_ = add_subcommand(
        glass, "import", "Read a glass file (.agf, or .yml of refractiveindex.info) and check it");
    add_option(*import_, "file", only_, "The file; with #NAME, print that glass for a scene file",
               "FILE");
    add_option(*import_, "--rows", rows_, "Write the glasses as rows of our catalogue here",
               "FILE.csv");
    add_flag(*import_, "--json", json_, "Print JSON");
}

void GlassCommandLine::add_convert(CLI::App& glass) {
    convert_ = add_subcommand(glass, "convert",
                              "Say a glass's dispersion as others do, and what that is worth");
    add_option(*convert_, "name", only_, "A glass; or else --n-d and one number", "NAME");
    add_option(*convert_, "--n-d", n_d_, "Index at the d line", "1.5168");
    const auto& units = dispersion_units();
    for (std::size_t i = 0; i < units.size(); ++i) {
        std::string option = "--" + units[i].name;
        std::replace(option.begin(), option.end(), '_', '-');
        add_option(*convert_, option, values_[i], units[i].meaning, "X");
    }
    add_flag(*convert_, "--json", json_, "Print JSON");
}

void GlassCommandLine::add_paper(CLI::App& glass) {
    paper_ = add_subcommand(
        glass, "paper",
        "The index as Musgrave 1989 has it, beside the true one; alone: what it claims of all");
    add_option(*paper_, "name", only_, "A glass; or else --eta-red and --w", "NAME");
    add_option(*paper_, "--eta-red", eta_red_, "Index at the far red, 800 nm", "4.2");
    add_option(*paper_, "--w", w_, "Dispersive power (n_F - n_C)/(n_D - 1)", "0.5");
    add_option(*paper_, "--spacing", spacing_, "What the index is straight in (frequency)",
               alternatives(spectral_spacing_names()));
    add_option(*paper_, "--plot", plot_,
               "Write the indices and the formulas' errors here; alone: all glasses, and Fig. 3.1",
               "FILE.svg");
    add_flag(*paper_, "--json", json_, "Print JSON");
}

std::vector<double> GlassCommandLine::at_nm() const {
    std::vector<double> wavelengths;
    for (const std::string& text : at_) wavelengths.push_back(wavelength_nm(text));
    return wavelengths;
}

GlassShowCommand GlassCommandLine::show_command() const {
    if (only_.empty()) throw UsageError("the name is missing", "`dewbow glass list` shows all");
    return {{only_}, at_nm(), checked_file("--plot", plot_, ".svg"), json_};
}

GlassShowCommand GlassCommandLine::compare_command() const {
    if (names_.size() < 2)
        throw UsageError("two names or more are wanted", "`dewbow glass show` takes one");
    if (names_.size() > kMostCompared)
        throw UsageError(
            fmt::format("{} names; at most {} are compared", names_.size(), kMostCompared));
    return {names_, at_nm(), checked_file("--plot", plot_, ".svg"), json_};
}

GlassImportCommand GlassCommandLine::import_command() const {
    if (only_.empty()) throw UsageError("the file is missing", "`dewbow glass import --help`");
    const std::size_t hash = only_.find('#');
    return {only_.substr(0, hash), hash == std::string::npos ? "" : only_.substr(hash + 1),
            checked_file("--rows", rows_, ".csv"), json_};
}

GlassConvertCommand GlassCommandLine::convert_command() const {
    GlassConvertCommand command;
    command.json = json_;
    command.name = only_;
    const auto& units = dispersion_units();
    std::size_t given = 0;
    for (std::size_t i = 0; i < units.size(); ++i) {
        if (values_[i].empty()) continue;
        ++given;
        std::string option = "--" + units[i].name;
        std::replace(option.begin(), option.end(), '_', '-');
        command.unit = units[i].name;
        command.value = parse_real(option, values_[i], kLeastValue, kMostValue);
    }
    if (!only_.empty()) {
        if (given > 0 || !n_d_.empty())
            throw UsageError("a glass is named, and numbers are given: one of them is too many");
        return command;
    }
    if (given == 0 && n_d_.empty())
        throw UsageError("nothing to convert: expected a glass, or --n-d with one number",
                         "`dewbow glass convert --help` tells which");
    if (n_d_.empty()) throw UsageError("--n-d is missing");
    if (given != 1)
        throw UsageError(fmt::format("{} numbers for the dispersion; expected one", given));
    command.n_d = parse_real("--n-d", n_d_, kLeastIndex, kMostIndex);
    return command;
}

GlassPaperCommand GlassCommandLine::paper_command() const {
    GlassPaperCommand command;
    command.name = only_;
    command.json = json_;
    command.plot = checked_file("--plot", plot_, ".svg");
    if (spacing_)
        command.spacing = static_cast<SpectralSpacing>(
            parse_word("--spacing", *spacing_, spectral_spacing_names()));
    if (!only_.empty() && (!eta_red_.empty() || !w_.empty()))
        throw UsageError("a glass is named, and numbers are given: one of them is too many");
    if (eta_red_.empty() != w_.empty())
        throw UsageError(eta_red_.empty() ? "--eta-red is missing" : "--w is missing");
    if (!eta_red_.empty()) {
        command.eta_red = parse_real("--eta-red", eta_red_, kLeastIndex, kMostIndex);
        command.w = parse_real("--w", w_, 0.0, kMostPower);
    }
    return command;
}

std::optional<GlassCommand> GlassCommandLine::command() const {
    if (list_->parsed()) return GlassListCommand{only_, json_};
    if (show_->parsed()) return show_command();
    if (compare_->parsed()) return compare_command();
    if (import_->parsed()) return import_command();
    if (convert_->parsed()) return convert_command();
    if (paper_->parsed()) return paper_command();
    return std::nullopt;
}

}  // namespace dewbow
