// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// perform_live SEA gl|cpu FOLDER [HOST:PORT]: a performance as the panel records one, at moments
// that are no frames; or as a bridge plays one, in real time. Writes what was shown at twenty
// frames (heights-FRAME.f32, the first row first) and the sea that is saved (performed.toml).
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <optional>
#include <random>
#include <string>

#include "ocean-preview/bridge_link.hpp"
#include "ocean-preview/live_sea.hpp"
#include "ocean-preview/workload.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/gl/context.hpp"
#include "ocean/seafile.hpp"
#include "preview/shown_maps.hpp"

namespace {

constexpr int kResolution = 128;

using namespace ocean;

/// Until a time of the sea, as fast as that of the wall.
void follow(app::BridgeLink& link, app::LiveSea& live, double until) {
    auto before = std::chrono::steady_clock::now();
    while (live.time() < until) {
        link.wait_and_apply(live, std::chrono::milliseconds(5));
        const auto now = std::chrono::steady_clock::now();
        live.advance(
            std::min(std::chrono::duration<double>(now - before).count(), until - live.time()));
        before = now;
        live.show();
    }
}

void perform(const std::string& source, const std::string& backend, const std::string& folder,
             const std::string& address) {
    const gl::HeadlessContext context;
    const gl::HeadlessContext::Current current(context);
    app::PreviewOptions options;
    options.map = kResolution;
    options.foam_map = kResolution;
    app::LiveSea live(read_sea(source), {.threads = 2, .computing = [&](const Sea& sea) {
                                             return app::computing_for(
                                                 *app::preview_backend(backend), options, sea,
                                                 context.info());
                                         }});
    live.near_detail = false;  // of no height
    std::mt19937 random(3);
    const auto between = [&](double least, double most) {
        return std::to_string(std::uniform_real_distribution<double>(least, most)(random));
    };
    // Something that is no part of it comes first.
    live.set("waves.0.wind_speed", "8");
    live.advance(2.03);
    std::optional<app::BridgeLink> link;
    if (!address.empty()) {
        link.emplace(bridge::LineClientOptions{bridge::parse_endpoint(address, "address")},
                     app::BridgeCalls{[](bool, const std::string&) {}});
        while (!link->joined()) link->wait_and_apply(live, std::chrono::milliseconds(20));
        live.settle();
    }
    live.start_recording();
    for (int i = 0; i < 20; ++i) {
        const int frame = 60 + 7 * i;
        const double until = live.sea().time_of(frame);
        if (link) follow(*link, live, until);
        for (int knob = 0; knob < 5 && !link; ++knob) {
            live.advance(0.19 * (until - live.time()));
            live.set("waves.0.wind_speed", between(4.0, 14.0));
            if (knob == 1) live.set("waves.0.wind_direction", between(0.0, 90.0));
            if (knob == 2) live.set("surface.choppiness", between(0.2, 1.2));
            live.show();
        }
        live.go_to(until);
        const std::vector<float> heights = test::shown_heights(live.show(), kResolution);
        std::ofstream file(folder + "/heights-" + std::to_string(frame) + ".f32", std::ios::binary);
        file.write(reinterpret_cast<const char*>(heights.data()),
                   static_cast<std::streamsize>(heights.size() * sizeof(float)));
    }
    live.stop_recording();
    std::ofstream(folder + "/performed.toml") << write_sea(live.sea());
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) return 2;
    try {
        perform(argv[1], argv[2], argv[3], argc > 4 ? argv[4] : "");
        return 0;
    } catch (const ocean::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
