// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Elevation models: measured heights of land or of a sea bed on a grid that exists once. A model is
// not a terrain: a terrain is made from parameters, a model is measured, may have holes, and says
// where on the Earth it lies. Readers of files are in ocean/internal/elevation_file.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "ocean/domain.hpp"
#include "ocean/page_vector.hpp"

namespace ocean {

/// Limits of the cells along a side of an elevation model.
inline constexpr int kMinElevationSide = 2;
inline constexpr int kMaxElevationSide = 65536;
/// Limit of a height's magnitude [m]: no planet has ground farther from zero.
inline constexpr double kMaxElevation = 1e5;

/// Heights at the centres of cells. The heights are a row-major array [j][i], j from the south, i
/// from the west.
struct ElevationModel {
    /// The centres of the cells [m]; wraps = false, and sample (0, 0) is the centre of the
    /// south-west cell. domain.step(0) and domain.step(1) are the sides of a cell.
    Domain domain{.origin = {}, .size = {}, .samples = {}, .wraps = false};
    PageVector<float> heights;  // [m], positive upwards; NaN = a hole
    /// The coordinate reference system: "EPSG:26911", or a definition in WKT; "" = unknown.
    std::string crs;
    std::string crs_definition;  // in WKT 1, where crs is a code and the reader knows it
    /// True if the file's cells were degrees. They are scaled to metres by the latitude of the
    /// centre, and the domain begins at (0, 0).
    bool was_degrees = false;
    std::array<double, 2> geographic_origin{};  // of sample (0, 0) [degrees east, degrees north]
    std::array<double, 2> geographic_cell{};    // [degrees]
    /// A sentence for each assumption that a reader made.
    std::vector<std::string> notes;
};

/// Facts about the heights of a model, for a user.
struct ElevationSummary {
    float lowest = 0.0f;  // [m]; this and the next three: 0 if all cells are holes
    float highest = 0.0f;
    double mean = 0.0;
    double rms = 0.0;       // about the mean [m]
    std::size_t holes = 0;  // a count of cells
};

ElevationSummary summarize(const ElevationModel& model);

/// Returns the sides of a cell of 1 degree x 1 degree at a latitude [degrees] on the ellipsoid of
/// WGS 84: metres to the east and to the north.
std::array<double, 2> metres_per_degree(double latitude);

/// Replaces the model's domain, which is in degrees, by one in metres: see was_degrees. Throws
/// Error invalid_value if the model reaches beyond a pole.
void scale_degrees(ElevationModel& model);

/// Fills the holes of a row-major array of `columns` columns with the smooth surface (discrete
/// Laplace equation) that continues the heights around each of them; heights that are known keep
/// their bits. Throws Error invalid_value if no height is known.
void fill_holes(std::span<float> heights, int columns);

/// Returns the model with square cells of `cell` [m] from its south-west sample on: each height is
/// the mean over its cell of the surface that is linear between the samples, so that a plane stays
/// that plane. Holes spread to the cells that they touch. Throws Error invalid_value unless a side
/// has 2 .. 32768 samples.
ElevationModel with_square_cells(const ElevationModel& model, double cell);

/// Returns the heights as bytes of little-endian floats.
std::vector<std::byte> bytes_of_heights(std::span<const float> heights);
/// Returns the SHA-256 of samples, cell and heights, in hexadecimal; the origin does not count.
std::string height_hash(const Domain& grid, std::span<const float> heights);
/// Returns true for a hash that earlier versions computed in a host whose locale has decimal
/// commas.
bool is_comma_hash(const std::string& stated, const Domain& grid, std::span<const float> heights);
/// The sentence about a hash for which is_comma_hash returns true.
inline constexpr const char* kCommaHashNote =
    "its hash was made in a program with decimal commas; save the file again to mend it";

}  // namespace ocean
