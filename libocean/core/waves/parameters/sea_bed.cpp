// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Beds of seas; see sea_bed.hpp.
#include "ocean/sea_bed.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ocean/error.hpp"
#include "ocean/internal/elevation.hpp"
#include "ocean/internal/text.hpp"

namespace ocean {
namespace {

Error bed_error(const std::string& fault, const std::string& allowed) {
    return Error(ErrorKind::invalid_value, {.what = "the bed " + fault, .allowed = allowed});
}

/// Returns the grid at the origin of `water`. The cell is rounded to twelve digits, so that a cell
/// read back from text gives the same bits.
Domain placed_grid(const Domain& grid, const Water& water) {
    constexpr int kDigits = 12;
    const double cell =
        parse_number(significant_text(grid.step(0), kDigits), "cell", 0.0, 2.0 * kMaxBedSize);
    Domain placed = grid;
    placed.origin = water.bed_origin();
    for (std::size_t axis = 0; axis < 2; ++axis) {
        placed.size[axis] = cell * (grid.samples[axis] - 1);
    }
    return placed;
}

/// Throws for heights that are NaN or beyond kMaxElevation; the message names the first of them.
void require_heights(const SeaBed& bed) {
    const auto is_bad = [](float h) { return !(std::abs(double{h}) <= kMaxElevation); };
    const auto bad = std::ranges::count_if(bed.heights, is_bad);
    if (bad == 0) return;
    const auto first = std::ranges::find_if(bed.heights, is_bad) - bed.heights.begin();
    const int i = static_cast<int>(first % bed.domain.samples[0]);
    const int j = static_cast<int>(first / bed.domain.samples[0]);
    const auto [x, y] = bed.domain.place(i, j);
    throw bed_error("has " + std::to_string(bad) + " of " + std::to_string(bed.heights.size()) +
                        " heights that are holes, no numbers or too far from 0, the first at x = " +
                        shortest_text(x) + " m, y = " + shortest_text(y) + " m (column " +
                        std::to_string(i) + ", row " + std::to_string(j) + " from the south-west)",
                    "heights within -1e5 .. 1e5 m; `ocean terrain import --holes fill` fills "
                    "holes");
}

bool is_placed(const SeaBed& bed, const Water& water) {
    return bed.domain.origin == water.bed_origin() && bed.unit == water.seabed_unit &&
           bed.sign == water.seabed_sign && bed.level == water.level;
}

/// Fills in the members that depend on `water`, from the given heights.
void place(SeaBed& bed, PageVector<float> given, const Water& water) {
    bed.domain = placed_grid(bed.domain, water);
    bed.unit = water.seabed_unit;
    bed.sign = water.seabed_sign;
    bed.level = water.level;
    const double scale = metres_of(bed.unit) * (bed.sign == BedSign::up ? 1.0 : -1.0);
    if (scale == 1.0 && bed.level == 0.0) {
        bed.heights = std::move(given);
    } else {
        bed.heights.resize(given.size());
        std::ranges::transform(given, bed.heights.begin(), [&](float h) {
            return static_cast<float>(double{h} * scale - bed.level);
        });
        bed.source = std::move(given);
    }
    require_heights(bed);
}

}  // namespace

void require_bed_grid(const Domain& grid) {
    for (const int side : grid.samples) {
        if (side >= kMinBedSide && side <= kMaxBedSide) continue;
        throw bed_error("has " + std::to_string(grid.samples[0]) + " x " +
                            std::to_string(grid.samples[1]) + " samples",
                        "2 .. 8192 samples a side");
    }
    for (std::size_t axis = 0; axis < 2; ++axis) {
        if (grid.size[axis] > 0.0 && grid.size[axis] <= kMaxBedSize) continue;
        throw bed_error("is " + shortest_text(grid.size[0]) + " m x " +
                            shortest_text(grid.size[1]) + " m large",
                        "sides of at most 100000 m");
    }
    constexpr double kSquare = 1e-6;
    if (std::abs(grid.step(0) / grid.step(1) - 1.0) <= kSquare) return;
    throw bed_error("has cells that are not square: they are " + significant_text(grid.step(0), 9) +
                        " m long to the east and " + significant_text(grid.step(1), 9) +
                        " m to the north",
                    "square cells; `ocean terrain import --square METRES` makes them");
}

double metres_of(BedUnit unit) {
    constexpr double kMetres[] = {1.0, 0.3048, 1200.0 / 3937.0};
    static_assert(std::size(kMetres) == enum_count<BedUnit>());
    return kMetres[static_cast<std::size_t>(unit)];
}

std::shared_ptr<const SeaBed> make_sea_bed(GivenBed given, const Water& water) {
    require_bed_grid(given.grid);
    if (given.heights.size() != given.grid.count()) {
        throw bed_error("has " + std::to_string(given.heights.size()) + " heights",
                        std::to_string(given.grid.count()) + ", one for each sample");
    }
    auto bed = std::make_shared<SeaBed>();
    bed->domain = placed_grid(given.grid, water);
    bed->sha256 = height_hash(bed->domain, given.heights);
    bed->terrain = std::move(given.terrain);
    bed->notes = std::move(given.notes);
    place(*bed, std::move(given.heights), water);
    return bed;
}

std::shared_ptr<const SeaBed> placed_bed(const std::shared_ptr<const SeaBed>& bed,
                                         const Water& water) {
    if (is_placed(*bed, water)) return bed;
    auto moved = std::make_shared<SeaBed>();
    moved->domain = bed->domain;
    moved->sha256 = bed->sha256;
    moved->terrain = bed->terrain;
    moved->notes = bed->notes;
    const std::span<const float> given = bed->given();
    place(*moved, PageVector<float>(given.begin(), given.end()), water);
    return moved;
}

bool same_bed(const Water& a, const Water& b) {
    if (a.bed == b.bed) return true;
    return a.bed != nullptr && b.bed != nullptr && a.bed->sha256 == b.bed->sha256;
}

bool Water::operator==(const Water& other) const {
    return depth == other.depth && gravity == other.gravity &&
           surface_tension == other.surface_tension && density == other.density &&
           seabed == other.seabed && seabed_origin == other.seabed_origin &&
           seabed_unit == other.seabed_unit && seabed_sign == other.seabed_sign &&
           level == other.level && shore == other.shore && same_bed(*this, other);
}

void validate_bed(const Water& water) {
    if (water.seabed_origin.size() == 1 || water.seabed_origin.size() > 2) {
        throw Error(ErrorKind::invalid_value,
                    {.what = "has " + std::to_string(water.seabed_origin.size()) + " numbers",
                     .parameter = "water.seabed_origin",
                     .allowed = "two, x and y, or none for (0, 0)"});
    }
    if (water.bed == nullptr) {
        if (water.seabed.empty()) return;
        throw Error(ErrorKind::invalid_value, {.what = "has not been read",
                                               .parameter = "water.seabed",
                                               .value = "\"" + water.seabed + "\""});
    }
    if (is_placed(*water.bed, water)) return;
    throw Error(
        ErrorKind::invalid_value,
        {.what = "lies elsewhere than seabed_origin, seabed_unit, seabed_sign and level say",
         .parameter = "water.seabed",
         .value = "\"" + water.seabed + "\""});
}

bool is_over(const SeaBed& bed, double x, double y) {
    const auto is_within = [&](double at, std::size_t axis) {
        const double rounding = 1e-6 * bed.cell();
        const double from_side = at - bed.domain.origin[axis];
        return from_side >= -rounding && from_side <= bed.domain.size[axis] + rounding;
    };
    return is_within(x, 0) && is_within(y, 1);
}

float bed_height(const SeaBed& bed, double x, double y) {
    const Domain& domain = bed.domain;
    const double u = std::clamp((x - domain.origin[0]) / domain.step(0), 0.0,
                                static_cast<double>(domain.samples[0] - 1));
    const double v = std::clamp((y - domain.origin[1]) / domain.step(1), 0.0,
                                static_cast<double>(domain.samples[1] - 1));
    const int i = std::min(static_cast<int>(u), domain.samples[0] - 2);
    const int j = std::min(static_cast<int>(v), domain.samples[1] - 2);
    const auto row = [&](int of) {
        const float* const cells =
            bed.heights.data() +
            static_cast<std::size_t>(of) * static_cast<std::size_t>(domain.samples[0]);
        return cells[i] + static_cast<float>(u - i) * (cells[i + 1] - cells[i]);
    };
    return row(j) + static_cast<float>(v - j) * (row(j + 1) - row(j));
}

void write_bed_heights(const SeaBed& bed, const Domain& domain, std::span<float> heights) {
    std::size_t next = 0;
    for (int j = 0; j < domain.samples[1]; ++j) {
        for (int i = 0; i < domain.samples[0]; ++i) {
            const auto [x, y] = domain.place(i, j);
            heights[next++] = bed_height(bed, x, y);
        }
    }
}

}  // namespace ocean
