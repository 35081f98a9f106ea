// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean povray` for a sea over a bed: for each frame a map of the coast and the maps of the open
// sea beside it, the bed as a land, and the files beside them.
#include <algorithm>
#include <optional>
#include <utility>

#include "console_host.hpp"
#include "ocean/domain.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/bake/povray_folder.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/ocean.hpp"
#include "ocean/seafile.hpp"
#include "povray_files.hpp"
#include "user_files.hpp"

namespace ocean::app {
namespace {

/// Returns the sea without its bed: what lies beside the coast.
Sea open_sea_of(const Sea& sea) {
    Sea open = sea;
    Water& water = open.parameters.water;
    const Water none;
    water.bed.reset();
    water.seabed.clear();
    water.seabed_origin.clear();
    water.seabed_unit = none.seabed_unit;
    water.seabed_sign = none.seabed_sign;
    water.level = none.level;
    water.shore = none.shore;
    return open;
}

BakePlan plan_open_sea(const PovrayCoastRequest& request, const Context& context) {
    BakeOptions options = request.bake;
    options.source = request.source;
    options.output = request.folder + "/sea_####" + povray_extension(request.format);
    options.threads = context.options.threads;
    options.max_resolution = kMaxPovrayResolution;
    options.format_options["detail-map"] = "yes";
    if (!request.near_only) options.format_options["far-maps"] = "yes";
    options.open_subject = [&](const std::string&) {
        return make_subject(open_sea_of(request.sea));
    };
    BakePlan plan = make_bake_plan(options, standard_catalogue());
    refuse_large_mesh(plan.resolution);
    return plan;
}

BakePlan plan_coast(const PovrayCoastRequest& request, const Context& context) {
    const std::optional<Region> region = parse_region(request.region);
    BakeOptions options = request.bake;
    options.source = request.source;
    options.output = request.folder + "/coast_####" + povray_extension(request.format);
    options.threads = context.options.threads;
    options.resolution.clear();  // that of the open sea
    options.format_options["mask-map"] = "yes";
    options.open_subject = [&](const std::string&) {
        if (region) return make_region_subject(request.sea, *region);
        return make_subject(request.sea);
    };
    BakePlan plan = make_bake_plan(options, standard_catalogue());
    if (plan.resolution > kMaxPovrayResolution) {
        throw Error(ErrorKind::invalid_value,
                    format_text("%s has %d samples along its longer side; allowed are at most %d: "
                                "choose a part of it with --region and --cell",
                                region ? "--region: it" : "the bed", plan.resolution,
                                kMaxPovrayResolution));
    }
    return plan;
}

}  // namespace

void write_povray_coast(const PovrayCoastRequest& request, const Context& context) {
    if (request.format != "df3") {
        throw Error(
            ErrorKind::unsupported,
            "--format " + request.format +
                ": a sea over a bed (water.seabed) has df3 alone, from which its water, its "
                "foam and its depth are read; `ocean bake --region` writes a mesh2");
    }
    const BakePlan open = plan_open_sea(request, context);
    const BakePlan coast = plan_coast(request, context);
    const PovrayCoastPlans plans{open, coast};
    const SeaState state =
        Ocean(sea_of(*open.subject).parameters, {.threads = open.threads}).state();
    const ExistingFrames existing = povray_existing_frames(open);
    const std::vector<FolderFile> files =
        povray_coast_files(plans, state, united(open.all_frames, existing.of_plan),
                           {request.folder, cache_file("povray")});
    const InputFiles inputs(request.source, named_files(request.sea));
    refuse_to_replace_others(files, request.folder, inputs);
    for (const BakePlan* plan : {&open, &coast}) {
        for (const std::string& path : paths_that_may_exist(*plan)) inputs.spare(path);
    }
    io::require_folder(request.folder);
    warn_of_foreign_frames(existing, open, request.folder, context);
    // A frame counts once its open sea is there: the coast comes first.
    const PovrayFolderWork work{request.folder, files, open, {&coast, &open}};
    if (!write_folder(work, request.dry_run, context)) return;
    const auto lists_of = [&](const std::vector<int>& frames) {
        return povray_coast_frame_lists(plans, state, frames);
    };
    update_frame_lists(open, request.folder, lists_of, context);
}

}  // namespace ocean::app
