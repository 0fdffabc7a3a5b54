// SPDX-License-Identifier: Apache-2.0

// `dewbow rainbow`.

#include "command.h"
#include "console.h"
#include "dewbow/base/error.h"
#include "dewbow/base/file.h"
#include "dewbow/base/parallel.h"
#include "rainbow_output.h"
#include "rainbow_paper.h"
#include "rainbow_plots.h"
#include "rainbow_self_check.h"
#include "rainbow_setup.h"
#include "rainbow_sphere.h"
#include "rainbow_summary.h"
#include "rainbow_tables.h"

namespace dewbow {
namespace {

void check_all_writable(const RainbowCommand& command) {
    for (const std::string& file : command.outputs) check_writable(file);
    for (const PlotRequest& plot : command.plots) check_writable(plot.file);
}

/// The files, in the order in which they are asked for.
std::vector<std::string> write_all(const RainbowCommand& command, RainbowTables& tables) {
    std::vector<std::string> written;
    const auto write = [&](const std::string& file, const std::string& bytes) {
        write_file_atomically(file, bytes);
        written.push_back(file);
        if (!command.quiet) print_message("wrote " + file);
    };
    for (const std::string& file : command.outputs)
        write(file, command.options.paper ? paper_csv() : rainbow_output(file, tables));
    for (const PlotRequest& plot : command.plots)
        write(plot.file, rainbow_plot(plot.kind, plot.file, tables));
    return written;
}

}  // namespace

int run(const RainbowCommand& command) {
    if (command.threads > 0) set_thread_count(command.threads);
    if (command.self_test) return run_rainbow_self_check(command.json);
    const bool files = !command.outputs.empty() || !command.plots.empty();
    if (command.size_parameter && !files) return run_sphere(command);
    check_all_writable(command);
    RainbowTables tables(set_up(command));
    const std::vector<std::string> written = write_all(command, tables);
    const bool paper = command.options.paper.has_value();
    if (command.json)
        print_data(paper ? paper_json() : summary_json(tables, written));
    else if (!files && !command.quiet)
        print_data(paper ? paper_text() : summary_text(tables));
    return kDone;
}

}  // namespace dewbow
