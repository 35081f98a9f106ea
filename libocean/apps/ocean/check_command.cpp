// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean check`: reads the files of a bake against its manifests.
#include <memory>
#include <string>
#include <variant>

#include "commands.hpp"
#include "console.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/bake/check.hpp"
#include "ocean/internal/json.hpp"
#include "ocean/subject.hpp"
#include "ocean/terrainfile.hpp"
#include "subject_argument.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

struct CheckOptions {
    std::string path, frames, against;
    bool merge = false;
};

std::string text_of(const std::string& source) {
    return std::visit([](auto&& model) { return make_subject(std::move(model))->text(); },
                      open_subject({source, {}}));
}

std::string counts_text(const BakeCheck& check) {
    std::string text = format_text("%zu of %zu files are whole, ", check.whole, check.files) +
                       bytes_text(check.bytes);
    for (const BakeFault fault :
         {BakeFault::missing, BakeFault::damaged, BakeFault::foreign, BakeFault::other}) {
        const auto count = std::ranges::count(check.faults, fault, &FaultyFile::fault);
        if (count > 0)
            text += format_text("; %td %s", count, std::string(fault_name(fault)).c_str());
    }
    return text;
}

std::string check_text(const BakeCheck& check) {
    std::string text;
    for (const FaultyFile& file : check.faults) {
        text += format_text("%-8s %s: %s\n", std::string(fault_name(file.fault)).c_str(),
                            file.path.c_str(), file.reason.c_str());
    }
    return text + counts_text(check) + "\n";
}

std::string check_json(const BakeCheck& check) {
    JsonArray faults(JsonLines{2});
    for (const FaultyFile& file : check.faults) {
        faults.add(JsonObject()
                       .add("fault", fault_name(file.fault))
                       .add("path", file.path)
                       .add("reason", file.reason));
    }
    JsonObject json;
    json.add("whole", check.whole).add("files", check.files).add("bytes", check.bytes);
    if (!check.merged.empty()) json.add("manifest", check.merged);
    return json.add("faults", faults).text() + "\n";
}

void run(const CheckOptions& options, const Context& context) {
    CheckRequest request;
    request.path = options.path;
    request.threads = context.options.threads;
    if (!options.frames.empty()) request.frames = parse_frames(options.frames);
    if (!options.against.empty()) request.against = text_of(options.against);
    request.merge = options.merge;
    request.progress = [&, report = build_progress_on(context.console)](std::string_view work,
                                                                        double share) {
        report(work, share);
        context.console.advance(share);
    };
    const BakeCheck check = check_bake(request);
    context.console.data(context.options.json ? check_json(check) : check_text(check));
    const std::size_t faults = check.faults.size();
    if (faults == 0) return;
    throw Error(ErrorKind::output,
                format_text("%zu fault%s in the files of ", faults, faults == 1 ? "" : "s") +
                    options.path + (options.merge ? ": its manifests are not merged" : ""));
}

constexpr char kCheckFooter[] =
    R"(Reads every file that out/sea.manifest.json and the manifests of shards list, and
writes nothing. Each fault is a line:
missing   a file, a frame or the manifest of a shard does not exist
damaged   the bytes are not those that were written
foreign   no manifest lists a file of the bake's name
other     the file is of another sea, of other options or of another version than
          most of its sequence, or than --against
Exit codes: 0 all is whole, 1 a fault, 2 wrong usage.)";

}  // namespace

Command check_command() {
    auto options = std::make_shared<CheckOptions>();
    return {
        .name = "check",
        .summary = "Read the files of a bake: what is missing, damaged or of another sea",
        .options =
            {{"",
              {{"BAKE", &options->path, "",
                "Its manifest, out/sea.manifest.json, or its -o, out/sea.####.exr", kRequired},
               {"--frames", &options->frames, "RANGES",
                "Frames that each product must have; default: no gap between those there are"},
               {"--against", &options->against, "SEA",
                "The sea, or terrain, that the files must show"},
               {"--merge", &options->merge, "",
                "If all is whole, join the manifests of the shards to one"}}},
             run_options("Print one JSON object; progress as JSON lines"),
             progress_option()},
        .footer = kCheckFooter,
        .run = [options](const Context& context) { run(*options, context); },
    };
}

}  // namespace ocean::app
