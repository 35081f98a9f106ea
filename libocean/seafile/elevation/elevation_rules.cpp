// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Units, degrees, holes and limits of elevation models: see elevation_rules.hpp.
#include "ocean/internal/elevation_rules.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include "ocean/internal/memory.hpp"
#include "ocean/text.hpp"

namespace ocean {

double metres_of(HeightUnit unit) {
    switch (unit) {
        case HeightUnit::metre:
            break;
        case HeightUnit::foot:
            return 0.3048;
        case HeightUnit::us_survey_foot:
            return 1200.0 / 3937.0;
    }
    return 1.0;
}

namespace elevation {
namespace {

constexpr double kMaxCoordinate = 1e9;  // [m or degrees]

Error bad_file(const std::string& name, const std::string& message) {
    return text::error_at(ErrorKind::bad_file, name, 0, message);
}

/// Returns "row 3 from the north, column 17" of a height.
std::string place_of(const Domain& domain, std::size_t index) {
    const std::size_t columns = static_cast<std::size_t>(domain.samples[0]);
    const std::size_t row = static_cast<std::size_t>(domain.samples[1]) - index / columns;
    return "row " + std::to_string(row) + " from the north, column " +
           std::to_string(index % columns + 1);
}

/// Returns true if the numbers of a header look like longitudes and latitudes. A grid that begins
/// at (0, 0) has an origin of its own.
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
    if (raw.metres_per_unit == 1.0) return;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        model.domain.origin[axis] *= raw.metres_per_unit;
        model.domain.size[axis] *= raw.metres_per_unit;
    }
    model.crs = "LOCAL_CS[\"metres of " + crs_name(model.crs) + "\",UNIT[\"metre\",1]]";
    model.notes.push_back("the horizontal unit of the file is " +
                          shortest_text(raw.metres_per_unit) + " m; cell and origin are metres");
}

/// Returns a note for each common mark for missing heights that is a height of the file. What the
/// file declares is no height any more.
std::vector<std::string> notes_of_marks(std::span<const float> heights) {
    constexpr std::array kMarks = {-32768.0f, -32767.0f, -9999.0f, -99999.0f, 32767.0f};
    std::array<std::size_t, kMarks.size()> counts{};
    for (const float height : heights) {
        for (std::size_t i = 0; i < kMarks.size(); ++i) counts[i] += height == kMarks[i] ? 1 : 0;
    }
    std::vector<std::string> notes;
    for (std::size_t i = 0; i < kMarks.size(); ++i) {
        if (counts[i] == 0) continue;
        notes.push_back(
            (counts[i] == 1 ? "1 height is " : std::to_string(counts[i]) + " heights are ") +
            shortest_text(kMarks[i]) +
            ", a common mark for missing heights, which the file does not declare; " +
            (counts[i] == 1 ? "it is kept" : "they are kept"));
    }
    return notes;
}

/// Converts heights to metres, positive upwards. Throws for one beyond kMaxElevation.
void scale_heights(RawModel& raw, const std::string& name, const ElevationOptions& options) {
    ElevationModel& model = raw.model;
    const HeightUnit unit = options.unit.value_or(raw.height_unit.value_or(HeightUnit::metre));
    const double metres = metres_of(unit);
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
    if (!options.unit && raw.height_unit && *raw.height_unit != HeightUnit::metre) {
        model.notes.push_back("the heights of the file are feet; they are converted to metres");
    }
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

ElevationModel make_model(const std::string& name, std::int64_t columns, std::int64_t rows,
                          const std::array<double, 2>& south_west_centre,
                          const std::array<double, 2>& cell) {
    require_sides(name, columns, rows);
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
    require_memory(4 * static_cast<std::uint64_t>(columns * rows),
                   name + ": an elevation model of " + std::to_string(columns) + " x " +
                       std::to_string(rows) + " cells",
                   "cut it into parts, or make its cells larger");
    ElevationModel model;
    model.domain = {.origin = south_west_centre,
                    .size = {cell[0] * static_cast<double>(columns - 1),
                             cell[1] * static_cast<double>(rows - 1)},
                    .samples = {static_cast<int>(columns), static_cast<int>(rows)},
                    .wraps = false};
    model.heights.resize(model.domain.count());
    return model;
}

bool is_fill_value(double value) {
    constexpr double kNoHeight = 1e30;
    return !(std::abs(value) < kNoHeight);
}

ElevationModel finish(RawModel raw, const std::string& name, const ElevationOptions& options) {
    std::vector<std::string> marks;
    if (!raw.has_shades) marks = notes_of_marks(raw.model.heights);
    scale_domain(raw, name, options.degrees);
    scale_heights(raw, name, options);
    std::ranges::move(marks, std::back_inserter(raw.model.notes));
    apply_holes(raw.model, name, options.holes);
    raw.model.crs = without_local_names(raw.model.crs);
    return std::move(raw.model);
}

}  // namespace elevation
}  // namespace ocean
