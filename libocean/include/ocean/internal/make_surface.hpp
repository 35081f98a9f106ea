// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From modes to the surface of one time, by a backend; and the planes of linear fields between
// them.
#pragma once

#include <array>

#include "ocean/backend.hpp"
#include "ocean/channel.hpp"
#include "ocean/internal/modes.hpp"
#include "ocean/page_vector.hpp"
#include "ocean/surface.hpp"

namespace ocean {

class ThreadPool;

/// Planes of resolution^2 values, row-major [j][i]; planes that were not requested are empty.
template <typename Real>
struct LinearPlanes {
    std::array<PageVector<Real>, kLinearCount> plane;
    const PageVector<Real>& operator[](Linear field) const {
        return plane[static_cast<std::size_t>(field)];
    }
    PageVector<Real>& operator[](Linear field) { return plane[static_cast<std::size_t>(field)]; }
};

/// Returns one map of `resolution` samples (0 = the modes' own; else a power of two, 32 .. 8192):
/// all modes below its Nyquist line, zero padded where the modes end. The bits do not depend on the
/// order of calls or the number of threads. Foam has a past and is not made here: see foam.hpp and
/// Ocean.
Surface make_surface(const Modes& modes, const SurfaceSettings& settings, double time,
                     ChannelSet channels, const Backend& backend, ThreadPool& pool,
                     int resolution = 0);

}  // namespace ocean
