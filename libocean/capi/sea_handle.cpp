// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The functions of libocean.h that open, describe and change a sea, and those that need none: each
// one a call into core or seafile, with its arguments checked and its result copied out.
#include "sea_handle.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <string_view>

#include "guard.hpp"
#include "handle_functions.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/internal/water_types.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/sea_bed.hpp"
#include "ocean/sea_state.hpp"
#include "ocean/seafile.hpp"
#include "ocean/version.hpp"

using namespace ocean;
using namespace ocean::capi;

namespace {

constexpr std::int32_t kMaxThreads = 1024;
constexpr std::array<std::string_view, 4> kBackends = {"cpu", "gl", "radix2", "dft"};
static_assert(OCEAN_CPU == 0 && OCEAN_GL == 1 && OCEAN_RADIX2 == 2 && OCEAN_DFT == 3);

/// The pool's jobs on the host's threads.
ThreadPool::RunJobs on_host(ocean_run_jobs run_jobs, void* user) {
    return [=](int count, const std::function<void(int)>& job) {
        const auto run_one = [](void* work, std::int32_t index) {
            const PlainFloats plain;
            (*static_cast<const std::function<void(int)>*>(work))(index);
        };
        run_jobs(user, run_one, const_cast<std::function<void(int)>*>(&job), count);
    };
}

void remove_bed(Water& water) {
    water.seabed.clear();
    water.bed = nullptr;
}

/// Returns the caller's heights. Throws CallError for sides that no bed has.
GivenBed read_bed(const float* heights, std::int32_t nx, std::int32_t ny, double cell) {
    GivenBed given;
    const auto require_side = [](std::int32_t side, const char* name) {
        if (side >= kMinBedSide && side <= kMaxBedSide) return;
        refuse({.parameter = name,
                .value = std::to_string(side),
                .allowed = "2 .. 8192, or NULL heights and 0 samples for no bed"});
    };
    require_side(nx, "nx");
    require_side(ny, "ny");
    given.grid.samples = {nx, ny};
    given.grid.size = {cell * (nx - 1), cell * (ny - 1)};
    given.heights.assign(heights, heights + given.grid.count());
    return given;
}

/// Gives the sea a bed whose heights are over still water.
void give_bed(Sea& sea, GivenBed given, double x0, double y0) {
    Water& water = sea.parameters.water;
    remove_bed(water);
    set_parameter(
        sea.parameters, "water.seabed_origin",
        x0 == 0.0 && y0 == 0.0 ? "[]" : "[" + shortest_text(x0) + ", " + shortest_text(y0) + "]");
    water.seabed_unit = BedUnit::m;
    water.seabed_sign = BedSign::up;
    water.level = 0.0;
    water.bed = make_sea_bed(std::move(given), water);
    if (!sea.take.empty()) require_takes(sea.parameters);
}

}  // namespace

/// The calls by which a sea differs in the functions of handle_functions.hpp.
template <>
struct ocean::capi::Family<ocean_sea> {
    static constexpr auto read_options = capi::read_options;
    static constexpr auto text = write_sea;
    static constexpr auto presets = ocean::presets;
    static constexpr auto find_preset = ocean::find_preset;
    static Sea read(const char* path) { return read_sea(path); }
    static Sea parse(std::string_view toml, const char* name, const std::string& folder) {
        return parse_sea(toml, name, folder);
    }
    static const Sea& model(const ocean_sea& handle) { return handle.ocean->sea(); }
    static auto& parameters(auto& sea) { return sea.parameters; }
    static void replace(ocean_sea& handle, Sea sea) { handle.ocean->change(std::move(sea)); }
    static std::string state(const ocean_sea& handle) {
        return sea_state_json(handle.ocean->state());
    }
};

OceanOptions ocean::capi::read_options(const ocean_options* given) {
    if (given == nullptr) return {};
    const ocean_options asked = read_struct(given, sizeof(given->struct_size), "ocean_options");
    if (asked.threads < 0 || asked.threads > kMaxThreads) {
        refuse({.parameter = "threads",
                .value = std::to_string(asked.threads),
                .allowed = "0 (the cores this process may use) .. " + std::to_string(kMaxThreads)});
    }
    if (asked.backend < OCEAN_CPU || asked.backend > OCEAN_DFT) {
        refuse({.parameter = "backend",
                .value = std::to_string(asked.backend),
                .allowed = "OCEAN_CPU, OCEAN_GL, OCEAN_RADIX2, OCEAN_DFT"});
    }
    if (asked.foam_start < OCEAN_FOAM_SETTLED || asked.foam_start > OCEAN_FOAM_EMPTY) {
        refuse({.parameter = "foam_start",
                .value = std::to_string(asked.foam_start),
                .allowed = "OCEAN_FOAM_SETTLED, OCEAN_FOAM_EMPTY"});
    }
    require_reserved(asked.reserved, "reserved");
    OceanOptions options;
    options.threads = asked.threads;
    options.backend = find_backend(kBackends[static_cast<std::size_t>(asked.backend)]);
    if (asked.foam_start == OCEAN_FOAM_EMPTY) options.foam_start = FoamStart::empty;
    if (asked.progress != nullptr) {
        const auto report = [progress = asked.progress, user = asked.user](std::int64_t done,
                                                                           std::int64_t total) {
            if (progress(user, done, total) == 0) return;
            throw CallError(OCEAN_CANCELLED, "the host's progress function ended the call");
        };
        options.foam_progress = report;
        options.build_progress = [report](std::string_view, double share) {
            constexpr double kWhole = 1000.0;
            report(static_cast<std::int64_t>(kWhole * share), static_cast<std::int64_t>(kWhole));
        };
        options.interrupt = [report] { report(0, 0); };
    }
    if (asked.run_jobs != nullptr) options.run_jobs = on_host(asked.run_jobs, asked.jobs_user);
    return options;
}

uint32_t ocean_abi_version(void) {
    return OCEAN_ABI_VERSION;
}
const char* ocean_version(void) {
    return OCEAN_VERSION;
}
const char* ocean_last_error(void) {
    return last_error();
}
const char* ocean_last_error_field(int32_t field) {
    return last_error_field(field);
}

ocean_result ocean_open(const char* path, const ocean_options* options, ocean_sea** out) {
    return open_handle(path, options, out);
}

ocean_result ocean_parse(const char* toml, size_t length, const char* base_dir,
                         const ocean_options* options, ocean_sea** out) {
    return parse_handle(toml, length, base_dir, options, out);
}

ocean_result ocean_clone(const ocean_sea* sea, const ocean_options* options, ocean_sea** out) {
    return clone_handle(sea, options, out);
}

void ocean_free(ocean_sea* sea) {
    free_handle(sea);
}

ocean_result ocean_set(ocean_sea* sea, const char* name, const char* value) {
    return set_value(sea, name, value);
}

ocean_result ocean_set_all(ocean_sea* sea, const char* const* names, const char* const* values,
                           size_t count) {
    return set_values(sea, names, values, count);
}

ocean_result ocean_add_waves(ocean_sea* sea, const char* name) {
    return in_handle(sea, [&] {
        require(name, "name");
        change(*sea, [&](Sea& changed) { add_wave_system(changed, name); });
    });
}

ocean_result ocean_remove_waves(ocean_sea* sea, const char* name) {
    return in_handle(sea, [&] {
        require(name, "name");
        change(*sea, [&](Sea& changed) { remove_wave_system(changed, name); });
    });
}

ocean_result ocean_set_bed(ocean_sea* sea, const float* heights, int32_t nx, int32_t ny, double x0,
                           double y0, double cell) {
    return in_handle(sea, [&] {
        if (heights == nullptr && nx == 0 && ny == 0) {
            return change(*sea, [](Sea& changed) { remove_bed(changed.parameters.water); });
        }
        require(heights, "heights");
        require_finite(x0, "x0", "metres");
        require_finite(y0, "y0", "metres");
        require_finite(cell, "cell", "metres");
        change(*sea,
               [&](Sea& changed) { give_bed(changed, read_bed(heights, nx, ny, cell), x0, y0); });
    });
}

ocean_result ocean_perform(ocean_sea* sea, double time, const char* name, const char* value) {
    return in_handle(sea, [&] {
        require(name, "name");
        require(value, "value");
        sea->ocean->perform(time, name, value);
    });
}

ocean_result ocean_get(const ocean_sea* sea, const char* name, char* out, size_t size) {
    return get_value(sea, name, out, size);
}

ocean_result ocean_text(const ocean_sea* sea, char* out, size_t* size) {
    return write_text(sea, out, size);
}

ocean_result ocean_parameters_json(char* out, size_t* size) {
    return guarded([&] { copy_text(parameters_json(), out, size); });
}

ocean_result ocean_state_json(const ocean_sea* sea, char* out, size_t* size) {
    return write_state(sea, out, size);
}

ocean_result ocean_records_json(const char* file, char* out, size_t* size) {
    return guarded([&] {
        require(file, "file");
        copy_text(records_json(read_spectra(file)), out, size);
    });
}

ocean_result ocean_preset(const char* name, char* out, size_t* size) {
    return write_preset<ocean_sea>(name, out, size);
}

ocean_result ocean_water_types_json(char* out, size_t* size) {
    return guarded([&] { copy_text(water_types_json(), out, size); });
}
