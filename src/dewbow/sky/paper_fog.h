// SPDX-License-Identifier: Apache-2.0
#pragma once

// The paper's rainbow in a picture: fog of a colour, or of a transmittance, that depends on the
// angle between a ray and the antisolar point.                        [Musgrave 1989, 4.3]

#include <optional>
#include <variant>

#include "dewbow/math/vector.h"
#include "dewbow/rainbow/paper/fog_table.h"
#include "dewbow/rainbow/paper/impressionistic.h"
#include "dewbow/sky/chaos.h"

namespace dewbow {

/// How much of what is behind a fog is replaced, with h d over t (eq. 14).
enum class FogEquation {
    corrected,  ///< 1 − e^{−hd/t}: nothing near, everything infinitely far
    printed,    ///< e^{hd/t}: everything and more, from the eye on
};

/// 13 coloured fogs of one transmittance in rings.                                     [4.3.1]
struct PaperRings {
    ImpressionisticBow bow;
    Colour<LinearSrgb> transmittance{{1.0, 1.0, 1.0}};  ///< > 0; "usually equal"
};

struct PaperRainbow {
    /// Rings, or white fogs whose transmittances are 4.3.2's table.
    std::variant<PaperRings, PaperMethod> bow = PaperMethod{};
    FogEquation equation = FogEquation::corrected;
    /// h; what is brightest in the table is replaced by 63 % at the distance 1/h.
    InverseLength constant = 1.0 / (1000.0 * unit::m);
    /// The rain ends here, or at what a ray meets before. Without it, as the paper has it, fog
    /// would turn all of the sky white where there is any (erratum E23). May be infinite.
    Length depth = 1000.0 * unit::m;
    /// Of white fog, cd m⁻²; nothing: the film's white.
    std::optional<double> luminance;
    /// On the ray's direction: transmittances are divided by its density.
    std::optional<Chaos> chaos;
};

/// Immutable.
class PaperFog {
public:
    /// @param antisolar  from the sun to the eye.
    /// Throws InputError: a table that cannot be made, numbers out of range.
    PaperFog(const PaperRainbow& rainbow, Dir<World> antisolar);

    struct Share {
        /// Of each channel, of what is behind it: 0 to 1; as printed 1 or more.
        Colour<LinearSrgb> replaced;
        Colour<LinearSrgb> colour;  ///< of the fog; (1, 1, 1) is white
    };
    /// What stands on a ray; nothing where there is no fog.
    /// @param direction  of the ray, from the eye, unit length.   @param distance  to what it
    /// meets; may be infinite.   @param u  in [0, 1)², for jitter.
    std::optional<Share> on_ray(Dir<World> direction, Length distance,
                                std::array<double, 2> u) const;

    const PaperRainbow& rainbow() const { return rainbow_; }

private:
    double replaced(Length distance, double transmittance, double density) const;

    PaperRainbow rainbow_;
    Dir<World> antisolar_;
    FogTable table_;  ///< empty: rings
};

/// Throws InputError that names the first thing that is out of its range.
void check_paper_rainbow(const PaperRainbow& rainbow);
void check_chaos(const Chaos& chaos);

}  // namespace dewbow
