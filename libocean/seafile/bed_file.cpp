// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The bed of a sea in files; see bed_file.hpp.
#include "bed_file.hpp"

#include <optional>
#include <utility>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/elevation.hpp"
#include "ocean/internal/elevation_file.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/sea_bed.hpp"
#include "ocean/terrain.hpp"
#include "ocean/terrainfile.hpp"
#include "toml_text.hpp"

namespace ocean {
namespace {

constexpr std::string_view kLines = "lines";

std::string name_of(std::string_view table) {
    return "water." + std::string(table);
}

bool is_terrain_file(const std::string& path) {
    return lower_case(path).ends_with(".toml");
}

/// Returns the heights of a land on its own grid. A tile becomes the samples of one period, which
/// exists once.
GivenBed bed_of_terrain(const TerrainModel& terrain) {
    Terrain land(terrain);
    GivenBed bed{.grid = land.domain()};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        bed.grid.size[axis] = land.domain().step(axis) * (bed.grid.samples[axis] - 1);
    }
    bed.grid.wraps = false;
    require_bed_grid(bed.grid);  // before the land is computed
    const Surface map = land.surface({Channel::height});
    const auto heights = map.channel(Channel::height);
    bed.heights.assign(heights.begin(), heights.end());
    bed.terrain = write_terrain(terrain);
    return bed;
}

GivenBed read_bed_file(const std::string& path, BedUnit unit) {
    if (is_terrain_file(path)) return bed_of_terrain(read_terrain(path));
    ElevationOptions options{.holes = HolePolicy::keep};  // make_sea_bed reports the holes
    // The sea itself scales heights of another unit, so that these heights stay as in the file.
    if (unit != BedUnit::m) options.unit = HeightUnit::m;
    ElevationModel model = read_elevation(path, options);
    return {
        .grid = model.domain, .heights = std::move(model.heights), .notes = std::move(model.notes)};
}

/// Returns the heights of the text or the file; nothing if there are neither.
std::optional<GivenBed> given_bed(const Water& water, const std::string& base_dir,
                                  InlinedBed& inlined) {
    const auto path = utf8_path(base_dir) / utf8_path(water.seabed);
    if (!inlined.terrain.empty()) {
        const std::string folder = text::to_utf8(path.parent_path());
        return bed_of_terrain(
            parse_terrain(inlined.terrain, "[" + name_of(kBedTerrain) + "]", folder));
    }
    if (!inlined.heights.heights.empty()) {
        return GivenBed{.grid = inlined.heights.grid,
                        .heights = std::move(inlined.heights.heights)};
    }
    if (!water.seabed.empty()) return read_bed_file(text::to_utf8(path), water.seabed_unit);
    if (inlined.heights.hash.empty()) return std::nullopt;
    throw Error(ErrorKind::invalid_value,
                {.what = "has a hash, but no file",
                 .allowed = "the path of the bed with the hash " + inlined.heights.hash});
}

/// Returns the error for a bed that is named by a hash, with that hash.
Error with_hash(const Error& error, const std::string& hash) {
    if (hash.empty() || error.kind() != ErrorKind::bad_file) return error;
    return Error(error.kind(), error.what() + ("; allowed: the bed with the hash " + hash),
                 error.fields());
}

}  // namespace

bool read_bed_table(const TomlEntry& entry, InlinedBed& bed) {
    const toml::table* table = entry.node->as_table();
    if (table == nullptr) return false;
    if (entry.key == kBedHeights) {
        bed.heights = read_height_grid(*table, name_of(kBedHeights), kMaxBedSide);
        return true;
    }
    if (entry.key != kBedTerrain) return false;
    const toml::array* lines = table->get_as<toml::array>(kLines);
    if (lines == nullptr || table->size() != 1 || !lines->is_homogeneous<std::string>()) {
        throw Error(ErrorKind::invalid_value, {.what = "is not the text of a terrain",
                                               .parameter = name_of(kBedTerrain),
                                               .value = "{...}",
                                               .allowed = "the one key lines, an array of texts"});
    }
    for (const toml::node& line : *lines) bed.terrain += line.as_string()->get() + "\n";
    return true;
}

void resolve_bed(Water& water, const std::string& base_dir, InlinedBed inlined) {
    const std::string hash = inlined.heights.hash;
    try {
        std::optional<GivenBed> given = given_bed(water, base_dir, inlined);
        if (!given) return;
        auto bed = make_sea_bed(*std::move(given), water);
        if (hash.empty() || bed->sha256 == hash) {
            water.bed = std::move(bed);
            return;
        }
        if (!is_comma_hash(hash, bed->domain, bed->given())) {
            throw Error(ErrorKind::invalid_value,
                        {.what = "is another bed: its hash is " + bed->sha256,
                         .allowed = "the bed with the hash " + hash});
        }
        auto noted = std::make_shared<SeaBed>(*bed);
        noted->notes.emplace_back(kCommaHashNote);
        water.bed = std::move(noted);
    } catch (const Error& error) {
        throw text::error_of_text(with_hash(error, hash), "water.seabed", water.seabed);
    }
}

std::string bed_text(const Water& water) {
    if (water.bed == nullptr) return "";
    const SeaBed& bed = *water.bed;
    if (bed.terrain.empty()) {
        return "\n[" + name_of(kBedHeights) + "]\n" +
               height_grid_text({bed.domain, bed.sha256, bed.given()});
    }
    std::string text = "\n[" + name_of(kBedTerrain) + "]\n" + std::string(kLines) + " = [\n";
    std::vector<std::string> lines = split(bed.terrain, '\n');
    if (!lines.empty() && lines.back().empty()) lines.pop_back();
    for (const std::string& line : lines) text += "    " + toml_string(line) + ",\n";
    return text + "]\n";
}

}  // namespace ocean
