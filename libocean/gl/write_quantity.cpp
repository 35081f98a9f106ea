// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See write_quantity.hpp.
#include "write_quantity.hpp"

#include "ocean/thread_pool.hpp"

namespace ocean::gl {

void write_quantity(const MapRequest& request, Quantity quantity, const float* texels, int step,
                    ThreadPool& pool) {
    const int resolution = request.modes.resolution;
    const auto width = static_cast<std::size_t>(resolution);
    const auto texel = static_cast<std::size_t>(step);
    for (const MapOutput& output : request.outputs) {
        for (std::size_t c = 0; c < output.used().size(); ++c) {
            if (output.component[c].quantity != quantity) continue;
            const float factor = output.component[c].factor;
            const auto stride = static_cast<std::size_t>(output.components);
            const std::size_t pitch = output.pitch(resolution);
            pool.for_each_item(resolution, [&](int row, int) {
                const auto j = static_cast<std::size_t>(row);
                const float* from = texels + j * width * texel;
                float* to = output.data + j * pitch + c;
                for (std::size_t i = 0; i < width; ++i) to[i * stride] = factor * from[i * texel];
            });
        }
    }
}

}  // namespace ocean::gl
