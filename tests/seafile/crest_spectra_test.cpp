// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Crests in seas of measured spectra: at their place and time, as the highest points near.
#include "../unit/crest_probe.hpp"
#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/internal/modes.hpp"
#include "ocean/seafile.hpp"
#include "ocean/thread_pool.hpp"
#include "paths.hpp"
#include "testing.hpp"

namespace ocean::test {
namespace {

class CrestOfSpectrum : public testing::TestWithParam<const char*> {};

TEST_P(CrestOfSpectrum, IsTheHighestPointNearItsPlaceAndTime) {
    const std::string text = std::string(
                                 "libocean = 1\n[grid]\nresolution = 128\npatch_size = 600.0\n"
                                 "[[waves]]\nspectrum = \"measured\"\nfile = \"") +
                             GetParam() +
                             "\"\n[[crests]]\ntime = 12.0\nx = 200.0\ny = 340.0\n"
                             "height = \"1.1 Hs\"\n";
    Parameters parameters = parse_sea(text, GetParam(), data_dir() + "/spectra").parameters;
    const DirectionalSpectrum spectrum = make_directional_spectrum(parameters);
    const SpectralMoments moments = spectrum.moments(parameters.water);
    const double peak = Dispersion(parameters.water).wavenumber(moments.peak_omega);
    parameters.surface.shortest_wavelength = kTwoPi / (12.0 * peak);
    const double wanted =
        1.1 * spectrum.moments(parameters.water, parameters.surface.shortest_wavelength)
                  .significant_wave_height();
    ThreadPool pool(1);
    for (const std::uint32_t seed : {1u, 2u}) {
        parameters.seed = seed;
        const Modes modes = make_modes(spectrum, parameters, pool);
        WaveSum sea(modes, parameters.water);
        sea.set_time(12.0);
        EXPECT_NEAR(sea.at_label(200.0, 340.0).height, wanted, 1e-4);
        const Highest highest =
            highest_near(parameters, modes, parameters.crests.front(), 12.0, 0.8);
        EXPECT_NEAR(highest.height / wanted, 1.0, 0.005) << "seed " << seed;
        EXPECT_NEAR(highest.time, 12.0, 0.15) << "seed " << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(Files, CrestOfSpectrum,
                         testing::Values("ndbc_41010.csv", "swan_nz_west_coast.spec",
                                         "ww3_station_44097.spec", "triaxys.DIRSPEC",
                                         "spotter_20180214.json"));

}  // namespace
}  // namespace ocean::test
