// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What the corpus does not show of WAVEWATCH III: the weights of rounded directions over a whole
// file, and numbers as Fortran writes them.

#include <tuple>

#include "formats/fortran_number.hpp"
#include "helpers.hpp"

namespace ocean::test {
namespace {

TEST(Wavewatch, RoundedDirectionsOfAnEvenCircleWeighTheSame) {
    for (const SpectrumRecord& record : read_spectra(kData + "/spectra/ww3_station_44097.spec")) {
        for (std::size_t i = 0; i < record.frequency.size(); ++i) {
            double sum = 0.0;
            for (std::size_t j = 0; j < 36; ++j) sum += record.directional_density[i * 36 + j];
            EXPECT_NEAR(record.density[i], 10.0 * sum, 1e-12 + 1e-9 * record.density[i]);
        }
    }
}

TEST(Wavewatch, NumbersAreReadAsFortranWritesThem) {
    const std::tuple<std::string, double, std::string> numbers[] = {
        {"0.261E-17", 0.261e-17, ""},
        {"0.123-100 x", 0.123e-100, " x"},
        {"0.123+100", 0.123e100, ""},
        {"0.1D-02 ", 0.1e-2, " "},
        {"-1.5d+1", -15.0, ""},
        {"+.5", 0.5, ""},
        {"5.", 5.0, ""},
        {"40.98-171.12", 40.98, "-171.12"},
        {"40.98-7.12", 40.98, "-7.12"},
        {"0.1E-02-0.2E-02", 0.1e-2, "-0.2E-02"},
        {"12-100", 12.0, "-100"},
        {"40.98-71 ", 40.98, "-71 "},
    };
    for (const auto& [spelled, value, after] : numbers) {
        std::string_view rest = spelled;
        EXPECT_EQ(text::next_fortran_number(rest), value) << spelled;
        EXPECT_EQ(rest, after) << spelled;
    }
    for (const std::string none : {"", ".", "-", "E5", "1E", "1E+", "1.2.3", "****", "nan", "inf",
                                   "1x", "1E999", "--1", "0x10", "1,5"}) {
        std::string_view rest = none;
        EXPECT_EQ(text::next_fortran_number(rest), std::nullopt) << none;
        EXPECT_EQ(rest, none);
    }
}

}  // namespace
}  // namespace ocean::test
