// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "hulls/wake_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "field/ease.hpp"

namespace ocean {
namespace {

constexpr int kBlocks = 3;           // a straight block has at most 2^3 ticks
constexpr double kStraight = 1e-3;   // distance from a straight line of constant speed [m]
constexpr double kTrail = 0.26;      // share of the square by which it trails the hull
constexpr double kFadeOfAge = 0.75;  // share of the age at which waves begin to fade
constexpr double kAtRest = 1e-3;     // [m/s]

PathVector operator-(const PathVector& a, const PathVector& b) {
    return {a.x - b.x, a.y - b.y};
}

/// The ticks of the clock. In a loop a whole number of the largest blocks fits into the period.
class WakeClock {
  public:
    explicit WakeClock(const TrackPath& path) : path_(path) {
        if (path.period() <= 0.0) return;
        constexpr double kBlock = kWakeTick * (1 << kBlocks);
        tick_ = path.period() / std::ceil(path.period() / kBlock) / (1 << kBlocks);
    }

    /// Returns the times of the nodes from `age` before `time` to `time` itself.
    std::vector<double> nodes(double time, double age) const {
        // Whole blocks, or the weights of the oldest nodes would jump.
        const double block = tick_ * (1 << kBlocks);
        const double first = std::max(path_.begin(), std::floor((time - age) / block) * block);
        if (!(time > first)) return {};
        std::int64_t n = floor_tick(time);
        const auto oldest = static_cast<std::int64_t>(std::ceil(first / tick_ - kRounding));
        std::vector<double> times;
        if (time > at(n) + kRounding) times.push_back(time);
        times.push_back(at(n));
        while (n > oldest) {
            int q = 0;
            while (q < kBlocks && may_merge(n, q + 1, oldest)) ++q;
            n -= std::int64_t{1} << q;
            times.push_back(at(n));
        }
        std::ranges::reverse(times);
        return times;
    }

  private:
    static constexpr double kRounding = 1e-9;

    double at(std::int64_t n) const { return static_cast<double>(n) * tick_; }
    std::int64_t floor_tick(double time) const {
        return static_cast<std::int64_t>(std::floor(time / tick_ + kRounding));
    }
    /// Returns true if a block of 2^q ticks may end at tick n.
    bool may_merge(std::int64_t n, int q, std::int64_t oldest) const {
        const std::int64_t ticks = std::int64_t{1} << q;
        return n % ticks == 0 && n - ticks >= oldest && is_straight(at(n - ticks), at(n));
    }
    bool is_straight(double from, double to) const {
        const PathVector a = path_.place(from);
        const PathVector b = path_.place(to);
        for (int i = 1; i < 4; ++i) {
            const double u = 0.25 * i;
            const PathVector at = path_.place(from + u * (to - from));
            const double off = std::max(std::abs(at.x - a.x - u * (b.x - a.x)),
                                        std::abs(at.y - a.y - u * (b.y - a.y)));
            if (off > kStraight) return false;
        }
        return true;
    }

    const TrackPath& path_;
    double tick_ = kWakeTick;
};

/// Returns true if a segment goes on from a run with the same length and speed.
bool goes_on(const WakeRun& run, double seconds, const PathVector& step) {
    constexpr double kSame = 1e-6;  // [s], [m]
    return std::abs(run.seconds - seconds) < kSame && std::abs(run.dx - step.x) < kSame &&
           std::abs(run.dy - step.y) < kSame;
}

}  // namespace

WakePlace wake_place(const TrackPath& path, double time, double size, double step) {
    // The mean of three past velocities turns and stops smoothly.
    const PathVector now = path.place(time);
    PathVector mean;
    for (const double lag : {1.0, 4.0, 16.0}) {
        const PathVector past = path.place(time - lag);
        mean.x += (now.x - past.x) / lag / 3.0;
        mean.y += (now.y - past.y) / lag / 3.0;
    }
    constexpr double kSlow = 4.0;  // [m^2/s^2]
    const double back = kTrail * size / std::sqrt(mean.x * mean.x + mean.y * mean.y + kSlow);
    const PathVector middle{now.x - back * mean.x, now.y - back * mean.y};
    return {{std::round(middle.x / step) * step, std::round(middle.y / step) * step}, middle};
}

WakePast wake_past(const TrackPath& path, double time, double age, double size, double step) {
    WakePast past;
    past.place = wake_place(path, time, size, step);
    past.hull = path.place(time) - past.place.centre;
    const std::vector<double> nodes = WakeClock(path).nodes(time, age);
    const auto weight = [&](double node) {
        return static_cast<float>(ease(1.0, kFadeOfAge, (time - node) / age));
    };
    const PathVector from_middle = past.place.centre - past.place.middle;
    bool open = false;
    for (std::size_t j = 0; j + 1 < nodes.size(); ++j) {
        const double seconds = nodes[j + 1] - nodes[j];
        const PathVector a = path.place(nodes[j]);
        const PathVector way = path.place(nodes[j + 1]) - a;
        const bool rests = std::hypot(way.x, way.y) < kAtRest * seconds;
        past.velocity = rests ? PathVector{} : PathVector{way.x / seconds, way.y / seconds};
        if (rests) {
            open = false;
            continue;
        }
        if (open && goes_on(past.runs.back(), seconds, way)) {
            ++past.runs.back().segments;
        } else {
            const PathVector at = a - past.place.centre;
            past.runs.push_back({.since = nodes[j] - time,
                                 .x = at.x,
                                 .y = at.y,
                                 .from_middle_x = static_cast<float>(at.x + from_middle.x),
                                 .from_middle_y = static_cast<float>(at.y + from_middle.y),
                                 .seconds = seconds,
                                 .dx = way.x,
                                 .dy = way.y,
                                 .segments = 1,
                                 .ages = past.ages.size()});
            past.ages.push_back(weight(nodes[j]));
            open = true;
        }
        past.ages.push_back(weight(nodes[j + 1]));
    }
    return past;
}

}  // namespace ocean
