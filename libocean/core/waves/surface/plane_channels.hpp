// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Channels by their rows of the table, from planes of their linear fields: the references make
// every channel this way, and all backends the channels that they have no code for.
#pragma once

#include <span>

#include "ocean/backend.hpp"
#include "ocean/internal/make_surface.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/surface.hpp"

namespace ocean {

class ThreadPool;

/// Writes every output of the request but its seam, in the precision of the planes, rounded once at
/// the end. `host_channels`: the rows of the host's channels.
template <typename Real>
void write_channels(const LinearPlanes<Real>& planes, const MapRequest& request,
                    std::span<const ChannelInfo> host_channels, ThreadPool& pool);

extern template void write_channels(const LinearPlanes<float>&, const MapRequest&,
                                    std::span<const ChannelInfo>, ThreadPool&);
extern template void write_channels(const LinearPlanes<double>&, const MapRequest&,
                                    std::span<const ChannelInfo>, ThreadPool&);

}  // namespace ocean
