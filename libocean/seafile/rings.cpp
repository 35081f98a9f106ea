// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Files of rings: see measured_rings.hpp.
#include <array>
#include <cmath>
#include <optional>

#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/csv_rows.hpp"
#include "ocean/internal/measured_rings.hpp"
#include "ocean/internal/text.hpp"

namespace ocean {
namespace {

constexpr std::array<std::string_view, 2> kColumns = {"wavenumber", "density"};
constexpr std::array<std::string_view, 2> kUnits = {"rad/m", "m^4"};

/// Returns the indices of the two columns. Throws for a unit that differs from the format's.
std::array<std::size_t, 2> find_columns(const csv::TableReader& table) {
    std::array<std::optional<std::size_t>, 2> places;
    std::string titles;
    for (std::size_t i = 0; i < table.titles().size(); ++i) {
        const csv::Title title = csv::parse_title(table.titles()[i]);
        titles += (i == 0 ? "" : ", ") + text::printable(title.name, 30);
        for (std::size_t column = 0; column < kColumns.size(); ++column) {
            if (title.name != kColumns[column]) continue;
            if (places[column]) {
                throw table.lines().fail("the column " + title.name + " is repeated");
            }
            if (!title.unit.empty() && title.unit != kUnits[column]) {
                throw table.lines().fail("the unit '" + text::printable(title.unit, 30) + "' of " +
                                         title.name +
                                         " is unknown; allowed: " + std::string(kUnits[column]));
            }
            places[column] = i;
        }
    }
    for (std::size_t column = 0; column < kColumns.size(); ++column) {
        if (places[column]) continue;
        throw table.lines().fail("the header line lacks the column " +
                                 std::string(kColumns[column]) + "; it has " +
                                 text::printable(titles, 100));
    }
    return {*places[0], *places[1]};
}

double number_of(csv::TableReader& table, std::size_t place, std::size_t column) {
    const std::optional<double> number = table.number(place);
    const bool positive = column == 0;
    if (number && std::isfinite(*number) && (positive ? *number > 0.0 : *number >= 0.0)) {
        return *number;
    }
    throw table.lines().fail(std::string(kColumns[column]) + " = '" +
                             text::printable(table.cell(place), 30) + "'; allowed is a number " +
                             (positive ? "above 0" : "of at least 0"));
}

}  // namespace

MeasuredRings parse_rings(std::string_view content, const std::string& name) {
    csv::TableReader table(content, name);
    if (table.titles().empty()) {
        throw text::error_at(ErrorKind::bad_file, name, 0,
                             "has no rings: the first line names the columns wavenumber, density");
    }
    const std::array<std::size_t, 2> places = find_columns(table);
    MeasuredRings rings;
    double sum = 0.0;
    while (table.next()) {
        const double wavenumber = number_of(table, places[0], 0);
        if (!rings.wavenumber.empty() && wavenumber <= rings.wavenumber.back()) {
            throw table.lines().fail("wavenumber = " + shortest_text(wavenumber) + " follows " +
                                     shortest_text(rings.wavenumber.back()) +
                                     "; wavenumbers must increase");
        }
        if (rings.wavenumber.size() == kMaxRings) {
            throw table.lines().fail("more than the " + std::to_string(kMaxRings) +
                                     " rings allowed");
        }
        rings.wavenumber.push_back(wavenumber);
        rings.density.push_back(number_of(table, places[1], 1));
        sum += rings.density.back();
    }
    if (rings.wavenumber.size() < kMinRings) {
        throw table.lines().fail("fewer than the " + std::to_string(kMinRings) + " rings required");
    }
    if (!(sum > 0.0 && std::isfinite(sum))) {
        throw table.lines().fail("the densities must be finite and not all 0");
    }
    return rings;
}

MeasuredRings read_rings(const std::string& path) {
    return parse_rings(text::read_file(path, kMaxRingsBytes), path);
}

}  // namespace ocean
