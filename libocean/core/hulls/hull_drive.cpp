// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/hull_drive.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "hulls/track_path.hpp"
#include "hulls/wake_lattice.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/hull_rules.hpp"

namespace ocean {
namespace {

constexpr double kStep = 0.25;     // between rows, which lie on an absolute clock [s]
constexpr double kSoon = 0.05;     // a row sooner after another one would say little [s]
constexpr double kPlan = 4.5;      // beyond the last row [s]: more than a span of the wake's clock
constexpr double kGain = 1.0;      // of speed [m/s^2]
constexpr double kThrottle = 2.0;  // of the wanted speed, by hand [m/s^2]
constexpr double kTurnRadius = 2.0;  // in lengths of the hull
constexpr double kTurnRate = 0.9 * kMaxTurnRate;
constexpr double kFastest = kMaxHullSpeed - 1e-6;  // a leg of it is no jump by rounding
/// The wake's square fits this Froude number, or the highest of the track before.
constexpr double kFroude = 0.55;

TrackCourse course_of(const PathVector& velocity, const PathVector& ahead) {
    const double speed = std::hypot(velocity.x, velocity.y);
    const PathVector& way = speed > 0.0 ? velocity : ahead;
    return {std::atan2(way.y, way.x) / kDegree, speed};
}

double turned(double heading) {
    return std::remainder(heading, 360.0);
}

/// Returns the time of the row after a time: those of a drive but its first are whole steps.
double next_row(double time) {
    return kStep * (std::floor((time + kSoon) / kStep) + 1.0);
}

}  // namespace

HullDrive::HullDrive(const Hull& hull, double time) : length_(hull.length) {
    require_time(time);
    const TrackPath path(hull.track, 0.0);
    const std::vector<TrackRow>& rows = hull.track->rows;
    for (std::size_t i = 0; i < rows.size() && rows[i].time < time; ++i) {
        track_.rows.push_back(rows[i]);
        track_.courses.push_back(hull.track->courses.empty()
                                     ? course_of(path.velocities()[i], path.heading(rows[i].time))
                                     : hull.track->courses[i]);
    }
    // A hull whose track is over stops there: without a row for that it would swing beyond its end.
    const bool is_over = track_.rows.size() == rows.size();
    if (is_over && last_time() + kStep < time) {
        const TrackRow end = track_.rows.back();
        track_.rows.push_back({end.time + 0.5 * kStep, end.x, end.y});
        track_.courses.push_back({track_.courses.back().heading, 0.0});
    }
    const bool is_at_row = !track_.rows.empty() && last_time() + kSoon >= time;
    const bool goes_on = is_over && track_.courses.back().speed > 0.0;
    if (!is_at_row && !goes_on) {
        const PathVector place = path.place(time);
        track_.rows.push_back({time, place.x, place.y});
        track_.courses.push_back(course_of(path.velocity(time), path.heading(time)));
    }
    wanted_ = track_.courses.back();
}

void HullDrive::want(const TrackCourse& course) {
    if (std::isnan(course.speed) || std::isnan(course.heading) || std::isinf(course.heading)) {
        throw Error(ErrorKind::invalid_value,
                    "a driven hull needs a speed and a heading that are numbers");
    }
    wanted_ = {turned(course.heading), std::clamp(course.speed, 0.0, kMaxHullSpeed)};
    rudder_ = 0.0;
}

void HullDrive::steer(double faster, double left, double seconds) {
    wanted_.speed = std::clamp(wanted_.speed + faster * kThrottle * seconds, 0.0, kMaxHullSpeed);
    if (left != 0.0 || rudder_ != 0.0) {
        // A heading that a person can read.
        wanted_.heading = std::round(10.0 * track_.courses.back().heading) / 10.0;
    }
    rudder_ = std::clamp(left, -1.0, 1.0);
}

HullDrive::Motion HullDrive::after(const Motion& at, double time) const {
    const double seconds = time - at.row.time;
    const auto& [heading, speed] = at.course;
    const double gain = kGain * seconds;
    const double next = speed + std::clamp(std::min(wanted_.speed, kFastest) - speed, -gain, gain);
    const double way = 0.5 * (speed + next) * seconds;
    const double most = std::min(kTurnRate * seconds, way / (kTurnRadius * length_) / kDegree);
    const double turn = rudder_ != 0.0 ? rudder_ * most
                                       : std::clamp(turned(wanted_.heading - heading), -most, most);
    const double middle = (heading + 0.5 * turn) * kDegree;
    return {{time, at.row.x + way * std::cos(middle), at.row.y + way * std::sin(middle)},
            {turned(heading + turn), next}};
}

bool HullDrive::advance(double time) {
    const std::size_t before = track_.rows.size();
    while (last_time() < time) {
        const Motion motion = after(last(), next_row(last_time()));
        track_.rows.push_back(motion.row);
        track_.courses.push_back(motion.course);
    }
    return track_.rows.size() > before;
}

std::shared_ptr<const HullTrack> HullDrive::planned() const {
    auto track = std::make_shared<HullTrack>(track_);
    Motion motion = last();
    while (motion.row.time < last_time() + kPlan) {
        motion = after(motion, next_row(motion.row.time));
        track->rows.push_back(motion.row);
        track->courses.push_back(motion.course);
    }
    return track;
}

HullDrive::Pose HullDrive::pose(double time) const {
    auto newest = std::make_shared<HullTrack>();
    const std::size_t first = track_.rows.size() - std::min<std::size_t>(track_.rows.size(), 5);
    newest->rows.assign(track_.rows.begin() + static_cast<std::ptrdiff_t>(first),
                        track_.rows.end());
    newest->courses.assign(track_.courses.begin() + static_cast<std::ptrdiff_t>(first),
                           track_.courses.end());
    const PathVector place = TrackPath(std::move(newest), 0.0).place(time);
    return {place.x, place.y, track_.courses.back()};
}

Hull hull_to_drive(Hull hull, const Water& water) {
    const double fastest =
        std::max(fastest_leg(*hull.track).speed, kFroude * std::sqrt(water.gravity * hull.length));
    const WakeSize size = wake_size(hull, fastest, water);
    hull.track_file.clear();
    hull.origin.clear();
    hull.origin_time.clear();
    hull.wake_size = size.side;
    hull.wake_age = size.age;
    return hull;
}

}  // namespace ocean
