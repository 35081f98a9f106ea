// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Questions at points of the world: each checks its buffers and points first and writes afterwards,
// in batches, so that a long list needs no memory of its own.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "guard.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/float_pose.hpp"
#include "ocean/ocean.hpp"
#include "query_buffers.hpp"
#include "sea_handle.hpp"

using namespace ocean;
using namespace ocean::capi;

namespace {

constexpr std::size_t kSampleFloats = 9;
constexpr std::size_t kSampleFloatsWithFoam = 10;
constexpr std::size_t kVelocityFloats = 3;
constexpr std::size_t kBodyDoubles = 5;
constexpr std::size_t kPoseFloats = 11;

/// n inputs of `width` doubles and n outputs of `floats` floats, `stride` apart.
struct Lists {
    const double* in;
    const char* in_name;
    std::size_t width;
    std::size_t n;
    float* out;
    const char* out_name;
    std::size_t floats;
    std::size_t stride;

    void check() const {
        if (stride < floats) {
            refuse({.parameter = "stride",
                    .value = std::to_string(stride),
                    .allowed = std::to_string(floats) + " floats or more"});
        }
        if (n == 0) return;
        require(in, in_name);
        require(out, out_name);
        if (stride > SIZE_MAX / sizeof(float) / n || width > SIZE_MAX / sizeof(double) / n) {
            refuse("n = " + std::to_string(n) + " with stride = " + std::to_string(stride) +
                   " is more than there are addresses");
        }
    }

    float* row(std::size_t i) const { return out + i * stride; }
};

std::array<double, 3> velocity_of(const WaterMotion& motion) {
    return {motion.velocity_x, motion.velocity_y, motion.velocity_z};
}

float* put(float* out, std::span<const double> values) {
    for (const double value : values) *out++ = static_cast<float>(value);
    return out;
}

}  // namespace

ocean_result ocean_query(ocean_sea* sea, double time, const double* xy, size_t n, float* samples,
                         size_t stride) {
    return in_handle(sea, [&] {
        require_finite(time, "time", "seconds");
        const Lists lists{xy, "xy", 2, n, samples, "samples", kSampleFloats, stride};
        lists.check();
        check_points(xy, n, "xy");
        QueryOptions options;
        options.foam = stride >= kSampleFloatsWithFoam;
        const auto query = [&](std::span<const WorldPoint> points, std::span<QuerySample> answers) {
            sea->ocean->query(time, points, answers, options);
        };
        query_in_batches(xy, n, query,
                         [&](std::size_t i, WorldPoint at, const QuerySample& sample) {
                             const double point[] = {at.x, at.y, sample.height};
                             float* out = put(lists.row(i), point);
                             out = put(out, sample.normal);
                             out = put(out, sample.velocity);
                             if (options.foam) put(out, {&sample.foam, 1});
                         });
    });
}

ocean_result ocean_query_points(ocean_sea* sea, const ocean_query_request* request) {
    return in_handle(sea, [&] {
        const ocean_query_request asked =
            read_struct(request, offsetof(ocean_query_request, resolution), "ocean_query_request");
        require_finite(asked.time, "time", "seconds");
        Ocean& ocean = *sea->ocean;
        answer_points(
            asked, asked.foam != 0,
            [&](auto points, auto answers, const QueryOptions& options) {
                ocean.query(asked.time, points, answers, options);
            },
            [&](const QueryOptions& options) {
                return ocean.query_height_error(asked.time, options);
            });
    });
}

ocean_result ocean_orbital_velocity(ocean_sea* sea, double time, double z, const double* xy,
                                    size_t n, float* velocities, size_t stride) {
    return in_handle(sea, [&] {
        require_finite(time, "time", "seconds");
        require_finite(z, "z", "metres");
        const Lists lists{xy, "xy", 2, n, velocities, "velocities", kVelocityFloats, stride};
        lists.check();
        check_points(xy, n, "xy");
        std::vector<WaterPoint> points;
        for (std::size_t i = 0; i < n; ++i) points.push_back({xy[2 * i], xy[2 * i + 1], z});
        std::vector<WaterMotion> answers(n);
        sea->ocean->water_motion(time, points, answers);
        for (std::size_t i = 0; i < n; ++i) put(lists.row(i), velocity_of(answers[i]));
    });
}

ocean_result ocean_water_points(ocean_sea* sea, const ocean_water_request* request) {
    return in_handle(sea, [&] {
        const ocean_water_request asked =
            read_struct(request, offsetof(ocean_water_request, resolution), "ocean_water_request");
        require_finite(asked.time, "time", "seconds");
        const StructArray samples(asked.samples, asked.count, asked.sample_size,
                                  "ocean_water_sample");
        if (asked.count > 0) require(asked.xyz, "xyz");
        check_points(asked.xyz, asked.count, "xyz");
        std::vector<WaterPoint> points;
        for (const double* p = asked.xyz; points.size() < asked.count; p += 3) {
            points.push_back({p[0], p[1], p[2]});
        }
        std::vector<WaterMotion> answers(points.size());
        sea->ocean->water_motion(asked.time, points, answers,
                                 query_options(asked.resolution, asked.refine, asked.exact, false));
        for (std::size_t i = 0; i < answers.size(); ++i) {
            ocean_water_sample sample{};
            put(sample.velocity, velocity_of(answers[i]));
            sample.pressure = static_cast<float>(answers[i].pressure);
            samples.put(i, sample);
        }
    });
}

ocean_result ocean_float_pose(ocean_sea* sea, double time, const double* bodies, size_t n,
                              float* poses, size_t stride) {
    return in_handle(sea, [&] {
        require_finite(time, "time", "seconds");
        const Lists lists{bodies, "bodies", kBodyDoubles, n, poses, "poses", kPoseFloats, stride};
        lists.check();
        std::vector<FloatBody> list;
        for (std::size_t i = 0; i < n; ++i) {
            const double* b = bodies + kBodyDoubles * i;
            list.push_back({b[0], b[1], b[2], b[3], b[4]});
            try {
                require_body(list.back());
            } catch (const Error& error) {
                const std::string sentence = "body " + std::to_string(i) + ": " + error.what();
                throw CallError(OCEAN_INVALID_ARGUMENT,
                                Error(error.kind(), sentence, error.fields()));
            }
        }
        std::vector<FloatPose> answers(n);
        sea->ocean->float_poses(time, list, answers);
        for (std::size_t i = 0; i < n; ++i) {
            float* out = put(lists.row(i), answers[i].position);
            out = put(out, answers[i].up);
            out = put(out, answers[i].forward);
            const double angles[] = {answers[i].pitch, answers[i].roll};
            put(out, angles);
        }
    });
}
