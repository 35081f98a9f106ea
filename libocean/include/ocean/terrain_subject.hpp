// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A terrain as a Subject, and the way back from a Subject to its terrain.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "ocean/domain.hpp"
#include "ocean/land.hpp"
#include "ocean/subject.hpp"
#include "ocean/subject_kind.hpp"
#include "ocean/terrain.hpp"

namespace ocean {

/// How often a tile is repeated to the east and to the north.
struct TerrainTiles {
    int x = 1;
    int y = 1;

    bool operator==(const TerrainTiles&) const = default;
};
inline constexpr int kMaxTerrainTiles = 64;

/// A rectangle of a terrain at any place, with samples `cell` apart; its far sides lie at the last
/// samples that are within the size.
struct TerrainRegion {
    std::array<double, 2> origin{};  // [m]
    std::array<double, 2> size{};    // [m]
    double cell = 1.0;               // [m]
};
/// Returns the samples of a region. Throws Error invalid_value unless it has 2 .. kMaxRegionSide
/// samples along each side and, with a placed land, lies within it.
Domain domain_of(const Terrain& terrain, const TerrainRegion& region);
inline constexpr int kMaxRegionSide = 32768;

/// Returns a region of a valid, resolved terrain as a subject.
std::unique_ptr<Subject> make_region_subject(Terrain terrain, const TerrainRegion& region);
/// Returns a valid, resolved terrain as a subject. The domain of its maps has the tile that often;
/// a resolution is that of one tile.
std::unique_ptr<Subject> make_subject(Terrain terrain, TerrainTiles tiles = {});
/// Returns the subject that text() of such a subject describes. `name` stands for a path in
/// messages. Throws Error as parse_terrain.
std::unique_ptr<Subject> parse_terrain_subject(std::string_view text, const std::string& name);

/// Returns the terrain of a subject, or null for a subject of another kind.
const Terrain* find_terrain(const Subject& subject);
/// Returns the Land that makes a terrain's maps. Throws Error unsupported for maps of another kind.
Land& land_of(SubjectMaps& maps);

}  // namespace ocean
