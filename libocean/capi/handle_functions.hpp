// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The functions that libocean.h has for a sea and for a terrain alike, each once, as a template
// over the handle. A function of libocean.h calls the template; Family<Opened> holds the
// differences.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "guard.hpp"
#include "handle.hpp"
#include "libocean.h"
#include "ocean/internal/json.hpp"
#include "ocean/internal/platform.hpp"

namespace ocean::capi {

/// The calls by which one kind of handle differs from another. A specialisation has
///     read_options(ocean_options*)   the options of its constructor; throws CallError
///     read(path)                     the model in a file
///     parse(toml, name, folder)      the model in a text of that name in messages, whose relative
///                                    files start from the folder
///     model(handle)                  the model of a handle
///     parameters(model)              where set_parameter() and get_parameter() find its parameters
///     replace(handle, model)         gives the handle another model
///     text(model), state(handle)     its resolved file, and its state as JSON
///     presets(), find_preset(name)   the presets of the family
template <typename Opened>
struct Family;

/// Gives the handle the model that `edit` makes of its present one. Where `edit` throws, nothing
/// changes.
template <typename Opened, typename Edit>
void change(Opened& handle, const Edit& edit) {
    auto changed = Family<Opened>::model(handle);
    edit(changed);
    Family<Opened>::replace(handle, std::move(changed));
}

template <typename Opened>
ocean_result open_handle(const char* path, const ocean_options* options, Opened** out) {
    return guarded([&] {
        require(path, "path");
        require(out, "out");
        auto opened_with = Family<Opened>::read_options(options);
        *out = std::make_unique<Opened>(Family<Opened>::read(path), std::move(opened_with),
                                        folder_of(path))
                   .release();
    });
}

template <typename Opened>
ocean_result parse_handle(const char* toml, std::size_t length, const char* base_dir,
                          const ocean_options* options, Opened** out) {
    return guarded([&] {
        require(toml, "toml");
        require(out, "out");
        auto opened_with = Family<Opened>::read_options(options);
        const std::string folder = base_dir != nullptr ? base_dir : "";
        *out = std::make_unique<Opened>(Family<Opened>::parse({toml, length}, "text", folder),
                                        std::move(opened_with), lasting_folder(folder))
                   .release();
    });
}

template <typename Opened>
ocean_result clone_handle(const Opened* handle, const ocean_options* options, Opened** out) {
    return in_handle(handle, [&] {
        require(out, "out");
        auto opened_with =
            options != nullptr ? Family<Opened>::read_options(options) : handle->options;
        *out = std::make_unique<Opened>(*handle, std::move(opened_with)).release();
    });
}

template <typename Opened>
void free_handle(Opened* handle) {
    if (handle == nullptr) return;
    const PlainFloats plain;
    if (enter_to_free(*handle)) delete handle;
}

template <typename Opened>
ocean_result set_value(Opened* handle, const char* name, const char* value) {
    return in_handle(handle, [&] {
        require(name, "name");
        require(value, "value");
        change(*handle, [&](auto& changed) {
            set_parameter(Family<Opened>::parameters(changed), name, value);
            resolve_files(changed, handle->base_dir);
        });
    });
}

template <typename Opened>
ocean_result set_values(Opened* handle, const char* const* names, const char* const* values,
                        std::size_t count) {
    return in_handle(handle, [&] {
        change(*handle, [&](auto& changed) {
            for_each_value(names, values, count, [&](const char* name, const char* value) {
                set_parameter(Family<Opened>::parameters(changed), name, value);
            });
            resolve_files(changed, handle->base_dir);
            validate(changed);
        });
    });
}

template <typename Opened>
ocean_result get_value(const Opened* handle, const char* name, char* out, std::size_t size) {
    return in_handle(handle, [&] {
        require(name, "name");
        require(out, "out");
        const auto& model = Family<Opened>::model(*handle);
        copy_text(get_parameter(Family<Opened>::parameters(model), name), out, &size);
    });
}

template <typename Opened>
ocean_result write_text(const Opened* handle, char* out, std::size_t* size) {
    return in_handle(handle, [&] {
        copy_text(Family<Opened>::text(Family<Opened>::model(*handle)), out, size);
    });
}

template <typename Opened>
ocean_result write_state(const Opened* handle, char* out, std::size_t* size) {
    return in_handle(handle, [&] {
        require(size, "size");
        copy_text(Family<Opened>::state(*handle), out, size);
    });
}

/// Writes the file of a preset, or for NULL the names of all presets of the family.
template <typename Opened>
ocean_result write_preset(const char* name, char* out, std::size_t* size) {
    return guarded([&] {
        if (name != nullptr) return copy_text(Family<Opened>::find_preset(name).toml, out, size);
        JsonArray names;
        for (const auto& preset : Family<Opened>::presets()) names.add(preset.name);
        copy_text(names.text(), out, size);
    });
}

}  // namespace ocean::capi
