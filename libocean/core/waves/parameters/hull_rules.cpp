// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Rules of hulls and their tracks; see hull_rules.hpp.
#include "ocean/internal/hull_rules.hpp"

#include <cmath>
#include <string>
#include <string_view>

#include "ocean/error.hpp"
#include "ocean/internal/grid.hpp"

namespace ocean {
namespace {

/// A leg from one row to the next.
struct Leg {
    double seconds;
    double speed;    // [m/s]
    double heading;  // [rad]
};

Leg leg_to(const HullTrack& track, std::size_t row) {
    const TrackRow& a = track.rows[row - 1];
    const TrackRow& b = track.rows[row];
    const double seconds = b.time - a.time;
    return {seconds, std::hypot(b.x - a.x, b.y - a.y) / seconds, std::atan2(b.y - a.y, b.x - a.x)};
}

/// The errors of one track.
class TrackRules {
  public:
    TrackRules(const HullTrack& track, const std::string& name) : track_(track), name_(name) {}

    void check() const {
        if (track_.rows.size() < 2) {
            refuse("has " + std::to_string(track_.rows.size()) + " rows", "2 or more");
        }
        if (!track_.courses.empty() && track_.courses.size() != track_.rows.size()) {
            refuse("has " + std::to_string(track_.courses.size()) + " courses for " +
                       std::to_string(track_.rows.size()) + " rows",
                   "one for each row, or none");
        }
        for (std::size_t row = 0; row < track_.rows.size(); ++row) check_row(row);
    }

  private:
    [[noreturn]] void refuse(const std::string& what, const std::string& allowed) const {
        throw Error(ErrorKind::invalid_value,
                    {.what = what, .parameter = name_, .allowed = allowed});
    }
    [[noreturn]] void refuse(std::size_t row, const std::string& what,
                             const std::string& allowed) const {
        refuse("row " + std::to_string(row + 1) + " (" + to_text(track_.rows[row].time) + " s) " +
                   what,
               allowed);
    }

    void check_row(std::size_t row) const {
        const TrackRow& at = track_.rows[row];
        constexpr double kFarthest = 1e7;
        if (!(std::abs(at.time) <= kLatestTime)) refuse(row, "has no time", "-1e9 .. 1e9 s");
        if (!(std::abs(at.x) <= kFarthest) || !(std::abs(at.y) <= kFarthest)) {
            refuse(row, "has no place", "x and y within -1e7 .. 1e7 m");
        }
        if (!track_.courses.empty()) check_course(row);
        if (row == 0) return;
        if (!(at.time > track_.rows[row - 1].time)) {
            refuse(row, "is not after the row before it", "rows in order of time");
        }
        const Leg leg = leg_to(track_, row);
        if (leg.speed > kMaxHullSpeed) {
            refuse(row, "is reached at " + fixed_speed(leg.speed) + ": the hull jumps",
                   "at most " + fixed_speed(kMaxHullSpeed));
        }
        if (row > 1) check_turn(row, leg_to(track_, row - 1), leg);
        if (!track_.courses.empty()) check_change_of_course(row, leg.seconds);
    }

    void check_course(std::size_t row) const {
        const TrackCourse& course = track_.courses[row];
        if (!(std::abs(course.heading) <= 720.0)) {
            refuse(row, "has no heading", "-720 .. 720 degrees");
        }
        if (!(course.speed >= 0.0 && course.speed <= kMaxHullSpeed)) {
            refuse(row, "has no speed that a hull can have", "0 .. " + fixed_speed(kMaxHullSpeed));
        }
    }

    /// Turns are judged while the hull moves: at rest the heading is noise.
    void check_turn(std::size_t row, const Leg& before, const Leg& after) const {
        if (before.speed < kMoving || after.speed < kMoving) return;
        refuse_turn(row - 1, (after.heading - before.heading) / kDegree,
                    0.5 * (before.seconds + after.seconds));
    }

    void check_change_of_course(std::size_t row, double seconds) const {
        const TrackCourse& from = track_.courses[row - 1];
        const TrackCourse& to = track_.courses[row];
        if (from.speed < kMoving || to.speed < kMoving) return;
        refuse_turn(row, to.heading - from.heading, seconds);
    }

    /// Throws if a turn by `degrees` in `seconds` is too fast.
    void refuse_turn(std::size_t row, double degrees, double seconds) const {
        const double angle = std::abs(std::remainder(degrees, 360.0));
        const double rate = angle / seconds;
        if (rate <= kMaxTurnRate) return;
        refuse(row,
               "turns by " + std::to_string(std::lround(angle)) + " degrees at " +
                   std::to_string(std::lround(rate)) + " degrees a second",
               "at most " + std::to_string(std::lround(kMaxTurnRate)) + " degrees a second");
    }

    static std::string fixed_speed(double speed) {
        return std::to_string(std::lround(speed)) + " m/s";
    }

    static constexpr double kMoving = 1.0;  // [m/s]

    const HullTrack& track_;
    const std::string& name_;
};

void require_closed(const HullTrack& track, double loop_period, const std::string& name) {
    constexpr double kSamePlace = 1e-3;  // [m]
    const TrackRow& first = track.rows.front();
    const TrackRow& last = track.rows.back();
    const double turns = loop_period / track.duration();
    const bool divides = std::abs(turns - std::round(turns)) < 1e-9 * turns && turns > 0.5;
    const bool closes = std::hypot(last.x - first.x, last.y - first.y) <= kSamePlace;
    if (divides && closes) return;
    throw Error(
        ErrorKind::invalid_value,
        {.what = closes
                     ? "lasts " + to_text(track.duration()) + " s, which does not divide the loop"
                     : "ends " + to_text(std::hypot(last.x - first.x, last.y - first.y)) +
                           " m from where it begins, and the sea loops",
         .parameter = name,
         .allowed = "with time.loop_period = " + to_text(loop_period) +
                    " s: a track that ends where it began, in a whole part of the loop"});
}

void validate_hull(const Hull& hull, const Parameters& parameters, const std::string& name) {
    if (hull.track == nullptr) {
        throw Error(ErrorKind::invalid_value,
                    {.what = hull.track_file.empty() ? "has no track"
                                                     : "has a track that has not been read",
                     .parameter = name,
                     .allowed = "track = [[time, x, y], ...] or track_file = a CSV or GPX file"});
    }
    require_track(*hull.track, name + ".track");
    const auto require_within_length = [&](std::string_view key, double value) {
        if (value <= hull.length) return;
        throw Error(ErrorKind::invalid_value,
                    {.what = "theory is that of a hull that is longer than wide and deep",
                     .parameter = name + "." + std::string(key),
                     .value = to_text(value) + " m",
                     .allowed = "at most its length, " + to_text(hull.length) + " m"});
    };
    require_within_length("beam", hull.beam);
    require_within_length("draught", hull.draught);
    if (hull.draught >= parameters.water.depth) {
        throw Error(
            ErrorKind::invalid_value,
            {.parameter = name + ".draught",
             .value = to_text(hull.draught) + " m",
             .allowed = "less than water.depth = " + to_text(parameters.water.depth) + " m"});
    }
    constexpr double kLengths = 4.0;  // a wake needs water around its hull
    if (hull.wake_size > 0.0 && hull.wake_size < kLengths * hull.length) {
        throw Error(ErrorKind::invalid_value,
                    {.what = "does not hold the hull and its waves",
                     .parameter = name + ".wake_size",
                     .value = to_text(hull.wake_size) + " m",
                     .allowed = "0, or at least four lengths of the hull, " +
                                to_text(kLengths * hull.length) + " m"});
    }
    if (parameters.time.loop_period > 0.0) {
        require_closed(*hull.track, parameters.time.loop_period, name + ".track");
    }
}

}  // namespace

bool Hull::operator==(const Hull& other) const {
    const bool same_track = track == other.track ||
                            (track != nullptr && other.track != nullptr && *track == *other.track);
    return same_track && length == other.length && beam == other.beam && draught == other.draught &&
           shape == other.shape && factor == other.factor &&
           trail_lifetime == other.trail_lifetime && track_file == other.track_file &&
           origin == other.origin && origin_time == other.origin_time &&
           wake_size == other.wake_size && wake_resolution == other.wake_resolution &&
           wake_age == other.wake_age;
}

FastestLeg fastest_leg(const HullTrack& track) {
    FastestLeg fastest;
    for (std::size_t row = 1; row < track.rows.size(); ++row) {
        const double speed = leg_to(track, row).speed;
        if (speed > fastest.speed) fastest = {speed, track.rows[row].time};
    }
    return fastest;
}

void require_track(const HullTrack& track, const std::string& name) {
    TrackRules(track, name).check();
}

void validate_hulls(const Parameters& parameters) {
    if (parameters.hulls.empty()) return;
    const Water& water = parameters.water;
    if (water.bed != nullptr || !water.seabed.empty()) {
        throw Error(ErrorKind::unsupported,
                    {.what = "a hull needs an open sea: over a bed its waves would refract, which "
                             "is not computed",
                     .parameter = "hulls",
                     .allowed = "no hulls with water.seabed"});
    }
    std::size_t rows = 0;
    for (std::size_t i = 0; i < parameters.hulls.size(); ++i) {
        const Hull& hull = parameters.hulls[i];
        const std::string name = "hulls." + std::to_string(i);
        if (hull.track != nullptr) rows += hull.track->rows.size();
        if (rows > kMaxTrackRows) {
            throw Error(ErrorKind::invalid_value,
                        {.what = "makes " + std::to_string(rows) + " rows of tracks",
                         .parameter = name + ".track",
                         .allowed = "at most " + std::to_string(kMaxTrackRows) +
                                    " of all hulls together; a row for each second is plenty"});
        }
        validate_hull(hull, parameters, name);
    }
}

std::vector<std::string> hull_warnings(const Parameters& parameters) {
    if (parameters.hulls.empty()) return {};
    return {
        "wakes of hulls do not repeat: maps of one period, their foam and spray leave them out; "
        "a region (ocean bake --region) and queries have them"};
}

}  // namespace ocean
