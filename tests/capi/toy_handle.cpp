// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A subject of a few lines behind a C handle, a plane with a slope: a table, a Family and the
// templates that seas and terrains have.
#include "toy_handle.hpp"

#include <array>

#include "handle_functions.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/seafile.hpp"
#include "query_buffers.hpp"
#include "table_reader.hpp"
#include "table_writer.hpp"

namespace ocean::test {

struct NoOptions {};

/// height = slope x + base
struct Plane {
    double slope = 0.5;
    double base = 0.0;
};

constexpr TableSection kSections[] = {{"plane"}};
constexpr TableRow<Plane> kRows[] = {
    {kSections[0], "slope", "", "Slope", "Rise per metre.", member<&Plane::slope>(), -9.0, 9.0,
     -1.0, 1.0, ParameterClass::live, StagesOf<Plane>::type::all},
    {kSections[0], "base", "m", "Base", "Height at x = 0.", member<&Plane::base>(), -100.0, 100.0,
     -10.0, 10.0, ParameterClass::live, StagesOf<Plane>::type::all},
};
constexpr Table<Plane> kTable{"plane", kSections, kRows};
const std::array<Preset, 1> kPresets = {{{"level", "", "libocean = 1\n[plane]\nslope = 0\n"}}};

static void set_parameter(Plane& plane, std::string_view name, std::string_view text) {
    const RefOf<Plane> ref = find_parameter(kTable, name);
    assign(plane, ref, parse_value(*ref.info, ref.item, text));
}
static std::string get_parameter(const Plane& plane, std::string_view name) {
    return to_text(value_of(plane, find_parameter(kTable, name)));
}
static void resolve_files(Plane&, const std::string&) {}
static void validate(const Plane& plane) {
    if (plane.slope * plane.base <= 0.0) return;
    throw Error(ErrorKind::invalid_value, "plane.base rises with the slope");
}

static Plane parse_plane(std::string_view toml, const std::string& name, const std::string&) {
    const toml::table root = parse_toml(toml, name);
    return TableReader<Plane>(kTable, name).read(root);
}

}  // namespace ocean::test

using namespace ocean;
using namespace ocean::capi;

struct toy_plane : Handle {
    static constexpr const char* kName = "plane";
    toy_plane(test::Plane given, test::NoOptions opened_with, std::string folder)
        : options(std::move(opened_with)), base_dir(std::move(folder)), plane(given) {}
    toy_plane(const toy_plane& built, test::NoOptions opened_with)
        : toy_plane(built.plane, std::move(opened_with), built.base_dir) {}

    test::NoOptions options;
    std::string base_dir;
    test::Plane plane;
};

template <>
struct ocean::capi::Family<toy_plane> {
    static constexpr auto parse = test::parse_plane;
    static test::NoOptions read_options(const ocean_options*) { return {}; }
    static test::Plane read(const char* path) {
        return parse(text::read_file(path, kMaxSeaFileBytes), path, "");
    }
    static const test::Plane& model(const toy_plane& handle) { return handle.plane; }
    static auto& parameters(auto& plane) { return plane; }
    static void replace(toy_plane& handle, test::Plane plane) {
        validate(plane);
        handle.plane = plane;
    }
    static std::string text(const test::Plane& plane) { return table_text(test::kTable, plane); }
    static std::string state(const toy_plane& handle) {
        JsonObject json;
        json.add("slope", handle.plane.slope);
        return json.text();
    }
    static const auto& presets() { return test::kPresets; }
    static const Preset& find_preset(std::string_view) { return test::kPresets[0]; }
};

const char* toy_last_error(void) {
    return last_error();
}
const char* toy_last_error_field(int32_t field) {
    return last_error_field(field);
}
ocean_result toy_open(const char* path, const ocean_options* options, toy_plane** out) {
    return open_handle(path, options, out);
}
ocean_result toy_parse(const char* toml, size_t length, const char* base_dir,
                       const ocean_options* options, toy_plane** out) {
    return parse_handle(toml, length, base_dir, options, out);
}
ocean_result toy_clone(const toy_plane* plane, const ocean_options* options, toy_plane** out) {
    return clone_handle(plane, options, out);
}
void toy_free(toy_plane* plane) {
    free_handle(plane);
}
ocean_result toy_set(toy_plane* plane, const char* name, const char* value) {
    return set_value(plane, name, value);
}
ocean_result toy_set_all(toy_plane* plane, const char* const* names, const char* const* values,
                         size_t count) {
    return set_values(plane, names, values, count);
}
ocean_result toy_get(const toy_plane* plane, const char* name, char* out, size_t size) {
    return get_value(plane, name, out, size);
}
ocean_result toy_text(const toy_plane* plane, char* out, size_t* size) {
    return write_text(plane, out, size);
}
ocean_result toy_state_json(const toy_plane* plane, char* out, size_t* size) {
    return write_state(plane, out, size);
}
ocean_result toy_parameters_json(char* out, size_t* size) {
    return guarded([&] { copy_text(parameters_json(listed(test::kTable)), out, size); });
}
ocean_result toy_preset(const char* name, char* out, size_t* size) {
    return write_preset<toy_plane>(name, out, size);
}
ocean_result toy_query_points(toy_plane* plane, const ocean_query_request* request) {
    return in_handle(plane, [&] {
        const auto answer = [&](std::span<const WorldPoint> points, std::span<QuerySample> answers,
                                const QueryOptions&) {
            for (std::size_t i = 0; i < points.size(); ++i) {
                answers[i].height = plane->plane.slope * points[i].x + plane->plane.base;
            }
        };
        answer_points(read_struct(request, sizeof(*request), "ocean_query_request"), false, answer,
                      [](const QueryOptions&) { return 0.0; });
    });
}
