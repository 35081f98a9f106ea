// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Carved land from its steady state: age, creep, the last flood, masks. See stream_power.hpp.
#include "ocean/internal/stream_power.hpp"

#include "land/streams/stream_creep.hpp"
#include "land/streams/stream_flood.hpp"
#include "land/streams/stream_heights.hpp"
#include "land/streams/stream_land.hpp"
#include "land/streams/stream_masks.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/text.hpp"

namespace ocean {
namespace {

constexpr double kAgeWork = 40.0;  // [ns] a cell

void require(bool holds, const char* parameter, double value, const char* allowed) {
    if (holds) return;
    throw Error(ErrorKind::invalid_value, ErrorFields{.what = "is out of range",
                                                      .parameter = parameter,
                                                      .value = plain_text(value),
                                                      .allowed = allowed});
}

void require_age(double age) {
    require(age >= 0.0 && age <= 1.0, "age", age, "0 .. 1");
}

void validate(const StreamSettings& settings, int columns, int rows, double cell) {
    const auto is_within = [](double value, double min, double max) {
        return value >= min && value <= max;  // false for NaN
    };
    require(is_within(settings.exponent, 0.0, 1.0), "exponent", settings.exponent, "0 .. 1");
    require(is_within(settings.hillslope_area, 1e-3, 1e12), "hillslope_area",
            settings.hillslope_area, "0.001 .. 1e+12 m2");
    require(is_within(settings.slope, 1e-3, 100.0), "slope", settings.slope, "0.001 .. 100");
    require(is_within(settings.max_slope, 1e-3, 100.0), "max_slope", settings.max_slope,
            "0.001 .. 100");
    require_age(settings.age);
    require(is_within(settings.creep, 0.0, 1e6), "creep", settings.creep, "0 .. 1e+06 m");
    require(columns >= kMinStreamSide, "columns", columns, "at least 2");
    require(rows >= kMinStreamSide, "rows", rows, "at least 2");
    require(std::int64_t{columns} * rows <= kMaxStreamCells, "rows", rows,
            "at most 2147483648 cells");
    require(is_within(cell, 1e-3, 1e6), "cell", cell, "0.001 .. 1e+06 m");
}

/// The maps that depend on age.
struct AgedMaps {
    PageVector<float> height;
    PageVector<float> wetness;
    PageVector<float> deposit;
};

/// Returns the maps of an age. Requires area and channel of the land.
AgedMaps aged_maps(const StreamLand& land, double age, StreamWork& work) {
    const StreamTree& tree = *land.tree;
    const StreamGrid& grid = tree.grid;
    AgedMaps maps{PageVector<float>(grid.size()), PageVector<float>(grid.size()),
                  PageVector<float>(grid.size())};
    if (age < 1.0) {
        set_aged(*tree.walk, age * double{tree.last_response}, tree.steady, tree.response,
                 maps.deposit, work);
    }
    PageVector<std::uint8_t> directions(grid.size());
    work.rows(grid, 12.0, [&](int first, int last) {
        for (CellIndex p = grid.index(0, first); p < grid.index(0, last); ++p) {
            const bool is_outlet = tree.directions[p] == kOutlet;
            directions[p] = is_outlet ? kOutlet : kUnseen;
            if (is_outlet || age >= 1.0) maps.deposit[p] = tree.steady[p];
            maps.height[p] = maps.deposit[p];  // the bed below the cover by creep and flood
        }
    });
    creep(grid, land.settings.creep, land.channel, tree.directions, maps.height, work);
    flood(grid, FloodTo::drain, maps.height, directions, work);
    set_wetness(grid, tree.directions, land.area, maps.height, maps.wetness, work);
    set_deposit(grid, *tree.walk, tree.directions, land.area, maps.height, maps.deposit, work);
    return maps;
}

void replace(AgedMaps& maps, double age, StreamLand& land) {
    land.height.swap(maps.height);
    land.wetness.swap(maps.wetness);
    land.deposit.swap(maps.deposit);
    land.settings.age = age;
}

/// Writes the drainage areas and the channels.
void set_areas(const StreamTree& tree, std::span<const std::uint32_t> counts, StreamLand& land,
               StreamWork& work) {
    const double cell_area = tree.grid.cell * tree.grid.cell;
    land.area = PageVector<float>(tree.grid.size());
    land.channel = PageVector<float>(tree.grid.size());
    work.rows(tree.grid, 12.0, [&](int first, int last) {
        for (CellIndex p = tree.grid.index(0, first); p < tree.grid.index(0, last); ++p) {
            land.area[p] = static_cast<float>(counts[p] * cell_area);
            land.channel[p] = tree.directions[p] == kOutlet ? 0.0f : channel_of(land.area[p]);
        }
    });
}

}  // namespace

double work_of_land(const StreamGrid& grid) {
    return static_cast<double>(grid.size()) *
           (kAgeWork + kCreepWork + kFloodWork + kMaskWork + kWalkWork);
}

StreamLand carve(const StreamSettings& settings, int columns, int rows, double cell,
                 const StreamSource& source, ThreadPool& pool, const StreamProgress& progress) {
    validate(settings, columns, rows, cell);
    const StreamGrid grid{columns, rows, cell};
    StreamWork work(pool, progress, work_of_levels(grid) + work_of_land(grid));
    StreamLand land;
    land.columns = columns;
    land.rows = rows;
    land.cell = cell;
    land.settings = settings;
    {
        PageVector<std::uint32_t> counts;
        land.tree = solve_levels(settings, grid, source, counts, work);
        set_areas(*land.tree, counts, land, work);
    }
    AgedMaps maps = aged_maps(land, settings.age, work);
    replace(maps, settings.age, land);
    if (progress) progress(1.0);
    return land;
}

void set_age(StreamLand& land, double age, ThreadPool& pool, const StreamProgress& progress) {
    require_age(age);
    if (land.tree == nullptr) throw Error(ErrorKind::invalid_value, "the land was not carved");
    StreamWork work(pool, progress, work_of_land(land.tree->grid));
    AgedMaps maps = aged_maps(land, age, work);
    if (progress) progress(1.0);
    replace(maps, age, land);
}

std::uint64_t stream_bytes(int columns, int rows) {
    const std::uint64_t cells =
        static_cast<std::uint64_t>(columns) * static_cast<std::uint64_t>(rows);
    // While the age changes: five maps and the tree; three new maps, directions and channels; lists
    // of the flood and the stems. carve needs 40.
    constexpr std::uint64_t kLand = 5 * 4 + 10;
    constexpr std::uint64_t kNewMaps = 3 * 4 + 1 + 4;
    constexpr std::uint64_t kLists = 7;  // at most 5.5 in all lands tried
    return cells * (kLand + kNewMaps + kLists);
}

}  // namespace ocean
