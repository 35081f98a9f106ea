// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The struct behind the opaque ocean_sea of libocean.h.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "handle.hpp"
#include "libocean.h"
#include "ocean/ocean.hpp"
#include "ocean/sea.hpp"

namespace ocean::capi {

/// Spray that a caller has been told the number of, until it is taken.
struct CountedSpray {
    std::uint64_t revision;  // of the sea
    double time;
    SpraySettings settings;
    std::optional<Domain> region;
    std::vector<SprayParticle> particles;
};

}  // namespace ocean::capi

struct ocean_sea : ocean::capi::Handle {
    static constexpr const char* kName = "sea";
    ocean_sea(ocean::Sea sea, ocean::OceanOptions opened_with, std::string folder)
        : options(std::move(opened_with)),
          base_dir(std::move(folder)),
          ocean(std::make_unique<ocean::Ocean>(std::move(sea), options)) {}
    ocean_sea(const ocean_sea& built, ocean::OceanOptions opened_with)
        : options(std::move(opened_with)),
          base_dir(built.base_dir),
          ocean(std::make_unique<ocean::Ocean>(*built.ocean, options)) {}

    ocean::OceanOptions options;
    std::string base_dir;                 // where a relative `file` or `take` starts
    std::unique_ptr<ocean::Ocean> ocean;  // readers may make it build what they ask for
    std::vector<ocean::MapOutput>
        map_outputs;  // of the request, kept so that frames allocate nothing
    std::optional<ocean::capi::CountedSpray> counted_spray;
};

namespace ocean::capi {

/// NULL: the defaults. Throws CallError for what libocean.h does not allow.
OceanOptions read_options(const ocean_options* given);

}  // namespace ocean::capi
