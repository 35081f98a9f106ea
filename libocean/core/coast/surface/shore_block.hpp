// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The labels that are read together while their waves are added. A block stays in the cache while
// it meets the maps of all waves.
#pragma once

#include <array>
#include <cstddef>

#include "coast/loops/band_sector_task.hpp"
#include "coast/loops/band_signals.hpp"
#include "coast/statics/shore_bands.hpp"
#include "coast/statics/shore_depths.hpp"
#include "field/jet.hpp"
#include "field/quad_grid.hpp"
#include "ocean/internal/coast_waves.hpp"

namespace ocean {

/// Numbers with their derivatives: value, by x, by y [1/m], by t [1/s].
struct BlockJets {
    alignas(64) std::array<BlockFloats, 4> part{};

    void clear(JetParts parts) {
        for (std::size_t p = 0; p < static_cast<std::size_t>(parts); ++p) part[p].fill(0.0f);
    }
    template <typename Scalar>
    Scalar at(std::size_t label) const;
    template <typename Scalar>
    void set(std::size_t label, const Scalar& number);
};
template <>
inline Jet BlockJets::at(std::size_t label) const {
    return {part[0][label], part[1][label], part[2][label], part[3][label]};
}
template <>
inline Plain BlockJets::at(std::size_t label) const {
    return part[0][label];
}
template <>
inline void BlockJets::set(std::size_t label, const Jet& number) {
    for (std::size_t p = 0; p < 4; ++p) part[p][label] = number.parts[static_cast<int>(p)];
}
template <>
inline void BlockJets::set(std::size_t label, const Plain& number) {
    part[0][label] = number.value();
}

/// Some labels, and where they lie in the maps of delays and of energy.
struct BlockPlaces {
    std::size_t count = 0;
    std::array<double, kShoreBlock> x, y;
    GridPlaces delays, energy;
};

/// The sums over the waves of a coast at the labels of a block.
struct WaveSums {
    BlockJets real, imaginary;   // parts of Z [m]
    BlockJets squares;           // sum of |Z|^2 of each band and sector [m^2]
    BlockJets along_x, along_y;  // displacement D at choppiness 1 [m]
    // The part of the open sea's displacement that the sectors' middles do not carry.
    BlockJets left_x, left_y;

    /// Returns the sums in the order of CoastRequest.
    std::array<BlockJets*, kCoastSums> all() {
        return {&real, &imaginary, &squares, &along_x, &along_y, &left_x, &left_y};
    }
};

/// A signal at the labels of a block.
struct BlockSignal {
    BlockJets re, im;

    SignalOutputs outputs(JetParts parts) {
        SignalOutputs out{.re = re.part[0].data(), .im = im.part[0].data()};
        if (parts != JetParts::value) {
            out.re_x = re.part[1].data();
            out.im_x = im.part[1].data();
            out.re_y = re.part[2].data();
            out.im_y = im.part[2].data();
        }
        if (parts == JetParts::all) {
            out.re_t = re.part[3].data();
            out.im_t = im.part[3].data();
        }
        return out;
    }
};

/// The labels that feel the bed, with the inputs and sums of the loop over the waves.
struct ShoalingBlock {
    BlockPlaces places;
    std::array<std::size_t, kShoreBlock> label;       // in the block
    std::array<BlockJets, kShoreBands> displacement;  // coth(k d) of the bands' middles
    std::array<bool, kShoreBlock> partly;             // the open sea is a part of the surface
    WaveSums sums;
};

}  // namespace ocean
