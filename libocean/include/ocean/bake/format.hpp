// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A format of baked files, as the rest of a bake sees it: a row of functions without the type of
// the format's settings. Formats are written as a BakeFormatOf (typed_format.hpp), which makes the
// row. A new format is one such constant in one file of bake/formats/, and one line of the table in
// catalogue.cpp.
//
//     for (const BakeFormat* format : standard_catalogue().formats) {
//         std::printf("%s: %s\n", format->extension.data(), format->summary.data());
//     }
//     const BakeFormat* exr = standard_catalogue().find_format(".exr");
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <typeinfo>
#include <utility>
#include <vector>

#include "ocean/channel.hpp"
#include "ocean/io/image.hpp"
#include "ocean/provenance.hpp"
#include "ocean/surface.hpp"

namespace ocean {

class BakedHeader;
class SubjectMaps;
struct BakeOptions;
struct BakePlan;
struct Catalogue;

/// The settings of a format or of a family of made products, as plans and tables hold them: without
/// their type. An immutable value that copies share; a default-constructed one holds nothing.
class ErasedSettings {
  public:
    ErasedSettings() = default;

    template <typename Settings>
    static ErasedSettings of(Settings settings) {
        ErasedSettings erased;
        erased.value_ = std::make_shared<const Settings>(std::move(settings));
        erased.type_ = &typeid(Settings);
        return erased;
    }

    /// Returns the value; it lives as long as this object. Throws std::logic_error unless it was
    /// stored as exactly this type: a format was called with the settings of another one.
    template <typename Settings>
    const Settings& as() const {
        if (*type_ != typeid(Settings)) {
            throw std::logic_error(std::string("settings of type ") + type_->name() +
                                   " were passed to functions for settings of type " +
                                   typeid(Settings).name());
        }
        return *static_cast<const Settings*>(value_.get());
    }

  private:
    std::shared_ptr<const void> value_;
    const std::type_info* type_ = &typeid(void);
};

/// An option of one or several formats, --NAME on the command line.
struct FormatOption {
    std::string name;   // "axes"
    std::string value;  // placeholder of its value in help texts, "AXES"; empty for a flag
    std::string help;
    std::string needs = "";  // another option and its value, "eye X,Y,HEIGHT": required beside it
    std::string_view subject = {};  // the only kind of subject that has the option; empty: any kind
};

/// The products that files of a format can hold, for the one parser of --products.
struct ProductChoice {
    std::span<const Product> known;              // the rows in which names are looked up
    std::string_view default_list;               // used if --products is not given
    const Product* alone = nullptr;              // points: excludes others, not in `known`
    std::string_view nothing = {};               // the word for no product: "position"
    std::string_view holder = {};                // the holder of `allowed` in messages: "a mesh"
    std::string_view allowed = {};               // names among `known`, "normal,foam"; empty: all
    std::span<const Product> also_allowed = {};  // further allowed rows of `known`
    std::string_view one_refusal = {};           // message for any bad list; empty: one per cause
};

/// The maps that a frame of a format is made of.
struct FrameMaps {
    ChannelSet channels;
    std::vector<int> resolutions;  // the finest first
    bool eulerian = false;         // heights only, as a function of the place instead of the label
    int finer = 0;  // samples along a side of one more map, after the others; 0 = none
    ChannelSet finer_channels = {};
    bool sequential = false;  // frames depend on earlier ones, so they are baked in order
};

/// A format's part of a plan, resolved from its options and the subject.
template <typename Settings>
struct FormatPlan {
    FrameMaps maps;
    Settings settings;
    /// Products that get a file each; their names go into the file name.
    std::vector<std::string> named_products = {};
    std::string note = {};  // a sentence about the files, for people
};

struct BakeFile {
    std::string path;
    int frame = 0;
    std::size_t part = 0;  // index among the files of the frame
    std::string product;   // its products, separated by commas
};

/// A frame whose maps have been computed, for the format to write.
struct FrameWork {
    const BakePlan& plan;
    int frame;
    std::span<const Surface> maps;  // the maps of FrameMaps, in its order
    SubjectMaps& source;            // makes them; for data that is not a map
    int threads;
    /// Runs `write` with interrupts deferred, then reads the file back, verifies it and enters its
    /// hashes into the manifest.
    std::function<void(const BakeFile& file, const std::function<void()>& write)> write_and_verify;
    /// Warns of something that the frame lacks.
    std::function<void(const std::string& message)> warn;

    io::Provenance provenance() const;
    double time() const;  // [s]
};
/// Returns the provenance that the files of a frame carry.
io::Provenance provenance_of(const BakePlan& plan, int frame);

/// A pointer to a function that every format has: a format without it does not compile.
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

/// The row of a format in a Catalogue, made by bake_format(). typed_format.hpp documents the
/// members. Functions get plans of this format; they throw std::logic_error for a plan with the
/// settings of another format.
struct BakeFormat {
    std::string_view name;
    std::string_view extension;
    std::string_view frame_extension;
    std::string_view label;
    std::string_view family;
    std::string_view summary;
    std::string_view example;
    bool holds_displaced;
    std::uint64_t library_bytes;

    Required<std::vector<FormatOption>(const Catalogue& catalogue)> options;
    Required<std::optional<ProductChoice>(const Catalogue& catalogue)> product_choice;
    Required<ErasedSettings(const BakeOptions& options, const Catalogue& catalogue)> read_options;
    Required<std::vector<const Product*>(const BakePlan& draft)> products;
    Required<FormatPlan<ErasedSettings>(const BakePlan& draft)> resolve;
    Required<std::vector<BakeFile>(const BakePlan& plan, int frame)> files;
    bool has_shared_files;
    Required<std::vector<BakeFile>(const BakePlan& plan)> shared_files;
    Required<void(const BakePlan& plan, const BakeFile& file)> write_shared;
    std::size_t frame_lists;
    Required<bool(const BakePlan& plan, const BakeFile& file)> matches_plan;
    bool interpolates_missing_frames;
    Required<std::string(const BakePlan& plan, const BakeFile& file)> recipe;
    Required<bool(const BakeFile& file)> is_baked;
    Required<std::uint64_t(const BakePlan& plan)> frame_bytes;
    Required<std::uint64_t(const BakePlan& plan, const BakeFile& file)> max_bytes;
    Required<void(const FrameWork& work, std::span<const BakeFile> files)> write;
    Required<bool(const BakePlan& plan, const BakeFile& file, int threads,
                  const io::ByteSink& sink)>
        read_pixels;
    bool header_proves_recipe;
    /// Null for a format whose files have no header.
    std::vector<io::HeaderString> (*read_header)(const std::string& path);
    Required<void(const BakedHeader& header, const Catalogue& catalogue, BakeOptions& options)>
        adopt;
};

/// Returns the SHA-256 of everything that decides the content of a file without a header: version,
/// format, backend, resolution, frame, `format_lines` and the subject.
std::string bake_recipe(const BakePlan& plan, int frame, std::string_view format_lines = "");

}  // namespace ocean
