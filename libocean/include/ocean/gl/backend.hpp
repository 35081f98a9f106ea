// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The backends `gl` and `thesis`: they compute maps by compute shaders of OpenGL 4.3.
#pragma once

#include "ocean/backend.hpp"

namespace ocean::gl {

/// Computes all maps on the GPU, and sums the waves of a coast there: what is left of a coast's
/// surface, and its foam and wet ground, which have a past, are computed by the processor. It uses
/// the context that is current at its first call, for all its calls; if none is current, a headless
/// one of its own. In a host's context it changes these bindings: program, storage buffers 0 to 9,
/// image units 0 to 6, textures of units 0 and 1, buffers for packing pixels. Throws Error no_gpu
/// if it cannot run or the context was lost: it then has released all its objects, and the next
/// call uses the context that is current then, or a new one. Its fitness is that of a headless
/// context: fast unless a CPU emulates the GPU.
extern const Backend kBackend;

/// Computes the same maps by the scheme of [Fluegge 2017], a dispatch for each stage of each
/// field's transform: a reference to read and to compare with, 10 times slower.
extern const Backend kThesisBackend;

}  // namespace ocean::gl
