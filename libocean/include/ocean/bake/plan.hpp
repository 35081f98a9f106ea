// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What a bake is asked to do, settled before anything is computed: options that do not fit each
// other or this version are refused here. A plan does not change after it is made.
#pragma once

#include <any>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "ocean/bake/catalogue.hpp"
#include "ocean/bake/format.hpp"
#include "ocean/bake/frames.hpp"
#include "ocean/subject.hpp"

namespace ocean {

/// As typed; "" = not given.
struct BakeOptions {
    std::string source;  // SEA
    std::string from;    // a baked file to take everything from that is not given
    std::string output, frames, shard, backend, resolution, fps;
    std::map<std::string, std::string> of_format;  // by the option's name; "yes" for a flag
    bool skip_existing = false;
    bool keep_going = false;
    int threads = 0;      // 0 = the cores this process may use
    int largest_map = 0;  // samples a side, where --resolution does not say; 0 = no limit
    /// Opens SEA, or the subject of a baked file: resolved and valid. Throws Error.
    std::function<std::unique_ptr<Subject>(const std::string& source)> open_subject;

    /// "" for an option that was not given.
    const std::string& format_option(const std::string& name) const;
    /// Gives it a value if it has none.
    void take(const std::string& name, std::string_view value);
};

struct BakePlan {
    std::shared_ptr<const Subject> subject;
    std::string subject_text;
    std::string subject_id;  // of io::Provenance
    const BakeFormat* format = nullptr;
    std::any settings;  // the format's
    FrameMaps maps;
    OutputPattern pattern;
    std::vector<int> frames;       // of this shard
    std::vector<int> all_frames;   // of all shards
    std::string shard;             // as typed; "" = all
    bool product_in_name = false;  // of each file
    Backend backend;
    std::string backend_note;  // why that one; "" where the user said so and nothing is to be told
    std::span<const ChannelInfo> channels;  // of the catalogue, beside the library's
    int resolution = 0;                     // of the finest map
    int threads = 0;
    bool skip_existing = false;
    bool keep_going = false;

    /// Maps of earlier foam are kept.
    bool follows_foam() const { return ocean::has_past(foam_use(maps.channels, channels)); }
    /// Foam and spray have one: frames are made one after another.
    bool has_past() const { return follows_foam() || maps.has_past; }
    /// Of the finest map, samples along a side.
    int finest() const { return maps.has_past ? maps.resolutions.front() : resolution; }
    /// Returns where the map of the plan's resolution lies.
    Domain domain() const { return subject->domain(resolution); }
    /// Returns the shortest wave of the finest map [m].
    double shortest_wave() const { return subject->shortest_wave(finest()); }
};

/// Of this shard, those that frames share first.
std::vector<BakeFile> all_files(const BakePlan& plan);
/// All files of a bake, the manifest too.
std::vector<std::string> output_paths(const BakePlan& plan);

/// Throws Error invalid_value, unsupported, or what opening the sea throws. What the catalogue
/// refers to must outlive the plan.
BakePlan make_bake_plan(const BakeOptions& options, const Catalogue& catalogue);

}  // namespace ocean
