// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The header strings of baked files; see provenance.hpp.
#include "ocean/provenance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ocean/detail.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/version.hpp"

namespace ocean {
namespace {

std::string pair_text(double x, double y) {
    return shortest_text(x) + "," + shortest_text(y);
}

std::string variance_text(double variance) {
    return shortest_text(std::round(variance * 1e8) / 1e8);
}

}  // namespace

std::vector<HeaderString> provenance_strings(const Provenance& provenance) {
    std::vector<HeaderString> strings;
    const auto add = [&strings](std::string_view name, std::string text) {
        strings.push_back({std::string(kHeaderPrefix) + std::string(name), std::move(text)});
    };
    add(provenance.kind, provenance.text);
    if (std::ranges::find(kFirstKinds, provenance.kind) == kFirstKinds.end()) {
        add("subject", provenance.kind);
    }
    if (provenance.frame) add("frame", std::to_string(*provenance.frame));
    if (provenance.time) add("time", shortest_text(*provenance.time));
    if (provenance.domain && provenance.domain->is_tile()) {
        add("period", shortest_text(provenance.domain->size[0]));
    } else if (provenance.domain) {
        const Domain& domain = *provenance.domain;
        add("origin", pair_text(domain.origin[0], domain.origin[1]));
        add("size", pair_text(domain.size[0], domain.size[1]));
        add("samples", pair_text(domain.samples[0], domain.samples[1]));
        add("wraps", domain.wraps ? "yes" : "no");
    }
    if (!provenance.backend.empty()) add("backend", provenance.backend);
    add("version", OCEAN_VERSION);
    return strings;
}

std::vector<HeaderString> product_strings(std::span<const Product* const> products,
                                          std::string_view axes) {
    std::string names, units;
    bool vectors = false;
    for (const Product* product : products) {
        const char* separator = names.empty() ? "" : ",";
        names += separator + std::string(product->name);
        units += separator + (product->unit.empty() ? "1" : std::string(product->unit));
        vectors = vectors || product->vector;
    }
    // A field without vectors is the same in all axes: x east and y north, as in zup.
    return {{"ocean:axes", std::string(vectors ? axes : "zup")},
            {"ocean:field", names},
            {"ocean:unit", units}};
}

std::vector<HeaderString> slope_tile_strings(const DetailBand& band, double residual,
                                             int map_resolution) {
    return {{"ocean:map_resolution", std::to_string(map_resolution)},
            {"ocean:tile", shortest_text(band.tile)},
            {"ocean:longest_wave", shortest_text(band.longest_wave)},
            {"ocean:shortest_wave", shortest_text(band.shortest_wave)},
            {"ocean:slope_variance", variance_text(band.variance.x) + "," +
                                         variance_text(band.variance.y) + "," +
                                         variance_text(band.variance.xy)},
            {"ocean:slope_residual", variance_text(residual)}};
}

}  // namespace ocean
