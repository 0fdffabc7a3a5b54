// SPDX-License-Identifier: Apache-2.0
#include "rainbow_tables.h"

#include "rainbow_degrees.h"

namespace dewbow {
namespace {

std::vector<Angle> angles_of(double from, double to, double step) {
    std::vector<Angle> angles;
    for (const double degrees : stepped(from, to, step)) angles.push_back(degrees * unit::deg);
    return angles;
}

}  // namespace

const ScatteringTable& RainbowTables::get(const std::string& model,
                                          const std::vector<Wavelength>& wavelengths,
                                          const std::vector<Angle>& angles) {
    const TableRequest request = setup_.request_for(model, wavelengths, angles);
    for (const Entry& entry : entries_)
        if (entry.model == model && entry.table.wavelengths == request.wavelengths &&
            entry.table.angles == request.angles)
            return entry.table;
    // Curves cost less than a file.
    const auto keep =
        request.wavelengths.size() > 1 ? RainbowSetup::Keep::on_disk : RainbowSetup::Keep::nowhere;
    entries_.push_back({model, setup_.table_of(request, keep)});
    return entries_.back().table;
}

std::vector<Angle> whole_circle() { return angles_of(0.0, 180.0, 0.1); }
std::vector<Angle> around_the_bows() { return angles_of(115.0, 155.0, 0.02); }
std::vector<Angle> half_the_sky(Angle nearest) {
    return angles_of(90.0, 180.0 - degrees_of(nearest), 0.05);
}

std::vector<Wavelength> visible_wavelengths() {
    std::vector<Wavelength> wavelengths;
    for (const double nm : stepped(380.0, 780.0, 5.0)) wavelengths.push_back(nm * unit::nm);
    return wavelengths;
}

}  // namespace dewbow
