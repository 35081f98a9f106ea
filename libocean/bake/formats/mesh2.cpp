// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// POV-Ray meshes as text: one period of the sea or, with --eye, the water that a camera sees up to
// the horizon.
#include <algorithm>
#include <optional>

#include "formats/formats.hpp"
#include "ocean/bake/typed_format.hpp"
#include "ocean/internal/cascades.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/io/mesh2.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/ocean.hpp"
#include "ocean/seafile.hpp"
#include "refuse.hpp"

namespace ocean {
namespace {

struct Mesh2Settings {
    std::optional<io::View> view;     // a mesh to the horizon instead of one period
    bool has_slope_variance = false;  // --slope-variance was given
    bool cover = false;               // cover as u of each vertex
};

std::vector<FormatOption> list_options(const Catalogue&) {
    constexpr const char* kEye = "eye X,Y,HEIGHT";
    return {
        {"eye", "X,Y,HEIGHT",
         "A mesh from this camera to the horizon, in metres; default: one period", "", kSeaKind},
        {"heading", "DEG", "Direction of the camera, counter-clockwise from +x; default 0", kEye,
         kSeaKind},
        {"field-of-view", "DEG", "Horizontal angle of view; default 60", kEye, kSeaKind},
        {"horizon", "M",
         "Distance of the farthest vertex; default: the distance at which the Earth hides the "
         "highest crest",
         kEye, kSeaKind},
        {"mesh-columns", "N", "Vertices from left to right; default 720", kEye, kSeaKind},
        {"mesh-rows", "N", "Vertices from near to far; default 1800", kEye, kSeaKind},
        {"slope-variance", "V",
         "Mean square slope of the waves that are too short for the map; default: from the "
         "spectrum",
         kEye, kSeaKind},
        {"mesh-foam", "",
         "Write the share of the water that foam hides as the u of each vertex; not with --eye", "",
         kSeaKind},
    };
}

std::optional<io::View> read_view(const BakeOptions& options) {
    const std::string& typed = options.format_option("eye");
    if (typed.empty()) return std::nullopt;
    const std::vector<std::string> eye = split(typed, ',');
    if (eye.size() != 3) {
        refuse("--eye " + typed + ": allowed is X,Y,HEIGHT in metres");
    }
    io::View view;
    view.x = parse_number(eye[0], "--eye X", -1e6, 1e6);
    view.y = parse_number(eye[1], "--eye Y", -1e6, 1e6);
    view.height = parse_number(eye[2], "--eye HEIGHT", 0.1, 1e5);
    const auto set_number = [&](const std::string& name, double lo, double hi, double& value) {
        const std::string& text = options.format_option(name);
        if (!text.empty()) value = parse_number(text, "--" + name, lo, hi);
    };
    set_number("heading", -360.0, 360.0, view.heading);
    set_number("field-of-view", 1.0, 150.0, view.field_of_view);
    set_number("horizon", 10.0, 1e6, view.horizon);
    set_number("slope-variance", 0.0, 1.0, view.unresolved_slope_variance);
    const auto set_whole_number = [&](const std::string& name, int& value) {
        const std::string& text = options.format_option(name);
        if (!text.empty()) value = parse_whole_number(text, "--" + name, 2, 16384);
    };
    set_whole_number("mesh-columns", view.columns);
    set_whole_number("mesh-rows", view.rows);
    return view;
}

Mesh2Settings read_options(const BakeOptions& options, const Catalogue&) {
    Mesh2Settings settings{read_view(options), !options.format_option("slope-variance").empty(),
                           !options.format_option("mesh-foam").empty()};
    if (settings.view && settings.cover) {
        refuse("--mesh-foam: a mesh to the horizon has no foam");
    }
    return settings;
}

/// Returns the mean square slope of the waves of the sea that are too short for the map.
double unresolved_slope_variance(const BakePlan& plan) {
    const auto slope_of = [&](const Parameters& parameters) {
        return Ocean(parameters, {.threads = plan.threads}).state().mean_square_slope;
    };
    const Parameters& shown = sea_of(*plan.subject).parameters;
    Parameters held = shown;
    if (held.grid.cascades == 1) {
        held.grid.resolution = std::min(plan.resolution, held.grid.resolution);
    } else {
        held.surface.shortest_wavelength =
            std::max(held.surface.shortest_wavelength, plan.shortest_wave());
    }
    return std::max(0.0, slope_of(shown).asked - slope_of(held).resolved);
}

FormatPlan<Mesh2Settings> resolve(const BakePlan& draft, const Mesh2Settings& requested) {
    using enum Channel;
    Mesh2Settings settings = requested;
    FrameMaps maps{{height, nx, ny, nz}, {draft.resolution}};
    if (is_displaced(*draft.subject)) maps.channels = maps.channels | ChannelSet{dx, dy};
    if (settings.cover) maps.channels = maps.channels | ChannelSet{cover};
    if (settings.view) {
        maps.channels = maps.channels | ChannelSet{slope_x, slope_y};
        maps.resolutions = halving_resolutions(draft.resolution);
        // Waves too short for the map scatter light too.
        if (!settings.has_slope_variance) {
            settings.view->unresolved_slope_variance = unresolved_slope_variance(draft);
        }
    }
    return {maps, settings};
}

std::vector<BakeFile> list_files(const BakePlan& plan, const Mesh2Settings&, int frame) {
    return {{plan.pattern.file(frame), frame, 0, "mesh"}};
}

std::string recipe(const BakePlan& plan, const Mesh2Settings& settings, const BakeFile& file) {
    std::string lines;
    if (const auto& view = settings.view) {
        lines =
            format_text("view %.17g %.17g %.17g %.17g %.17g %.17g %.17g %d %d %.17g\n", view->x,
                        view->y, view->height, view->heading, view->field_of_view, view->nearest,
                        view->horizon, view->columns, view->rows, view->unresolved_slope_variance);
    }
    return bake_recipe(plan, file.frame, lines);
}

std::uint64_t vertices(const BakePlan& plan, const Mesh2Settings& settings) {
    const auto& view = settings.view;
    if (view) {
        return static_cast<std::uint64_t>(view->columns) * static_cast<std::uint64_t>(view->rows);
    }
    const auto [columns, rows] = io::patch_vertices(plan.domain());
    return static_cast<std::uint64_t>(columns) * static_cast<std::uint64_t>(rows);
}

std::uint64_t frame_bytes(const BakePlan& plan, const Mesh2Settings& settings) {
    // A vertex has six floats, two of uv and one of cover, and two triangles of three numbers.
    return vertices(plan, settings) * (9 * sizeof(float) + 6 * sizeof(int));
}

std::uint64_t max_bytes(const BakePlan& plan, const Mesh2Settings& settings, const BakeFile&) {
    // The longest numbers are "-1.2345678e-05", "-.1234" and "2147483647"; kAround is the
    // punctuation of three numbers.
    constexpr std::uint64_t kFloat = 14, kUnit = 6, kIndex = 10, kAround = 5, kHead = 4096;
    const std::uint64_t cover = settings.cover ? kUnit + 2 + kAround : 0;  // "<.1234,0>"
    return kHead + vertices(plan, settings) *
                       (3 * kFloat + 3 * kUnit + 2 * 3 * kIndex + (1 + 1 + 2) * kAround + cover);
}

bool is_baked(const BakeFile& file) {
    const std::string head = text::first_bytes(file.path, 1000);
    const std::size_t subject = head.find("//   Desc: The surface of ");
    return subject != std::string::npos && head.find(", by libocean", subject) != std::string::npos;
}

void write(const FrameWork& work, const Mesh2Settings& settings, std::span<const BakeFile> files) {
    const auto& view = settings.view;
    const io::Mesh mesh =
        view ? io::make_horizon_mesh(work.maps, *view) : io::make_patch_mesh(work.maps.front());
    work.write_and_verify(files.front(), [&] {
        io::write_mesh2(mesh, work.provenance(), files.front().path,
                        {.view = view ? &*view : nullptr, .u = "cover"});
    });
}

constexpr BakeFormatOf<Mesh2Settings> kOf = {
    .name = "mesh2",
    .extension = ".inc",
    .label = "POV-Ray mesh",
    .family = "Mesh files",
    .summary = "POV-Ray meshes: a period, or to the horizon",
    .example = "--eye 0,0,8 --heading 90",
    .options = list_options,
    .read_options = read_options,
    .resolve = resolve,
    .files = list_files,
    .recipe = recipe,
    .is_baked = is_baked,
    .frame_bytes = frame_bytes,
    .max_bytes = max_bytes,
    .write = write,
};

}  // namespace

const BakeFormat kMesh2Format = bake_format<kOf>();

}  // namespace ocean
