// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The writer of all folders; see povray_folders.hpp.
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <system_error>

#include "console_host.hpp"
#include "input_files.hpp"
#include "interrupt.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/platform.hpp"
#include "povray_folders.hpp"

namespace ocean::app {
namespace {

bool is_kept(const FolderFile& file, const std::string& path) {
    std::error_code error;
    return file.is_users && std::filesystem::exists(utf8_path(path), error);
}

bool has_text(const std::string& path, const std::string& text) {
    return text::first_bytes(path, text.size() + 1) == text;
}

/// Throws Error invalid_value if a file would replace one that another program or the user wrote:
/// an input of the command, or a file of the folder.
void refuse_to_replace_others(const std::vector<FolderFile>& files, const std::string& folder,
                              const InputFiles& inputs) {
    for (const FolderFile& file : files) {
        // The folder's own sea.toml may be the source.
        const std::string path = folder + "/" + file.name;
        if (!has_text(path, file.text)) inputs.spare(path);
        if (file.is_users) continue;
        io::refuse_to_replace_foreign_file(path, "`ocean povray`", [&] {
            const std::string opening = file.opening();
            return text::first_bytes(path, opening.size()) == opening;
        });
    }
}

/// Returns the forecast of all that is not the plan with the frames.
BakeForecast forecast_beside(const PovrayFolder& folder, const std::vector<FolderFile>& files,
                             const std::string& path) {
    BakeForecast beside;
    for (const FolderFile& file : files) {
        const bool kept = is_kept(file, path + "/" + file.name);
        beside.files.push_back({path + "/" + file.name, kept ? 1 : 0});
        if (!kept) beside.bytes += file.text.size();
    }
    for (const BakePlan& plan : folder.plans) {
        if (&plan == &folder.plans[folder.counted]) continue;
        const BakeForecast more = forecast_bake(plan);
        beside.files.insert(beside.files.end(), more.files.begin(), more.files.end());
        beside.bytes += more.bytes;
    }
    return beside;
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

/// Writes the lists of frames again: another chunk may have baked some meanwhile.
void update_frame_lists(const PovrayFolder& folder, const std::string& path,
                        const Context& context) {
    const InterruptWatch::Hold whole = context.interrupts.hold();
    const io::FolderLock lock(path);
    const BakePlan& plan = folder.plans[folder.counted];
    const std::vector<int> frames = united(plan.all_frames, povray_existing_frames(plan).of_plan);
    for (const FolderFile& file : folder.frame_lists(folder.plans, frames)) {
        const std::string name = path + "/" + file.name;
        if (!has_text(name, file.text)) io::write_file_atomically(name, file.text);
    }
}

}  // namespace

void write_povray_folder(const PovrayFolder& folder, const PovrayRequest& request,
                         const Context& context) {
    Console& console = context.console;
    const BakePlan& counted = folder.plans[folder.counted];
    const ExistingFrames existing =
        folder.frame_lists ? povray_existing_frames(counted) : ExistingFrames{};
    const std::vector<FolderFile> files =
        folder.files(folder.plans, united(counted.all_frames, existing.of_plan));
    std::vector<std::string> named;
    for (const BakePlan& plan : folder.plans) {
        std::ranges::move(plan.subject->named_files(), std::back_inserter(named));
    }
    const InputFiles inputs(request.subject.source, named);
    refuse_to_replace_others(files, request.folder, inputs);
    for (const BakePlan& plan : folder.plans) {
        for (const std::string& path : paths_that_may_exist(plan)) inputs.spare(path);
    }
    io::require_folder(request.folder);
    if (folder.cost) console.report("povray", folder.cost->text, folder.cost->members);
    const std::string foreign =
        foreign_frames_warning(existing, counted.all_frames, request.folder + "/ocean.ini");
    if (!foreign.empty()) console.warning(foreign);
    const BakeForecast beside = forecast_beside(folder, files, request.folder);
    const BakeForecast forecast = forecast_bake(counted);
    if (request.dry_run) return show_forecast(forecast, beside, console);
    report_forecast(forecast, beside, console);
    write_files(files, request.folder, context);
    for (const BakePlan& plan : folder.plans) bake_on_console(plan, context);
    if (folder.frame_lists) update_frame_lists(folder, request.folder, context);
}

}  // namespace ocean::app
