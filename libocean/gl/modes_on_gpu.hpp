// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The modes of one map in buffers of the GPU.
#pragma once

#include <complex>

#include "ocean/backend.hpp"
#include "ocean/gl/objects.hpp"
#include "ocean/page_vector.hpp"

namespace ocean {
class ThreadPool;
}

namespace ocean::gl {

class ModesOnGpu {
  public:
    /// Uploads what is not there yet: all of a new lattice, amplitudes only when the waves alone
    /// have changed. Returns whether it uploaded anything.
    bool load(const MapModes& modes, ThreadPool& pool);
    /// As storage buffers 0 (amplitudes), 1 (rates) and 2 (displacements).
    void bind() const;
    /// The power of two by which gradient_xy is about as large as the height, in metres.
    float gradient_scale() const { return gradient_scale_; }

  private:
    void load_lattice(const MapModes& modes, ThreadPool& pool);
    void load_amplitudes(const MapModes& modes, ThreadPool& pool);

    float find_gradient_scale(const MapModes& modes, ThreadPool& pool) const;

    Buffer amplitudes_;
    Buffer rates_;
    Buffer displacements_;
    Revision revision_;  // of what is loaded
    Revision lattice_revision_;
    float gradient_scale_ = 1.0f;
};

/// h0 of all modes of a map, in FFT order: zero where there are none.
PageVector<std::complex<float>> map_amplitudes(const MapModes& modes, ThreadPool& pool);

/// A new buffer of so many bytes, or `buffer` with that size; bound as a storage buffer.
void resize_storage(Buffer& buffer, std::size_t bytes, const void* data);

}  // namespace ocean::gl
