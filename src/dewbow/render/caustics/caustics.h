// SPDX-License-Identifier: Apache-2.0
#pragma once

// Camera paths and light paths together: `path`, and beside it paths that start at the lamps,
// aimed at what bends or mirrors light. Shares: weights.h.

#include <memory>
#include <string>

#include "dewbow/render/estimator.h"

namespace dewbow {

/// Where no lamp shines on a caster it is `path`, bit by bit.
class CausticsEstimator : public Estimator {
public:
    /// `scene` must outlive the estimator. It aims by geometry alone until aim() is called.
    explicit CausticsEstimator(const Scene& scene);
    /// Learns where light paths arrive, if the settings wish it. Before anything is rendered.
    void aim();

    void render(const Unit& unit, FilmSums& film) const override;
    double light_paths() const override;
    void trace_light(const LightUnit& unit, SplatList& splats) const override;
    std::optional<LightPathReport> light_path_report() const override;

    /// The same lamps and the same aim, with weights as though there were `share` times as many
    /// light paths; 0: `path`, bit by bit.
    CausticsEstimator with_share_of_light_paths(double share) const;

private:
    struct Prepared;
    CausticsEstimator(std::shared_ptr<Prepared> prepared, double light_paths);

    std::shared_ptr<Prepared> prepared_;
    double light_paths_;  ///< for each sample of each pixel
};

std::unique_ptr<Estimator> make_caustics_estimator(const Scene& scene);
std::string caustics_settings(const RenderSettings& settings);

}  // namespace dewbow
