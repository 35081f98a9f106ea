// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The border of a bed: see shore_border.hpp.
#include "shore_border.hpp"

#include <algorithm>
#include <cmath>

namespace ocean {
namespace {

constexpr int kReach = 8;         // of the planes, to both sides and inward [cells]
constexpr double kFlat = 1e-4;    // slope below which contours follow the border
constexpr double kAgainst = 0.2;  // sine of the angle of 12 degrees

/// Sums over samples at (t, n) of the depth d, which give the best-fitting plane.
struct PlaneSums {
    double count = 0.0, t = 0.0, n = 0.0, d = 0.0;
    double tt = 0.0, tn = 0.0, nn = 0.0, dt = 0.0, dn = 0.0;

    void add(double at, double an, double ad) {
        count += 1.0, t += at, n += an, d += ad;
        tt += at * at, tn += at * an, nn += an * an, dt += at * ad, dn += an * ad;
    }
    /// Returns the slopes of d along t and n, or 0 where the samples do not determine them.
    PlaneVector slopes() const {
        if (count < 3.0) return {};
        const double vtt = tt - t * t / count, vtn = tn - t * n / count, vnn = nn - n * n / count;
        const double vtd = dt - t * d / count, vnd = dn - n * d / count;
        const double determinant = vtt * vnn - vtn * vtn;
        if (!(determinant > 1e-3 * vtt * vnn)) return {};
        return {(vtd * vnn - vnd * vtn) / determinant, (vnd * vtt - vtd * vtn) / determinant};
    }
};

/// Returns the uphill vector of the plane that best fits the depth beside sample k of a side.
/// Samples of min_depth do not count: there the depth is a limit and not the bed's.
PlaneVector fitted_upslope(const BedGrid& depth, float min_depth, const BorderSide& side, int k) {
    const int first = std::max(k - kReach, 0), last = std::min(k + kReach, side.length - 1);
    const int across = depth.domain.samples[side.di != 0 ? 1 : 0];
    const int rows = std::min(kReach + 1, across);
    const int ni = static_cast<int>(side.inward.x), nj = static_cast<int>(side.inward.y);
    PlaneSums sums;
    for (int n = 0; n < rows; ++n) {
        for (int t = first; t <= last; ++t) {
            const float d = depth.at(side.i + t * side.di + n * ni, side.j + t * side.dj + n * nj);
            if (d > min_depth) sums.add(t - k, n, double{d});
        }
    }
    const PlaneVector slopes = sums.slopes();
    const double along = -slopes.x / depth.cell(), inward = -slopes.y / depth.cell();
    if (!(std::hypot(along, inward) > kFlat)) return side.inward;
    return {along * side.di + inward * side.inward.x, along * side.dj + inward * side.inward.y};
}

}  // namespace

std::array<BorderSide, kBorderSides> border_sides(const Domain& domain) {
    const int nx = domain.samples[0], ny = domain.samples[1];
    return {{{0, 0, 0, 1, ny, {1.0, 0.0}},
             {nx - 1, 0, 0, 1, ny, {-1.0, 0.0}},
             {0, 0, 1, 0, nx, {0.0, 1.0}},
             {0, ny - 1, 1, 0, nx, {0.0, -1.0}}}};
}

BorderSlopes::BorderSlopes(const BedGrid& depth) : sides_(border_sides(depth.domain)) {
    if (depth.values.empty()) return;
    const float least = *std::min_element(depth.values.begin(), depth.values.end());
    for (std::size_t s = 0; s < sides_.size(); ++s) {
        slopes_[s].reserve(static_cast<std::size_t>(sides_[s].length));
        for (int k = 0; k < sides_[s].length; ++k) {
            const PlaneVector slope = fitted_upslope(depth, least, sides_[s], k);
            const double length = std::hypot(slope.x, slope.y);
            slopes_[s].push_back({slope.x / length, slope.y / length});
        }
    }
}

PlaneVector refracted(PlaneVector direction, double slowness, PlaneVector upslope) {
    if (slowness == 1.0) return direction;
    const PlaneVector contour{-upslope.y, upslope.x};
    const double up = direction.dot(upslope), along = direction.dot(contour);
    const double snell = std::sqrt(std::max(slowness * slowness - along * along, 0.0));
    const double t = std::clamp(up / kAgainst + 1.0, 0.0, 1.0);
    const double climb = up + t * t * (3.0 - 2.0 * t) * (snell - std::abs(up));
    return {climb * upslope.x + along * contour.x, climb * upslope.y + along * contour.y};
}

}  // namespace ocean
