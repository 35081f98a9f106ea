// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "workload.hpp"

#include <algorithm>

#include "ocean/cascades.hpp"

namespace ocean::app {
namespace {

/// Samples of the largest maps, cells of the mesh and the share of the pixels that a processor that
/// plays a GPU draws in time.
constexpr int kSoftwareMap = 256;
constexpr int kSoftwareFoamMap = 512;
constexpr int kSoftwareCells = 64;
constexpr double kSoftwareScale = 0.5;

}  // namespace

bool computes_well(const gl::ContextInfo& context) {
    const bool has_compute = context.major > 4 || (context.major == 4 && context.minor >= 3);
    return has_compute && !context.software;
}

Workload workload_for(const PreviewOptions& options, const Sea& sea, const gl::ContextInfo& context,
                      bool computes) {
    Workload work;
    work.maps.compute = computes;
    if (context.software) {
        const Grid& grid = sea.parameters.grid;
        work.maps.cascade_resolution = std::min(grid.resolution, kSoftwareMap);
        work.maps.foam_resolution = std::min(default_map_resolution(grid), kSoftwareFoamMap);
        work.renderer.cells = kSoftwareCells;
        work.scale = kSoftwareScale;
    }
    if (options.map) work.maps.cascade_resolution = *options.map;
    if (options.foam_map) work.maps.foam_resolution = *options.foam_map;
    if (options.cells) work.renderer.cells = *options.cells;
    return work;
}

}  // namespace ocean::app
