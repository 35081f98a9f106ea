// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "region_argument.hpp"

#include <array>

#include "ocean/internal/text.hpp"

namespace ocean::app {

std::vector<Option> region_options(RegionArgument& argument) {
    return {{"--region", &argument.region, "X0,Y0,X1,Y1",
             "Only this rectangle [m], of a land or of a sea with a bed or hulls; needs --cell"},
            {"--cell", &argument.cell, "METRES",
             "Distance of the samples of --region: neighbouring regions of one cell that share an "
             "edge join without a seam"}};
}

std::optional<Region> parse_region(const RegionArgument& argument) {
    if (argument.region.empty() && argument.cell.empty()) return std::nullopt;
    if (argument.region.empty() || argument.cell.empty()) {
        refuse("--region and --cell: give both, such as --region 0,0,500,500 --cell 2");
    }
    const std::vector<std::string> numbers = split(argument.region, ',');
    std::array<double, 4> corner{};
    if (numbers.size() != corner.size()) {
        refuse("--region " + argument.region + ": four numbers are needed, X0,Y0,X1,Y1");
    }
    for (std::size_t i = 0; i < corner.size(); ++i) {
        corner[i] = parse_number(numbers[i], "--region", -1e8, 1e8);
    }
    if (!(corner[2] > corner[0] && corner[3] > corner[1])) {
        refuse("--region " + argument.region + ": X1 must be above X0, and Y1 above Y0");
    }
    return Region{{corner[0], corner[1]},
                  {corner[2] - corner[0], corner[3] - corner[1]},
                  parse_number(argument.cell, "--cell", 1e-3, 1e6)};
}

}  // namespace ocean::app
