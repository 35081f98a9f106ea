// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The bed of a sea: heights on square cells that exist once, over still water, below which the
// waves feel the ground. A bed is not an elevation model: it has no holes, and its heights have the
// unit, sign and level of the sea's parameters already applied, where a model has a datum of its
// own.
//
//     GivenBed given;
//     given.grid = {.size = {990.0, 490.0}, .samples = {100, 50}, .wraps = false};  // of 10 m
//     given.heights.assign(given.grid.count(), -4.0f);
//     parameters.water.bed = make_sea_bed(std::move(given), parameters.water);
//     Ocean coast(parameters);
//     const Surface surf = coast.region(12.0, parameters.water.bed->domain, {Channel::height});
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "ocean/domain.hpp"
#include "ocean/page_vector.hpp"
#include "ocean/parameters.hpp"

namespace ocean {

/// Limits of the samples along a side of a bed, and of the side itself [m].
inline constexpr int kMinBedSide = 2;
inline constexpr int kMaxBedSide = 8192;
inline constexpr double kMaxBedSize = 100000.0;

/// Immutable once it is made. Several threads and seas may share one.
struct SeaBed {
    /// wraps = false; the sea's parameters give the origin, and both steps are equal but for their
    /// last bits.
    Domain domain{.origin = {}, .size = {}, .samples = {}, .wraps = false};
    /// Row-major [j][i], j from the south, i from the west; over still water, positive up [m].
    PageVector<float> heights;
    /// The heights as given, before unit, sign and level; empty if these change nothing.
    PageVector<float> source;
    /// SHA-256 of samples, cell and given heights, in hexadecimal: the same at every level.
    std::string sha256;
    /// The resolved text of the terrain file that gave the heights; empty for any other bed.
    std::string terrain;
    /// A sentence for each assumption that a reader of the file made.
    std::vector<std::string> notes;

    // The unit, sign and level that were applied to the given heights.
    BedUnit unit = BedUnit::m;
    BedSign sign = BedSign::up;
    double level = 0.0;  // [m]

    double cell() const { return domain.step(0); }
    std::span<const float> given() const { return source.empty() ? heights : source; }
};

/// Heights as given, before a sea places them.
struct GivenBed {
    Domain grid{.origin = {}, .size = {}, .samples = {}, .wraps = false};  // its origin is ignored
    PageVector<float> heights = {};
    std::string terrain = {};
    std::vector<std::string> notes = {};
};

/// Throws Error invalid_value for a grid whose sides have other than kMinBedSide .. kMaxBedSide
/// samples or are longer than kMaxBedSize, and for cells that are not square.
void require_bed_grid(const Domain& grid);

/// Returns the bed of the given heights with the origin, unit, sign and level of `water`: height =
/// given * unit * sign - level. Throws as require_bed_grid, and Error invalid_value with the number
/// and the first place of heights that are NaN or beyond kMaxElevation.
std::shared_ptr<const SeaBed> make_sea_bed(GivenBed given, const Water& water);

/// Returns the bed at the position that `water` states, which is `bed` itself if it lies there
/// already. Throws as make_sea_bed.
std::shared_ptr<const SeaBed> placed_bed(const std::shared_ptr<const SeaBed>& bed,
                                         const Water& water);

/// Returns true if two waters have the same given heights, or both have no bed.
bool same_bed(const Water& a, const Water& b);
/// Throws Error invalid_value if the bed has not been read, or lies elsewhere than the parameters
/// state.
void validate_bed(const Water& water);

/// Returns the length of a unit [m].
double metres_of(BedUnit unit);

/// Facts about a bed, for a user.
struct SeaBedSummary {
    std::array<int, 2> samples{};
    double cell = 0.0;     // [m]
    double lowest = 0.0;   // [m]
    double highest = 0.0;  // [m]
    double mean = 0.0;     // [m]
    double wet = 0.0;      // share of the samples below still water
    double shallow = 0.0;  // share of the samples below still water, but above water.depth
    std::string sha256;
};

/// Returns the facts of a bed in water of that depth.
SeaBedSummary summarize(const SeaBed& bed, const Water& water);

/// Returns a sentence for each assumption of the bed's reader, for each sign of a wrong sign, unit
/// or datum, and for a bed on which waves do not change.
std::vector<std::string> bed_warnings(const SeaBed& bed, const Water& water);

/// The waves that come to a coast, with the properties that a bed must suit.
struct IncomingWaves {
    /// The waves of one system.
    struct System {
        std::string name;              // as in a sea file, or empty if there is one system alone
        double peak_wavelength = 0.0;  // in the open sea [m]
        double direction = 0.0;        // to which they travel [rad]
    };
    std::vector<System> systems;   // the systems that have energy
    double peak_wavelength = 0.0;  // of all systems together [m]
    double period = 0.0;           // of the sea's surface in space [m]
    double depth = 0.0;            // of the open sea [m]
};

/// Returns the waves of a sea. Computes the spectrum of each system. Needs validated parameters.
IncomingWaves incoming_waves(const Parameters& parameters);

/// Returns a sentence for each way in which a bed does not suit its waves: where they come in,
/// water along the sides that is shallower than half a wavelength and than the open sea, land
/// there, more than half of these sides land with deeper water behind (as of a bed that is upside
/// down), or a depth there that is the open sea's in feet; a bed deeper than an open sea whose
/// waves feel its ground; a bed shorter than a wave; cells too coarse for the waves; a surface that
/// repeats within the bed.
std::vector<std::string> coast_warnings(const SeaBed& bed, const IncomingWaves& waves);

/// Returns true for a place over the bed or on its border.
bool is_over(const SeaBed& bed, double x, double y);
/// Returns the height of the bed at a place [m], linear between its samples; beyond the bed, the
/// height of its border.
float bed_height(const SeaBed& bed, double x, double y);
/// Writes bed_height() at the samples of a domain, row-major [j][i]. `heights` must hold
/// domain.count() values.
void write_bed_heights(const SeaBed& bed, const Domain& domain, std::span<float> heights);
/// Returns a sentence if some samples of a region lie beyond the bed, where the sea is open.
std::vector<std::string> region_warnings(const SeaBed& bed, const Domain& region);

}  // namespace ocean
