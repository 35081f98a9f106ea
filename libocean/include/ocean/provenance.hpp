// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Where a baked file comes from, as the strings "ocean:..." of its header. The writers of all
// formats and the C API share these words, so that a host's own files say the same as ours.
//
//     Provenance provenance{.kind = "sea", .text = write_sea(sea), .frame = 48, .time = 2.0};
//     provenance.domain = surface.domain();
//     for (const HeaderString& each : provenance_strings(provenance)) {
//         image.set_attribute(each.name, each.text);  // ocean:sea, ocean:frame, ocean:time ...
//     }
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/channel.hpp"
#include "ocean/domain.hpp"

namespace ocean {

struct DetailBand;

/// A text of a file's header.
struct HeaderString {
    std::string name;
    std::string text;
};

/// The words by which a program makes a file again. provenance_strings puts them into a header; a
/// header leaves out members that are not set.
struct Provenance {
    std::string kind = {};  // the subject's kind; for "sea" the header has `text` as ocean:sea
    std::string text = {};  // the subject's own file, resolved: it needs no other file
    std::string id = {};    // a short name of the subject on its map, for hosts; not in the header
    std::optional<int> frame = {};
    std::optional<double> time = {};  // [s]
    std::optional<Domain> domain = {};
    std::string backend = {};  // the backend that computed the file: last bits differ
};

inline constexpr std::string_view kHeaderPrefix = "ocean:";
/// The kinds that headers named before they had ocean:subject.
inline constexpr std::array kFirstKinds = {kSeaKind, std::string_view("foam_texture")};

/// Returns ocean:KIND, frame, time, period (or, unless the domain is a tile: origin, size, samples
/// and wraps), backend and version. A kind outside kFirstKinds adds ocean:subject = KIND.
std::vector<HeaderString> provenance_strings(const Provenance& provenance);
/// Returns ocean:axes, field and unit of an image of these products; commas join the words of
/// several products. `axes` is the order of the image's vectors; an image without vectors has
/// "zup".
std::vector<HeaderString> product_strings(std::span<const Product* const> products,
                                          std::string_view axes);
/// Returns the header strings of a slope tile beside its product: the resolution of the map whose
/// end begins the band, tile and waves [m], variances. Variances have eight decimals, on which all
/// machines agree.
std::vector<HeaderString> slope_tile_strings(const DetailBand& band, double residual,
                                             int map_resolution);

namespace io {

using ocean::HeaderString;
using ocean::Provenance;
using ocean::provenance_strings;

}  // namespace io
}  // namespace ocean
