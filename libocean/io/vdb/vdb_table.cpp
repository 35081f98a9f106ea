// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The table that the module is loaded for. Its other symbols are visible too, because OpenVDB's
// library and the module must share the names of types that OpenVDB keeps in templates.
#include "ocean/version.hpp"
#include "vdb_module.hpp"

extern "C" const ocean::io::VdbModule ocean_vdb_module;
const ocean::io::VdbModule ocean_vdb_module = {
    OCEAN_VERSION,
    ocean::io::vdb::make_level_set,
    ocean::io::vdb::make_velocity,
    ocean::io::vdb::make_density,
    ocean::io::vdb::make_points,
    ocean::io::vdb::write_vdb,
};
