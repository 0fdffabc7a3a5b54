// SPDX-License-Identifier: Apache-2.0
#pragma once

// The options of `dewbow rainbow`.

#include <optional>
#include <string>
#include <vector>

#include "rainbow_command.h"

namespace CLI {
class App;
}

namespace dewbow {

class RainbowCommandLine {
public:
    explicit RainbowCommandLine(CLI::App& app);
    /// What was asked for, if `dewbow rainbow` was given. Throws UsageError.
    std::optional<RainbowCommand> command() const;

private:
    void add_drops();
    void add_model();
    void add_sun();
    void add_view();
    void add_output();
    void read_model(Storm& storm) const;
    void read_drops(Storm& storm) const;
    void read_sun(Storm& storm) const;
    void read_view(Storm& storm) const;
    void read_sphere(RainbowCommand& command) const;
    /// Throws UsageError for what --paper does not go with.
    /// Throws UsageError where an option was given that is none of `names`.
    void refuse_all_but(const std::vector<std::string>& names, const std::string& reason) const;
    void check_paper() const;

    using Text = std::optional<std::string>;
    CLI::App* rainbow_ = nullptr;
    Text storm_, radius_, shape_, water_, air_, oscillation_, tilt_, haze_, index_, size_parameter_;
    Text tolerance_, illuminant_, sun_altitude_, sun_radius_, limb_darkening_;
    Text wavelengths_, angles_, polarisation_, polariser_, clock_angle_, threads_;
    std::vector<std::string> models_, orders_, sizes_, outputs_, plots_;
    bool paper_ = false, point_sun_ = false, reddened_ = false, amplitudes_ = false;
    bool no_cache_ = false, quiet_ = false, json_ = false, self_test_ = false;
};

}  // namespace dewbow
