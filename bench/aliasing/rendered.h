// SPDX-License-Identifier: Apache-2.0
#pragma once

// The same pictures as dispersed_source.h has in closed form, rendered by distributed_1989.

#include "aliasing/dispersed_source.h"
#include "aliasing/prisms.h"

namespace dewbow::bench {

/// aliasing() of pictures of a source of `width_arcmin` through the prism, in pixels of
/// `pixel_arcmin`: that of `samples` fixed samples against one of very many.
double rendered_aliasing(const Prism& prism, Angle apex, double width_arcmin, double pixel_arcmin,
                         int samples);

}  // namespace dewbow::bench
