// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/light_set.h"

#include <algorithm>
#include <cmath>

namespace dewbow {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kOneBelow = 1.0 - 0x1p-53;  // the largest double below 1
/// Share of the choices that falls on all groups of lights alike, and within the infinitely far
/// ones on all alike, so that none is starved by an estimate that knows nothing of what stands
/// between.
constexpr double kEvenShare = 0.1;

LightSample from_arrival(LightSample::Source source, int index, const Arrival& arrival,
                         double chosen) {
    return {source, index, arrival.direction, arrival.distance, chosen, arrival.factor, true};
}

/// `u` within the part of [0, 1) of width `share` that begins at `low`, stretched to [0, 1).
double stretched(double u, double low, double share) {
    return std::clamp((u - low) / share, 0.0, kOneBelow);
}

}  // namespace

LightSet::LightSet(const Scene& scene) : glowing_of_shape_(scene.shapes.size(), -1) {
    for (std::size_t i = 0; i < scene.shapes.size(); ++i)
        if (scene.materials[std::size_t(scene.shapes[i].material)].gives_light())
            add_shape(scene, int(i));
    for (const Light& light : scene.lights) {
        if (PunctualLight::holds(light))
            punctual_.emplace_back(light);
        else if (const auto* beam = std::get_if<BeamLight>(&light))
            beams_.emplace_back(*beam);
        else
            infinite_.emplace_back(light);
    }
    build_tree();
    std::vector<bool> not_distant;
    for (const InfiniteLight& light : infinite_) not_distant.push_back(!light.distant());
    far_ = far_of(std::vector<bool>(infinite_.size(), true));
    far_but_distant_ = far_of(not_distant);
}

LightSet::Far LightSet::far_of(const std::vector<bool>& asked) const {
    const auto count = std::count(asked.begin(), asked.end(), true);
    if (count == 0) return {};
    Far far;
    for (std::size_t i = 0; i < asked.size(); ++i)
        if (asked[i]) far.irradiance += infinite_[i].irradiance();
    std::vector<double> weights(asked.size(), 0.0);
    for (std::size_t i = 0; i < asked.size(); ++i)
        if (asked[i])
            weights[i] =
                (1.0 - kEvenShare) *
                    (far.irradiance > 0.0 ? infinite_[i].irradiance() / far.irradiance : 0.0) +
                kEvenShare / double(count);
    far.choose.emplace(weights);
    return far;
}

void LightSet::add_shape(const Scene& scene, int shape) {
    glowing_of_shape_[std::size_t(shape)] = int(shapes_.size());
    shapes_.emplace_back(scene, shape);
}

void LightSet::build_tree() {
    std::vector<LightBounds> bounds;
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
        first_leaf_.push_back(int(leaves_.size()));
        for (int part = 0; part < shapes_[i].parts(); ++part) {
            leaves_.push_back({LightSample::Source::shape, int(i), part});
            bounds.push_back(shapes_[i].bounds(part));
        }
    }
    for (std::size_t i = 0; i < punctual_.size(); ++i) {
        leaves_.push_back({LightSample::Source::punctual, int(i), 0});
        bounds.push_back(punctual_[i].bounds());
    }
    tree_.emplace(bounds);
}

std::vector<LightBounds> LightSet::near_bounds() const {
    std::vector<LightBounds> all;
    for (const GlowingShape& shape : shapes_) {
        LightBounds whole = shape.bounds(0);
        for (int part = 1; part < shape.parts(); ++part) whole = join(whole, shape.bounds(part));
        all.push_back(whole);
    }
    for (const PunctualLight& light : punctual_) all.push_back(light.bounds());
    return all;
}

double LightSet::beam_irradiance(const Receiver& receiver) const {
    double sum = 0.0;
    for (const Beam& beam : beams_) sum += beam.irradiance(receiver);
    return sum;
}

LightSet::Shares LightSet::shares(const Receiver& receiver, Asked asked) const {
    const Far& far = this->far(asked);
    if (beams_.empty() && !far.choose) return {1.0, 0.0, 0.0};
    if (beams_.empty() && tree_->empty()) return {0.0, 0.0, 1.0};
    Shares shares{tree_->irradiance(receiver), beam_irradiance(receiver), far.irradiance};
    const double sum = shares.near + shares.beams + shares.far;
    if (!(sum > 0.0)) return {0.0, 0.0, far.choose ? 1.0 : 0.0};
    const int groups = (shares.near > 0.0) + (shares.beams > 0.0) + (shares.far > 0.0);
    for (double* share : {&shares.near, &shares.beams, &shares.far})
        if (*share > 0.0) *share = (1.0 - kEvenShare) * *share / sum + kEvenShare / groups;
    return shares;
}

std::optional<LightSample> LightSet::sample(const Receiver& receiver, double u_choice,
                                            std::array<double, 2> u, Asked asked) const {
    const Shares share = shares(receiver, asked);
    std::optional<LightSample> sample;
    if (u_choice < share.near) {
        sample = sample_near(receiver, stretched(u_choice, 0.0, share.near), u);
        if (sample) sample->pdf *= share.near;
    } else if (u_choice < share.near + share.beams) {
        sample = sample_beam(receiver, stretched(u_choice, share.near, share.beams));
        if (sample) sample->pdf *= share.beams;
    } else if (share.far > 0.0) {
        sample = sample_far(stretched(u_choice, share.near + share.beams, share.far), u, asked);
        if (sample) sample->pdf *= share.far;
    }
    return sample;
}

std::optional<LightSample> LightSet::sample_near(const Receiver& receiver, double u_choice,
                                                 std::array<double, 2> u) const {
    const auto choice = tree_->sample(receiver, u_choice);
    if (!choice) return std::nullopt;
    const Leaf& leaf = leaves_[std::size_t(choice->light)];
    if (leaf.source == LightSample::Source::punctual) {
        const auto arrival = punctual_[std::size_t(leaf.index)].arrival(receiver.position);
        if (!arrival) return std::nullopt;
        return from_arrival(leaf.source, leaf.index, *arrival, choice->probability);
    }
    const auto s = shapes_[std::size_t(leaf.index)].sample(leaf.part, receiver.position, u);
    if (!s) return std::nullopt;
    LightSample sample{leaf.source, leaf.index, s->direction, s->distance,
                       choice->probability * s->pdf};
    sample.primitive = s->primitive;
    const Glow& glow = shapes_[std::size_t(leaf.index)].glow();
    if (!glow.varies()) return sample;
    const SurfaceCoordinates at = shapes_[std::size_t(leaf.index)].coordinates(*s);
    sample.factor = glow.alpha(at);
    if (sample.factor == 0.0) return std::nullopt;
    if (glow.coloured()) sample.colour = glow.colour(at);
    return sample;
}

std::optional<LightSample> LightSet::sample_beam(const Receiver& receiver, double u_choice) const {
    const double sum = beam_irradiance(receiver);
    double target = u_choice * sum;
    int last = -1;  // rounding may leave a rest
    for (std::size_t i = 0; i < beams_.size() && target >= 0.0; ++i) {
        const double here = beams_[i].irradiance(receiver);
        if (!(here > 0.0)) continue;
        last = int(i);
        target -= here;
    }
    if (last < 0) return std::nullopt;
    const Beam& beam = beams_[std::size_t(last)];
    return from_arrival(LightSample::Source::beam, last, *beam.arrival(receiver.position),
                        beam.irradiance(receiver) / sum);
}

std::optional<LightSample> LightSet::sample_far(double u_choice, std::array<double, 2> u,
                                                Asked asked) const {
    const Distribution1D& choose = *far(asked).choose;
    const std::size_t index = choose.sample(u_choice).index;
    const auto s = infinite_[index].sample(u);
    if (!s) return std::nullopt;
    return LightSample{LightSample::Source::infinite,
                       int(index),
                       s->direction,
                       kInfinity,
                       choose.probability(index) * s->pdf,
                       1.0,
                       infinite_[index].parallel()};
}

void LightSet::radiance(const LightSample& sample, const LaneSet& lanes, RgbLightLanes& rgb,
                        LaneValues& out) const {
    const auto index = std::size_t(sample.index);
    if (sample.source == LightSample::Source::infinite) {
        infinite_[index].radiance(sample.direction, lanes, rgb, out);
        return;
    }
    const std::span<double> values = out.first(lanes.count);
    if (sample.source == LightSample::Source::punctual)
        punctual_[index].spectrum().eval_lanes(lanes.lambdas(), values);
    else if (sample.source == LightSample::Source::beam)
        beams_[index].spectrum().eval_lanes(lanes.lambdas(), values);
    else if (shapes_[index].glow().coloured())
        rgb.eval(sample.colour, lanes, out);
    else
        shapes_[index].glow().spectrum().eval_lanes(lanes.lambdas(), values);
    if (sample.factor != 1.0)
        for (int k = 0; k < lanes.count; ++k) out[k] *= sample.factor;
}

const Glow& LightSet::glow_at(const Hit& hit) const {
    return shapes_[std::size_t(glowing_of_shape_[std::size_t(hit.shape)])].glow();
}

void LightSet::emission(const Hit& hit, const SurfaceCoordinates& at, const LaneSet& lanes,
                        RgbLightLanes& rgb, LaneValues& out) const {
    const Glow& glow = glow_at(hit);
    if (glow.coloured())
        rgb.eval(glow.colour(at), lanes, out);
    else
        glow.spectrum().eval_lanes(lanes.lambdas(), out.first(lanes.count));
}

double LightSet::pdf_of_hit(const Receiver& receiver, Vec3 direction, const Hit& hit) const {
    const auto glowing = std::size_t(glowing_of_shape_[std::size_t(hit.shape)]);
    const int part = shapes_[glowing].part_of(hit, receiver.position + direction * hit.t);
    const double chosen =
        shares(receiver).near * tree_->probability(receiver, first_leaf_[glowing] + part);
    if (chosen == 0.0) return 0.0;
    return chosen * shapes_[glowing].pdf(part, receiver.position, direction, hit);
}

double LightSet::pdf_of_choice(const Receiver& receiver, LightSample::Source source,
                               int index) const {
    const Shares share = shares(receiver);
    switch (source) {
        case LightSample::Source::shape:
            return 0.0;
        case LightSample::Source::punctual: {
            const int leaf = int(leaves_.size() - punctual_.size()) + index;
            return share.near * tree_->probability(receiver, leaf);
        }
        case LightSample::Source::beam: {
            const double sum = beam_irradiance(receiver);
            return sum > 0.0 ? share.beams * beams_[std::size_t(index)].irradiance(receiver) / sum
                             : 0.0;
        }
        case LightSample::Source::infinite:
            return share.far * far_.choose->probability(std::size_t(index));
    }
    return 0.0;
}

bool LightSet::infinite_radiance(int i, Vec3 direction, const LaneSet& lanes, RgbLightLanes& rgb,
                                 LaneValues& out) const {
    const InfiniteLight& light = infinite_[std::size_t(i)];
    if (!light.shows(direction)) return false;
    light.radiance(direction, lanes, rgb, out);
    return true;
}

double LightSet::pdf_of_infinite(const Receiver& receiver, int i, Vec3 direction,
                                 Asked asked) const {
    const Far& far = this->far(asked);
    if (!far.choose) return 0.0;
    return shares(receiver, asked).far * far.choose->probability(std::size_t(i)) *
           infinite_[std::size_t(i)].pdf(direction);
}

}  // namespace dewbow
