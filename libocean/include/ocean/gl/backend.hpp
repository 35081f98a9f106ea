// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The backends `gl` and `thesis`: they compute maps by compute shaders of OpenGL 4.3.
//
//     Ocean ocean(read_sea("storm.toml"), {.backend = gl::kBackend});
//     const BackendFitness fitness = gl::kBackend.fitness(1024);
//     if (!fitness.runs) std::puts(fitness.reason.c_str());
//     const Surface surface = ocean.evaluate(12.0, {Channel::height});
#pragma once

#include "ocean/backend.hpp"

namespace ocean::gl {

/// Computes all maps and sums the waves of a coast on the GPU. The processor computes the rest of a
/// coast's surface, and its foam and wet ground, which have a past. All calls use the context that
/// is current at the first call, or, if none is current, a headless context of the backend's own.
/// In a host's context it changes these bindings: program, storage buffers 0 to 9, image units 0 to
/// 6, textures of units 0 and 1, buffers for packing pixels. Throws Error no_gpu if it cannot run
/// or the context was lost: the backend has then released all its objects, and the next call uses
/// the context current at that call, or a new one. The fitness is the fitness of a headless
/// context: fast unless a CPU emulates the GPU.
extern const Backend kBackend;

/// Computes the same maps by the scheme of [Fluegge 2017], a dispatch for each stage of each
/// field's transform: a reference to read and to compare with, 10 times slower.
extern const Backend kThesisBackend;

}  // namespace ocean::gl
