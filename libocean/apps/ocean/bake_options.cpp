// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The options of `ocean bake` as the command line has them; what they mean is settled in
// bake_plan.cpp.
#include <span>

#include "bake_plan.hpp"

namespace ocean::app {

std::vector<OptionGroup> bake_options(BakeOptions& options) {
    // SEA or --from, which is checked when both are known.
    std::vector<OptionGroup> groups = {
        sea_options(options.sea, kOptional),
        {"Sea",
         {{"--from", &options.from, "FRAME.exr",
           "A baked file in place of SEA: the sea, and all options below that are not given"},
          {"--fps", &options.fps, "RATE", "Frames per second, in place of the sea's time.fps"}}},
        {"Output",
         {{"-o,--output", &options.output, "FILE",
           "out/sea.####.exr; .exr, .df3, .png (height_field) or .inc (mesh2)", kRequired},
          {"--frames", &options.frames, "RANGES",
           "FIRST-LAST[xSTEP] in comma lists, such as 1-250x2; default: the sea's first frame"},
          {"--shard", &options.shard, "I/N", "Only the I-th of N parts of the frames, such as 2/5"},
          {"--skip-existing", &options.skip_existing, "",
           "Keep complete files of the same sea and options, which takes reading them"},
          {"--keep-going", &options.keep_going, "", "Go on with the other frames when one fails"},
          {"-n,--dry-run", &options.dry_run, "",
           "Print the files and how much room they need; write nothing"},
          {"--resolution", &options.resolution, "R",
           "Samples along a side, a power of two; default: the sea's grid"},
          {"--backend", &options.backend, "NAME", "cpu, radix2 or dft; default cpu"}}},
        {"EXR files",
         {{"--products", &options.products, "LIST",
           "Of height, displacement, slope, normal, jacobian, velocity; default "
           "displacement,normal"},
          {"--type", &options.type, "TYPE",
           "float or half; default: float for displacement and velocity, half for the rest"},
          {"--axes", &options.axes, "AXES",
           "Order of vectors: tnb (x, z, y), zup (x, y, z), yup (x, z, -y); default tnb"},
          {"--layout", &options.layout, "LAYOUT",
           "separate (a file for each product) or layered (one file); default separate"},
          {"--compression", &options.compression, "CODEC",
           "none, rle, zips, zip, piz or pxr24; default zip"}}},
        {"Mesh files",
         {{"--eye", &options.eye, "X,Y,HEIGHT",
           "A mesh from this camera to the horizon, in metres; default: one period of the sea"},
          {"--heading", &options.heading, "DEG",
           "Where the camera looks, counter-clockwise from +x; default 0"},
          {"--field-of-view", &options.field_of_view, "DEG", "Horizontal; default 60"},
          {"--horizon", &options.horizon, "M",
           "Distance of the farthest vertex; default: where the Earth hides the highest crest"},
          {"--mesh-columns", &options.mesh_columns, "N", "Vertices across; default 720"},
          {"--mesh-rows", &options.mesh_rows, "N", "Vertices away; default 1800"},
          {"--slope-variance", &options.slope_variance, "V",
           "Mean square slope of the waves that are too short for the map; default: what the "
           "spectrum has of them"}}},
    };
    for (OptionGroup& group : std::span(groups).subspan(1)) {
        for (Option& option : group.options) {
            if (std::holds_alternative<std::string*>(option.target)) option.rule = NotEmpty{};
        }
    }
    return groups;
}

}  // namespace ocean::app
