// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The plan of a bake, resolved before anything is computed: options that contradict each other, or
// that this version does not have, are refused here. A plan does not change after it is made. Frame
// numbers and the names of their files follow the grammar of --frames and -o.
//
//     BakeOptions options{.source = "storm.toml", .output = "out/sea.####.exr", .frames = "1-48"};
//     options.format_options["products"] = "displacement,normal,foam";
//     options.open_subject = [](const std::string& path) { return make_subject(read_sea(path)); };
//     const BakePlan plan = make_bake_plan(options, standard_catalogue());
//     for (int frame : plan.frames) std::puts(plan.pattern.file(frame).c_str());
//     run_bake(plan, host);  // run.hpp
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/bake/catalogue.hpp"
#include "ocean/bake/format.hpp"
#include "ocean/subject.hpp"

namespace ocean {

/// Returns the frames of INT[-INT[xINT]] in comma lists, such as "1-250x2" (or "1-250:2"), "-10--5"
/// or "1,5,9-12", in the order given, without duplicates. Throws Error invalid_value with the part
/// that is wrong.
std::vector<int> parse_frames(std::string_view text);

/// Returns "7, 9-11, 20-90x10", the frames as ranges for parse_frames, in the order given. A text
/// of more than about 200 bytes is cut off after a range, with "... LAST".
std::string frames_text(const std::vector<int>& frames);
/// Returns the largest step that reaches all frames from the first one; 1 for one frame. `frames`
/// must be ascending.
int common_step(const std::vector<int>& frames);

/// A part of a list for one machine of a render farm: one of `count` consecutive blocks whose sizes
/// differ by at most one frame.
struct Shard {
    int number = 1;  // 1 .. count
    int count = 1;

    /// Returns the shard's part of the list.
    std::vector<int> of(const std::vector<int>& frames) const;
};
/// Reads "2/5". Throws Error invalid_value.
Shard parse_shard(std::string_view text);

/// The pattern of -o, "out/sea.####.exr". A lone # is four digits, two or more are one digit each;
/// %04d and $F4 are equivalent to ####.
class OutputPattern {
  public:
    OutputPattern() = default;
    /// Throws Error invalid_value for an empty name or two frame tokens.
    explicit OutputPattern(const std::string& path);

    /// Returns the pattern with .#### before the extension, unless it has a frame token.
    OutputPattern with_token() const;
    bool has_token() const { return width_ > 0; }
    /// Returns the extension in lower case with its dot, ".exr"; "" if it has none.
    std::string extension() const;
    /// Returns the path of a frame's file; a product precedes the number: out/sea.normal.0001.exr.
    std::string file(int frame, std::string_view product = "") const;
    /// Returns the number in the place of the frame token of a file name without its folder;
    /// nothing if the name does not begin as the pattern does. The text after the number is
    /// ignored.
    std::optional<int> number_in(std::string_view name) const;
    /// Returns the start that the names of all files share, "sea"; "" for out/####.exr.
    std::string stem() const;
    /// Returns the path of the manifest, out/sea.manifest.json, or out/sea.man where that is too
    /// long; of a shard out/sea.manifest.3of20.json. Throws Error invalid_value if that is too
    /// long.
    std::string manifest(const std::optional<Shard>& shard = {}) const;
    /// Returns the shard whose manifest has a name (without its folder); nothing for other files.
    std::optional<Shard> shard_of_manifest(std::string_view name) const;
    /// Returns the folder of all files; "" for the current one.
    std::string folder() const;

  private:
    std::string folder_;  // with its final slash
    std::string before_;  // the file name before the frame token
    std::string after_;   // the file name after it, with the extension
    int width_ = 0;       // digits of the frame token; 0 = no token
};

/// The options of a bake as they were typed; "" = not given.
struct BakeOptions {
    std::string source;  // SEA
    std::string from;    // a baked file that supplies everything that is not given
    std::string output, frames, shard, backend, resolution, fps;
    std::map<std::string, std::string> format_options;  // by their names; "yes" for a flag
    bool skip_existing = false;
    bool keep_going = false;
    bool overwrite = false;  // replaces frames of another subject, which is refused without it
    int threads = 0;         // 0 = the cores this process may use
    int max_resolution = 0;  // of the default resolution [samples along a side]; 0 = no limit
    /// Opens SEA, or the subject of a baked file: resolved and valid. Throws Error.
    std::function<std::unique_ptr<Subject>(const std::string& source)> open_subject;
    /// Called while a plan computes its subject, as MapsOptions::build_progress; may be empty.
    std::function<void(std::string_view work, double share)> build_progress;

    /// Returns "" for an option that was not given.
    const std::string& format_option(const std::string& name) const;
    /// Sets an option of formats unless it was given.
    void set_default(const std::string& name, std::string_view value);
};

/// A draft is a plan that its format has not resolved yet: it has subject, format, the format's
/// settings as requested, frames and resolution.
struct BakePlan {
    std::shared_ptr<const Subject> subject;
    std::string subject_text;
    std::string subject_hash;  // of the text, as manifests have it
    std::string subject_id;    // of io::Provenance
    const BakeFormat* format = nullptr;
    ErasedSettings settings;  // the format's
    FrameMaps maps;
    OutputPattern pattern;
    std::vector<int> frames;       // of this shard
    std::vector<int> all_frames;   // of all shards
    std::optional<Shard> shard;    // nothing = all
    bool product_in_name = false;  // of each file
    Backend backend;
    std::string backend_note;  // why this backend; "" if the user named it and it needs no note
    std::string format_note;   // the format's note about its files, or ""
    std::span<const ChannelInfo> channels;  // the catalogue's, beside the library's
    int resolution = 0;                     // of the finest map
    int threads = 0;
    bool skip_existing = false;
    bool keep_going = false;
    bool overwrite = false;
    std::function<void(std::string_view work, double share)> build_progress;  // of the options

    /// Returns the settings of maps that a plan computes.
    MapsOptions maps_options() const {
        return {.threads = threads, .build_progress = build_progress};
    }
    /// Returns true if maps of earlier foam are kept from frame to frame.
    bool follows_foam() const { return ocean::has_past(foam_use(maps.channels, channels)); }
    /// Returns true if frames depend on earlier ones (foam, spray), so that they are baked in
    /// order.
    bool is_sequential() const { return follows_foam() || maps.sequential; }
    /// Returns the samples along a side of the finest map.
    int finest() const { return maps.sequential ? maps.resolutions.front() : resolution; }
    /// Returns the domain of the map that has the plan's resolution.
    Domain domain() const { return subject->domain(resolution); }
    /// Returns the shortest wave of the finest map [m].
    double shortest_wave() const { return subject->shortest_wave(finest()); }
};

/// Returns the plan of a bake, which refers to the catalogue: its rows must outlive the plan.
/// Throws Error invalid_value, unsupported, or the error of opening the subject.
BakePlan make_bake_plan(const BakeOptions& options, const Catalogue& catalogue);

}  // namespace ocean
