// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "hulls/track_path.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "ocean/internal/grid.hpp"

namespace ocean {
namespace {

/// Returns the slope from one row to the next.
PathVector leg_slope(const TrackRow& a, const TrackRow& b) {
    const double seconds = b.time - a.time;
    return {(b.x - a.x) / seconds, (b.y - a.y) / seconds};
}

/// Returns the slope at `at` of the parabola through three rows.
PathVector parabola_slope(const TrackRow& before, const TrackRow& at, const TrackRow& after) {
    const PathVector a = leg_slope(before, at);
    const PathVector b = leg_slope(at, after);
    const double share = (at.time - before.time) / (after.time - before.time);
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

/// Returns the velocities at the rows. A track that repeats goes on from its last row to its
/// second.
std::vector<PathVector> row_velocities(const HullTrack& track, bool repeats) {
    const std::vector<TrackRow>& rows = track.rows;
    std::vector<PathVector> velocities(rows.size());
    const std::size_t last = rows.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
        if (!track.courses.empty()) {
            const auto [heading, speed] = track.courses[i];
            velocities[i] = {speed * std::cos(heading * kDegree),
                             speed * std::sin(heading * kDegree)};
        } else if (i > 0 && i < last) {
            velocities[i] = parabola_slope(rows[i - 1], rows[i], rows[i + 1]);
        } else if (repeats) {
            TrackRow before = rows[last - 1];
            before.time -= track.duration();
            velocities[i] = parabola_slope(before, rows[0], rows[1]);
        } else {
            velocities[i] =
                i == 0 ? leg_slope(rows[0], rows[1]) : leg_slope(rows[last - 1], rows[last]);
        }
    }
    return velocities;
}

}  // namespace

TrackPath::TrackPath(std::shared_ptr<const HullTrack> track, double loop_period)
    : track_(std::move(track)),
      velocities_(row_velocities(*track_, loop_period > 0.0)),
      period_(loop_period > 0.0 ? track_->duration() : 0.0) {}

double TrackPath::begin() const {
    return period_ > 0.0 ? -std::numeric_limits<double>::infinity() : track_->rows.front().time;
}

double TrackPath::track_time(double time) const {
    if (period_ <= 0.0) return time;
    const double first = track_->rows.front().time;
    const double since = std::fmod(time - first, period_);
    return first + (since < 0.0 ? since + period_ : since);
}

PathVector TrackPath::heading(double time) const {
    constexpr double kMoment = 0.05;  // [s]
    constexpr double kMoved = 1e-3;   // [m]
    const auto way = [&](double from, double to) {
        const PathVector a = place(from);
        const PathVector b = place(to);
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        return length > kMoved ? PathVector{(b.x - a.x) / length, (b.y - a.y) / length}
                               : PathVector{};
    };
    const auto moves = [](const PathVector& v) { return v.x != 0.0 || v.y != 0.0; };
    PathVector found = way(time - kMoment, time);
    if (moves(found)) return found;
    const std::vector<TrackRow>& rows = track_->rows;
    const auto passed = static_cast<std::size_t>(
        std::ranges::upper_bound(rows, track_time(time), {}, &TrackRow::time) - rows.begin());
    if (!track_->courses.empty()) {
        const double heading = track_->courses[std::max<std::size_t>(passed, 1) - 1].heading;
        return {std::cos(heading * kDegree), std::sin(heading * kDegree)};
    }
    for (std::size_t row = passed; row > 0 && !moves(found); --row) {
        found = way(rows[row - 1].time - kMoment, rows[row - 1].time);
    }
    for (std::size_t row = 0; row < rows.size() && !moves(found); ++row) {
        found = way(rows[row].time, rows[row].time + kMoment);
    }
    return found;
}

TrackPath::Leg TrackPath::leg_at(double time) const {
    const std::vector<TrackRow>& rows = track_->rows;
    const auto after = std::ranges::upper_bound(rows, time, {}, &TrackRow::time);
    const auto i = static_cast<std::size_t>(after - rows.begin()) - 1;
    const double seconds = rows[i + 1].time - rows[i].time;
    return {i, seconds, (time - rows[i].time) / seconds};
}

PathVector TrackPath::place(double time) const {
    const std::vector<TrackRow>& rows = track_->rows;
    time = track_time(time);
    if (time <= rows.front().time) return {rows.front().x, rows.front().y};
    if (time >= rows.back().time) return {rows.back().x, rows.back().y};
    const auto [i, seconds, u] = leg_at(time);
    const TrackRow& a = rows[i];
    const TrackRow& b = rows[i + 1];
    const double ease = u * u * (3.0 - 2.0 * u);
    const double from_a = u * (1.0 - u) * (1.0 - u) * seconds;
    const double from_b = -u * u * (1.0 - u) * seconds;
    const PathVector& v = velocities_[i];
    const PathVector& w = velocities_[i + 1];
    return {a.x + ease * (b.x - a.x) + from_a * v.x + from_b * w.x,
            a.y + ease * (b.y - a.y) + from_a * v.y + from_b * w.y};
}

PathVector TrackPath::velocity(double time) const {
    const std::vector<TrackRow>& rows = track_->rows;
    time = track_time(time);
    if (time < rows.front().time || time >= rows.back().time) return {};
    const auto [i, seconds, u] = leg_at(time);
    const double ease = 6.0 * u * (1.0 - u) / seconds;
    const double from_a = (1.0 - u) * (1.0 - 3.0 * u);
    const double from_b = u * (3.0 * u - 2.0);
    const PathVector& v = velocities_[i];
    const PathVector& w = velocities_[i + 1];
    return {ease * (rows[i + 1].x - rows[i].x) + from_a * v.x + from_b * w.x,
            ease * (rows[i + 1].y - rows[i].y) + from_a * v.y + from_b * w.y};
}

double TrackPath::same_until(const TrackPath& other) const {
    constexpr double kNever = std::numeric_limits<double>::infinity();
    const std::vector<TrackRow>& rows = track_->rows;
    const std::vector<TrackRow>& others = other.track_->rows;
    const std::size_t both = std::min(rows.size(), others.size());
    std::size_t same = 0;
    while (same < both && rows[same] == others[same] &&
           velocities_[same] == other.velocities_[same]) {
        ++same;
    }
    if (same == rows.size() && same == others.size() && period_ == other.period_) return kNever;
    return same == 0 || period_ > 0.0 || other.period_ > 0.0 ? -kNever : rows[same - 1].time;
}

}  // namespace ocean
