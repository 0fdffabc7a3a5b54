// SPDX-License-Identifier: Apache-2.0

// `dewbow spectrum`.

#include "command.h"
#include "console.h"
#include "dewbow/base/file.h"
#include "spectrum_output.h"
#include "spectrum_plots.h"

namespace dewbow {
namespace {

/// The files, in the order in which they are asked for.
std::vector<std::string> write_all(const SpectrumCommand& command, const SpectrumSetup& setup) {
    std::vector<std::string> written;
    const auto write = [&](const std::string& file, const std::string& bytes) {
        write_file_atomically(file, bytes);
        written.push_back(file);
        if (!command.quiet) print_message("wrote " + file);
    };
    for (const std::string& file : command.outputs) write(file, spectrum_output(file, setup));
    for (const PlotRequest& plot : command.plots) write(plot.file, spectrum_plot(plot, setup));
    return written;
}

}  // namespace

int run(const SpectrumCommand& command) {
    for (const std::string& file : command.outputs) check_writable(file);
    for (const PlotRequest& plot : command.plots) check_writable(plot.file);
    const SpectrumSetup setup(command);
    const std::vector<std::string> written = write_all(command, setup);
    if (command.json)
        print_data(spectrum_json(setup, written));
    else if (written.empty() && !command.quiet)
        print_data(spectrum_text(setup));
    return kDone;
}

}  // namespace dewbow
