// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A file of rings gives wavenumbers and densities, whatever further columns it has. What is refused
// stands in sentences/rings.toml.

#include "helpers.hpp"
#include "ocean/internal/measured_rings.hpp"
#include "temporary_folder.hpp"

namespace ocean {
namespace {

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

TEST(Rings, AreAtMost4096) {
    std::string many = "wavenumber,density\n";
    for (int i = 1; i <= 4097; ++i) many += std::to_string(i) + ",1\n";
    EXPECT_EQ(test::message_of([&] { parse_rings(many, "r.csv"); }),
              "r.csv:4098: more than the 4096 rings allowed");
}

}  // namespace
}  // namespace ocean
