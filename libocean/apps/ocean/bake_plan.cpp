// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What `ocean bake` is asked to do; see bake_plan.hpp.
#include "bake_plan.hpp"

#include <algorithm>
#include <limits>

#include "bake_source.hpp"
#include "ocean/cascades.hpp"
#include "ocean/error.hpp"
#include "ocean/foam.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/sea_state.hpp"
#include "ocean/seafile.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

[[noreturn]] void refuse(const std::string& message) {
    throw Error(ErrorKind::invalid_value, message);
}

BakeFormat find_format(const OutputPattern& pattern, const std::string& output) {
    const std::string extension = pattern.extension();
    if (extension == ".exr") return BakeFormat::exr;
    if (extension == ".png") return BakeFormat::height_field;
    if (extension == ".inc") return BakeFormat::mesh2;
    if (extension == ".df3") return BakeFormat::df3;
    const std::string allowed = "allowed are .exr, .df3, .png (height_field) and .inc (mesh2)";
    for (const char* later : {".vdb", ".obj", ".ply", ".pc2"}) {
        if (extension == later) {
            throw Error(ErrorKind::unsupported,
                        "-o " + output + ": " + later + " comes with a later version; " + allowed);
        }
    }
    refuse("-o " + output + ": the extension names the format; " + allowed);
}

/// An option that the format would ignore is a misunderstanding.
void refuse_foreign(const BakeOptions& options, BakeFormat format) {
    const auto refuse_given = [](const char* name, const std::string& value, const char* home) {
        if (value.empty()) return;
        refuse(std::string(name) + " " + value + ": only files of type " + home + " know it");
    };
    if (format != BakeFormat::exr) {
        refuse_given("--products", options.products, ".exr");
        refuse_given("--type", options.type, ".exr");
        refuse_given("--axes", options.axes, ".exr");
        refuse_given("--layout", options.layout, ".exr");
        refuse_given("--compression", options.compression, ".exr");
    }
    if (format != BakeFormat::mesh2) refuse_given("--eye", options.eye, ".inc");
    if (!options.eye.empty()) return;
    const auto needs_eye = [](const char* name, const std::string& value) {
        if (!value.empty()) refuse(std::string(name) + " " + value + ": needs --eye X,Y,HEIGHT");
    };
    needs_eye("--heading", options.heading);
    needs_eye("--field-of-view", options.field_of_view);
    needs_eye("--horizon", options.horizon);
    needs_eye("--mesh-columns", options.mesh_columns);
    needs_eye("--mesh-rows", options.mesh_rows);
    needs_eye("--slope-variance", options.slope_variance);
}

std::vector<const Product*> find_products(const std::string& names) {
    const std::string list = names.empty() ? "displacement,normal,foam" : names;
    std::vector<const Product*> products;
    for (const std::string& name : split(list, ',')) {
        const Product* product = &find_product(name);
        if (std::find(products.begin(), products.end(), product) != products.end()) {
            refuse("--products " + list + ": " + name + " is there twice");
        }
        products.push_back(product);
    }
    return products;
}

template <typename Value>
Value choose(const char* option, const std::string& text,
             std::initializer_list<std::pair<const char*, Value>> choices) {
    std::string allowed;
    for (const auto& [name, value] : choices) {
        if (text == name) return value;
        allowed += (allowed.empty() ? "" : ", ") + std::string(name);
    }
    refuse(std::string(option) + " " + text + ": allowed are " + allowed);
}

io::ExrOptions exr_options(const BakeOptions& options) {
    io::ExrOptions exr;
    if (!options.axes.empty()) exr.axes = io::find_axes(options.axes);
    if (!options.compression.empty()) {
        exr.compression = io::find_exr_compression(options.compression);
    }
    if (!options.type.empty()) {
        exr.type = choose<io::PixelType>(
            "--type", options.type,
            {{"float", io::PixelType::full_float}, {"half", io::PixelType::half_float}});
    }
    return exr;
}

std::optional<io::View> find_view(const BakeOptions& options) {
    if (options.eye.empty()) return std::nullopt;
    const std::vector<std::string> eye = split(options.eye, ',');
    if (eye.size() != 3) refuse("--eye " + options.eye + ": allowed is X,Y,HEIGHT in metres");
    io::View view;
    view.x = parse_number(eye[0], "--eye X", -1e6, 1e6);
    view.y = parse_number(eye[1], "--eye Y", -1e6, 1e6);
    view.height = parse_number(eye[2], "--eye HEIGHT", 0.1, 1e5);
    const auto take = [](const std::string& text, const char* what, double lo, double hi,
                         double& value) {
        if (!text.empty()) value = parse_number(text, what, lo, hi);
    };
    take(options.heading, "--heading", -360.0, 360.0, view.heading);
    take(options.field_of_view, "--field-of-view", 1.0, 150.0, view.field_of_view);
    take(options.horizon, "--horizon", 10.0, 1e6, view.horizon);
    take(options.slope_variance, "--slope-variance", 0.0, 1.0, view.unresolved_slope_variance);
    const auto take_whole = [](const std::string& text, const char* what, int& value) {
        if (!text.empty()) value = parse_whole_number(text, what, 2, 16384);
    };
    take_whole(options.mesh_columns, "--mesh-columns", view.columns);
    take_whole(options.mesh_rows, "--mesh-rows", view.rows);
    return view;
}

int find_resolution(const std::string& text, const Grid& grid) {
    if (text.empty()) return default_map_resolution(grid);
    const int resolution = parse_whole_number(text, "--resolution", kMinResolution, kMaxResolution);
    if (!is_power_of_two(resolution)) {
        refuse(format_text("--resolution = %d: allowed is a power of two, %d .. %d", resolution,
                           kMinResolution, kMaxResolution));
    }
    return resolution;
}

ChannelSet find_channels(const BakePlan& plan) {
    if (plan.format == BakeFormat::height_field) return {Channel::height};
    const ChannelSet mesh = {Channel::dx, Channel::dy, Channel::height,
                             Channel::nx, Channel::ny, Channel::nz};
    if (plan.view) return mesh | ChannelSet{Channel::slope_x, Channel::slope_y};
    if (plan.format == BakeFormat::mesh2) return mesh;
    if (plan.format == BakeFormat::df3) return io::df3_channels();
    ChannelSet channels;
    for (const Product* product : plan.products) channels = channels | product->set();
    return channels;
}

/// Gives the names room for the frame number and the product where several files need it.
void settle_names(BakePlan& plan) {
    const bool separate = plan.format == BakeFormat::exr && !plan.layered;
    const bool several = plan.frames.size() > 1 || (separate && plan.products.size() > 1);
    if (several) plan.pattern = plan.pattern.with_token();
    plan.product_in_name = separate && plan.pattern.has_token();
}

}  // namespace

std::vector<int> BakePlan::resolutions() const {
    std::vector<int> levels = {resolution};
    while ((view || far_maps) && levels.back() > kMinResolution)
        levels.push_back(levels.back() / 2);
    return levels;
}

std::uint64_t BakePlan::modes_memory() const {
    return modes_bytes(sea.parameters.grid);
}

std::uint64_t BakePlan::frame_memory() const {
    std::uint64_t bytes = 0;
    const int maps = channels.size() + (has_foam() ? kFoamMaps : 0);
    for (const int level : resolutions()) bytes += surface_bytes(level, maps);
    if (inverts_displacement()) {
        return bytes + SurfaceQuery::map_bytes(sea.parameters.grid, height_query());
    }
    if (format != BakeFormat::mesh2) return bytes;
    // A vertex has six floats and two triangles of three numbers, and as much again as text.
    return bytes + mesh_vertices() * 2 * (6 * sizeof(float) + 6 * sizeof(int));
}

bool BakePlan::inverts_displacement() const {
    if (format != BakeFormat::height_field) return false;
    return sea.parameters.surface.choppiness != 0.0 || !sea.take.empty();
}

QueryOptions BakePlan::height_query() const {
    // Twice as fine where the library has such maps.
    return {.refine = 4 * resolution <= kMaxResolution ? 2 : 1,
            .foam = false,
            .resolution = resolution};
}

std::uint64_t BakePlan::mesh_vertices() const {
    const auto side = static_cast<std::uint64_t>(resolution) + 1;
    if (!view) return side * side;
    return static_cast<std::uint64_t>(view->columns) * static_cast<std::uint64_t>(view->rows);
}

double BakePlan::shortest_wave() const {
    const Grid& grid = sea.parameters.grid;
    // On an axis the modes end with the last cascade's.
    const Lattice finest{grid.resolution, grid.patch_size / cascade_divisors(grid).back()};
    return std::max(finest.shortest_wavelength(),
                    Lattice{resolution, grid.patch_size}.shortest_wavelength());
}

BakePlan make_bake_plan(const BakeOptions& typed) {
    const BakeOptions options = with_source(typed);
    BakePlan plan;
    plan.pattern = OutputPattern(options.output);
    plan.format = find_format(plan.pattern, options.output);
    refuse_foreign(options, plan.format);
    if (plan.format == BakeFormat::exr) plan.products = find_products(options.products);
    if (!options.layout.empty()) {
        plan.layered =
            choose<bool>("--layout", options.layout, {{"separate", false}, {"layered", true}});
    }
    plan.skip_existing = options.skip_existing;
    plan.keep_going = options.keep_going;
    plan.exr = exr_options(options);
    plan.view = find_view(options);
    plan.slope_variance_given = !options.slope_variance.empty();
    if (!options.backend.empty()) plan.backend = find_backend(options.backend);
    if (!options.frames.empty()) plan.frames = parse_frames(options.frames);

    plan.sea = open_sea(options.sea);
    if (!options.fps.empty()) set_parameter(plan.sea.parameters, "time.fps", options.fps);
    if (plan.frames.empty()) plan.frames = {plan.sea.parameters.time.first_frame};
    plan.resolution = find_resolution(options.resolution, plan.sea.parameters.grid);
    plan.channels = find_channels(plan);
    settle_names(plan);
    plan.shard = options.shard;
    if (!options.shard.empty()) plan.frames = parse_shard(options.shard).of(plan.frames);
    plan.sea_text = write_sea(plan.sea);
    return plan;
}

}  // namespace ocean::app
