// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Small bakes, and their refusals.
#pragma once

#include "ocean/bake/run.hpp"
#include "ocean/seafile.hpp"
#include "refusal.hpp"
#include "temporary_folder.hpp"

namespace ocean::test {

using FormatOptions = std::map<std::string, std::string>;

/// Returns a bake of a preset to maps of 32 samples.
inline BakeOptions sea_bake(const std::string& output, const std::string& frames = "",
                            const FormatOptions& format_options = {}) {
    BakeOptions options;
    options.source = "preset:beaufort_4";
    options.output = output;
    options.frames = frames;
    options.resolution = "32";
    options.threads = 1;
    options.format_options = format_options;
    options.open_subject = [](const std::string&) {
        return parse_sea_subject(find_preset("beaufort_4").toml, "beaufort_4");
    };
    return options;
}

/// Returns why there is no such plan, or "planned".
inline std::string refusal_of(const BakeOptions& options,
                              const Catalogue& catalogue = standard_catalogue()) {
    const std::string message = message_of([&] { make_bake_plan(options, catalogue); });
    return message.empty() ? "planned" : message;
}

/// Bakes, and returns a letter for each frame: b if it was baked, k if it was kept.
inline std::string bake(const BakeOptions& options,
                        const Catalogue& catalogue = standard_catalogue()) {
    struct Events : BakeHost {
        std::string text;
        void frame_baked(int, double, const std::vector<std::string>&) override { text += "b"; }
        void frame_skipped(int, const std::vector<std::string>&) override { text += "k"; }
    } events;
    run_bake(make_bake_plan(options, catalogue), events);
    return events.text;
}

}  // namespace ocean::test
