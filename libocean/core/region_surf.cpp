// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "coast.hpp"
#include "ocean/internal/surf_traces.hpp"
#include "ocean/ocean.hpp"

namespace ocean {

RegionSurf::RegionSurf(const Domain& domain) : traces_(std::make_unique<RegionTraces>(domain)) {}
RegionSurf::RegionSurf(RegionSurf&&) noexcept = default;
RegionSurf::~RegionSurf() = default;

void RegionSurf::read(Ocean& sea, double time,
                      const std::function<void(std::uint32_t, float, float)>& visit) {
    for (const SurfReader::Piece& piece : sea.coast_->surf(time, traces_->reader)) {
        for (std::size_t n = 0; n < piece.labels.size(); ++n) {
            visit(piece.labels.index[n], piece.breaking[n], piece.depths[n]);
        }
    }
}

}  // namespace ocean
