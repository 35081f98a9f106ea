// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea with its division into pairs, and reads of it that several tests share.
#pragma once

#include "coast/loops/band_signals.hpp"
#include "ocean/thread_pool.hpp"
#include "test_seas.hpp"

namespace ocean::test {

struct DividedSea {
    Parameters parameters;
    Modes modes;
    ShoreBands bands;
    double height;  // significant [m]

    explicit DividedSea(const Parameters& of) : parameters(of) {
        ThreadPool pool(1);
        const DirectionalSpectrum spectrum = make_directional_spectrum(parameters, pool);
        modes = make_modes(spectrum, parameters, pool);
        bands = choose_bands(spectrum, parameters);
        height = spectrum.moments(parameters.water).significant_wave_height();
    }
};

struct Places {
    std::vector<double> x, y;

    Places(std::size_t n, double from, double to) {
        std::mt19937 numbers(7);
        std::uniform_real_distribution<double> anywhere(from, to);
        for (std::size_t i = 0; i < n; ++i) {
            x.push_back(anywhere(numbers));
            y.push_back(anywhere(numbers));
        }
    }
    std::size_t size() const { return x.size(); }
};

/// Returns the sum of the real parts of all pairs.
inline std::vector<double> height_of_pairs(const BandSignals& signals, const Places& at) {
    std::vector<double> sum(at.size());
    std::vector<float> re(at.size());
    for (std::size_t pair = 0; pair < signals.count(); ++pair) {
        signals.read(pair, at.size(), at.x.data(), at.y.data(), {.re = re.data()});
        for (std::size_t i = 0; i < at.size(); ++i) sum[i] += static_cast<double>(re[i]);
    }
    return sum;
}

}  // namespace ocean::test
