// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A backend at work, and the channels that it has no code for. The facade and single surfaces make
// their maps through it alone.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "ocean/backend.hpp"
#include "ocean/internal/make_surface.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/surface.hpp"
#include "waves/surface/bound_maps.hpp"

namespace ocean {

class MapWriter {
  public:
    /// Makes a writer. `host_channels`: the rows of the host's channels, which must outlive it.
    explicit MapWriter(const Backend& backend, std::span<const ChannelInfo> host_channels = {});
    /// Copies a writer for other host channels; the copy shares what the backend made of the modes.
    MapWriter(const MapWriter& other, std::span<const ChannelInfo> host_channels);

    const Backend& backend() const { return backend_; }
    /// Writes the outputs as a MapFunction does. Throws Error for an unknown channel.
    bool write(const MapRequest& request, ThreadPool& pool);

  private:
    bool write_samples(const MapRequest& request, ThreadPool& pool);
    /// Returns true if the request's tick of foam is kept by the run that makes its channels.
    bool keeps_in_one_run(const MapRequest& request) const;
    /// Writes the tick of foam that is to be kept, and then the map over it.
    bool write_after_tick(const MapRequest& request, ThreadPool& pool);
    /// Writes channels of kKernelFormulas from the planes.
    void write_by_kernel(ChannelSet channels, const MapRequest& request, ThreadPool& pool);
    /// Adds the bound waves to the outputs that are multiples of a field, and to the planes.
    void add_bound_waves(const MapRequest& request, LinearSet fields, LinearSet planes,
                         ThreadPool& pool);

    Backend backend_;
    std::span<const ChannelInfo> host_channels_;
    MapFunction maps_;
    // The fields of channels that the backend does not compute; kept, so that frames do not
    // allocate.
    LinearPlanes<float> planes_;
    std::vector<MapOutput> outputs_;
    std::optional<BoundMaps> bound_;  // of a sea of second order
};

}  // namespace ocean
