// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The buffers of a host's queries, for seas and terrains: points in, samples out, in batches.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "guard.hpp"
#include "libocean.h"
#include "ocean/query.hpp"

namespace ocean::capi {

inline constexpr std::size_t kBatch = 1 << 14;

/// n points of as many coordinates as there are names.
inline void check_points(const double* points, std::size_t n, std::string_view coordinates) {
    for (std::size_t i = 0; i < n; ++i) {
        for (const char name : coordinates) {
            require_finite(*points++, name + (" of point " + std::to_string(i)), "metres");
        }
    }
}

/// Queries n points in batches; write(i, point, sample) puts the answer to point i into a buffer.
/// query(points, answers) answers one batch.
template <typename Query, typename Write>
void query_in_batches(const double* xy, std::size_t n, const Query& query, const Write& write) {
    std::vector<WorldPoint> points;
    std::vector<QuerySample> answers(std::min(n, kBatch));
    for (std::size_t first = 0; first < n; first += kBatch) {
        points.clear();
        for (std::size_t i = first; i < std::min(first + kBatch, n); ++i) {
            points.push_back({xy[2 * i], xy[2 * i + 1]});
        }
        query(points, answers);
        for (std::size_t i = 0; i < points.size(); ++i) write(first + i, points[i], answers[i]);
    }
}

/// A host's array of structs, `count` of them each `size` bytes apart, of which a smaller one has
/// fewer members.
template <typename Struct>
class StructArray {
  public:
    StructArray(Struct* data, std::size_t count, std::size_t size, const std::string& name)
        : data_(reinterpret_cast<unsigned char*>(data)), size_(size) {
        require_struct_size(size, sizeof(float), "sample_size", name, sizeof(Struct));
        constexpr std::size_t kMaxDoubles = 3;  // of a point
        if (count > SIZE_MAX / std::max(size, kMaxDoubles * sizeof(double))) {
            refuse("count = " + std::to_string(count) + " is more than there are addresses");
        }
        if (count > 0) require(data, "samples");
    }
    void put(std::size_t i, const Struct& value) const {
        std::memcpy(data_ + i * size_, &value, std::min(size_, sizeof(value)));
    }

  private:
    unsigned char* data_;
    std::size_t size_;
};

inline QueryOptions query_options(std::int32_t resolution, std::int32_t refine, std::int32_t exact,
                                  bool foam) {
    return {exact != 0, refine == 0 ? 1 : refine, foam, resolution};
}

inline ocean_sample sample_of(const QuerySample& from) {
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

/// Answers a request: query(points, answers, options) answers one batch, height_error(options)
/// returns the error of all.
template <typename Query, typename HeightError>
void answer_points(const ocean_query_request& asked, bool foam, const Query& query,
                   const HeightError& height_error) {
    const StructArray samples(asked.samples, asked.count, asked.sample_size, "ocean_sample");
    if (asked.count > 0) require(asked.xy, "xy");
    check_points(asked.xy, asked.count, "xy");
    const QueryOptions options = query_options(asked.resolution, asked.refine, asked.exact, foam);
    query_in_batches(
        asked.xy, asked.count,
        [&](std::span<const WorldPoint> points, std::span<QuerySample> answers) {
            query(points, answers, options);
        },
        [&](std::size_t i, WorldPoint, const QuerySample& sample) {
            samples.put(i, sample_of(sample));
        });
    if (asked.height_error != nullptr) *asked.height_error = height_error(options);
}

}  // namespace ocean::capi
