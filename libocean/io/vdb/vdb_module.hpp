// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// OpenVDB is in a module that programs load when they first make a volume: the linker needs 50 ms
// for its sixty thousand symbols, at each start of a program that is linked to it. The functions of
// ocean/io/vdb.hpp that need it are in the module's own namespace, behind a table.
#pragma once

#include "ocean/io/vdb.hpp"

namespace ocean::io {

struct VdbModule {
    const char* version;  // of the library that it was built with
    decltype(make_level_set)* level_set;
    decltype(make_velocity)* velocity;
    decltype(make_density)* density;
    decltype(make_points)* points;
    decltype(write_vdb)* write;
};

namespace vdb {
decltype(io::make_level_set) make_level_set;
decltype(io::make_velocity) make_velocity;
decltype(io::make_density) make_density;
decltype(io::make_points) make_points;
decltype(io::write_vdb) write_vdb;
}  // namespace vdb

}  // namespace ocean::io
