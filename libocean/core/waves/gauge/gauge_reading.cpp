// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The reading of a gauge: finds the label that is displayed at its position, then sums all modes
// there; see gauge.hpp.

#include "ocean/internal/gauge.hpp"
#include "ocean/internal/surface_query.hpp"
#include "ocean/query.hpp"
#include "wave/wave.hpp"
#include "waves/query/inversion.hpp"

namespace ocean {
namespace {

/// Returns the label displayed at (x, y), the highest if there are several.
ShownLabel label_at(const WaveSum& sea, double choppiness, double x, double y,
                    const SurfaceQuery* query) {
    // |D| is a Gaussian vector: it exceeds 5 rms with a probability of 1e-11.
    constexpr double kReach = 5.0;
    constexpr double kTolerance = 1e-9;  // relative to the reach
    const double reach = kReach * choppiness * sea.displacement_rms();
    if (!(reach > 0.0)) return {x, y, 1.0, true};
    const InversionTarget target{x, y, choppiness, reach, kTolerance * reach};
    const auto source = [&sea](double u, double v) { return sea.displacement_at(u, v); };
    if (query == nullptr) return find_label(source, target, x, y);
    const QuerySample top = query->sample({x, y});
    const ShownLabel label = find_label(source, target, top.label[0], top.label[1]);
    if (label.converged) return label;
    return {top.label[0], top.label[1], 0.0, false};
}

}  // namespace

GaugeReading read_gauge(const WaveSum& sea, double choppiness, double x, double y,
                        const WaterLevel& level, const SurfaceQuery* query) {
    const ShownLabel label = label_at(sea, choppiness, x, y, query);
    const LinearSample sample = sea.at_label(label.x, label.y);
    const auto normal =
        wave::double_precision::surface_normal(choppiness, sample.gradient_xx, sample.gradient_yy,
                                               sample.gradient_xy, sample.slope_x, sample.slope_y);
    return {sample.height, -normal.x / normal.z, -normal.y / normal.z,
            sea.water_motion(x, y, level)};
}

}  // namespace ocean
