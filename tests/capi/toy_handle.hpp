// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The C interface of toy_handle.cpp.
#pragma once

#include "libocean.h"

extern "C" {
typedef struct toy_plane toy_plane;

const char* toy_last_error(void);
const char* toy_last_error_field(int32_t field);
ocean_result toy_open(const char* path, const ocean_options* options, toy_plane** out);
ocean_result toy_parse(const char* toml, size_t length, const char* base_dir,
                       const ocean_options* options, toy_plane** out);
ocean_result toy_clone(const toy_plane* plane, const ocean_options* options, toy_plane** out);
void toy_free(toy_plane* plane);
ocean_result toy_set(toy_plane* plane, const char* name, const char* value);
ocean_result toy_set_all(toy_plane* plane, const char* const* names, const char* const* values,
                         size_t count);
ocean_result toy_get(const toy_plane* plane, const char* name, char* out, size_t size);
ocean_result toy_text(const toy_plane* plane, char* out, size_t* size);
ocean_result toy_state_json(const toy_plane* plane, char* out, size_t* size);
ocean_result toy_parameters_json(char* out, size_t* size);
ocean_result toy_preset(const char* name, char* out, size_t* size);
ocean_result toy_query_points(toy_plane* plane, const ocean_query_request* request);
}
