// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Loads the module of OpenVDB: by the search path of the program, which knows where it lies beside
// it, or from the folder of the installed library.
#include <dlfcn.h>

#include <string>
#include <string_view>

#include "ocean/error.hpp"
#include "ocean/version.hpp"
#include "vdb_module.hpp"

namespace ocean::io {
namespace {

constexpr const char* kName = "ocean_vdb.so";
constexpr const char* kInstalled = OCEAN_MODULE_FOLDER "/ocean_vdb.so";

/// Returns the module. It stays loaded: grids are destroyed by its code. Throws Error output.
const VdbModule& load() {
    void* library = dlopen(kName, RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) library = dlopen(kInstalled, RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) {
        throw Error(ErrorKind::output, std::string("cannot load what makes volumes: ") + dlerror());
    }
    const auto* const module = static_cast<const VdbModule*>(dlsym(library, "ocean_vdb_module"));
    if (module == nullptr || std::string_view(module->version) != OCEAN_VERSION) {
        throw Error(ErrorKind::output,
                    std::string(kName) + " is of another libocean than this, " + OCEAN_VERSION);
    }
    return *module;
}

const VdbModule& vdb_module() {
    static const VdbModule& module = load();
    return module;
}

}  // namespace

VdbGrid make_level_set(const WorldBox& box, const VoxelRange& voxels,
                       std::span<const SurfaceColumn> columns, VolumeAxes axes, ThreadPool& pool) {
    return vdb_module().level_set(box, voxels, columns, axes, pool);
}

VdbGrid make_velocity(const VoxelRange& voxels, std::span<const float> heights,
                      const VelocityLayer& layer, VolumeAxes axes, ThreadPool& pool) {
    return vdb_module().velocity(voxels, heights, layer, axes, pool);
}

VdbGrid make_density(const VoxelRange& voxels, std::span<const float> heights,
                     std::span<const DensityPuff> puffs, VolumeAxes axes, ThreadPool& pool) {
    return vdb_module().density(voxels, heights, puffs, axes, pool);
}

VdbGrid make_points(const Points& points, double cell) {
    return vdb_module().points(points, cell);
}

void write_vdb(std::span<const VdbGrid> grids, std::span<const HeaderString> strings,
               bool half_floats, const std::string& path) {
    vdb_module().write(grids, strings, half_floats, path);
}

}  // namespace ocean::io
