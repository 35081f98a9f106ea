// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The eikonal equation by fast sweeping [Zhao 2005]: upwind differences of first order, solved at
// one sample after the other in each of the four diagonal orders in turn. Information travels along
// a ray as far as its direction stays in the quadrant of the order.
#include "eikonal.hpp"

#include <algorithm>
#include <cmath>

namespace ocean {
namespace {

constexpr double kUnreached = 1e30;
constexpr double kInward = 1e-9;  // component of a direction that enters by a side

/// Returns the upwind delay at a sample from its neighbours' delays, a along x and b along y, both
/// against the open sea's wave at the sample itself: the root of (v - a)^2 + (v - b)^2 = s^2, or
/// the wave along an axis.
double upwind_root(double a, double b, double s) {
    const double difference = std::abs(a - b);
    if (difference >= s) return std::min(a, b) + s;
    return 0.5 * (a + b + std::sqrt(2.0 * s * s - difference * difference));
}

}  // namespace

EikonalSolver::EikonalSolver(const SampleGrid& grid, const BorderSlopes& border)
    : grid_(grid),
      border_(border),
      stride_(static_cast<std::size_t>(grid.columns) + 2),
      delays_(stride_ * (static_cast<std::size_t>(grid.rows) + 2)),
      stale_(static_cast<std::size_t>(grid.rows)),
      upwind_(grid.count()) {}

/// Writes the slowness that a first-order difference needs. On a plane wave of direction n that is
/// bent along x by f'', the differences have the square sum s^2 - h f' f'' (nx^3 + ny^3), which is
/// the squared slowness at h/2 (nx^2, ny^2) upwind. The directions come from the delays. A second
/// solve is therefore of second order where waves are smooth.
void EikonalSolver::refine_slowness(std::span<const float> slowness) {
    const double cx = direction_.x, cy = direction_.y;
    for (int j = 0; j < grid_.rows; ++j) {
        const double* const row = &delays_[padded(0, j)];
        const double* const below = row - stride_;
        const double* const above = row + stride_;
        for (int i = 0; i < grid_.columns; ++i) {
            const double west = row[i - 1] - cx, east = row[i + 1] + cx;
            const double south = below[i] - cy, north = above[i] + cy;
            const double x = std::max(row[i] - std::min(west, east), 0.0);
            const double y = std::max(row[i] - std::min(south, north), 0.0);
            const std::size_t at = grid_.index(i, j);
            const double s = double{slowness[at]}, square = x * x + y * y;
            if (!(square > 0.0)) continue;
            const auto change = [&](double step, std::size_t beside) {
                return step > 0.0 ? step * step / square * (double{slowness[beside]} - s) : 0.0;
            };
            const std::size_t columns = static_cast<std::size_t>(grid_.columns);
            upwind_[at] =
                static_cast<float>(s + 0.5 * change(x, west <= east ? at - 1 : at + 1) +
                                   0.5 * change(y, south <= north ? at - columns : at + columns));
        }
    }
}

/// Writes the delays on the sides by which the waves come in. Along a side the delay changes by the
/// tangential component of the wave vector by Snell's law less the open sea's. It is 0 at the
/// deepest sample and wherever the water is deep, because the open sea reaches these samples.
void EikonalSolver::enter(std::span<const float> slowness) {
    const int west_or_east = direction_.x > kInward ? 0 : (direction_.x < -kInward ? 1 : -1);
    const int south_or_north = direction_.y > kInward ? 2 : (direction_.y < -kInward ? 3 : -1);
    int deepest_side = -1, deepest_k = 0;
    double least = 0.0, first = 0.0;
    for (const int s : {west_or_east, south_or_north}) {
        if (s < 0) continue;
        const BorderSide& side = border_.side(s);
        for (int k = 0; k < side.length; ++k) {
            const double local = slowness_at(slowness, side, k);
            const double phase =
                direction_.x * (side.i + k * side.di) + direction_.y * (side.j + k * side.dj);
            if (deepest_side < 0 || local < least || (local == least && phase < first)) {
                deepest_side = s, deepest_k = k, least = local, first = phase;
            }
        }
    }
    enter_side(slowness, deepest_side, deepest_k, 0.0);
    const int other = deepest_side == west_or_east ? south_or_north : west_or_east;
    if (other < 0) return;
    const int i = west_or_east == 0 ? 0 : grid_.columns - 1;
    const int j = south_or_north == 2 ? 0 : grid_.rows - 1;
    enter_side(slowness, other, other >= 2 ? i : j, delays_[padded(i, j)]);
}

/// Writes the delays of one side in both senses from a sample of known delay.
void EikonalSolver::enter_side(std::span<const float> slowness, int s, int from, double delay) {
    const BorderSide& side = border_.side(s);
    const PlaneVector tangent{1.0 * side.di, 1.0 * side.dj};
    const auto rate = [&](int k, double local) {
        return refracted(direction_, local, border_.upslope(s, k)).dot(tangent) -
               direction_.dot(tangent);
    };
    for (const int sense : {1, -1}) {
        double tau = delay, before = rate(from, slowness_at(slowness, side, from));
        for (int k = from; k >= 0 && k < side.length; k += sense) {
            const double local = slowness_at(slowness, side, k);
            const double next = rate(k, local);
            if (k != from) tau += sense * 0.5 * (before + next);
            if (local == 1.0) tau = 0.0;
            before = next;
            double& value = delays_[padded(side.i + k * side.di, side.j + k * side.dj)];
            value = std::min(value, tau);
        }
    }
}

/// Keeps the tangential components along sides where waves enter only because the bed outside turns
/// them.
void EikonalSolver::note_slant(std::span<const float> slowness, int s) {
    const BorderSide& side = border_.side(s);
    std::vector<float>& slant = slant_[static_cast<std::size_t>(s)];
    slant.clear();
    if (direction_.dot(side.inward) > kInward) return;
    bool any = false;
    std::vector<float> along(static_cast<std::size_t>(side.length));
    for (int k = 0; k < side.length; ++k) {
        const double local = slowness_at(slowness, side, k);
        const double inward =
            std::max(refracted(direction_, local, border_.upslope(s, k)).dot(side.inward), 0.0);
        any = any || inward > kInward;
        along[static_cast<std::size_t>(k)] =
            static_cast<float>(std::sqrt(std::max(local * local - inward * inward, 0.0)));
    }
    if (any) slant.swap(along);
}

/// Lowers the delays along a side that note_slant has kept, in both senses. Returns true if one
/// changed.
bool EikonalSolver::follow_side(int s) {
    const std::vector<float>& slant = slant_[static_cast<std::size_t>(s)];
    if (slant.empty()) return false;
    const BorderSide& side = border_.side(s);
    const double step = direction_.x * side.di + direction_.y * side.dj;
    const std::size_t along = side.di != 0 ? 1 : stride_;
    double* const line = &delays_[padded(side.i, side.j)];
    bool changed = false;
    const auto lower = [&](int k, double before) {
        double& tau = line[static_cast<std::size_t>(k) * along];
        const double value = before + double{slant[static_cast<std::size_t>(k)]};
        if (!(value < tau - kTolerance)) return;
        tau = value;
        changed = true;
    };
    for (int k = 1; k < side.length; ++k) {
        lower(k, line[static_cast<std::size_t>(k - 1) * along] - step);
    }
    for (int k = side.length - 2; k >= 0; --k) {
        lower(k, line[static_cast<std::size_t>(k + 1) * along] + step);
    }
    return changed;
}

/// Visits a row in the order +1 or -1. Returns true if a sample changed. Most visits change
/// nothing; the test needs no root and does not wait for the previous sample.
template <int kStep>
bool EikonalSolver::sweep_row(int j) {
    double* const row = &delays_[padded(0, j)];
    const double* const below = row - stride_;
    const double* const above = row + stride_;
    const float* const slowness = &upwind_[grid_.index(0, j)];
    const double cx = direction_.x, cy = direction_.y;
    bool changed = false;
    for (int n = 0; n < grid_.columns; ++n) {
        const int i = kStep > 0 ? n : grid_.columns - 1 - n;
        const double a = std::min(row[i - 1] - cx, row[i + 1] + cx);
        const double b = std::min(below[i] - cy, above[i] + cy);
        const double s = double{slowness[i]};
        const double along = std::max(row[i] - a, 0.0), across = std::max(row[i] - b, 0.0);
        if (along * along + across * across <= s * (s + 2.0 * kTolerance)) continue;
        row[i] = upwind_root(a, b, s);
        changed = true;
    }
    return changed;
}

/// Notes that a row has changed: the row and its neighbours need another visit.
void EikonalSolver::mark_row(int j) {
    for (int k = std::max(j - 1, 0); k <= std::min(j + 1, grid_.rows - 1); ++k) {
        stale_[static_cast<std::size_t>(k)] = 1;
    }
}

/// Sweeps until a sweep changes nothing. Returns the number of sweeps.
int EikonalSolver::sweep(std::span<const float> slowness, int max_sweeps) {
    std::fill(delays_.begin(), delays_.end(), kUnreached);
    std::fill(stale_.begin(), stale_.end(), char{1});
    enter(slowness);
    // The first order follows the open sea's direction; the next one flips the lesser component.
    const bool turn_y_first = std::abs(direction_.x) >= std::abs(direction_.y);
    for (int sweep = 0; sweep < max_sweeps; ++sweep) {
        const bool one = ((sweep + 1) & 2) != 0, other = (sweep & 2) != 0;
        const bool right = (turn_y_first ? other : one) != (direction_.x >= 0.0);
        const bool up = (turn_y_first ? one : other) != (direction_.y >= 0.0);
        bool changed = false;
        for (int s = 0; s < kBorderSides; ++s) changed = follow_side(s) || changed;
        if (changed) std::fill(stale_.begin(), stale_.end(), char{1});
        for (int n = 0; n < grid_.rows; ++n) {
            const int j = up ? n : grid_.rows - 1 - n;
            if (stale_[static_cast<std::size_t>(j)] == 0) continue;
            stale_[static_cast<std::size_t>(j)] = 0;
            if (!(right ? sweep_row<1>(j) : sweep_row<-1>(j))) continue;
            mark_row(j);
            changed = true;
        }
        if (!changed) return sweep + 1;
    }
    return max_sweeps;
}

int EikonalSolver::solve(std::span<const float> slowness, PlaneVector direction, int max_sweeps) {
    direction_ = direction;
    for (int s = 0; s < kBorderSides; ++s) note_slant(slowness, s);
    std::copy(slowness.begin(), slowness.end(), upwind_.begin());
    sweep(slowness, max_sweeps);
    refine_slowness(slowness);
    return sweep(slowness, max_sweeps);
}

}  // namespace ocean
