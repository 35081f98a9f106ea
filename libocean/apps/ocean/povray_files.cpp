// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See povray_files.hpp.
#include "povray_files.hpp"

#include <filesystem>
#include <system_error>

#include "console_host.hpp"
#include "interrupt.hpp"
#include "ocean/bake/catalogue.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::app {
namespace {

bool is_kept(const FolderFile& file, const std::string& path) {
    std::error_code error;
    return file.is_users && std::filesystem::exists(utf8_path(path), error);
}

}  // namespace

std::string povray_extension(const std::string& format) {
    for (const BakeFormat* known : standard_catalogue().formats) {
        if (known->name == format) return std::string(known->extension);
    }
    throw Error(ErrorKind::invalid_value, "--format " + format + " is unknown");
}

void refuse_large_mesh(int resolution) {
    if (resolution <= kMaxPovrayResolution) return;
    throw Error(ErrorKind::invalid_value,
                format_text("--resolution = %d: allowed is at most %d, for which POV-Ray makes "
                            "a mesh of 2 GiB",
                            resolution, kMaxPovrayResolution));
}

void refuse_to_replace_others(const std::vector<FolderFile>& files, const std::string& folder,
                              const InputFiles& inputs) {
    for (const FolderFile& file : files) {
        // The folder's own sea.toml may be the source.
        const std::string path = folder + "/" + file.name;
        if (text::first_bytes(path, file.text.size() + 1) != file.text) inputs.spare(path);
        if (file.is_users) continue;
        io::refuse_to_replace_foreign_file(path, "`ocean povray`", [&] {
            const std::string opening = file.opening();
            return text::first_bytes(path, opening.size()) == opening;
        });
    }
}

namespace {

BakeForecast forecast_folder(const std::vector<FolderFile>& files, const std::string& folder) {
    BakeForecast forecast;
    for (const FolderFile& file : files) {
        const std::string path = folder + "/" + file.name;
        const bool kept = is_kept(file, path);
        forecast.files.push_back({path, kept ? 1 : 0});
        if (!kept) forecast.bytes += file.text.size();
    }
    return forecast;
}

void add_files(BakeForecast& forecast, const BakeForecast& more) {
    forecast.files.insert(forecast.files.end(), more.files.begin(), more.files.end());
    forecast.bytes += more.bytes;
}

void write_files(const std::vector<FolderFile>& files, const std::string& folder,
                 const Context& context) {
    io::make_folder(folder);
    const InterruptWatch::Hold whole = context.interrupts.hold();
    const io::FolderLock lock(folder);
    for (const FolderFile& file : files) {
        const std::string path = folder + "/" + file.name;
        if (is_kept(file, path)) {
            context.console.note(path + " exists and is kept");
            continue;
        }
        io::write_file_atomically(path, file.text);
        context.console.deliver({path});
    }
}

}  // namespace

void refuse_folder_of(const std::string& folder, const std::string& file, const std::string& other,
                      const std::string& own) {
    std::error_code error;
    if (!std::filesystem::exists(utf8_path(folder + "/" + file), error)) return;
    throw Error(ErrorKind::invalid_value, "-o " + folder + ": the folder holds " + other + ", " +
                                              file + "; " + own + " needs its own");
}

bool write_folder(const PovrayFolderWork& work, bool dry_run, const Context& context) {
    BakeForecast beside = forecast_folder(work.files, work.folder);
    for (const BakePlan* plan : work.plans) {
        if (plan != &work.frames) add_files(beside, forecast_bake(*plan));
    }
    const BakeForecast baked = forecast_bake(work.frames);
    if (dry_run) {
        show_forecast(baked, beside, context.console);
        return false;
    }
    report_forecast(baked, beside, context.console);
    write_files(work.files, work.folder, context);
    for (const BakePlan* plan : work.plans) {
        ConsoleHost host(context);
        run_bake(*plan, host);
    }
    return true;
}

void update_frame_lists(
    const BakePlan& plan, const std::string& folder,
    const std::function<std::vector<FolderFile>(const std::vector<int>&)>& lists_of,
    const Context& context) {
    const InterruptWatch::Hold whole = context.interrupts.hold();
    const io::FolderLock lock(folder);
    const std::vector<int> frames = united(plan.all_frames, povray_existing_frames(plan).of_plan);
    for (const FolderFile& file : lists_of(frames)) {
        const std::string path = folder + "/" + file.name;
        if (text::first_bytes(path, file.text.size() + 1) == file.text) continue;
        io::write_file_atomically(path, file.text);
    }
}

void warn_of_foreign_frames(const ExistingFrames& existing, const BakePlan& plan,
                            const std::string& folder, const Context& context) {
    const std::string warning =
        foreign_frames_warning(existing, plan.all_frames, folder + "/ocean.ini");
    if (!warning.empty()) context.console.warning(warning);
}

}  // namespace ocean::app
