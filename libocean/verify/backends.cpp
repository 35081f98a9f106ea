// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Instruction sets, reference backends and the GPU against sums in double precision.
#include <algorithm>
#include <complex>
#include <string>
#include <vector>

#include "bench.hpp"
#include "literature.hpp"
#include "map_statistics.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/fft.hpp"
#include "ocean/internal/kernel_backends.hpp"
#include "ocean/internal/make_surface.hpp"
#include "ocean/internal/modes.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::verify {
namespace {

using Complex = std::complex<double>;

/// Heights and slopes of a sea at a time, by a transform in double precision of its modes.
struct ExactMaps {
    std::vector<double> height, slope_x, slope_y;

    ExactMaps(const Modes& modes, double time, int size) {
        const auto cells = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
        // One transform has two fields: the second one as the imaginary part.
        std::vector<Complex> heights(cells), slopes(cells);
        for (const CascadeModes& cascade : modes.cascades)
            add(cascade, modes, time, size, heights, slopes);
        const Radix2Fft<double> fft(size);
        fft.transform_2d(heights, FftDirection::inverse);
        fft.transform_2d(slopes, FftDirection::inverse);
        for (std::size_t i = 0; i < cells; ++i) {
            height.push_back(heights[i].real());
            slope_x.push_back(slopes[i].real());
            slope_y.push_back(slopes[i].imag());
        }
    }

  private:
    static void add(const CascadeModes& cascade, const Modes& modes, double time, int size,
                    std::vector<Complex>& heights, std::vector<Complex>& slopes) {
        const int n = cascade.lattice.resolution;
        const double dk = 2.0 * kPi / modes.lattice.period;
        const auto index = [&](int i, int j, int side) {
            return static_cast<std::size_t>((j + side) % side) * static_cast<std::size_t>(side) +
                   static_cast<std::size_t>((i + side) % side);
        };
        for (int j = 1 - n / 2; j < n / 2; ++j) {
            for (int i = 1 - n / 2; i < n / 2; ++i) {
                const int x = i * cascade.divisor, y = j * cascade.divisor;
                if (std::max(std::abs(x), std::abs(y)) >= size / 2) continue;
                const std::size_t at = index(i, j, n), mirrored = index(-i, -j, n);
                const double turns = (static_cast<double>(cascade.rate_high[at]) +
                                      static_cast<double>(cascade.rate_low[at])) *
                                     modes.tau(time);
                const Complex turn = std::polar(1.0, -2.0 * kPi * (turns - std::floor(turns)));
                const Complex h = Complex(cascade.h0[at]) * turn +
                                  std::conj(Complex(cascade.h0[mirrored]) * turn);
                const std::size_t to = index(x, y, size);
                heights[to] += h;
                slopes[to] += h * Complex(0.0, 1.0) * (dk * Complex(x, y));
            }
        }
    }
};

void equal_bits_row(Bench& bench, const Parameters& parameters) {
    const std::span<const Backend> kernels = kernel_backends();
    Row row{.id = "backends.equal_bits",
            .claim = "All instruction sets give the same bits",
            .reference = "values of the instruction set in use",
            .method =
                "samples that differ, of height, offset, normal, Jacobian and whitecap; N = "
                "128; compared: " +
                joined(kernels, ", ", &Backend::name),
            .tolerance = 0.0,
            .bound = "none may differ"};
    const ChannelSet channels = {Channel::height,   Channel::dx,      Channel::dy,
                                 Channel::nx,       Channel::ny,      Channel::nz,
                                 Channel::jacobian, Channel::whitecap};
    Ocean sea(parameters, bench.options());
    const Modes& modes = sea.modes();
    std::vector<Surface> maps;
    for (const Backend& kernel : kernels) {
        maps.push_back(make_surface(modes, parameters.surface, 12.0, channels, kernel, bench.pool));
    }
    for (int c = 0; c < kChannelCount; ++c) {
        const auto channel = static_cast<Channel>(c);
        if (!channels.contains(channel)) continue;
        const std::span<const float> first = maps.front().channel(channel);
        for (const Surface& map : maps) {
            const std::span<const float> other = map.channel(channel);
            for (std::size_t i = 0; i < first.size(); ++i) {
                if (first[i] != other[i]) row.measured += 1.0;
            }
        }
    }
    bench.add(std::move(row));
}

/// The modes themselves: heights at some places by the sum that the equations say.
void sum_row(Bench& bench, const Parameters& parameters) {
    Ocean sea(parameters, bench.options());
    const Surface map = sea.evaluate(12.0, {Channel::height});
    const CascadeModes& waves = sea.modes().cascades.front();
    const int n = waves.lattice.resolution;
    const double dk = 2.0 * kPi / waves.lattice.period;
    std::vector<double> sums, values;
    for (int sample = 0; sample < 16; ++sample) {
        const int x = 7 * sample % n, y = 23 * sample % n;
        double height = 0.0;
        for (int j = 1 - n / 2; j < n / 2; ++j) {
            for (int i = 1 - n / 2; i < n / 2; ++i) {
                if (i == 0 && j == 0) continue;
                const auto at = static_cast<std::size_t>((j + n) % n * n + (i + n) % n);
                const double omega =
                    angular_frequency(dk * std::hypot(i, j), parameters.water.depth);
                const double phase = 2.0 * kPi * (i * x + j * y) / n - omega * 12.0;
                height += 2.0 * std::real(Complex(waves.h0[at]) * std::polar(1.0, phase));
            }
        }
        sums.push_back(height);
        values.push_back(
            static_cast<double>(map.channel(Channel::height)[static_cast<std::size_t>(y * n + x)]));
    }
    bench.add({.id = "backends.sum_of_waves",
               .claim = "A map is the sum of its waves",
               .reference = "[Tessendorf 2001]: h = 2 Re sum h0 exp(i (k x - omega t)), omega of "
                            "[Lamb 1932]",
               .method = "rms of the difference over the rms of heights at 16 samples, t = 12 s, N "
                         "= 128, L = 150 m",
               .measured = relative_error(values, sums),
               .tolerance = 1e-6,
               .bound = "1e-6 of single precision"});
}

}  // namespace

Row precision_row(Bench& bench, const Parameters& parameters, const Backend& backend, Row row) {
    const int size = parameters.grid.resolution;
    row.reference = "a transform in double precision of the same modes";
    row.method =
        "largest of the rms differences of height and slopes over their rms, t = 12 and 1e6 "
        "s" +
        row.method;
    row.tolerance = 1e-6;
    row.bound = "1e-6 of single precision";
    if (backend.fitness != nullptr) {
        const BackendFitness fitness = backend.fitness(size);
        row.method += fitness.reason.empty() ? "" : "; " + fitness.reason;
        if (!fitness.runs) row.not_run = fitness.reason;
        if (!fitness.runs) return row;
    }
    try {
        Ocean sea(parameters, bench.options());
        for (const double time : {12.0, 1e6}) {
            const ExactMaps exact(sea.modes(), time, size);
            const Surface map = make_surface(sea.modes(), parameters.surface, time,
                                             {Channel::height, Channel::slope_x, Channel::slope_y},
                                             backend, bench.pool, size);
            for (const auto& [channel, values] : {std::pair{Channel::height, &exact.height},
                                                  std::pair{Channel::slope_x, &exact.slope_x},
                                                  std::pair{Channel::slope_y, &exact.slope_y}}) {
                row.measured =
                    std::max(row.measured, relative_error(map.channel(channel), *values));
            }
        }
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::no_gpu) throw;
        row.not_run = error.what();
    }
    return row;
}

void verify_backends(Bench& bench) {
    Parameters parameters = wind_sea(10.0, 100e3, 128, 150.0);
    sum_row(bench, parameters);
    equal_bits_row(bench, parameters);
    std::vector<Backend> backends(kernel_backends().begin(), kernel_backends().end());
    backends.push_back(Backend::radix2);
    backends.push_back(Backend::dft);
    backends.insert(backends.end(), bench.request.backends.begin(), bench.request.backends.end());
    for (const Backend& backend : backends) {
        bench.add(precision_row(bench, parameters, backend,
                                {.id = "backends.precision_" + std::string(backend.name),
                                 .claim = "Linear fields by " + std::string(backend.name),
                                 .method = ", N = 128, L = 150 m"}));
    }
    if (!bench.request.backends.empty()) return;
    bench.add({.id = "backends.precision_gl",
               .claim = "Linear fields by gl",
               .not_run = "this program was built without a GPU library"});
}

}  // namespace ocean::verify
