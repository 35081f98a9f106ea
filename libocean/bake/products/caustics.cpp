// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Caustics among the products of image files: one map of the frame's size.
#include "ocean/internal/caustics.hpp"

#include <algorithm>
#include <optional>

#include "ocean/bake/plan.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/csv_rows.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/seafile.hpp"
#include "ocean/thread_pool.hpp"
#include "products/products.hpp"
#include "refuse.hpp"
#include "source.hpp"

namespace ocean {
namespace {

/// Default depth of the plane in a deeper sea [m]: waves of three metres focus light at about this
/// depth.
constexpr double kDefaultDepth = 10.0;
constexpr const char* kDefaultSun = "90,0";

struct CausticsRequest {
    std::optional<double> depth;  // as given [m]
    CausticsSettings resolved;    // settings, with the depth of the sea
};

std::vector<FormatOption> list_options() {
    return {
        {"caustics-depth", "METRES",
         "Depth of the level plane that caustics fall on; default: the sea's depth, 10 at most", "",
         kSeaKind},
        {"sun", "ALTITUDE,BEARING",
         "Direction of the sun for caustics, degrees above the horizon and counter-clockwise from "
         "+x; default " +
             std::string(kDefaultSun),
         "", kSeaKind}};
}

CausticsRequest read(const BakeOptions& options) {
    CausticsRequest settings;
    const std::string& depth = options.format_option("caustics-depth");
    const std::string& sun = options.format_option("sun");
    if (!depth.empty()) {
        settings.depth =
            parse_number(depth, "--caustics-depth", kMinCausticsDepth, kMaxCausticsDepth);
    }
    const std::vector<std::string> angles = split(sun.empty() ? kDefaultSun : sun, ',');
    if (angles.size() != 2) {
        refuse("--sun " + sun + ": two numbers are needed, ALTITUDE,BEARING");
    }
    settings.resolved.sun_altitude =
        parse_number(trimmed(angles[0]), "--sun, altitude", kMinCausticsSunAltitude, 90.0);
    settings.resolved.sun_bearing =
        parse_number(trimmed(angles[1]), "--sun, bearing", -3600.0, 3600.0);
    return settings;
}

/// Resolves the settings. The plane lies no deeper than the water.
MadePlan<CausticsRequest> resolve(const BakePlan& draft, const CausticsRequest& requested,
                                  const std::vector<const Product*>& products) {
    const Water& body = sea_of(*draft.subject).parameters.water;
    if (body.bed) {
        throw Error(ErrorKind::unsupported,
                    "--products caustics: they fall on a level plane, and this sea has a bed "
                    "(water.seabed)");
    }
    if (!draft.domain().wraps) {
        throw Error(ErrorKind::unsupported,
                    "--products caustics: they repeat with their map, and this region of a sea "
                    "with hulls does not");
    }
    const double water = body.depth;
    CausticsRequest settings = requested;
    settings.resolved.depth = requested.depth.value_or(std::min(water, kDefaultDepth));
    if (settings.resolved.depth > water) {
        refuse("--caustics-depth " + shortest_text(settings.resolved.depth) + ": the sea is " +
               shortest_text(water) + " m deep");
    }
    return {products, kCausticsChannels, settings};
}

std::vector<io::HeaderString> strings(const BakePlan&, const CausticsRequest& settings, int,
                                      const Product&) {
    const CausticsSettings& caustics = settings.resolved;
    return {{"ocean:caustics_depth", shortest_text(caustics.depth)},
            {"ocean:sun",
             shortest_text(caustics.sun_altitude) + "," + shortest_text(caustics.sun_bearing)}};
}

std::uint64_t frame_bytes(const BakePlan& plan, const CausticsRequest&) {
    return caustics_bytes(plan.resolution);
}

MadeFrame make(const FrameWork& work, const CausticsRequest& settings) {
    ThreadPool pool(work.threads);
    return [map = make_caustics(work.maps.front(), settings.resolved, pool)](
               const Product&) mutable { return MadeSamples{.map = std::move(map)}; };
}

void adopt(const BakedHeader& header, BakeOptions& options) {
    options.set_default("caustics-depth", header.text("caustics_depth"));
    options.set_default("sun", header.text("sun"));
}

constexpr MadeProductOf<CausticsRequest> kOf = {
    .products = {&kCausticsProduct, 1},
    .options = list_options,
    .read = read,
    .resolve = resolve,
    .strings = strings,
    .frame_bytes = frame_bytes,
    .make = make,
    .adopt = adopt,
};

}  // namespace

const MadeProduct kCaustics = made_product<kOf>();

}  // namespace ocean
