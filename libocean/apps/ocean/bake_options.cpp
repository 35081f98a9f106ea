// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The options of `ocean bake` as the command line has them; what they mean is settled in
// bake_plan.cpp.
#include <CLI/CLI.hpp>

#include "bake_plan.hpp"

namespace ocean::app {

void add_bake_options(CLI::App& command, BakeOptions& options) {
    const auto add = [&](const char* name, std::string& value, const char* type, const char* group,
                         const char* help) {
        const auto not_empty = [](const std::string& text) {
            return text.empty() ? "an empty value is not allowed" : std::string();
        };
        return command.add_option(name, value, help)
            ->type_name(type)
            ->check(not_empty)
            ->group(group);
    };
    const auto flag = [&](const char* name, bool& value, const char* group, const char* help) {
        command.add_flag(name, value, help)->group(group);
    };
    add_sea_argument(command, options.sea);
    // Or --from, which is checked when both are known.
    command.get_option("SEA")->required(false);
    add("--from", options.from, "FRAME.exr", "Sea",
        "A baked file in place of SEA: the sea, and all options below that are not given");
    add("--fps", options.fps, "RATE", "Sea", "Frames per second, in place of the sea's time.fps");
    add("-o,--output", options.output, "FILE", "Output",
        "out/sea.####.exr; .exr, .df3, .png (height_field) or .inc (mesh2)")
        ->required();
    add("--frames", options.frames, "RANGES", "Output",
        "FIRST-LAST[xSTEP] in comma lists, such as 1-250x2; default: the sea's first frame");
    add("--shard", options.shard, "I/N", "Output",
        "Only the I-th of N parts of the frames, such as 2/5");
    flag("--skip-existing", options.skip_existing, "Output",
         "Keep complete files of the same sea and options, which takes reading them");
    flag("--keep-going", options.keep_going, "Output",
         "Go on with the other frames when one fails");
    flag("-n,--dry-run", options.dry_run, "Output",
         "Print the files and how much room they need; write nothing");
    add("--resolution", options.resolution, "R", "Output",
        "Samples along a side, a power of two; default: the sea's grid");
    add("--backend", options.backend, "NAME", "Output", "cpu, radix2 or dft; default cpu");
    const char* exr = "EXR files";
    add("--products", options.products, "LIST", exr,
        "Of height, displacement, slope, normal, jacobian, velocity; default displacement,normal");
    add("--type", options.type, "TYPE", exr,
        "float or half; default: float for displacement and velocity, half for the rest");
    add("--axes", options.axes, "AXES", exr,
        "Order of vectors: tnb (x, z, y), zup (x, y, z), yup (x, z, -y); default tnb");
    add("--layout", options.layout, "LAYOUT", exr,
        "separate (a file for each product) or layered (one file); default separate");
    add("--compression", options.compression, "CODEC", exr,
        "none, rle, zips, zip, piz or pxr24; default zip");
    const char* mesh = "Mesh files";
    add("--eye", options.eye, "X,Y,HEIGHT", mesh,
        "A mesh from this camera to the horizon, in metres; default: one period of the sea");
    add("--heading", options.heading, "DEG", mesh,
        "Where the camera looks, counter-clockwise from +x; default 0");
    add("--field-of-view", options.field_of_view, "DEG", mesh, "Horizontal; default 60");
    add("--horizon", options.horizon, "M", mesh,
        "Distance of the farthest vertex; default: where the Earth hides the highest crest");
    add("--mesh-columns", options.mesh_columns, "N", mesh, "Vertices across; default 720");
    add("--mesh-rows", options.mesh_rows, "N", mesh, "Vertices away; default 1800");
    add("--slope-variance", options.slope_variance, "V", mesh,
        "Mean square slope of the waves that are too short for the map; default: what the "
        "spectrum has of them");
}

}  // namespace ocean::app
