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

float* WakeTurns::column(int block, int node, int part) {
    return columns_.data() +
           static_cast<std::size_t>((block * nodes_ + node) * kParts + part) * kWakeBlock;
}

void WakeTurns::write(int node, int part, double x, double y) {
    constexpr int kWidth = kWakeBlock;
    const int half = resolution_ / 2;
    const auto angle = [](double turns) { return kTwoPi * (turns - std::round(turns)); };
    const auto product = [](const std::complex<double>& a, const std::complex<double>& b) {
        return std::complex<double>(a.real() * b.real() - a.imag() * b.imag(),
                                    a.real() * b.imag() + a.imag() * b.real());
    };
    std::complex<double> step = std::polar(1.0, angle(y));
    std::complex<double> value = 1.0;
    for (int m = 0; m < half; m += kWidth) {
        float* const to = column(m / kWidth, node, part);
        float* const mirror = column((half + m) / kWidth, node, part);
        for (int lane = 0; lane < kWidth; ++lane) {
            to[lane] = mirror[lane] = static_cast<float>(value.real());
            to[kWidth + lane] = static_cast<float>(value.imag());
            mirror[kWidth + lane] = -to[kWidth + lane];
            value = product(value, step);
        }
    }
    step = std::polar(1.0, angle(x));
    value = std::polar(1.0, -half * angle(x));
    for (int n = 0; n < resolution_; ++n) {
        float* const to =
            rows_.data() + static_cast<std::size_t>((n * nodes_ + node) * kParts + part);
        to[0] = static_cast<float>(value.real());
        to[1] = static_cast<float>(value.imag());
        value = product(value, step);
    }
}

WakeRuns WakeTurns::fill(const WakePast& past, int first) {
    const int last = std::min(first + kSegments, static_cast<int>(past.nodes.size()) - 1);
    nodes_ = last - first + 1;
    const std::size_t floats = static_cast<std::size_t>(nodes_) *
                               static_cast<std::size_t>(resolution_) * std::size_t{kParts};
    columns_.resize(std::max(columns_.size(), floats));
    rows_.resize(std::max(rows_.size(), floats));
    for (int node = 0; node < nodes_; ++node) {
        const WakeNode& at = past.nodes[static_cast<std::size_t>(first + node)];
        write(node, 0, -at.x / side_, -at.y / side_);
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
        write(mine.first, 2, halves * run.dx / side_, halves * run.dy / side_);
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
