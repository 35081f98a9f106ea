// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: a file of rings gives wavenumbers and densities, whatever further columns it has; every
// row that is no ring, and every table that is no spectrum, is refused with its line.
#include <gtest/gtest.h>

#include "helpers.hpp"
#include "ocean/internal/measured_rings.hpp"
#include "temporary_folder.hpp"

namespace ocean {
namespace {

using test::refusal_of;

TEST(Rings, AFileHasWavenumbersAndDensities) {
    const MeasuredRings expected{{0.01, 0.02}, {5e6, 0.0}};
    EXPECT_EQ(parse_rings("wavenumber,density,count\n0.01,5e6,2\n0.02,0,7\n", "r.csv"), expected);
    EXPECT_EQ(
        parse_rings("# measured\ncount;Density (m^4);wavenumber [rad/m]\n1;5e6;0,01\n1;0;0,02",
                    "r.csv"),
        expected);
    const test::TemporaryFolder folder;
    std::ofstream(folder.file("r.csv"))
        << "wavenumber,density,model,residual\n0.01,5e6,,\n0.02,0,,";
    EXPECT_EQ(read_rings(folder.file("r.csv")), expected);
}

TEST(Rings, EachBadTableGetsItsSentence) {
    const std::pair<std::string, std::string> all[] = {
        {"", "r.csv: has no rings: the first line names the columns wavenumber, density"},
        {"k,S\n1,2\n", "r.csv:1: the header line lacks the column wavenumber; it has k, s"},
        {"wavenumber\n1\n2\n",
         "r.csv:1: the header line lacks the column density; it has wavenumber"},
        {"wavenumber,density,density\n1,2,3\n", "r.csv:1: the column density is repeated"},
        {"wavenumber (1/m),density\n1,2\n",
         "r.csv:1: the unit '1/m' of wavenumber is unknown; allowed: rad/m"},
        {"wavenumber,density\n1,2\n", "r.csv:2: fewer than the 2 rings required"},
        {"wavenumber,density\n0,2\n", "r.csv:2: wavenumber = '0'; allowed is a number above 0"},
        {"wavenumber,density\ninf,2\n", "r.csv:2: wavenumber = 'inf'; allowed is a number above 0"},
        {"wavenumber,density\n1,-2\n",
         "r.csv:2: density = '-2'; allowed is a number of at least 0"},
        {"wavenumber,density\n1,nan\n",
         "r.csv:2: density = 'nan'; allowed is a number of at least 0"},
        {"wavenumber,density\n1,\n", "r.csv:2: density = ''; allowed is a number of at least 0"},
        {"wavenumber,density\n2,1\n2,1\n",
         "r.csv:3: wavenumber = 2 follows 2; wavenumbers must increase"},
        {"wavenumber,density\n1,0\n2,0\n", "r.csv:3: the densities must be finite and not all 0"},
        {"wavenumber,density\n1,1\n2\n",
         "r.csv:3: fewer cells than the 2 columns of the header line"},
    };
    for (const auto& bad : all) {
        const auto refused = refusal_of([&] { parse_rings(bad.first, "r.csv"); });
        EXPECT_EQ(refused.message, bad.second);
        EXPECT_EQ(refused.kind, ErrorKind::bad_file);
    }
    std::string many = "wavenumber,density\n";
    for (int i = 1; i <= 4097; ++i) many += std::to_string(i) + ",1\n";
    EXPECT_EQ(refusal_of([&] { parse_rings(many, "r.csv"); }).message,
              "r.csv:4098: more than the 4096 rings allowed");
}

}  // namespace
}  // namespace ocean
