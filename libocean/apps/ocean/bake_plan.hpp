// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What `ocean bake` is asked to do, settled before anything is computed: options that do not fit
// each other or this version are refused here.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frames.hpp"
#include "ocean/io.hpp"
#include "ocean/query.hpp"
#include "ocean/surface.hpp"
#include "sea_argument.hpp"

namespace CLI {
class App;
}

namespace ocean::app {

/// As typed; "" = not given.
struct BakeOptions {
    SeaArgument sea;
    std::string from;  // a baked file to take everything from that is not given
    std::string output, frames, shard, products, type, axes, layout, compression, backend,
        resolution, fps;
    bool skip_existing = false;
    bool keep_going = false;
    bool dry_run = false;
    std::string eye, heading, field_of_view, horizon, mesh_columns, mesh_rows, slope_variance;
};

enum class BakeFormat { exr, height_field, mesh2, df3 };

struct FileCount {
    int files = 0, kept = 0;
    std::uint64_t bytes = 0;  // of those that are not kept, at most
};

struct BakePlan {
    Sea sea;
    std::string sea_text;
    BakeFormat format = BakeFormat::exr;
    OutputPattern pattern;
    std::vector<int> frames;               // of this shard
    std::string shard;                     // as typed; "" = all
    std::vector<const Product*> products;  // of an EXR
    bool skip_existing = false;
    bool keep_going = false;
    bool layered = false;
    bool product_in_name = false;
    io::ExrOptions exr;
    std::optional<io::View> view;  // a mesh to the horizon instead of one period
    bool slope_variance_given = false;
    bool far_maps = false;  // coarser maps beside that of each frame, a DF3 file each
    FileCount beside;       // of the folder's other files, which somebody else writes
    Backend backend = Backend::cpu;
    int resolution = 0;  // of the finest map
    ChannelSet channels;

    /// The maps of one frame: one, or for a view and with far maps R, R/2, ... 32 samples.
    std::vector<int> resolutions() const;
    /// Bytes for what all frames share.
    std::uint64_t modes_memory() const;
    /// A choppy height field is asked for at places of the world, with `height_query`.
    bool inverts_displacement() const;
    QueryOptions height_query() const;
    /// Bytes for one frame: its maps, what inverts them, and a mesh.
    std::uint64_t frame_memory() const;
    std::uint64_t mesh_vertices() const;
    /// Foam has a past: frames are made one after another.
    bool has_foam() const { return channels.contains(Channel::foam); }
    /// The shortest wave of the finest map, along an axis.
    double shortest_wave() const;
};

void add_bake_options(CLI::App& command, BakeOptions& options);

/// Throws Error invalid_value, unsupported, or what opening the sea throws.
BakePlan make_bake_plan(const BakeOptions& options);

}  // namespace ocean::app
