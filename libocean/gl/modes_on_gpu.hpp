// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The modes of one map in buffers of the GPU.
#pragma once

#include <complex>

#include "ocean/backend.hpp"
#include "ocean/internal/gl/objects.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/page_vector.hpp"

namespace ocean {
class ThreadPool;
}

namespace ocean::gl {

class ModesOnGpu {
  public:
    /// Uploads the data that is missing: all of a new lattice, only the amplitudes if only the
    /// waves have changed. Returns true if it uploaded anything.
    bool load(const MapModes& modes, ThreadPool& pool);
    /// Binds storage buffers 0 (amplitudes), 1 (rates) and 2 (displacements).
    void bind() const;
    /// Returns the power of two that makes gradient_xy about as large as the height [m].
    float gradient_scale() const { return gradient_scale_; }

  private:
    void load_lattice(const MapModes& modes, ThreadPool& pool);
    void load_amplitudes(const MapModes& modes, ThreadPool& pool);

    float find_gradient_scale(const MapModes& modes, ThreadPool& pool) const;

    Buffer amplitudes_;
    Buffer rates_;
    Buffer displacements_;
    Revision revision_;  // of the loaded modes
    Revision lattice_revision_;
    float gradient_scale_ = 1.0f;
};

/// Returns h0 of all modes of a map, in FFT order: zero where there are none.
PageVector<std::complex<float>> map_amplitudes(const MapModes& modes, ThreadPool& pool);

/// Makes a storage buffer of `bytes` bytes, or resizes `buffer` to that size, and leaves it bound.
void resize_storage(Buffer& buffer, std::size_t bytes, const void* data);

}  // namespace ocean::gl
