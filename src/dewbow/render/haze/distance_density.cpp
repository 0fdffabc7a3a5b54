// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/haze/distance_density.h"

#include <algorithm>
#include <cmath>

namespace dewbow {

namespace {

constexpr double kOneBelow = 1.0 - 0x1p-53;  // the largest double below 1
/// A ray that meets a lamp's centre passes it at this share of the way there: above roundings of
/// its direction.
constexpr double kLeastWidth = 1e-12;

/// `u` within the part of [0, 1) of width `share` that begins at `low`, stretched to [0, 1).
double stretched(double u, double low, double share) {
    return std::clamp((u - low) / share, 0.0, kOneBelow);
}

/// What lies further away, m, has no place in double precision beside what is here.
constexpr double kFurthest = 1e15;

/// 1 − e^(−σ d): the share of light that is lost on the way d.
double lost(double per_m, double distance) { return -std::expm1(-per_m * distance); }

}  // namespace

DistanceDensity::DistanceDensity(std::span<const double> extinction) {
    int lanes = 0;
    for (const double per_m : extinction) {
        if (!(per_m > 0.0)) continue;
        ++lanes;
        const auto end = extinctions_.begin() + extinction_count_;
        const auto same = std::find_if(extinctions_.begin(), end,
                                       [&](const Extinction& e) { return e.per_m == per_m; });
        if (same == end) extinctions_[std::size_t(extinction_count_++)] = {per_m, 0.0};
        same->share += 1.0;
    }
    for (Extinction& e : extinctions()) e.share /= lanes;
}

void DistanceDensity::add(const Term& term) {
    if (!(term.weight > 0.0) || !std::isfinite(term.weight) || count_ == kMostTerms) return;
    terms_[std::size_t(count_++)] = term;
    total_ += term.weight;
}

void DistanceDensity::add_equiangular(RayInterval where, double centre, double width,
                                      double intensity) {
    if (where.empty()) return;
    width = std::max(width, kLeastWidth * (1.0 + std::abs(centre)));
    const double angle =
        std::atan((where.end - centre) / width) - std::atan((where.begin - centre) / width);
    // What is left of the brightest of it on its way to the ray and along it.
    const double nearest = std::clamp(centre, where.begin, where.end);
    const double way = nearest + std::hypot(width, nearest - centre);
    double left = 0.0;
    for (const Extinction& e : extinctions()) left += e.share * std::exp(-e.per_m * way);
    add({intensity * left * angle / width, where, true, centre, width, angle});
}

void DistanceDensity::add_attenuated(RayInterval where, double irradiance) {
    if (where.empty()) return;
    double length = 0.0;
    for (const Extinction& e : extinctions())
        length += e.share * std::exp(-e.per_m * where.begin) *
                  lost(e.per_m, where.end - where.begin) / e.per_m;
    add({irradiance * length, where, false, 0.0, 0.0, 0.0});
}

void DistanceDensity::finish(RayInterval where, double defensive) {
    const double others = total_;
    if (count_ == kMostTerms) total_ -= terms_[std::size_t(--count_)].weight;
    add_attenuated(where, 1.0);
    if (!(others > 0.0) || empty()) return;
    Term& last = terms_[std::size_t(count_ - 1)];
    total_ -= last.weight;
    last.weight = total_ * defensive / (1.0 - defensive);
    total_ += last.weight;
}

double DistanceDensity::sample(double u) const {
    double low = 0.0;
    for (int i = 0; i + 1 < count_; ++i) {
        const double share = terms_[std::size_t(i)].weight / total_;
        if (u < low + share) return sample(terms_[std::size_t(i)], stretched(u, low, share));
        low += share;
    }
    const Term& last = terms_[std::size_t(count_ - 1)];
    return sample(last, stretched(u, low, last.weight / total_));
}

double DistanceDensity::sample(const Term& term, double u) const {
    const RayInterval& where = term.where;
    double distance;
    if (term.equiangular) {
        const double first = std::atan((where.begin - term.centre) / term.width);
        distance = term.centre + term.width * std::tan(first + u * term.angle);
    } else {
        int i = 0;
        double low = 0.0;
        while (i + 1 < extinction_count_ && u >= low + extinctions_[std::size_t(i)].share)
            low += extinctions_[std::size_t(i++)].share;
        const Extinction& e = extinctions_[std::size_t(i)];
        const double left = stretched(u, low, e.share) * lost(e.per_m, where.end - where.begin);
        distance = where.begin - std::log1p(-left) / e.per_m;
    }
    return std::clamp(distance, where.begin, std::min(where.end, kFurthest));
}

double DistanceDensity::pdf(double distance) const {
    double sum = 0.0;
    for (int i = 0; i < count_; ++i)
        sum += terms_[std::size_t(i)].weight * pdf(terms_[std::size_t(i)], distance);
    return sum / total_;
}

double DistanceDensity::pdf(const Term& term, double distance) const {
    if (distance < term.where.begin || distance > term.where.end) return 0.0;
    if (term.equiangular) {
        const double along = distance - term.centre;
        return term.width / (term.angle * (term.width * term.width + along * along));
    }
    double sum = 0.0;
    for (const Extinction& e : extinctions())
        sum += e.share * e.per_m * std::exp(-e.per_m * (distance - term.where.begin)) /
               lost(e.per_m, term.where.end - term.where.begin);
    return sum;
}

}  // namespace dewbow
