// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The functions of libocean.h by which a host keeps a sea in properties of its own and writes files
// that say where they come from.
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "guard.hpp"
#include "ocean/internal/cascades.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/json.hpp"
#include "ocean/provenance.hpp"
#include "ocean/seafile.hpp"
#include "outputs.hpp"
#include "sea_handle.hpp"

using namespace ocean;
using namespace ocean::capi;

namespace {

/// "detail1" and its neighbours: one product for each slope tile.
constexpr std::span<const Product> kSlopeTileFields = std::span(kDetailProducts).subspan(1);
/// The bytes of ocean_detail_band before members were added at its end.
constexpr std::size_t kFirstBand = offsetof(ocean_detail_band, mean_square);

/// Returns the product that a request calls its field. Throws CallError for an unknown name.
const Product& find_field(std::string_view name) {
    for (const Product& product : kProducts) {
        if (product.name == name) return product;
    }
    for (const Product& product : kSlopeTileFields) {
        if (product.name == name) return product;
    }
    std::string known;
    for (const Product& product : kProducts) known += std::string(product.name) + ", ";
    refuse({.parameter = "field",
            .value = std::string(name),
            .allowed = known + "detail1 .. detail" + std::to_string(kSlopeTileFields.size())});
}

bool is_slope_tile(const Product& product) {
    return &product >= kSlopeTileFields.data() &&
           &product < kSlopeTileFields.data() + kSlopeTileFields.size();
}

/// Returns the caller's band as core's.
DetailBand read_band(const ocean_provenance_request& asked) {
    require_struct_size(asked.band_size, kFirstBand, "band_size", "ocean_detail_band",
                        sizeof(ocean_detail_band));
    const auto band =
        read_bytes<ocean_detail_band>(asked.band, asked.band_size, "ocean_detail_band");
    return {.shortest_wave = band.shortest_wave,
            .longest_wave = band.longest_wave,
            .tile = band.tile,
            .variance = {band.variance_x, band.variance_y, band.covariance}};
}

void append(std::vector<HeaderString>& strings, std::vector<HeaderString> more) {
    for (HeaderString& string : more) strings.push_back(std::move(string));
}

std::vector<HeaderString> field_strings(const ocean_sea& sea,
                                        const ocean_provenance_request& asked) {
    if (asked.field == nullptr) return {};
    const Product& product = find_field(asked.field);
    const Product* const one[] = {&product};
    auto strings = product_strings(one, axes_name(asked.axes));
    if (!is_slope_tile(product)) return strings;
    const int resolution = asked.resolution != 0
                               ? asked.resolution
                               : default_map_resolution(sea.ocean->parameters().grid);
    const bool is_known = asked.band != nullptr;
    auto tile =
        slope_tile_strings(is_known ? read_band(asked) : DetailBand{}, asked.residual, resolution);
    if (!is_known) tile.resize(1);
    append(strings, std::move(tile));
    return strings;
}

std::string json_of(const std::vector<HeaderString>& strings) {
    JsonObject json;
    for (const HeaderString& string : strings) json.add(string.name, string.text);
    return json.text();
}

void check(const ocean_provenance_request& asked) {
    require_finite(asked.time, "time", "seconds");
    require_finite(asked.residual, "residual", "mean square slope");
    require_reserved(asked.reserved, "reserved");
    if (asked.resolution != 0 && !is_resolution(asked.resolution)) {
        refuse({.parameter = "resolution",
                .value = std::to_string(asked.resolution),
                .allowed = "0 (ocean_map_resolution) or a power of two, 32 .. 8192"});
    }
    axes_name(asked.axes);  // throws
}

}  // namespace

ocean_result ocean_values_json(const ocean_sea* sea, char* out, size_t* size) {
    return in_handle(sea, [&] {
        JsonObject json;
        for (const NamedText& named : sea_values(sea->ocean->sea())) {
            json.add(named.name, named.value);
        }
        copy_text(json.text(), out, size);
    });
}

ocean_result ocean_text_of_values(const char* const* names, const char* const* values, size_t count,
                                  char* out, size_t* size) {
    return guarded([&] {
        std::vector<NamedValue> named;
        for_each_value(names, values, count, [&](const char* name, const char* value) {
            named.push_back({name, value});
        });
        copy_text(text_of_values(named), out, size);
    });
}

ocean_result ocean_time_of_frame(const ocean_sea* sea, double frame, double* time) {
    return in_handle(sea, [&] {
        require(time, "time");
        require_finite(frame, "frame", "frames");
        *time = sea->ocean->sea().time_of(frame);
    });
}

ocean_result ocean_provenance_json(const ocean_sea* sea, const ocean_provenance_request* request,
                                   char* out, size_t* size) {
    return in_handle(sea, [&] {
        const auto asked =
            read_struct(request, sizeof(ocean_provenance_request), "ocean_provenance_request");
        check(asked);
        const Sea& open = sea->ocean->sea();
        auto strings = provenance_strings({.kind = std::string(kSeaKind),
                                           .text = write_sea(open),
                                           .frame = asked.frame,
                                           .time = asked.time,
                                           .domain = Domain::tile(open.parameters.grid.patch_size),
                                           .backend = std::string(sea->options.backend.name)});
        append(strings, field_strings(*sea, asked));
        copy_text(json_of(strings), out, size);
    });
}
