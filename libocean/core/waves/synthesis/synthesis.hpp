// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The common task of all backends, in the way of the references: from the modes at one time to
// planes of real, linear fields. waves/surface/plane_channels.cpp computes channels from these
// planes.
#pragma once

#include "ocean/backend.hpp"
#include "ocean/internal/linear_shape.hpp"
#include "ocean/internal/make_surface.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/surface.hpp"

namespace ocean {

class ThreadPool;

/// Returns the fields by direct sums along each axis in double.
LinearPlanes<double> synthesize_dft(const MapModes& modes, LinearSet fields, ThreadPool& pool);
/// Returns the fields by full complex radix-2 transforms in float, one field at a time.
LinearPlanes<float> synthesize_radix2(const MapModes& modes, LinearSet fields, ThreadPool& pool);

}  // namespace ocean
