// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What stands behind the opaque ocean_sea of libocean.h.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "libocean.h"
#include "ocean/ocean.hpp"
#include "ocean/sea.hpp"

struct ocean_sea {
    ocean_sea(ocean::Sea sea, ocean::OceanOptions opened_with, std::string folder)
        : options(opened_with),
          base_dir(std::move(folder)),
          ocean(std::make_unique<ocean::Ocean>(std::move(sea), options)) {}

    ocean::OceanOptions options;
    std::string base_dir;                 // where a relative `file` or `take` starts
    std::unique_ptr<ocean::Ocean> ocean;  // readers may make it build what they ask for
    std::vector<ocean::MapOutput>
        map_outputs;  // of the request, kept so that frames allocate nothing
};
