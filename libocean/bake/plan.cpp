// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See plan.hpp.
#include "ocean/bake/plan.hpp"

#include <algorithm>
#include <iterator>

#include "formats/formats.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/csv_rows.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/io/subject_words.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/land_mask.hpp"
#include "ocean/version.hpp"
#include "refuse.hpp"
#include "sha256.hpp"
#include "source.hpp"

namespace ocean {
namespace {

/// Returns "24000/1001", film's rate on television, as a decimal number.
std::string decimal_rate(const std::string& text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos) return text;
    const auto part = [&](const std::string& digits) {
        return parse_number(trimmed(digits), "--fps " + text, 1e-9, 1e9);
    };
    return shortest_text(part(text.substr(0, slash)) / part(text.substr(slash + 1)));
}

[[noreturn]] void refuse_absent(const std::string& typed, const FormatLibrary& one,
                                const std::string& allowed) {
    const std::string library(one.library);
    throw Error(ErrorKind::unsupported,
                typed + ": this program was built without " + library +
                    "; the build of `cmake --preset release` has it where " + library +
                    " is installed" + allowed);
}

/// Returns ".exr, .df3 and .png (height_field)", with the name of a format if it differs from the
/// extension.
std::string extensions_of(std::span<const BakeFormat* const> formats) {
    std::vector<std::string> words;
    for (const BakeFormat* format : formats) {
        const bool says_its_name = format->extension.substr(1) == format->name;
        words.push_back(std::string(format->extension) +
                        (says_its_name ? "" : " (" + std::string(format->name) + ")"));
    }
    return listing(words, "and");
}

/// Returns the formats that can hold the subject; all formats if the subject cannot be opened.
std::vector<const BakeFormat*> formats_of_subject(const BakeOptions& options,
                                                  const Catalogue& catalogue) {
    std::vector<const BakeFormat*> formats(catalogue.formats.begin(), catalogue.formats.end());
    try {
        if (is_displaced(*options.open_subject(options.source))) {
            std::erase_if(formats, [](const BakeFormat* one) { return !one->holds_displaced; });
        }
    } catch (const Error&) {
        // An extension that is wrong for any subject is reported first.
    }
    return formats;
}

[[noreturn]] void refuse_extension(const BakeOptions& options, const Catalogue& catalogue,
                                   const std::string& extension) {
    const std::string& output = options.output;
    const auto formats = formats_of_subject(options, catalogue);
    const std::string allowed = "allowed are " + extensions_of(formats);
    for (const FormatLibrary& one : catalogue.libraries) {
        if (extension == one.extension) refuse_absent("-o " + output, one, "; " + allowed);
    }
    std::vector<KnownName> names;
    for (const BakeFormat* format : formats) {
        names.push_back({format->extension.substr(1), format->extension});
    }
    const std::string typed = extension.substr(std::min<std::size_t>(extension.size(), 1));
    refuse("-o " + output + ": the extension names the format" + did_you_mean(typed, names) + "; " +
           allowed);
}

std::vector<FormatOption> options_of(const BakeFormat& format, const Catalogue& catalogue) {
    return format.options(catalogue);
}

/// Returns the extensions of the formats that have an option, ".ply, .obj and .usda".
std::string homes_of(const std::string& option, const Catalogue& catalogue) {
    std::vector<std::string> homes;
    for (const BakeFormat* format : catalogue.formats) {
        const std::vector<FormatOption> known = options_of(*format, catalogue);
        const bool has_it =
            std::ranges::any_of(known, [&](const FormatOption& one) { return one.name == option; });
        if (has_it) homes.emplace_back(format->extension);
    }
    return listing(homes, "and");
}

/// Refuses options that only other formats have, options whose companion is missing, and options of
/// a format that this program lacks.
void refuse_foreign_options(const BakeOptions& options, const BakeFormat& format,
                            const Catalogue& catalogue) {
    const std::vector<FormatOption> known = options_of(format, catalogue);
    const auto knows = [&](const std::string& name) {
        return std::any_of(known.begin(), known.end(),
                           [&](const FormatOption& option) { return option.name == name; });
    };
    for (const BakeFormat* home : catalogue.formats) {
        for (const FormatOption& option : options_of(*home, catalogue)) {
            const std::string& text = options.format_option(option.name);
            if (text.empty()) continue;
            const std::string typed =
                "--" + option.name + (option.value.empty() ? "" : " " + text) + ": ";
            if (options.format_option(option.needs.substr(0, option.needs.find(' '))).empty() &&
                !option.needs.empty()) {
                refuse(typed + "needs --" + option.needs);
            }
            if (!knows(option.name)) {
                refuse(typed + "only files of type " + homes_of(option.name, catalogue) +
                       " have it");
            }
        }
    }
    for (const FormatLibrary& one : catalogue.libraries) {
        if (!catalogue.lacks(one)) continue;
        for (const std::string name : one.options) {
            const std::string& text = options.format_option(name);
            if (!text.empty()) refuse_absent("--" + name + " " + text, one, "");
        }
    }
}

[[noreturn]] void refuse_foreign_subject(const std::string& option, std::string_view owner,
                                         const Subject& subject) {
    throw Error(ErrorKind::unsupported, option + ": only " + io::subject_words(owner).noun +
                                            " has it, and this is " +
                                            io::subject_words(subject.kind()).noun);
}

/// Refuses a displaced subject for files that hold heights of places only.
void refuse_displaced(const BakePlan& draft) {
    if (draft.format->holds_displaced || !is_displaced(*draft.subject)) return;
    throw Error(ErrorKind::unsupported,
                "files of type " + std::string(draft.format->extension) +
                    " hold heights of places, and the points of " +
                    io::subject_words(draft.subject->kind()).noun +
                    " are displaced; its heights by place are a height field, .png");
}

/// Refuses options and products that only another kind of subject has.
void refuse_foreign_subject(const BakeOptions& options, const Catalogue& catalogue,
                            const BakePlan& draft) {
    const auto is_foreign = [&](std::string_view owner) {
        return !owner.empty() && owner != draft.subject->kind();
    };
    for (const FormatOption& option : options_of(*draft.format, catalogue)) {
        if (!is_foreign(option.subject) || options.format_option(option.name).empty()) continue;
        refuse_foreign_subject("--" + option.name, option.subject, *draft.subject);
    }
    for (const Product* product : draft.format->products(draft)) {
        if (!is_foreign(product->subject)) continue;
        refuse_foreign_subject("--products " + std::string(product->name), product->subject,
                               *draft.subject);
    }
}

/// Refuses maps of channels that the subject does not have. Hosts' channels are computed from the
/// library's channels.
void require_channels(const BakePlan& plan) {
    const ChannelSet available = plan.subject->channels();
    for (int c = 0; c < kChannelCount; ++c) {
        const auto channel = static_cast<Channel>(c);
        if (!plan.maps.channels.contains(channel) || available.contains(channel)) continue;
        throw Error(ErrorKind::unsupported, "a " + std::string(plan.subject->kind()) + " has no " +
                                                std::string(channel_info(channel).name));
    }
    for (const Product& mask : kMaskProducts) {
        const ChannelSet set = mask.set();
        if (!plan.maps.channels.intersects(set) || available.contains(set)) continue;
        throw Error(ErrorKind::unsupported, "this " + std::string(plan.subject->kind()) +
                                                " has no mask " + std::string(mask.name) +
                                                ": its file has no section that makes it");
    }
}

const Backend& backend_by_name(const Catalogue& catalogue, const std::string& name) {
    for (const Backend& backend : catalogue.backends) {
        if (backend.name == name) return backend;
    }
    if (name == "gl" || name == "thesis") find_backend(name);  // throws the reason
    std::vector<std::string_view> names = {kAutoBackend};
    for (const Backend& backend : catalogue.backends) names.push_back(backend.name);
    refuse("unknown backend '" + name + "'" + did_you_mean(name, names) +
           "; known: " + catalogue.backend_names());
}

/// Sets the first backend that is faster than cpu, else cpu. Queries each backend once, because
/// that may create a GPU context.
void choose_fast_backend(const Catalogue& catalogue, int resolution, BakePlan& plan) {
    plan.backend = Backend::cpu;
    plan.backend_note = "backend cpu";
    for (const Backend& backend : catalogue.backends) {
        const auto made = plan.subject->backend_resolution(backend, resolution);
        if (!backend.may_be_fast || !made) continue;
        const BackendFitness fitness = backend.fitness(*made);
        const std::string name(backend.name);
        if (fitness.runs && fitness.fast) {
            plan.backend = backend;
            plan.backend_note = "backend " + name + ": " + fitness.reason;
            return;
        }
        plan.backend_note += ", not " + name + ": " + fitness.reason;
    }
}

/// Sets the backend for the largest of the plan's maps. Throws Error no_gpu for a backend that does
/// not run on this machine.
void resolve_backend(const Catalogue& catalogue, const std::string& name, BakePlan& plan) {
    const int resolution = std::max(plan.maps.finer, std::ranges::max(plan.maps.resolutions));
    if (name == kAutoBackend) return choose_fast_backend(catalogue, resolution, plan);
    plan.backend = backend_by_name(catalogue, name.empty() ? "cpu" : name);
    const auto made = plan.subject->backend_resolution(plan.backend, resolution);
    if (!made) {
        throw Error(ErrorKind::unsupported,
                    "--backend " + name +
                        ": land with gullies, streams, a shore or a place of its own is made on "
                        "the CPU alone, and a sea over a bed by cpu and gl");
    }
    if (plan.backend.fitness == nullptr) return;
    const BackendFitness fitness = plan.backend.fitness(*made);
    if (!fitness.runs) throw Error(ErrorKind::no_gpu, "--backend " + name + ": " + fitness.reason);
    plan.backend_note = "backend " + name + ": " + fitness.reason;
}

int find_resolution(const BakeOptions& options, const Subject& subject) {
    const std::string& text = options.resolution;
    if (text.empty()) {
        const int shown = subject.default_resolution();
        return options.max_resolution > 0 ? std::min(shown, options.max_resolution) : shown;
    }
    const int resolution = parse_whole_number(text, "--resolution", kMinResolution, kMaxResolution);
    if (!is_resolution(resolution)) {
        refuse(format_text("--resolution = %d: allowed is a power of two, %d .. %d", resolution,
                           kMinResolution, kMaxResolution));
    }
    return resolution;
}

/// Adds the frame number and the product to the names of files if there are several.
void resolve_names(const FormatPlan<ErasedSettings>& files, BakePlan& plan) {
    const bool several = plan.frames.size() > 1 || files.named_products.size() > 1;
    if (several) plan.pattern = plan.pattern.with_token();
    plan.product_in_name = !files.named_products.empty() && plan.pattern.has_token();
}

}  // namespace

const std::string& BakeOptions::format_option(const std::string& name) const {
    static const std::string not_given;
    const auto found = format_options.find(name);
    return found == format_options.end() ? not_given : found->second;
}

void BakeOptions::set_default(const std::string& name, std::string_view value) {
    std::string& option = format_options[name];
    if (option.empty()) option = value;
}

io::Provenance provenance_of(const BakePlan& plan, int frame) {
    return {.kind = std::string(plan.subject->kind()),
            .text = plan.subject_text,
            .id = plan.subject_id,
            .frame = frame,
            .time = plan.subject->timeline().time_of(frame),
            .domain = plan.domain(),
            .backend = std::string(plan.backend.name)};
}

io::Provenance FrameWork::provenance() const {
    return provenance_of(plan, frame);
}

double FrameWork::time() const {
    return plan.subject->timeline().time_of(frame);
}

std::vector<int> halving_resolutions(int resolution) {
    std::vector<int> levels = {resolution};
    while (levels.back() > kMinResolution) levels.push_back(levels.back() / 2);
    return levels;
}

namespace {

/// Returns the domain of a plan as text: a terrain may be repeated, and a sea over a bed may be
/// shown in part. An open sea has no such lines: its text implies its domain, and older recipes had
/// none.
std::string domain_lines(const BakePlan& plan) {
    const Domain domain = plan.domain();
    if (plan.subject->kind() == kSeaKind && domain.is_tile()) return "";
    std::string text = "domain";
    for (const double value :
         {domain.origin[0], domain.origin[1], domain.size[0], domain.size[1]}) {
        text += " " + shortest_text(value);
    }
    return text + "\n";
}

}  // namespace

std::string bake_recipe(const BakePlan& plan, int frame, std::string_view format_lines) {
    std::string text = format_text("libocean %s\nformat %s\nbackend %s\nresolution %d\nframe %d\n",
                                   OCEAN_VERSION, plan.pattern.extension().c_str(),
                                   std::string(plan.backend.name).c_str(), plan.resolution, frame);
    text += format_lines;
    return sha256_hex(text + domain_lines(plan) + plan.subject_text);
}

BakePlan make_bake_plan(const BakeOptions& typed, const Catalogue& catalogue) {
    BakePlan plan;
    plan.pattern = OutputPattern(typed.output);
    plan.format = catalogue.find_format(plan.pattern.extension());
    const BakeOptions options = with_source(typed, catalogue, plan.format);
    if (plan.format == nullptr) {
        refuse_extension(options, catalogue, plan.pattern.extension());
    }
    refuse_foreign_options(options, *plan.format, catalogue);
    plan.settings = plan.format->read_options(options, catalogue);
    plan.skip_existing = options.skip_existing;
    plan.keep_going = options.keep_going;
    plan.overwrite = options.overwrite;
    plan.threads = options.threads;
    plan.build_progress = options.build_progress;
    plan.channels = catalogue.channels;
    // A wrong name is refused before the sea is read.
    if (!options.backend.empty() && options.backend != kAutoBackend) {
        backend_by_name(catalogue, options.backend);
    }
    if (!options.frames.empty()) plan.frames = parse_frames(options.frames);

    std::unique_ptr<Subject> subject = options.open_subject(options.source);
    if (!options.fps.empty()) subject->set("time.fps", decimal_rate(options.fps));
    plan.subject = std::move(subject);
    if (plan.frames.empty()) plan.frames = {plan.subject->timeline().first_frame};
    plan.all_frames = plan.frames;
    plan.resolution = find_resolution(options, *plan.subject);
    refuse_displaced(plan);
    refuse_foreign_subject(options, catalogue, plan);
    FormatPlan<ErasedSettings> resolved = plan.format->resolve(plan);
    resolve_names(resolved, plan);
    plan.maps = std::move(resolved.maps);
    require_channels(plan);
    plan.settings = std::move(resolved.settings);
    plan.format_note = std::move(resolved.note);
    resolve_backend(catalogue, options.backend, plan);
    if (!options.shard.empty()) {
        plan.shard = parse_shard(options.shard);
        plan.frames = plan.shard->of(plan.frames);
        plan.pattern.manifest(plan.shard);  // refuses a name that is too long
    }
    plan.subject_text = plan.subject->text();
    plan.subject_hash = short_hash(plan.subject_text);
    plan.subject_id =
        short_hash(plan.subject_text + domain_lines(plan) + std::to_string(plan.resolution));
    return plan;
}

}  // namespace ocean
