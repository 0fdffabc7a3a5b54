// SPDX-License-Identifier: Apache-2.0
#include "rainbow_sphere.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "command.h"
#include "console.h"
#include "dewbow/base/error.h"
#include "dewbow/rainbow/models.h"
#include "rainbow_degrees.h"
#include "rainbow_setup.h"

namespace dewbow {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kConvention =
    "Bohren & Huffman (1983): time factor exp(-i omega t), index n + ik, k >= 0; S1 perpendicular, "
    "S2 parallel to the scattering plane; 0 deg is forward";

/// Its text reads back as the same number, whatever reads it.
std::string exact(double value) { return fmt::format("{:.17g}", value); }
Json json_number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

struct OneSphere {
    std::string model_name;
    std::unique_ptr<ScatteringModel> model;
    ComplexIndex index{1.0, 0.0};
    Drop drop;
    Orders orders;
    std::vector<Angle> angles;
    Efficiencies efficiencies;
};

OneSphere sphere_of(const RainbowCommand& command) {
    const Storm storm = storm_of(command);
    if (!storm.index)
        throw UsageError("one sphere by --size-parameter needs its index",
                         "for instance --index 1.333");
    if (storm.models.size() > 1)
        throw UsageError(
            fmt::format("{} models for one sphere; expected one", storm.models.size()));
    OneSphere sphere;
    sphere.model_name = storm.models.empty() ? "mie" : storm.models.front();
    sphere.orders = storm.orders;
    sphere.model = make_scattering_model(sphere.model_name, {storm.orders, {}, 0.02});
    sphere.index = *storm.index;
    sphere.drop.size_parameter = *command.size_parameter;
    sphere.angles = storm.angles;
    if (sphere.angles.empty())
        for (const double degrees : stepped(0.0, 180.0, 10.0))
            sphere.angles.push_back(degrees * unit::deg);
    sphere.efficiencies = sphere.model->efficiencies(sphere.index, sphere.drop);
    return sphere;
}

std::vector<Amplitudes> amplitudes_of(const OneSphere& sphere) {
    const auto* model = dynamic_cast<const AmplitudeModel*>(sphere.model.get());
    if (!model)
        throw UsageError(
            fmt::format("model \"{}\" has no amplitudes, only intensities", sphere.model_name),
            "--model mie, debye, airy and uniform_airy have them");
    std::vector<Amplitudes> amplitudes(sphere.angles.size());
    model->amplitudes(sphere.index, sphere.drop, sphere.angles, amplitudes);
    return amplitudes;
}

std::vector<Intensities> intensities_of(const OneSphere& sphere) {
    std::vector<Intensities> intensities(sphere.angles.size());
    sphere.model->intensities(sphere.index, {&sphere.drop, 1}, sphere.angles, intensities);
    return intensities;
}

Json head_json(const OneSphere& sphere) {
    const Efficiencies& q = sphere.efficiencies;
    Json json{{"model", sphere.model_name},
              {"size_parameter", sphere.drop.size_parameter},
              {"index", {{"n", sphere.index.n}, {"k", sphere.index.k}}},
              {"convention", kConvention},
              {"Q_ext", json_number(q.extinction)},
              {"Q_sca", json_number(q.scattering)},
              {"g", json_number(q.asymmetry)}};
    if (!sphere.orders.empty()) json["orders"] = sphere.orders;
    return json;
}

std::string head_text(const OneSphere& sphere) {
    const Efficiencies& q = sphere.efficiencies;
    std::string text = fmt::format("model {}, size parameter {}, index {}", sphere.model_name,
                                   sphere.drop.size_parameter, sphere.index.n);
    if (!sphere.index.is_real()) text += fmt::format(" + {}i", sphere.index.k);
    return text + fmt::format("\n{}\nQ_ext {}\nQ_sca {}\ng     {}\n", kConvention,
                              exact(q.extinction), exact(q.scattering), exact(q.asymmetry));
}

Json json_of(std::complex<double> value) {
    return {json_number(value.real()), json_number(value.imag())};
}

void print_amplitudes(const OneSphere& sphere, bool json) {
    const std::vector<Amplitudes> all = amplitudes_of(sphere);
    Json rows = Json::array();
    std::string text =
        head_text(sphere) + "angle_deg  S1 (real, imaginary)  S2 (real, imaginary)\n";
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double degrees = degrees_of(sphere.angles[i]);
        const auto &s1 = all[i].perpendicular, &s2 = all[i].parallel;
        rows.push_back({{"angle_deg", degrees}, {"S1", json_of(s1)}, {"S2", json_of(s2)}});
        text += fmt::format("{}  {} {}  {} {}\n", degrees, exact(s1.real()), exact(s1.imag()),
                            exact(s2.real()), exact(s2.imag()));
    }
    Json object = head_json(sphere);
    object["amplitudes"] = std::move(rows);
    print_data(json ? object.dump() + "\n" : text);
}

void print_intensities(const OneSphere& sphere, bool json) {
    const std::vector<Intensities> all = intensities_of(sphere);
    Json rows = Json::array();
    std::string text = head_text(sphere) + "angle_deg  |S1|^2  |S2|^2\n";
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double degrees = degrees_of(sphere.angles[i]);
        rows.push_back({{"angle_deg", degrees},
                        {"S1_squared", json_number(all[i].perpendicular)},
                        {"S2_squared", json_number(all[i].parallel)}});
        text += fmt::format("{}  {}  {}\n", degrees, exact(all[i].perpendicular),
                            exact(all[i].parallel));
    }
    Json object = head_json(sphere);
    object["intensities"] = std::move(rows);
    print_data(json ? object.dump() + "\n" : text);
}

}  // namespace

int run_sphere(const RainbowCommand& command) {
    const OneSphere sphere = sphere_of(command);
    if (command.amplitudes)
        print_amplitudes(sphere, command.json);
    else
        print_intensities(sphere, command.json);
    return kDone;
}

}  // namespace dewbow
