// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The plane below a floating body; see float_pose.hpp.
#include "ocean/internal/float_pose.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "ocean/error.hpp"
#include "ocean/internal/text.hpp"

namespace ocean {
namespace {

constexpr int kMaxSamples = 64;  // along each side
constexpr double kMaxSide = 1e5;
constexpr double kDegrees = 180.0 / kPi;

struct Direction {
    double x, y;
};

/// The middles of equal parts of one side, none longer than a sample of the map.
struct Side {
    Direction along;
    int count;
    double part;  // m

    Side(Direction direction, double length, double spacing)
        : along(direction),
          count(std::clamp(static_cast<int>(std::ceil(std::min(length / spacing, 1e6))), 1,
                           kMaxSamples)),
          part(length / count) {}
    double at(int i) const { return (i + 0.5 - 0.5 * count) * part; }
};

/// Sums over the samples, in the body's axes: s forward, t to port, both 0 in the mean.
struct PlaneSums {
    double height = 0.0;
    double height_s = 0.0, height_t = 0.0;
    double ss = 0.0, tt = 0.0;
    double slope_x = 0.0, slope_y = 0.0;
    int count = 0;

    void add(const QuerySample& sample, double s, double t) {
        height += sample.height;
        height_s += sample.height * s;
        height_t += sample.height * t;
        ss += s * s;
        tt += t * t;
        // A vertical surface counts as a surface of 89.9 degrees.
        const double up = std::max(sample.normal[2], 1e-3);
        slope_x -= sample.normal[0] / up;
        slope_y -= sample.normal[1] / up;
        ++count;
    }
    /// Returns the slope of the plane along a side, or the surface's slope if the side is too
    /// short.
    double slope(const Side& side, double height_moment, double moment) const {
        if (side.count > 1) return height_moment / moment;
        return (slope_x * side.along.x + slope_y * side.along.y) / count;
    }
};

FloatPose pose_of(const FloatBody& body, double height, const Side& length, double slope_s,
                  const Side& width, double slope_t) {
    FloatPose pose{{body.x, body.y, height}, {}, {}, 0.0, 0.0};
    const double up_length = std::sqrt(1.0 + slope_s * slope_s + slope_t * slope_t);
    pose.up[0] = -(slope_s * length.along.x + slope_t * width.along.x) / up_length;
    pose.up[1] = -(slope_s * length.along.y + slope_t * width.along.y) / up_length;
    pose.up[2] = 1.0 / up_length;
    const double forward_length = std::sqrt(1.0 + slope_s * slope_s);
    pose.forward[0] = length.along.x / forward_length;
    pose.forward[1] = length.along.y / forward_length;
    pose.forward[2] = slope_s / forward_length;
    pose.pitch = std::atan(slope_s) * kDegrees;
    // The port vector is up x forward; its z is the sine of the roll.
    const double port_z = pose.up[0] * pose.forward[1] - pose.up[1] * pose.forward[0];
    pose.roll = std::asin(std::clamp(port_z, -1.0, 1.0)) * kDegrees;
    return pose;
}

}  // namespace

void require_body(const FloatBody& body) {
    const auto refuse = [](const char* name, double value, const char* allowed) {
        throw Error(ErrorKind::invalid_value,
                    {.parameter = name, .value = plain_text(value), .allowed = allowed});
    };
    if (!std::isfinite(body.x)) refuse("x", body.x, "a finite number of metres");
    if (!std::isfinite(body.y)) refuse("y", body.y, "a finite number of metres");
    if (!std::isfinite(body.heading)) refuse("heading", body.heading, "a finite angle in degrees");
    // The comparisons are written so that NaN fails them.
    const auto is_side = [](double side) { return side >= 0.0 && side <= kMaxSide; };
    if (!is_side(body.length)) refuse("length", body.length, "0 .. 100000 m");
    if (!is_side(body.width)) refuse("width", body.width, "0 .. 100000 m");
}

FloatPose float_pose(const SurfaceQuery& query, const FloatBody& body, ThreadPool& pool) {
    return float_pose([&](std::span<const WorldPoint> points,
                          std::span<QuerySample> samples) { query.sample(points, samples, pool); },
                      query.spacing(), body);
}

FloatPose float_pose(const SampleSurface& surface, double spacing, const FloatBody& body) {
    require_body(body);
    const double angle = std::fmod(body.heading, 360.0) / kDegrees;
    const Direction forward{std::cos(angle), std::sin(angle)};
    const Side length(forward, body.length, spacing);
    const Side width({-forward.y, forward.x}, body.width, spacing);

    std::vector<WorldPoint> points;
    for (int j = 0; j < width.count; ++j) {
        for (int i = 0; i < length.count; ++i) {
            const double s = length.at(i);
            const double t = width.at(j);
            points.push_back(
                {body.x + s * forward.x - t * forward.y, body.y + s * forward.y + t * forward.x});
        }
    }
    std::vector<QuerySample> samples(points.size());
    surface(points, samples);

    PlaneSums sums;
    std::size_t next = 0;
    for (int j = 0; j < width.count; ++j) {
        for (int i = 0; i < length.count; ++i) sums.add(samples[next++], length.at(i), width.at(j));
    }
    return pose_of(body, sums.height / sums.count, length,
                   sums.slope(length, sums.height_s, sums.ss), width,
                   sums.slope(width, sums.height_t, sums.tt));
}

}  // namespace ocean
