// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The files of one frame; see bake_frame.hpp. A file is read back as soon as it is written: its
// hashes are those of what the disk holds, and a disk that lies is found out.
#include "bake_frame.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "console.hpp"
#include "ocean/error.hpp"
#include "ocean/platform.hpp"
#include "ocean/version.hpp"
#include "sha256.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

io::ExrLabel exr_label(const BakePlan& plan, const std::vector<const Product*>& fields, int frame) {
    const Lattice map{plan.resolution, plan.sea.parameters.grid.patch_size};
    return {plan.sea_text, frame, plan.sea.time_of(frame), plan.backend, map, fields, plan.layered};
}

BakeFile exr_file(const BakePlan& plan, const std::vector<const Product*>& fields, int frame) {
    BakeFile file;
    for (const Product* field : fields) {
        file.product += (file.product.empty() ? "" : ",") + std::string(field->name);
    }
    file.path = plan.pattern.file(frame, plan.product_in_name ? file.product : "");
    file.fields = fields;
    file.header = io::exr_header_bytes(exr_label(plan, fields, frame), plan.exr);
    file.recipe = sha256_hex(file.header);
    return file;
}

std::string recipe_text(const BakePlan& plan, int frame) {
    std::string text = format_text("libocean %s\nformat %s\nbackend %s\nresolution %d\nframe %d\n",
                                   OCEAN_VERSION, plan.pattern.extension().c_str(),
                                   std::string(plan.backend.name).c_str(), plan.resolution, frame);
    if (plan.view) {
        const io::View& view = *plan.view;
        text += format_text("view %.17g %.17g %.17g %.17g %.17g %.17g %.17g %d %d %.17g\n", view.x,
                            view.y, view.height, view.heading, view.field_of_view, view.nearest,
                            view.horizon, view.columns, view.rows, view.unresolved_slope_variance);
    }
    return text + plan.sea_text;
}

std::filesystem::path native(const BakeFile& file) {
    return utf8_path(file.path);
}

/// "sea_0001.df3" -> "sea_0001_far1.df3".
std::string far_path(const std::string& path, std::size_t level) {
    const std::size_t dot = path.rfind('.');
    return path.substr(0, dot) + "_far" + std::to_string(level) + path.substr(dot);
}

/// A device or a pipe has nothing to keep, and nothing to read back.
bool is_regular(const BakeFile& file) {
    std::error_code error;
    return std::filesystem::is_regular_file(native(file), error);
}

void hash_file(const BakeFile& file, ManifestEntry& entry) {
    std::ifstream stream(native(file), std::ios::binary);
    std::vector<char> block(std::size_t{1} << 20);
    Sha256 hash;
    while (stream) {
        stream.read(block.data(), static_cast<std::streamsize>(block.size()));
        const auto count = static_cast<std::size_t>(stream.gcount());
        hash.add({block.data(), count});
        entry.bytes += count;
    }
    if (!stream.eof()) throw Error(ErrorKind::bad_file, "cannot read '" + file.path + "'");
    entry.sha256 = hash.hex();
}

std::string hash_pixels(const BakeFile& file, int threads) {
    Sha256 hash;
    const io::ByteSink sink = [&hash](std::string_view bytes) { hash.add(bytes); };
    if (!file.header.empty()) {
        io::read_exr_pixels(file.path, file.header, threads, sink);
    } else {
        io::read_height_field(file.path, sink);
    }
    return hash.hex();
}

/// Throws Error bad_file if the file is damaged or none of this plan.
ManifestEntry inspect(const BakePlan& plan, const BakeFile& file, int frame, int threads) {
    ManifestEntry entry;
    entry.name = native(file).filename().string();
    entry.frame = frame;
    entry.time = plan.sea.time_of(frame);
    entry.product = file.product;
    entry.recipe = file.recipe;
    hash_file(file, entry);
    const bool height_field =
        plan.format == BakeFormat::height_field && native(file).extension() == ".png";
    if (!file.header.empty() || height_field) entry.pixels_sha256 = hash_pixels(file, threads);
    return entry;
}

}  // namespace

std::vector<BakeFile> files_of_frame(const BakePlan& plan, int frame) {
    std::vector<BakeFile> files;
    if (plan.format == BakeFormat::exr && plan.layered) {
        files.push_back(exr_file(plan, plan.products, frame));
    } else if (plan.format == BakeFormat::exr) {
        for (const Product* field : plan.products) files.push_back(exr_file(plan, {field}, frame));
    } else {
        const std::string path = plan.pattern.file(frame);
        const std::string recipe = sha256_hex(recipe_text(plan, frame));
        const auto add = [&](const std::string& file, const char* product) {
            files.push_back({file, product, {}, "", recipe, plan.resolution});
        };
        switch (plan.format) {
            case BakeFormat::mesh2:
                add(path, "mesh");
                break;
            case BakeFormat::height_field:
                add(path, "height");
                add(path + ".txt", "height");
                add(path + ".inc", "height");
                break;
            default:
                for (const int resolution : plan.resolutions()) {
                    add(files.empty() ? path : far_path(path, files.size()), "map");
                    files.back().resolution = resolution;
                }
        }
    }
    return files;
}

std::optional<ManifestEntry> find_complete(const BakePlan& plan, const BakeFile& file, int frame,
                                           const Manifest& manifest, int threads) {
    const ManifestEntry* listed = manifest.find(native(file).filename().string());
    const bool speaks_for_itself = !file.header.empty();
    if (!is_regular(file) || (listed == nullptr && !speaks_for_itself)) return std::nullopt;
    try {
        ManifestEntry entry = inspect(plan, file, frame, threads);
        if (listed != nullptr && listed->sha256 != entry.sha256) return std::nullopt;
        if (!speaks_for_itself && listed->recipe != entry.recipe) return std::nullopt;
        return entry;
    } catch (const Error&) {
        return std::nullopt;
    }
}

FrameBaker::FrameBaker(const Bake& bake, int threads)
    : bake_(bake),
      threads_(threads),
      exr_(bake.plan.exr),
      ocean_(bake.ocean, {.threads = threads,
                          .backend = bake.plan.backend,
                          .foam_progress = foam_progress_on(bake.console)}) {
    exr_.threads = threads;
}

bool FrameBaker::keep(const std::vector<BakeFile>& files, int frame) {
    std::vector<ManifestEntry> entries;
    for (const BakeFile& file : files) {
        auto entry = find_complete(bake_.plan, file, frame, bake_.manifest, threads_);
        if (!entry) return false;
        entries.push_back(std::move(*entry));
    }
    for (ManifestEntry& entry : entries) bake_.manifest.add(std::move(entry));
    return true;
}

void FrameBaker::make(const std::vector<BakeFile>& files, int frame) {
    const BakePlan& plan = bake_.plan;
    const double time = plan.sea.time_of(frame);
    const std::vector<Surface> levels = make_levels(time);
    const io::Frame labelled{levels.front(), plan.sea_text, frame, time, plan.backend};
    if (plan.format == BakeFormat::mesh2) {
        write_mesh(files.front(), labelled, levels);
    } else if (plan.format == BakeFormat::df3) {
        write_maps(files, frame, levels);
    } else {
        write_images(files, labelled);
    }
}

std::vector<Surface> FrameBaker::make_levels(double time) {
    const BakePlan& plan = bake_.plan;
    std::vector<Surface> levels;
    if (plan.format == BakeFormat::height_field) return {shown_heights(time)};
    for (const int resolution : plan.resolutions()) {
        if (levels.empty() || !plan.has_foam()) {
            levels.push_back(ocean_.evaluate(time, plan.channels, resolution));
            continue;
        }
        // Foam has a past on each map; what it looks like from far away is its mean.
        Surface level(Lattice{resolution, levels.front().period()}, time, plan.channels);
        std::vector<MapOutput> outputs = outputs_of(level);
        std::erase_if(outputs, [](const MapOutput& output) {
            return channels_of({&output, 1}).contains(Channel::foam);
        });
        ocean_.evaluate_into(time, outputs, resolution);
        io::average_foam(levels.back(), level);
        levels.push_back(std::move(level));
    }
    return levels;
}

Surface FrameBaker::shown_heights(double time) {
    const BakePlan& plan = bake_.plan;
    if (plan.sea.at(time).surface.choppiness == 0.0) {
        return ocean_.evaluate(time, plan.channels, plan.resolution);
    }
    const Lattice map{plan.resolution, plan.sea.parameters.grid.patch_size};
    Surface surface(map, time, plan.channels);
    const auto n = static_cast<std::size_t>(plan.resolution);
    const double spacing = map.period / plan.resolution;
    const QueryOptions options = plan.height_query();
    std::size_t folded = 0;
    std::vector<WorldPoint> row(n);
    std::vector<QuerySample> samples(n);
    for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t i = 0; i < n; ++i) {
            row[i] = {static_cast<double>(i) * spacing, static_cast<double>(j) * spacing};
        }
        ocean_.query(time, row, samples, options);
        for (std::size_t i = 0; i < n; ++i) {
            surface.channel(Channel::height)[j * n + i] = static_cast<float>(samples[i].height);
            folded += samples[i].folded ? 1 : 0;
        }
    }
    if (folded > 0) {
        bake_.console.warning(format_text(
            "at %g s %zu of %zu points lie where the crests have folded over: they take the top "
            "sheet",
            time, folded, n * n));
    }
    return surface;
}

void FrameBaker::write_maps(const std::vector<BakeFile>& files, int frame,
                            std::span<const Surface> levels) {
    for (std::size_t level = 0; level < files.size(); ++level) {
        const InterruptWatch::Hold whole = bake_.interrupts.hold();
        io::write_df3(levels[level], files[level].path);
        record(files[level], frame);
    }
}

void FrameBaker::write_images(const std::vector<BakeFile>& files, const io::Frame& frame) {
    if (bake_.plan.format == BakeFormat::height_field) {
        const InterruptWatch::Hold whole = bake_.interrupts.hold();
        io::write_height_field(frame, files.front().path);
        for (const BakeFile& file : files) record(file, frame.number);
        return;
    }
    for (const BakeFile& file : files) {
        const InterruptWatch::Hold whole = bake_.interrupts.hold();
        if (bake_.plan.layered) {
            io::write_exr_layered(frame, file.fields, file.path, exr_);
        } else {
            io::write_exr(frame, *file.fields.front(), file.path, exr_);
        }
        record(file, frame.number);
    }
}

void FrameBaker::write_mesh(const BakeFile& file, const io::Frame& frame,
                            std::span<const Surface> levels) {
    const auto& view = bake_.plan.view;
    const io::Mesh mesh =
        view ? io::make_horizon_mesh(levels, *view) : io::make_patch_mesh(levels.front());
    const InterruptWatch::Hold whole = bake_.interrupts.hold();
    io::write_mesh2(mesh, frame, file.path, view ? &*view : nullptr);
    record(file, frame.number);
}

void FrameBaker::record(const BakeFile& file, int frame) {
    if (!is_regular(file)) return;
    try {
        bake_.manifest.add(inspect(bake_.plan, file, frame, threads_));
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::bad_file) throw;
        throw Error(ErrorKind::output,
                    "'" + file.path + "' does not read back as it was written: " + error.what());
    }
}

}  // namespace ocean::app
