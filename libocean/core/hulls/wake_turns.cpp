// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "hulls/wake_turns.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "ocean/internal/grid.hpp"

namespace ocean {
namespace {

constexpr int kParts = 4;  // values of a node

}  // namespace

WakeTurns::WakeTurns(int resolution, double side, double half_length)
    : resolution_(resolution), side_(side), half_length_(half_length) {}

void WakeTurns::write(int node, int part, double turns, PageVector<float>& values,
                      int width) const {
    const double angle = kTwoPi * (turns - std::round(turns));
    const std::complex<double> step = std::polar(1.0, angle);
    std::complex<double> value = std::polar(1.0, -angle * (resolution_ / 2));
    for (int n = 0; n < resolution_; n += width) {
        float* const re = values.data() +
                          static_cast<std::size_t>(((n / width) * nodes_ + node) * kParts + part) *
                              static_cast<std::size_t>(width);
        for (int lane = 0; lane < width; ++lane) {
            re[lane] = static_cast<float>(value.real());
            re[lane + width] = static_cast<float>(value.imag());
            value = {value.real() * step.real() - value.imag() * step.imag(),
                     value.real() * step.imag() + value.imag() * step.real()};
        }
    }
}

WakeRuns WakeTurns::fill(const WakePast& past, int first) {
    const int last = std::min(first + kSegments, static_cast<int>(past.nodes.size()) - 1);
    nodes_ = last - first + 1;
    const std::size_t floats = static_cast<std::size_t>(nodes_) *
                               static_cast<std::size_t>(resolution_) * std::size_t{kParts};
    columns_.resize(std::max(columns_.size(), floats));
    rows_.resize(std::max(rows_.size(), floats));
    const auto write_both = [&](int node, int part, double turns_x, double turns_y) {
        write(node, part, turns_x, columns_, static_cast<int>(kWakeBlock));
        write(node, part, turns_y, rows_, 1);
    };
    for (int node = 0; node < nodes_; ++node) {
        const WakeNode& at = past.nodes[static_cast<std::size_t>(first + node)];
        write_both(node, 0, -at.x / side_, -at.y / side_);
    }
    runs_.clear();
    for (const WakeRun& run : past.runs) {
        if (run.last <= first || run.first >= last) continue;
        WakeRun& mine = runs_.emplace_back(run);
        mine.first = std::max(run.first, first) - first;
        mine.last = std::min(run.last, last) - first;
        const double halves = half_length_ / std::hypot(run.dx, run.dy);
        mine.pause = static_cast<float>(run.seconds);
        mine.side_x = static_cast<float>(run.dx / side_);
        mine.side_y = static_cast<float>(run.dy / side_);
        mine.halves = static_cast<float>(halves);
        write_both(mine.first, 2, halves * run.dx / side_, halves * run.dy / side_);
    }
    return {past.nodes.data() + first,
            runs_.data(),
            runs_.size(),
            {columns_.data(), rows_.data(), static_cast<std::size_t>(nodes_)}};
}

std::uint64_t WakeTurns::bytes(int resolution) {
    return std::uint64_t{2 * kParts} * (kSegments + 1) * static_cast<std::uint64_t>(resolution) *
           sizeof(float);
}

}  // namespace ocean
