// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/paper/fog_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "dewbow/base/error.h"
#include "dewbow/base/random.h"
#include "dewbow/optics/dispersion.h"
#include "dewbow/rainbow/drop_ray.h"

namespace dewbow {
namespace {

constexpr double kPi = std::numbers::pi;
/// Musgrave's fit to Kaye & Laby, and his air.                                     [4.3.2]
constexpr double kCauchyA = 1.3239, kCauchyB_nm2 = 3116.3, kPaperAir = 1.0003;
constexpr int kOrders[] = {2, 3};

using Buckets = std::vector<double>;

std::size_t bucket_of(Angle scattering) {
    const double r = (kPi * unit::rad - scattering) / kPaperBucket;
    return std::min(std::size_t(std::max(r, 0.0)), std::size_t(kPaperBuckets - 1));
}

double solid_angle(std::size_t bucket) {
    return cell_solid_angle(double(bucket) * kPaperBucket, double(bucket + 1) * kPaperBucket)
        .to(unit::sr);
}

/// Impact parameter of ray k.
double impact_parameter(const PaperMethod& method, int sample, int k) {
    const double within =
        method.random_rays
            ? SampleKey(stream_key(method.seed, std::uint32_t(sample), std::uint32_t(k)), 0)
                  .one(0, Purpose::impact_parameter)
            : 0.5;
    return method.random_rays ? within : (k + within) / method.rays;
}

/// Calls add(bucket, flux) for what one ray sends out after one reflection, and after two.
template <class Add>
void trace_ray(const PaperMethod& method, double b, RelativeIndex n, const Add& add) {
    const DropRay ray = drop_ray(b, n);
    const double weight =
        (method.density == RayDensity::even_over_disc ? 2.0 * b : 1.0) / method.rays;
    for (int p : kOrders) {
        const RayAmplitudes left = ray_amplitudes(ray, n, p);
        const double energy =
            0.5 * (left.perpendicular * left.perpendicular + left.parallel * left.parallel);
        const std::size_t bucket = bucket_of(scattering_angle(deviation(ray, p)));
        add(bucket, weight * energy / (method.per_solid_angle ? solid_angle(bucket) : 1.0));
    }
}

/// The limit of ever more rays.
Buckets exact_intensities(const PaperMethod& method, RelativeIndex n) {
    std::vector<Angle> edges;
    for (int k = 0; k <= kPaperBuckets; ++k) edges.push_back(double(k) * kPaperBucket);
    std::vector<PolarisedFlux> cells(kPaperBuckets);
    for (int p : kOrders) add_geometric_flux(n, p, edges, cells, method.density);
    Buckets buckets(kPaperBuckets);
    for (std::size_t k = 0; k < buckets.size(); ++k)
        buckets[k] = cells[kPaperBuckets - 1 - k].unpolarised() /
                     (method.per_solid_angle ? solid_angle(k) : 1.0);
    return buckets;
}

using Channels = std::array<Buckets, 3>;

void check(const PaperMethod& method) {
    if (method.wavelengths < 1)
        throw InputError(fmt::format("{} wavelengths; expected 1 or more", method.wavelengths));
    if (method.jitter_wavelengths && method.rays < 1)
        throw InputError("wavelengths are jittered ray by ray; expected 1 ray or more");
}

/// One wavelength for all rays of an interval.
Channels fixed_wavelengths(const PaperMethod& method) {
    Channels rgb;
    rgb.fill(Buckets(kPaperBuckets));
    Colour<LinearSrgb> white;
    for (int k = 0; k < method.wavelengths; ++k) {
        const double f = (k + 0.5) / method.wavelengths;
        const Colour<LinearSrgb> colour = linear_spectrum_colour(f);
        white = white + colour;
        const Buckets buckets = paper_intensities(method, paper_wavelength(f, method.spacing));
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t i = 0; i < buckets.size(); ++i) rgb[c][i] += colour[c] * buckets[i];
    }
    // A number of samples that is no multiple of 13 would tint the sum.
    for (std::size_t c = 0; c < 3; ++c)
        if (white[c] > 0.0)
            for (double& value : rgb[c]) value *= kPaperWhite / white[c];
    return rgb;
}

Channels jittered_wavelengths(const PaperMethod& method) {
    Channels rgb;
    rgb.fill(Buckets(kPaperBuckets));
    for (int k = 0; k < method.wavelengths; ++k) {
        const std::uint64_t stream = stream_key(method.seed, std::uint32_t(k), 0);
        for (int ray = 0; ray < method.rays; ++ray) {
            const SampleKey key(stream, std::uint32_t(ray));
            const double f = (k + key.one(0, Purpose::wavelength)) / method.wavelengths;
            const Colour<LinearSrgb> colour = linear_spectrum_colour(f);
            const RelativeIndex n = paper_index(method, paper_wavelength(f, method.spacing));
            trace_ray(method, impact_parameter(method, k, ray), n,
                      [&](std::size_t bucket, double flux) {
                          for (std::size_t c = 0; c < 3; ++c) rgb[c][bucket] += colour[c] * flux;
                      });
        }
    }
    return rgb;
}

}  // namespace

PaperMethod paper_method_corrected() {
    PaperMethod method;
    method.density = RayDensity::even_over_disc;
    method.per_solid_angle = true;
    method.water = PaperWater::iapws;
    method.divide_by_air = false;
    method.kernel = SunKernel::disc;
    method.wavelengths = 10 * kPaperSamples;
    method.rays = 0;
    return method;
}

RelativeIndex paper_index(const PaperMethod& method, Wavelength lambda) {
    const double nm = lambda.to(unit::nm);
    static const DispersionPtr water = make_dispersion({"water", {20.0}, IndexReference::vacuum});
    static const DispersionPtr around = air();
    const double n = method.water == PaperWater::cauchy
                         ? kCauchyA + kCauchyB_nm2 / (nm * nm)
                         : ((*water)(lambda) / (*around)(lambda)).value;
    return {method.divide_by_air ? n / kPaperAir : n};
}

std::vector<double> sun_kernel(SunKernel kernel) {
    if (kernel == SunKernel::none) return {1.0};
    if (kernel == SunKernel::disc) return projection_kernel({kSunRadius, 0.0}, kPaperBucket);
    const auto taps = published_sun_kernel();
    return {taps.begin(), taps.end()};
}

std::vector<double> convolve_mirrored(const std::vector<double>& values,
                                      const std::vector<double>& kernel) {
    const int size = int(values.size()), reach = int(kernel.size()) / 2;
    std::vector<double> result(values.size());
    for (int i = 0; i < size; ++i)
        for (int k = -reach; k <= reach; ++k) {
            const int at = i + k, mirrored = at < 0 ? -1 - at : at;
            const int inside = mirrored >= size ? 2 * size - 1 - mirrored : mirrored;
            result[std::size_t(inside)] += kernel[std::size_t(k + reach)] * values[std::size_t(i)];
        }
    return result;
}

std::vector<double> paper_intensities(const PaperMethod& method, Wavelength lambda) {
    if (method.rays < 0) throw InputError(fmt::format("{} rays; expected 0 or more", method.rays));
    const RelativeIndex n = paper_index(method, lambda);
    if (method.rays == 0) return exact_intensities(method, n);
    Buckets buckets(kPaperBuckets);
    const int sample = int(std::lround(lambda.to(unit::nm) * 1000.0));
    for (int k = 0; k < method.rays; ++k)
        trace_ray(method, impact_parameter(method, sample, k), n,
                  [&](std::size_t bucket, double flux) { buckets[bucket] += flux; });
    return buckets;
}

FogTable make_fog_table(const PaperMethod& method) {
    check(method);
    Channels rgb =
        method.jitter_wavelengths ? jittered_wavelengths(method) : fixed_wavelengths(method);
    const std::vector<double> kernel = sun_kernel(method.kernel);
    double greatest = 0.0;
    for (Buckets& channel : rgb) {
        channel = convolve_mirrored(channel, kernel);
        greatest = std::max(greatest, *std::max_element(channel.begin(), channel.end()));
    }
    FogTable table;
    table.intensity.resize(kPaperBuckets);
    table.transmittance.resize(kPaperBuckets);
    for (std::size_t i = 0; i < std::size_t(kPaperBuckets); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const double value = rgb[c][i] / greatest;
            table.intensity[i][c] = value;
            table.transmittance[i][c] =
                value > 0.0 ? 1.0 / value : std::numeric_limits<double>::infinity();
        }
    return table;
}

}  // namespace dewbow
