// SPDX-License-Identifier: Apache-2.0
#pragma once

// The lanes of a packet that a path still carries, packed together.

#include <array>
#include <span>

#include "dewbow/spectrum/wavelengths.h"

namespace dewbow {

/// One number a lane. Not initialised: only the lanes that are carried are written and read.
struct alignas(64) LaneValues {
    std::array<double, kMaxLanes> v;
    double operator[](int k) const { return v[std::size_t(k)]; }
    double& operator[](int k) { return v[std::size_t(k)]; }
    std::span<double> first(int count) { return {v.data(), std::size_t(count)}; }
};

struct LaneSet {
    int count = 0;
    std::array<int, kMaxLanes> id;  ///< which lane of the packet
    LaneValues lambda_nm;

    static LaneSet all(const WavelengthPacket& packet) {
        LaneSet set;
        set.count = packet.count;
        for (int k = 0; k < packet.count; ++k) {
            set.id[std::size_t(k)] = k;
            set.lambda_nm[k] = packet.lambda_nm[std::size_t(k)];
        }
        return set;
    }
    static LaneSet one(const WavelengthPacket& packet, int lane) {
        LaneSet set;
        set.count = 1;
        set.id[0] = lane;
        set.lambda_nm[0] = packet.lambda_nm[std::size_t(lane)];
        return set;
    }
    std::span<const double> lambdas() const { return {lambda_nm.v.data(), std::size_t(count)}; }
};

}  // namespace dewbow
