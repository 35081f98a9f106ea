// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Textures of foam: the request checked, the texels copied out.
#include "ocean/internal/foam_texture.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "guard.hpp"
#include "ocean/thread_pool.hpp"
#include "sea_handle.hpp"

using namespace ocean;
using namespace ocean::capi;

ocean_result ocean_foam_texture(const ocean_foam_texture_request* request,
                                const ocean_options* options, double* period) {
    return guarded([&] {
        require(request, "request");
        const ocean_foam_texture_request asked =
            read_struct(request, sizeof(ocean_foam_texture_request), "ocean_foam_texture_request");
        require(asked.kind, "kind");
        const FoamTextureSettings settings{find_foam_texture(asked.kind), asked.size, asked.seed};
        require_foam_texture_size(settings.size);
        const OceanOptions given = read_options(options);
        const auto side = static_cast<std::size_t>(settings.size);
        if (asked.data != nullptr) {
            require_capacity("count", asked.count, side * side,
                             "the texture has " + std::to_string(side * side) + " texels");
            ThreadPool pool(given.threads, given.run_jobs);
            pool.set_interrupt(given.interrupt);
            std::ranges::copy(make_foam_texture(settings, pool), asked.data);
        }
        if (period != nullptr) *period = foam_texture_info(settings.kind).period;
    });
}
