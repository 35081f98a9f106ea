// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The functions of libocean.h that open, describe and change a sea, and those that need none: each
// one a call into core or seafile, with its arguments checked and its result copied out.
#include "sea_handle.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>

#include "guard.hpp"
#include "handle.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/json.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/sea_bed.hpp"
#include "ocean/sea_state.hpp"
#include "ocean/seafile.hpp"
#include "ocean/text.hpp"
#include "ocean/version.hpp"
#include "ocean/water_types.hpp"

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

std::string preset_names_json() {
    JsonArray names;
    for (const Preset& preset : presets()) names.add(preset.name);
    return names.text();
}

/// Another sea from now on: whole, or, where `edit` throws, not at all.
void change_sea(ocean_sea& sea, const std::function<void(Sea&)>& edit) {
    Sea changed = sea.ocean->sea();
    edit(changed);
    sea.ocean->change(std::move(changed));
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

std::string ocean::capi::lasting_folder(const std::string& folder) {
    std::error_code code;
    const std::filesystem::path current = std::filesystem::current_path(code);
    return text::to_utf8(code ? utf8_path(folder) : current / utf8_path(folder));
}

std::string ocean::capi::folder_of(const char* path) {
    return lasting_folder(text::to_utf8(utf8_path(path).parent_path()));
}

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
    return guarded([&] {
        require(path, "path");
        require(out, "out");
        const OceanOptions opened_with = read_options(options);
        *out = std::make_unique<ocean_sea>(read_sea(path), opened_with, folder_of(path)).release();
    });
}

ocean_result ocean_parse(const char* toml, size_t length, const char* base_dir,
                         const ocean_options* options, ocean_sea** out) {
    return guarded([&] {
        require(toml, "toml");
        require(out, "out");
        const OceanOptions opened_with = read_options(options);
        const std::string folder = base_dir != nullptr ? base_dir : "";
        Sea sea = parse_sea({toml, length}, "text", folder);
        *out = std::make_unique<ocean_sea>(std::move(sea), opened_with, lasting_folder(folder))
                   .release();
    });
}

ocean_result ocean_clone(const ocean_sea* sea, const ocean_options* options, ocean_sea** out) {
    return guarded([&] {
        const Visit visit(sea);
        require(out, "out");
        const OceanOptions opened_with = options != nullptr ? read_options(options) : sea->options;
        *out = std::make_unique<ocean_sea>(*sea, opened_with).release();
    });
}

void ocean_free(ocean_sea* sea) {
    if (sea == nullptr) return;
    const PlainFloats plain;
    if (!enter_to_free(*sea)) return;
    delete sea;
}

ocean_result ocean_set(ocean_sea* sea, const char* name, const char* value) {
    return guarded([&] {
        const Visit visit(sea);
        require(name, "name");
        require(value, "value");
        change_sea(*sea, [&](Sea& changed) {
            set_parameter(changed.parameters, name, value);
            resolve_files(changed, sea->base_dir);
        });
    });
}

ocean_result ocean_set_all(ocean_sea* sea, const char* const* names, const char* const* values,
                           size_t count) {
    return guarded([&] {
        const Visit visit(sea);
        if (count > 0) {
            require(names, "names");
            require(values, "values");
        }
        change_sea(*sea, [&](Sea& changed) {
            for (std::size_t i = 0; i < count; ++i) {
                require(names[i], ("names[" + std::to_string(i) + "]").c_str());
                require(values[i], ("values[" + std::to_string(i) + "]").c_str());
                set_parameter(changed.parameters, names[i], values[i]);
            }
            resolve_files(changed, sea->base_dir);
            validate(changed);
        });
    });
}

ocean_result ocean_add_waves(ocean_sea* sea, const char* name) {
    return guarded([&] {
        const Visit visit(sea);
        require(name, "name");
        change_sea(*sea, [&](Sea& changed) { add_wave_system(changed, name); });
    });
}

ocean_result ocean_remove_waves(ocean_sea* sea, const char* name) {
    return guarded([&] {
        const Visit visit(sea);
        require(name, "name");
        change_sea(*sea, [&](Sea& changed) { remove_wave_system(changed, name); });
    });
}

ocean_result ocean_set_bed(ocean_sea* sea, const float* heights, int32_t nx, int32_t ny, double x0,
                           double y0, double cell) {
    return guarded([&] {
        const Visit visit(sea);
        if (heights == nullptr && nx == 0 && ny == 0) {
            return change_sea(*sea, [](Sea& changed) { remove_bed(changed.parameters.water); });
        }
        require(heights, "heights");
        require_finite(x0, "x0", "metres");
        require_finite(y0, "y0", "metres");
        require_finite(cell, "cell", "metres");
        change_sea(*sea, [&](Sea& changed) {
            give_bed(changed, read_bed(heights, nx, ny, cell), x0, y0);
        });
    });
}

ocean_result ocean_perform(ocean_sea* sea, double time, const char* name, const char* value) {
    return guarded([&] {
        const Visit visit(sea);
        require(name, "name");
        require(value, "value");
        sea->ocean->perform(time, name, value);
    });
}

ocean_result ocean_get(const ocean_sea* sea, const char* name, char* out, size_t size) {
    return guarded([&] {
        const Visit visit(sea);
        require(name, "name");
        require(out, "out");
        copy_text(get_parameter(sea->ocean->parameters(), name), out, &size);
    });
}

ocean_result ocean_text(const ocean_sea* sea, char* out, size_t* size) {
    return guarded([&] {
        const Visit visit(sea);
        copy_text(write_sea(sea->ocean->sea()), out, size);
    });
}

ocean_result ocean_parameters_json(char* out, size_t* size) {
    return guarded([&] { copy_text(parameters_json(), out, size); });
}

ocean_result ocean_state_json(const ocean_sea* sea, char* out, size_t* size) {
    return guarded([&] {
        const Visit visit(sea);
        require(size, "size");
        copy_text(sea_state_json(sea->ocean->state()), out, size);
    });
}

ocean_result ocean_records_json(const char* file, char* out, size_t* size) {
    return guarded([&] {
        require(file, "file");
        copy_text(records_json(read_spectra(file)), out, size);
    });
}

ocean_result ocean_preset(const char* name, char* out, size_t* size) {
    return guarded([&] {
        copy_text(name != nullptr ? find_preset(name).toml : preset_names_json(), out, size);
    });
}

ocean_result ocean_water_types_json(char* out, size_t* size) {
    return guarded([&] { copy_text(water_types_json(), out, size); });
}
