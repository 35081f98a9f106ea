// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The function of libocean.h that writes a bake as a job for a render farm.
#include <string>

#include "guard.hpp"
#include "ocean/internal/farm/farm_job.hpp"
#include "ocean/internal/json.hpp"
#include "ocean/seafile.hpp"
#include "sea_handle.hpp"

using namespace ocean;
using namespace ocean::capi;

namespace {

FarmJob read_job(const Sea& sea, const ocean_farm_request& asked) {
    require(asked.output, "output");
    require(asked.frames, "frames");
    require_reserved(asked.reserved, "reserved");
    for (const std::int32_t number : {asked.frames_per_task, asked.threads, asked.minutes}) {
        if (number < 0) refuse("a farm request has a number below 0");
    }
    FarmJob job{.sea_text = write_sea(sea),
                .time_of = [&sea](int frame) { return sea.time_of(frame); },
                .output = asked.output,
                .frames = {asked.frames, asked.frames + asked.frame_count},
                .options = {},
                .render = asked.render == nullptr ? "" : asked.render,
                .frames_per_task = asked.frames_per_task,
                .threads = asked.threads,
                .minutes = asked.minutes,
                .memory_bytes = asked.memory_bytes};
    if (asked.option_count > 0) require(asked.options, "options");
    for (std::size_t i = 0; i < asked.option_count; ++i) {
        require(asked.options[i], "an option");
        job.options.emplace_back(asked.options[i]);
    }
    return job;
}

}  // namespace

ocean_result ocean_farm_job_json(const ocean_sea* sea, const ocean_farm_request* request, char* out,
                                 size_t* size) {
    return in_handle(sea, [&] {
        const auto asked = read_struct(request, sizeof(ocean_farm_request), "ocean_farm_request");
        require(asked.engine, "engine");
        const Sea& open = sea->ocean->sea();
        JsonObject files;
        for (const FarmFile& file :
             farm_files(find_farm_engine(asked.engine), read_job(open, asked))) {
            files.add(file.name, file.text);
        }
        copy_text(files.text(), out, size);
    });
}
