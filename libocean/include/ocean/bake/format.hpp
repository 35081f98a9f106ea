// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A format of baked files: all that the rest of a bake knows of it. One constant of this type in
// one file of bake/formats/, and one line of the table in catalogue.cpp, make a new format.
#pragma once

#include <any>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ocean/io/image.hpp"
#include "ocean/io/provenance.hpp"
#include "ocean/surface.hpp"

namespace ocean {

class BakedHeader;
class SubjectMaps;
struct BakeOptions;
struct BakePlan;
struct Catalogue;

/// An option that formats have for themselves, --NAME on the command line.
struct FormatOption {
    std::string name;   // "axes"
    std::string value;  // what stands for its value in a help text, "AXES"; empty: it is a flag
    std::string help;
    std::string needs = "";  // another option and its value, "eye X,Y,HEIGHT": refused without it
    std::string_view subject = {};  // the one kind of subject that has it; empty: any may
};

/// The maps that a frame is made of.
struct FrameMaps {
    ChannelSet channels;
    std::vector<int> resolutions;  // the finest first
    bool by_place = false;         // the height alone, a function of the place instead of the label
    int finer = 0;                 // one more map of so many samples, after the others; 0 = none
    ChannelSet finer_channels = {};
    bool has_past = false;  // what is made of no map follows one, frame after frame
};

/// What a format makes of its options and of the sea.
struct FormatPlan {
    FrameMaps maps;
    std::any settings;  // the format's own, for its other functions
    /// Of files that a product in their names tells apart: those products.
    std::vector<std::string> named_products = {};
};

struct BakeFile {
    std::string path;
    int frame = 0;
    std::size_t part = 0;  // its number among the files of the frame
    std::string product;   // what it holds, several in comma lists
};

/// A frame whose maps are there, on its way to its files.
struct FrameWork {
    const BakePlan& plan;
    int frame;
    std::span<const Surface> maps;  // as FrameMaps says
    SubjectMaps& source;            // of the maps, for what is no map
    int threads;
    /// Has `write` make a file, undisturbed by an interrupt; reads it back for the manifest.
    std::function<void(const BakeFile& file, const std::function<void()>& write)> put;
    /// Of what the frame lacks.
    std::function<void(const std::string& message)> warn;

    io::Provenance provenance() const;
    double time() const;
};
/// What the files of a frame say of it.
io::Provenance provenance_of(const BakePlan& plan, int frame);

/// A pointer to a function that every format has: one without it does not compile.
template <typename Function>
class Required;
template <typename Result, typename... Arguments>
class Required<Result(Arguments...)> {
  public:
    constexpr Required(Result (*function)(Arguments...)) : function_(function) {}
    constexpr Required(std::nullptr_t) = delete;
    Result operator()(Arguments... arguments) const {
        return function_(std::forward<Arguments>(arguments)...);
    }

  private:
    Result (*function_)(Arguments...);
};

/// Functions get plans whose format they are. Those that are not Required are null where a format
/// has no such thing.
struct BakeFormat {
    std::string_view name;                  // "height_field"
    std::string_view extension;             // in lower case with its dot, ".png"
    std::string_view frame_extension = {};  // of a frame's own file, where it is another
    std::string_view family;                // heading of its options in a help text, "EXR files"

    std::vector<FormatOption> (*options)(const Catalogue& catalogue) = nullptr;
    /// The settings that the options ask for, before there is a sea. Throws Error.
    std::any (*read_options)(const BakeOptions& options, const Catalogue& catalogue) = nullptr;
    /// The products that the settings of a plan ask for: the plan refuses those that its subject
    /// does not have. Of formats with a choice of products.
    std::vector<const Product*> (*products)(const BakePlan& begun) = nullptr;
    /// For a plan with subject, resolution and settings. Throws Error.
    Required<FormatPlan(const BakePlan& begun)> settle;
    /// In the order in which they are written. Cheap: a bake asks for all its frames at its start.
    Required<std::vector<BakeFile>(const BakePlan& plan, int frame)> files;
    /// Beside the frames what all of them share: the same bytes from each shard. With write_shared.
    std::vector<BakeFile> (*shared_files)(const BakePlan& plan) = nullptr;
    void (*write_shared)(const BakePlan& plan, const BakeFile& file) = nullptr;
    /// How many of the shared files, the first ones, list the frames of the folder: their plan's
    /// all_frames has those of earlier chunks too, and they are written again after the frames.
    std::size_t frame_lists = 0;
    /// Whether a frame's file that is there is of the plan's sea and options, whatever its frame.
    /// Of formats with frame_lists.
    bool (*is_of_plan)(const BakePlan& plan, const BakeFile& file) = nullptr;
    /// Whether a reader of the frames fills one that is missing without a word. With frame_lists.
    bool hides_gaps = false;
    /// SHA-256 of all that decides the content of a file.
    Required<std::string(const BakePlan& plan, const BakeFile& file)> recipe;
    /// Whether a file that is there may be one that a bake wrote, of any sea: others are the
    /// user's, and stay. By its beginning, so that it costs little.
    Required<bool(const BakeFile& file)> is_baked;
    /// Memory that a frame needs beside its maps, at most.
    std::uint64_t (*frame_bytes)(const BakePlan& plan) = nullptr;
    /// Of a file, at most.
    Required<std::uint64_t(const BakePlan& plan, const BakeFile& file)> most_bytes;
    Required<void(const FrameWork& work, std::span<const BakeFile> files)> write;
    /// The decoded samples of a file, whatever its compression; false for a file that is no image.
    /// Throws Error bad_file for a file that is damaged or another.
    bool (*read_pixels)(const BakePlan& plan, const BakeFile& file, int threads,
                        const io::ByteSink& sink) = nullptr;
    /// read_pixels tells by itself whether a file is the plan's; others need a manifest.
    bool tells_its_recipe = false;
    /// What a baked file says of itself. Throws Error bad_file.
    std::vector<io::HeaderString> (*read_header)(const std::string& path) = nullptr;
    /// --from: takes what was not typed from the header of a baked file.
    void (*adopt)(const BakedHeader& header, const Catalogue& catalogue,
                  BakeOptions& options) = nullptr;
};

/// SHA-256 of what decides the content of a file without a header: version, format, backend,
/// resolution, frame, the format's own lines and the sea.
std::string bake_recipe(const BakePlan& plan, int frame, std::string_view format_lines = "");

}  // namespace ocean
