// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Units, degrees, holes and limits of elevation models: see elevation_rules.hpp.
#include "ocean/internal/elevation_rules.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "ocean/internal/memory.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/sea_bed.hpp"

namespace ocean {

namespace elevation {
namespace {

constexpr double kMaxCoordinate = 1e9;  // [m or degrees]

Error bad_file(const std::string& name, const std::string& message) {
    return text::error_at(ErrorKind::bad_file, name, 0, message);
}

/// Returns "row 3 from the north, column 17" for a height.
std::string place_of(const Domain& domain, std::size_t index) {
    const std::size_t columns = static_cast<std::size_t>(domain.samples[0]);
    const std::size_t row = static_cast<std::size_t>(domain.samples[1]) - index / columns;
    return "row " + std::to_string(row) + " from the north, column " +
           std::to_string(index % columns + 1);
}

/// Returns true if the numbers of a header look like longitudes and latitudes. A grid that begins
/// at (0, 0) has a local origin.
bool looks_geographic(const Domain& domain) {
    const std::array<double, 2> half = {0.5 * domain.step(0), 0.5 * domain.step(1)};
    const double west = domain.origin[0] - half[0], south = domain.origin[1] - half[1];
    const double east = domain.origin[0] + domain.size[0] + half[0];
    const double north = domain.origin[1] + domain.size[1] + half[1];
    const bool own_origin =
        (west == 0.0 && south == 0.0) || (domain.origin[0] == 0.0 && domain.origin[1] == 0.0);
    constexpr double kSlack = 1e-6;
    return !own_origin && domain.step(0) < 1.0 && domain.step(1) < 1.0 && west >= -360.0 - kSlack &&
           east <= 360.0 + kSlack && south >= -90.0 - kSlack && north <= 90.0 + kSlack;
}

std::string degrees_note(const ElevationModel& model, const std::string& why) {
    const std::array<double, 2>& cell = model.geographic_cell;
    return "cells of " + significant_text(cell[0], 10) + " x " + significant_text(cell[1], 10) +
           " degrees" + why + " are " + fixed_text(model.domain.step(0), 3) + " m x " +
           fixed_text(model.domain.step(1), 3) + " m at the latitude of the centre, " +
           fixed_text(model.geographic_origin[1] + 0.5 * cell[1] * (model.domain.samples[1] - 1),
                      4);
}

/// Scales a map whose unit is not the metre. Returns false for a map in metres.
bool scale_unit(RawModel& raw) {
    if (raw.metres_per_unit == 1.0) return false;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        raw.model.domain.origin[axis] *= raw.metres_per_unit;
        raw.model.domain.size[axis] *= raw.metres_per_unit;
    }
    raw.model.notes.push_back("the horizontal unit of the file is " +
                              shortest_text(raw.metres_per_unit) +
                              " m; cell and origin are metres");
    return true;
}

/// Scales the cells of a map that stretches the ground, as Mercator's does: slopes and wavelengths
/// are then the ground's. Returns false for another map. The origin stays the map's.
bool scale_to_ground(RawModel& raw, const std::string& system) {
    const std::array<double, 2>& scale = raw.ground_scale;
    if (scale == std::array{1.0, 1.0}) return false;
    Domain& domain = raw.model.domain;
    const auto cell = [&] {
        return significant_text(domain.step(0), 6) + " m x " + significant_text(domain.step(1), 6) +
               " m";
    };
    const std::string of_map = cell();
    for (std::size_t axis = 0; axis < 2; ++axis) domain.size[axis] *= scale[axis];
    raw.model.notes.push_back("cells of " + of_map + (system.empty() ? "" : " of " + system) +
                              " are " + cell() +
                              " on the ground at the centre of the map, to which they are scaled; "
                              "the origin is that of the map");
    return true;
}

/// Scales the domain to metres.
void scale_domain(RawModel& raw, const std::string& name, CellsInDegrees requested) {
    ElevationModel& model = raw.model;
    const bool guessed = requested == CellsInDegrees::automatic && !raw.is_geographic;
    const bool degrees = guessed ? looks_geographic(model.domain)
                         : requested == CellsInDegrees::automatic
                             ? *raw.is_geographic
                             : requested == CellsInDegrees::yes;
    if (degrees) {
        try {
            scale_degrees(model);
        } catch (const Error& error) {
            throw text::error_at(Error(ErrorKind::bad_file, error.what()), name, 0);
        }
        const bool stated = raw.is_geographic.value_or(false);
        const std::string why =
            guessed  ? " (guessed from the coordinates; the file does not name its unit)"
            : stated ? ""
                     : " (as requested)";
        model.notes.push_back(degrees_note(model, why));
        return;
    }
    if (requested == CellsInDegrees::no && raw.is_geographic.value_or(false)) {
        model.notes.push_back("the file has cells of degrees, which are metres as requested");
    }
    if (is_mercator(model.crs)) {
        model.notes.push_back(
            "the map of the file is Mercator's, which stretches the ground, twice at 60 degrees "
            "north or south; cells are metres of the map, those of a GeoTIFF would be scaled");
    }
    const std::string system = crs_name(model.crs);
    const bool scaled = scale_unit(raw);
    if (!scale_to_ground(raw, system) && !scaled) return;
    model.crs =
        "LOCAL_CS[\"metres" + (system.empty() ? "" : " of " + system) + "\",UNIT[\"metre\",1]]";
    model.crs_definition.clear();
}

/// Adds a note for each common mark for missing heights that the file contains as a sample. Marks
/// that the file declares have already been replaced.
void note_marks(const RawModel& raw, std::vector<std::string>& notes) {
    for (const double mark : {-32768.0, -32767.0, -9999.0, -99999.0, 32767.0}) {
        const auto height = static_cast<float>(raw.sample_scale[0] * mark + raw.sample_scale[1]);
        const auto count = std::ranges::count(raw.model.heights, height);
        if (count == 0) continue;
        const bool is_one = count == 1;
        notes.push_back(std::to_string(count) + (is_one ? " height is " : " heights are ") +
                        shortest_text(mark) +
                        ", a common mark for missing heights, which the file does not declare; " +
                        (is_one ? "it is kept" : "they are kept"));
    }
}

/// Converts heights to metres, positive upwards. Throws for a height beyond kMaxElevation.
void scale_heights(RawModel& raw, const std::string& name, const ElevationOptions& options) {
    ElevationModel& model = raw.model;
    const double metres = options.unit ? metres_of(*options.unit) : raw.height_unit.value_or(1.0);
    const double factor = options.sign == HeightSign::down ? -metres : metres;
    for (std::size_t i = 0; i < model.heights.size(); ++i) {
        float& height = model.heights[i];
        if (std::isnan(height)) continue;
        const double scaled = factor * double{height};
        if (!(std::abs(scaled) <= kMaxElevation)) {
            throw bad_file(name, "the height " + shortest_text(height) + " in " +
                                     place_of(model.domain, i) +
                                     " is out of range; allowed: -100000 .. 100000 m, or the "
                                     "file's own value for a missing height" +
                                     raw.hint);
        }
        height = static_cast<float>(scaled);
    }
    if (options.unit || metres == 1.0) return;
    const bool is_foot = std::abs(metres / metres_of(HeightUnit::ft) - 1.0) < 1e-5;
    model.notes.push_back("the heights of the file are " +
                          (is_foot ? "feet" : "in units of " + shortest_text(metres) + " m") +
                          "; they are converted to metres");
}

}  // namespace

void apply_holes(ElevationModel& model, const std::string& name, HolePolicy policy) {
    const auto holes = static_cast<std::size_t>(
        std::ranges::count_if(model.heights, [](float h) { return std::isnan(h); }));
    if (holes == 0) return;
    if (holes == model.heights.size()) throw bad_file(name, "has no heights, only holes");
    const std::string share =
        std::to_string(holes) + " of " + std::to_string(model.heights.size()) + " heights (" +
        significant_text(
            100.0 * static_cast<double>(holes) / static_cast<double>(model.heights.size()), 2) +
        " %)";
    if (policy == HolePolicy::refuse) {
        throw bad_file(name, share +
                                 " are missing; they can be filled with the smooth surface "
                                 "around them (holes: fill)");
    }
    if (policy == HolePolicy::fill) {
        fill_holes(model.heights, model.domain.samples[0]);
        model.notes.push_back(share +
                              " were missing and are filled with the smooth surface around "
                              "them");
    }
}

void require_sides(const std::string& name, std::int64_t columns, std::int64_t rows) {
    for (const std::int64_t side : {columns, rows}) {
        if (side >= kMinElevationSide && side <= kMaxElevationSide) continue;
        throw bad_file(name, "has " + std::to_string(columns) + " x " + std::to_string(rows) +
                                 " cells; allowed: 2 .. 65536 along each side");
    }
}

Domain make_domain(const std::string& name, std::int64_t columns, std::int64_t rows,
                   const std::array<double, 2>& south_west_centre,
                   const std::array<double, 2>& cell) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
        if (!(cell[axis] > 0.0 && cell[axis] <= kMaxCoordinate)) {
            throw bad_file(name, "has cells of " + shortest_text(cell[0]) + " x " +
                                     shortest_text(cell[1]) + "; allowed are positive sizes");
        }
        if (!(std::abs(south_west_centre[axis]) <= kMaxCoordinate)) {
            throw bad_file(name, "has an origin of (" + shortest_text(south_west_centre[0]) + ", " +
                                     shortest_text(south_west_centre[1]) +
                                     "); allowed: -1e9 .. 1e9");
        }
    }
    return {.origin = south_west_centre,
            .size = {cell[0] * static_cast<double>(columns - 1),
                     cell[1] * static_cast<double>(rows - 1)},
            .samples = {static_cast<int>(columns), static_cast<int>(rows)},
            .wraps = false};
}

void allocate_heights(ElevationModel& model, const std::string& name) {
    const std::int64_t columns = model.domain.samples[0], rows = model.domain.samples[1];
    require_sides(name, columns, rows);
    require_memory(4 * static_cast<std::uint64_t>(columns * rows),
                   name + ": an elevation model of " + std::to_string(columns) + " x " +
                       std::to_string(rows) + " cells",
                   "cut it into parts, or make its cells larger");
    model.heights.resize(model.domain.count());
}

double rounding_of(std::string_view word) {
    constexpr int kDigitsOfRounding = 6;
    const std::size_t end = std::min(word.find_first_of("eE"), word.size());
    int digits = 0, decimals = 0;
    bool has_point = false;
    for (const char c : word.substr(0, end)) {
        has_point |= c == '.' || c == ',';
        if (c < '0' || c > '9') continue;
        decimals += has_point ? 1 : 0;
        digits += digits > 0 || c != '0' ? 1 : 0;
    }
    if (digits < kDigitsOfRounding) return 0.0;
    const double exponent =
        end < word.size() ? text::parse_number(word.substr(end + 1)).value_or(0.0) : 0.0;
    return 0.5 * std::pow(10.0, exponent - decimals);
}

bool MissingMark::matches(double height, std::string_view word) const {
    if (height == value || static_cast<float>(height) == static_cast<float>(value)) return true;
    const double difference = std::abs(height - value);
    constexpr double kMaxRounding = 5e-6;  // half of the last of six digits, relative
    if (!(difference <= 1.001 * kMaxRounding * std::abs(value))) return false;
    // A whole number in a header is exact.
    const double of_header = value == std::floor(value) ? 0.0 : rounding;
    constexpr double kSlack = 1e-9;  // allows a tie to fall on either side
    return difference <= (1.0 + kSlack) * std::max(of_header, rounding_of(word));
}

bool is_fill_value(double value) {
    constexpr double kNoHeight = 1e30;
    return !(std::abs(value) < kNoHeight);
}

GridWindow crop_window(const RawModel& raw, const std::string& name,
                       const ElevationOptions& options) {
    RawModel frame;
    frame.model.domain = raw.model.domain;
    frame.is_geographic = raw.is_geographic;
    frame.metres_per_unit = raw.metres_per_unit;
    if (options.crop_in_degrees && raw.is_geographic == false) {
        throw Error(ErrorKind::invalid_value,
                    "--crop in degrees: " + name + " has cells of metres");
    }
    if (!options.crop_in_degrees) scale_domain(frame, name, options.degrees);
    const Domain& whole = frame.model.domain;
    std::array<std::int64_t, 2> first{}, count{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double step = whole.step(axis), end = whole.samples[axis] - 1;
        const double low = ((*options.crop)[axis] - whole.origin[axis]) / step;
        const double high = ((*options.crop)[axis + 2] - whole.origin[axis]) / step;
        first[axis] = static_cast<std::int64_t>(std::ceil(std::clamp(low, 0.0, end + 1.0)));
        count[axis] =
            static_cast<std::int64_t>(std::floor(std::clamp(high, -1.0, end))) - first[axis] + 1;
        if (count[axis] >= kMinElevationSide) continue;
        throw Error(ErrorKind::invalid_value,
                    "--crop leaves fewer than 2 x 2 cells; the centres lie within " +
                        plain_text(whole.origin[0]) + "," + plain_text(whole.origin[1]) + "," +
                        plain_text(whole.origin[0] + whole.size[0]) + "," +
                        plain_text(whole.origin[1] + whole.size[1]));
    }
    return {first[0], first[1], count[0], count[1]};
}

/// Keeps a window of a model, in the file's units.
static void keep_window(ElevationModel& model, const GridWindow& window) {
    const Domain whole = model.domain;
    const auto columns = static_cast<std::size_t>(window.columns);
    PageVector<float> kept;
    kept.reserve(columns * static_cast<std::size_t>(window.rows));
    for (std::int64_t j = window.south; j < window.south + window.rows; ++j) {
        const float* const row = model.heights.data() + j * whole.samples[0] + window.west;
        kept.insert(kept.end(), row, row + columns);
    }
    model.heights = std::move(kept);
    model.domain = {
        .origin = whole.place(static_cast<int>(window.west), static_cast<int>(window.south)),
        .size = {whole.step(0) * static_cast<double>(window.columns - 1),
                 whole.step(1) * static_cast<double>(window.rows - 1)},
        .samples = {static_cast<int>(window.columns), static_cast<int>(window.rows)},
        .wraps = false};
}

ElevationModel finish(RawModel raw, const std::string& name, const ElevationOptions& options) {
    if (options.crop) keep_window(raw.model, crop_window(raw, name, options));
    std::vector<std::string> marks;
    if (!raw.has_shades) note_marks(raw, marks);
    scale_domain(raw, name, options.degrees);
    scale_heights(raw, name, options);
    std::ranges::move(marks, std::back_inserter(raw.model.notes));
    apply_holes(raw.model, name, options.holes);
    raw.model.crs = without_local_names(raw.model.crs);
    return std::move(raw.model);
}

}  // namespace elevation
}  // namespace ocean
