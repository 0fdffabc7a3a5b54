// SPDX-License-Identifier: Apache-2.0
#include "glass_facts.h"

#include "dewbow/base/error.h"
#include "dewbow/import/glass/glass_file.h"

namespace dewbow {

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text.append(text.empty() ? "" : ", ").append(word);
    return text;
}

Glass glass_named(const std::string& name) {
    if (is_glass_file_reference(name)) {
        const GlassReference reference = split_glass_reference(name);
        return load_glass(reference.file, reference.name);
    }
    try {
        return find_glass(name);
    } catch (const InputError& error) {
        throw UsageError(error.sentence(), error.hint());
    }
}

GlassFacts::GlassFacts(Glass of) : glass(std::move(of)), dispersion(make_dispersion(glass.data)) {
    const DispersionPtr medium = medium_of(glass.data.reference);
    in_air = index_in_air(dispersion);
    const IndexInAir n = [this, medium](double air_nm) {
        const Wavelength lambda = vacuum_wavelength(air_nm);
        return (*dispersion)(lambda).value / (*medium)(lambda).value;
    };
    n_d = n(kAird_nm);
    V_d = abbe_number(*dispersion, *medium);
    w = dispersion->is_constant() ? 0.0 : dispersive_power(n);
    P_gF = dispersion->is_constant() ? 0.0 : partial_dispersion(n, 435.8343, kAirF_nm);
}

double GlassFacts::index_in_vacuum(double lambda_nm) const {
    return (*dispersion)(lambda_nm * unit::nm).value;
}

double GlassFacts::index(double lambda_nm) const {
    return index_in_vacuum(lambda_nm) /
           (*medium_of(glass.data.reference))(lambda_nm * unit::nm).value;
}

bool GlassFacts::has_data_at(double lambda_nm) const {
    return lambda_nm >= glass.lambda_min_nm && lambda_nm <= glass.lambda_max_nm;
}

std::vector<std::string> GlassFacts::notes() const {
    std::vector<std::string> all;
    if (const auto note = range_warning(glass)) all.push_back(*note);
    if (const auto note = birefringence_note(glass)) all.push_back(*note);
    return all;
}

}  // namespace dewbow
