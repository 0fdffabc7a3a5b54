// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/distributed_1989/scene_of_1989.h"

#include <map>
#include <utility>

#include "dewbow/optics/paper_index.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/illuminant.h"
#include "dewbow/spectrum/lanewise.h"

namespace dewbow::distributed_1989 {

namespace {

constexpr double kBlueEnds_nm = 490.0, kGreenEnds_nm = 580.0;

class Channels : public Lanewise<Channels> {
public:
    explicit Channels(MonitorRgb rgb) : rgb_(rgb) {}
    double value_at(double lambda_nm) const {
        return lambda_nm < kBlueEnds_nm ? rgb_[2] : lambda_nm < kGreenEnds_nm ? rgb_[1] : rgb_[0];
    }
    double max_value() const override { return *std::max_element(rgb_.v.begin(), rgb_.v.end()); }
    bool is_constant() const override { return rgb_[0] == rgb_[1] && rgb_[1] == rgb_[2]; }

private:
    MonitorRgb rgb_;
};

/// What a surface of that reflectance gives back of D65.
class UnderWhite : public Lanewise<UnderWhite> {
public:
    explicit UnderWhite(const Spectrum& reflectance) : reflectance_(reflectance) {}
    double value_at(double lambda_nm) const {
        const Wavelength lambda = lambda_nm * unit::nm;
        return reflectance_(lambda) * (*white_)(lambda);
    }
    double max_value() const override { return reflectance_.max_value() * white_->max_value(); }

private:
    const Spectrum& reflectance_;
    SpectrumPtr white_ = find_illuminant("D65");
};

MonitorRgb rgb_of_light(const Colour<Xyz>& light, const SpectralModel& model) {
    MonitorRgb rgb = model.rgb(light * (1.0 / cie_y_integral()));
    for (double& channel : rgb.v) channel = std::max(0.0, channel);
    return rgb;
}
MonitorRgb rgb_of_light(const Spectrum& light, const SpectralModel& model) {
    return rgb_of_light(xyz_from_spectrum(light), model);
}

/// The channels of a sky's light, direction by direction.
class SkyInChannels : public SkyDome {
public:
    SkyInChannels(SkyDomePtr sky, const SpectralModel& model)
        : sky_(std::move(sky)), model_(model) {
        for (int i = 0; i < kPlaces; ++i)
            lambda_nm_[std::size_t(i)] = kLambdaMin_nm + (i + 0.5) * kStep_nm;
    }
    void radiance_lanes(Dir<World> direction, std::span<const double> lambda_nm,
                        std::span<double> out) const override {
        std::array<double, kPlaces> radiance;
        sky_->radiance_lanes(direction, lambda_nm_, radiance);
        Colour<Xyz> xyz{};
        for (std::size_t i = 0; i < kPlaces; ++i) {
            const auto bar = cie_xyz_bar(lambda_nm_[i]);
            for (std::size_t c = 0; c < 3; ++c) xyz.v[c] += radiance[i] * bar[c] * kStep_nm;
        }
        const SpectrumPtr channels = make_channels(rgb_of_light(xyz, model_));
        channels->eval_lanes(lambda_nm, out);
    }
    double luminance(Dir<World> direction) const override { return sky_->luminance(direction); }

private:
    /// Skies are smooth but for lines of the night: 5 nm.
    static constexpr int kPlaces = 94;
    static constexpr double kStep_nm = (kLambdaMax_nm - kLambdaMin_nm) / kPlaces;
    SkyDomePtr sky_;
    const SpectralModel& model_;
    std::array<double, kPlaces> lambda_nm_;
};

/// Puts channels in the place of spectra.
class ToChannels {
public:
    explicit ToChannels(const SpectralModel& model) : model_(model) {}

    void light(SpectrumPtr& spectrum) const {
        if (spectrum) spectrum = channels_of_light(*spectrum, model_);
    }
    void reflectance(ColourInput& input) const {
        if (input.spectrum) input.spectrum = channels_of_reflectance(*input.spectrum, model_);
    }

    // Surfaces.
    void operator()(Black&) const {}
    void operator()(Mix&) const {}
    void operator()(Conductor&) const {}
    void operator()(Diffuse& s) const { reflectance(s.reflectance); }
    void operator()(Mirror& s) const { reflectance(s.reflectance); }
    void operator()(Dielectric& s) const { reflectance(s.tint); }
    void operator()(ThinDielectric& s) const { reflectance(s.tint); }
    void operator()(MetallicRoughness& s) const {
        reflectance(s.base_colour);
        reflectance(s.specular_colour);
        reflectance(s.sheen_colour);
    }

    // Lights.
    void operator()(PointLight& l) const { light(l.intensity); }
    void operator()(SpotLight& l) const { light(l.intensity); }
    void operator()(ProfileLight& l) const { light(l.intensity_per_cd); }
    void operator()(BeamLight& l) const { light(l.irradiance); }
    void operator()(DistantLight& l) const { light(l.irradiance); }
    void operator()(UniformEnvironment& l) const { light(l.radiance); }
    void operator()(std::shared_ptr<const ImageEnvironment>&) const {}
    void operator()(SkyDomePtr& sky) const {
        sky = std::make_shared<SkyInChannels>(std::move(sky), model_);
    }

private:
    const SpectralModel& model_;
};

/// Media that scatter nothing, and whose indices are straight lines if asked for. What was one
/// medium stays one.
class ToldMedia {
public:
    explicit ToldMedia(const Distributed1989Settings& settings)
        : lines_(settings.index == IndexSource::linear), spacing_(settings.model.spacing) {}

    void operator()(MediumPtr& medium) {
        if (!lines_ && !medium->scattering) return;
        MediumPtr& told = told_[medium];
        if (!told) {
            Medium copy = *medium;
            copy.index = of(copy.index);
            copy.scattering = nullptr;
            copy.phase = nullptr;
            told = std::make_shared<const Medium>(std::move(copy));
        }
        medium = told;
    }
    void operator()(Material& material) {
        if (auto* glass = std::get_if<Dielectric>(&material.surface)) (*this)(glass->interior);
        if (auto* pane = std::get_if<ThinDielectric>(&material.surface))
            pane->index = of(pane->index);
    }

private:
    DispersionPtr of(const DispersionPtr& real) const {
        return lines_ ? paper_index_of(real, IndexReading::intended, spacing_) : real;
    }

    bool lines_;
    SpectralSpacing spacing_;
    std::map<MediumPtr, MediumPtr> told_;
};

}  // namespace

SpectrumPtr make_channels(MonitorRgb rgb) { return std::make_shared<Channels>(rgb); }

SpectrumPtr channels_of_light(const Spectrum& light, const SpectralModel& model) {
    return make_channels(rgb_of_light(light, model));
}

SpectrumPtr channels_of_reflectance(const Spectrum& reflectance, const SpectralModel& model) {
    if (reflectance.is_constant()) {
        const double value = reflectance(kChannel_nm[0] * unit::nm);
        return make_channels({{value, value, value}});
    }
    MonitorRgb rgb = rgb_of_light(UnderWhite(reflectance), model);
    for (double& channel : rgb.v) channel = std::min(1.0, channel);
    return make_channels(rgb);
}

RgbBasis light_basis_in_channels(const SpectralModel& model) {
    RgbBasis basis;
    for (std::size_t i = 0; i < basis.size(); ++i)
        basis[i] = channels_of_light(*light_basis()[i], model);
    return basis;
}

RgbBasis reflectance_basis_in_channels(const SpectralModel& model) {
    RgbBasis basis;
    for (std::size_t i = 0; i < basis.size(); ++i)
        basis[i] = channels_of_reflectance(*reflectance_basis()[i], model);
    return basis;
}

Scene scene_of_1989(const Scene& scene, const SpectralModel& model) {
    const Distributed1989Settings& settings = scene.render.distributed_1989;
    Scene told = scene;
    told.aerial = nullptr;
    ToldMedia told_media(settings);
    told_media(told.surroundings);
    for (Material& material : told.materials) told_media(material);
    if (settings.transport == RgbOrSpectral::rgb) {
        const ToChannels to_channels(model);
        for (Material& material : told.materials) {
            to_channels.light(material.emission);
            std::visit(to_channels, material.surface);
        }
        for (Light& light : told.lights) std::visit(to_channels, light);
    }
    return told;
}

}  // namespace dewbow::distributed_1989
