// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Caustics among the products of image files: one map of the frame's size.
#include "ocean/caustics.hpp"

#include <algorithm>
#include <optional>

#include "ocean/bake/plan.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/csv_rows.hpp"
#include "ocean/sea_subject.hpp"
#include "ocean/text.hpp"
#include "ocean/thread_pool.hpp"
#include "products/products.hpp"
#include "source.hpp"

namespace ocean {
namespace {

/// m, where there is no floor above it: waves of three metres gather light about here.
constexpr double kUsualDepth = 10.0;
constexpr const char* kUsualSun = "90,0";

struct Settings {
    std::optional<double> depth;  // as typed
    CausticsSettings made_with;   // with the depth that the sea has
};

std::vector<FormatOption> list_options() {
    return {{"caustics-depth", "METRES",
             "Of the level plane that caustics fall on; default: the sea's depth, 10 at most"},
            {"sun", "ALTITUDE,BEARING",
             "Of caustics, degrees above the horizon and counter-clockwise from +x; default " +
                 std::string(kUsualSun)}};
}

Settings read(const BakeOptions& options) {
    Settings settings;
    const std::string& depth = options.format_option("caustics-depth");
    const std::string& sun = options.format_option("sun");
    if (!depth.empty()) {
        settings.depth =
            parse_number(depth, "--caustics-depth", kMinCausticsDepth, kMaxCausticsDepth);
    }
    const std::vector<std::string> angles = split(sun.empty() ? kUsualSun : sun, ',');
    if (angles.size() != 2) {
        throw Error(ErrorKind::invalid_value,
                    "--sun " + sun + ": two numbers are needed, ALTITUDE,BEARING");
    }
    settings.made_with.sun_altitude =
        parse_number(csv::trimmed(angles[0]), "--sun, altitude", kMinCausticsSunAltitude, 90.0);
    settings.made_with.sun_bearing =
        parse_number(csv::trimmed(angles[1]), "--sun, bearing", -3600.0, 3600.0);
    return settings;
}

/// The plane lies no deeper than the water.
MadePlan<Settings> settle(const BakePlan& begun, const Settings& asked,
                          const std::vector<const Product*>& products) {
    const double water = sea_of(*begun.subject).parameters.water.depth;
    Settings settings = asked;
    settings.made_with.depth = asked.depth.value_or(std::min(water, kUsualDepth));
    if (settings.made_with.depth > water) {
        throw Error(ErrorKind::invalid_value,
                    "--caustics-depth " + shortest_text(settings.made_with.depth) +
                        ": the sea is " + shortest_text(water) + " m deep");
    }
    return {products, kCausticsChannels, settings};
}

std::vector<io::HeaderString> strings(const BakePlan&, const Settings& settings, int,
                                      const Product&) {
    const CausticsSettings& caustics = settings.made_with;
    return {{"ocean:caustics_depth", shortest_text(caustics.depth)},
            {"ocean:sun",
             shortest_text(caustics.sun_altitude) + "," + shortest_text(caustics.sun_bearing)}};
}

std::uint64_t frame_bytes(const BakePlan& plan, const Settings&) {
    return caustics_bytes(plan.resolution);
}

MadeFrame make(const FrameWork& work, const Settings& settings) {
    ThreadPool pool(work.threads);
    return [map = make_caustics(work.maps.front(), settings.made_with, pool)](
               const Product&) mutable { return MadeSamples{.map = std::move(map)}; };
}

void adopt(const BakedHeader& header, BakeOptions& options) {
    options.take("caustics-depth", header.text("caustics_depth"));
    options.take("sun", header.text("sun"));
}

constexpr MadeProductOf<Settings> kOf = {
    .products = {&kCausticsProduct, 1},
    .options = list_options,
    .read = read,
    .settle = settle,
    .strings = strings,
    .frame_bytes = frame_bytes,
    .make = make,
    .adopt = adopt,
};

}  // namespace

const MadeProduct kCaustics = made_product<kOf>();

}  // namespace ocean
