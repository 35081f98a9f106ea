// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Questions at points of the world: each checks its buffers and points first and writes afterwards,
// in batches, so that a long list needs no memory of its own.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "guard.hpp"
#include "ocean/error.hpp"
#include "ocean/ocean.hpp"
#include "sea_handle.hpp"

using namespace ocean;
using namespace ocean::capi;

namespace {

constexpr std::size_t kBatch = 1 << 14;
constexpr std::size_t kSampleFloats = 9;
constexpr std::size_t kSampleFloatsWithFoam = 10;
constexpr std::size_t kVelocityFloats = 3;
constexpr std::size_t kBodyDoubles = 5;
constexpr std::size_t kPoseFloats = 11;

void require_finite(double value, const std::string& name, const char* unit) {
    if (std::isfinite(value)) return;
    refuse(name + " = " + std::to_string(value) + "; allowed: a finite number of " + unit);
}

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
            refuse("stride = " + std::to_string(stride) + "; allowed: " + std::to_string(floats) +
                   " floats or more");
        }
        if (n == 0) return;
        require(in, in_name);
        require(out, out_name);
        if (stride > SIZE_MAX / sizeof(float) / n || width > SIZE_MAX / sizeof(double) / n) {
            refuse("n = " + std::to_string(n) + " with stride = " + std::to_string(stride) +
                   " is more than there are addresses");
        }
    }

    /// ask(first, count) answers a batch, write(i, out) puts the i-th answer of it into the buffer.
    template <typename Ask, typename Write>
    void in_batches(const Ask& ask, const Write& write) const {
        for (std::size_t first = 0; first < n; first += kBatch) {
            const std::size_t count = std::min(kBatch, n - first);
            ask(first, count);
            for (std::size_t i = 0; i < count; ++i) write(i, out + (first + i) * stride);
        }
    }
};

void check_points(const double* xy, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) {
        require_finite(xy[2 * i], "x of point " + std::to_string(i), "metres");
        require_finite(xy[2 * i + 1], "y of point " + std::to_string(i), "metres");
    }
}

/// Points of one batch, as core takes them.
std::span<const WorldPoint> fill_points(std::vector<WorldPoint>& points, const double* xy,
                                        std::size_t first, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        points[i] = {xy[2 * (first + i)], xy[2 * (first + i) + 1]};
    }
    return std::span(points).first(count);
}

ocean_sample sample_of(const QuerySample& from) {
    ocean_sample sample{};
    sample.height = static_cast<float>(from.height);
    for (int c = 0; c < 3; ++c) {
        sample.normal[c] = static_cast<float>(from.normal[c]);
        sample.velocity[c] = static_cast<float>(from.velocity[c]);
    }
    sample.foam = static_cast<float>(from.foam);
    std::ranges::copy(from.label, sample.label);
    if (from.folded) sample.flags |= OCEAN_FOLDED;
    if (from.undecided) sample.flags |= OCEAN_UNDECIDED;
    return sample;
}

float* put(float* out, std::span<const double> values) {
    for (const double value : values) *out++ = static_cast<float>(value);
    return out;
}

}  // namespace

ocean_result ocean_query(ocean_sea* sea, double time, const double* xy, size_t n, float* samples,
                         size_t stride) {
    return guarded([&] {
        const Visit visit(sea);
        require_finite(time, "time", "seconds");
        const Lists lists{xy, "xy", 2, n, samples, "samples", kSampleFloats, stride};
        lists.check();
        check_points(xy, n);
        QueryOptions options;
        options.foam = stride >= kSampleFloatsWithFoam;
        std::vector<WorldPoint> points(std::min(n, kBatch));
        std::vector<QuerySample> answers(points.size());
        lists.in_batches(
            [&](std::size_t first, std::size_t count) {
                sea->ocean->query(time, fill_points(points, xy, first, count), answers, options);
            },
            [&](std::size_t i, float* out) {
                const QuerySample& sample = answers[i];
                const double point[] = {points[i].x, points[i].y, sample.height};
                out = put(out, point);
                out = put(out, sample.normal);
                out = put(out, sample.velocity);
                if (options.foam) put(out, {&sample.foam, 1});
            });
    });
}

ocean_result ocean_query_points(ocean_sea* sea, const ocean_query_request* request) {
    return guarded([&] {
        const Visit visit(sea);
        require(request, "request");
        const ocean_query_request asked =
            read_struct(request, offsetof(ocean_query_request, resolution), "ocean_query_request");
        require_finite(asked.time, "time", "seconds");
        if (asked.count > 0) {
            require(asked.xy, "xy");
            require(asked.samples, "samples");
        }
        const std::size_t size = asked.sample_size;
        if (size < sizeof(float) || size > kMaxStructSize || size % alignof(std::int32_t) != 0) {
            refuse("sample_size = " + std::to_string(size) +
                   "; set it to sizeof(ocean_sample), here " +
                   std::to_string(sizeof(ocean_sample)));
        }
        if (asked.count > SIZE_MAX / std::max(size, 2 * sizeof(double))) {
            refuse("count = " + std::to_string(asked.count) + " is more than there are addresses");
        }
        check_points(asked.xy, asked.count);
        QueryOptions options;
        options.foam = asked.foam != 0;
        options.exact = asked.exact != 0;
        options.refine = asked.refine == 0 ? 1 : asked.refine;
        options.resolution = asked.resolution;
        std::vector<WorldPoint> points(std::min(asked.count, kBatch));
        std::vector<QuerySample> answers(points.size());
        auto* out = reinterpret_cast<unsigned char*>(asked.samples);
        for (std::size_t first = 0; first < asked.count; first += kBatch) {
            const std::size_t count = std::min(kBatch, asked.count - first);
            sea->ocean->query(asked.time, fill_points(points, asked.xy, first, count), answers,
                              options);
            for (std::size_t i = 0; i < count; ++i, out += size) {
                const ocean_sample sample = sample_of(answers[i]);
                std::memcpy(out, &sample, std::min(size, sizeof(sample)));
            }
        }
        if (asked.height_error != nullptr) {
            *asked.height_error = sea->ocean->query_height_error(asked.time, options);
        }
    });
}

ocean_result ocean_orbital_velocity(ocean_sea* sea, double time, double z, const double* xy,
                                    size_t n, float* velocities, size_t stride) {
    return guarded([&] {
        const Visit visit(sea);
        require_finite(time, "time", "seconds");
        require_finite(z, "z", "metres");
        const Lists lists{xy, "xy", 2, n, velocities, "velocities", kVelocityFloats, stride};
        lists.check();
        check_points(xy, n);
        std::vector<WorldPoint> points(std::min(n, kBatch));
        std::vector<std::array<double, 3>> answers(points.size());
        lists.in_batches(
            [&](std::size_t first, std::size_t count) {
                sea->ocean->orbital_velocity(time, z, fill_points(points, xy, first, count),
                                             answers);
            },
            [&](std::size_t i, float* out) { put(out, answers[i]); });
    });
}

ocean_result ocean_float_pose(ocean_sea* sea, double time, const double* bodies, size_t n,
                              float* poses, size_t stride) {
    return guarded([&] {
        const Visit visit(sea);
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
                refuse("body " + std::to_string(i) + ": " + error.what());
            }
        }
        std::vector<FloatPose> answers(n);
        sea->ocean->float_poses(time, list, answers);
        for (std::size_t i = 0; i < n; ++i) {
            float* out = poses + i * stride;
            out = put(out, answers[i].position);
            out = put(out, answers[i].up);
            out = put(out, answers[i].forward);
            const double angles[] = {answers[i].pitch, answers[i].roll};
            put(out, angles);
        }
    });
}
