// SPDX-License-Identifier: Apache-2.0
#pragma once

// The options of `dewbow spectrum`.

#include <optional>
#include <string>
#include <vector>

#include "spectrum_command.h"

namespace CLI {
class App;
}

namespace dewbow {

class SpectrumCommandLine {
public:
    explicit SpectrumCommandLine(CLI::App& app);
    /// What was asked for, if `dewbow spectrum` was given. Throws UsageError.
    std::optional<SpectrumCommand> command() const;

private:
    void add_model();
    void add_sampling();
    void add_output();
    SpectralModelSettings model() const;
    SpectralSampling sampling() const;

    using Text = std::optional<std::string>;
    CLI::App* spectrum_ = nullptr;
    Text colours_, monitor_, negative_, spacing_, samples_, jitter_, sets_, seed_, gamma_;
    std::vector<std::string> outputs_, plots_;
    bool correlated_ = false, tailored_ = false, quiet_ = false, json_ = false;
};

}  // namespace dewbow
