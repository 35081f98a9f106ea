// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What a bake will take; see bake_estimate.hpp.
#include "bake_estimate.hpp"

#include <algorithm>
#include <filesystem>

#include "bake_frame.hpp"
#include "console.hpp"
#include "ocean/platform.hpp"
#include "ocean/sea_state.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

/// No codec makes a file larger: a block that it would blow up is stored as it is.
std::uint64_t most_exr_bytes(const BakePlan& plan, const BakeFile& file) {
    constexpr std::uint64_t kPerBlock = 16;  // its place in the table, its row and its size
    const auto n = static_cast<std::uint64_t>(plan.resolution);
    std::uint64_t sample = 0;
    for (const io::ExrChannel& channel : io::exr_channels(file.fields, plan.layered, plan.exr.type))
        sample += channel.type == io::PixelType::half_float ? 2 : 4;
    return file.header.size() + n * kPerBlock + n * n * sample;
}

std::uint64_t most_text_bytes(const BakePlan& plan) {
    // The longest numbers: "-1.2345678e-05", "-.1234", "2147483647", and what stands around three.
    constexpr std::uint64_t kFloat = 14, kUnit = 6, kIndex = 10, kAround = 5, kHead = 4096;
    const std::uint64_t foam = plan.has_foam() ? kUnit + 2 + kAround : 0;  // "<.1234,0>"
    return kHead + plan.mesh_vertices() *
                       (3 * kFloat + 3 * kUnit + 2 * 3 * kIndex + (1 + 1 + 2) * kAround + foam);
}

std::uint64_t most_bytes(const BakePlan& plan, const BakeFile& file) {
    constexpr std::uint64_t kSmallFile = 4096;
    if (plan.format == BakeFormat::df3) return io::df3_bytes(file.resolution);
    if (plan.format == BakeFormat::exr) return most_exr_bytes(plan, file);
    if (plan.format == BakeFormat::mesh2) return most_text_bytes(plan);
    if (utf8_path(file.path).extension() == ".txt") return kSmallFile;
    const auto side = static_cast<std::uint64_t>(plan.resolution) + 1;
    return side * (2 * side + 16) + kSmallFile;
}

/// Of the file system that the folder is on, or will be.
std::uint64_t free_bytes(const std::string& folder) {
    std::error_code error;
    std::filesystem::path place = std::filesystem::absolute(utf8_path(folder), error);
    while (!std::filesystem::exists(place, error) && place.has_relative_path()) {
        place = place.parent_path();
    }
    return std::filesystem::space(place, error).available;
}

}  // namespace

std::uint64_t memory_bytes(const BakePlan& plan, int workers) {
    const auto each = static_cast<std::uint64_t>(workers);
    // With a take each worker is at a time of its own, and the sea at another.
    const std::uint64_t seas = plan.sea.take.empty() ? 1 : 1 + each;
    return seas * plan.modes_memory() + each * plan.frame_memory();
}

Crew choose_crew(const BakePlan& plan, int threads) {
    require_memory(memory_bytes(plan, 1),
                   format_text("a bake of %d x %d samples", plan.resolution, plan.resolution));
    const int all = threads > 0 ? threads : available_cores();
    const int frames = static_cast<int>(plan.frames.size());
    Crew crew;
    crew.workers = plan.has_foam() ? 1 : std::clamp(frames, 1, all);
    // Half of what is there: the disk's cache and the neighbours want some too.
    while (crew.workers > 1 && memory_bytes(plan, crew.workers) > available_memory() / 2) {
        --crew.workers;
    }
    crew.threads = all / crew.workers;
    return crew;
}

void show_plan(const BakePlan& plan, const Crew& crew, Console& console) {
    const Manifest manifest(plan.pattern.manifest());
    FileCount all = plan.beside;
    for (const int frame : plan.frames) {
        const std::vector<BakeFile> files = files_of_frame(plan, frame);
        const bool keep =
            plan.skip_existing && std::all_of(files.begin(), files.end(), [&](auto& file) {
                return find_complete(plan, file, frame, manifest, crew.threads).has_value();
            });
        for (const BakeFile& file : files) {
            console.data(file.path + (keep ? "\tkept\n" : "\n"));
            if (!keep) all.bytes += most_bytes(plan, file);
            ++all.files;
            all.kept += keep ? 1 : 0;
        }
    }
    const std::uint64_t room = free_bytes(plan.pattern.folder());
    const std::uint64_t memory = memory_bytes(plan, crew.workers);
    console.report(
        "plan",
        format_text("%d files, %d of them kept, the others at most ", all.files, all.kept) +
            bytes_text(all.bytes) + "; " + bytes_text(room) + " are free; " + bytes_text(memory) +
            " of memory",
        format_text("\"files\": %d, \"kept\": %d, \"bytes\": %llu, \"free_bytes\": %llu, "
                    "\"memory_bytes\": %llu",
                    all.files, all.kept, static_cast<unsigned long long>(all.bytes),
                    static_cast<unsigned long long>(room),
                    static_cast<unsigned long long>(memory)));
    if (all.bytes > room) {
        console.warning("the files may need " + bytes_text(all.bytes) + ", " + bytes_text(room) +
                        " are free: they may not fit");
    }
}

}  // namespace ocean::app
