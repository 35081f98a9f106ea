// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The radix-2 transform that this library's forerunners used: a full complex map for each field,
// row by row, then column by column with its stride. One thread.
#include <cmath>
#include <complex>
#include <memory>

#include "frame_maps.hpp"
#include "ocean/internal/fft.hpp"

namespace ocean::bench {

namespace {

struct Radix2 {
    explicit Radix2(const Cell& c)
        : cell(c),
          fields(fields_of(FrameKind::vertices)),
          fft(c.resolution()),
          vertices(c.resolution()) {
        const std::size_t size = c.sea->modes.lattice.size();
        for (std::size_t f = 0; f < fields.size(); ++f) {
            maps.emplace_back(size);
            planes.emplace_back(size);
        }
    }

    void frame(double time) {
        const CascadeModes& modes = cell.sea->modes.cascades.front();
        const double tau = cell.sea->modes.tau(time);
        const double step = modes.lattice.wavenumber_step();
        const int n = cell.resolution();
        for (int j = 0; j < n; ++j) {
            const auto ky = static_cast<float>(step * signed_wavenumber(j, n));
            for (int i = 0; i < n; ++i) {
                const auto kx = static_cast<float>(step * signed_wavenumber(i, n));
                spectra(modes,
                        static_cast<std::size_t>(j) * static_cast<std::size_t>(n) +
                            static_cast<std::size_t>(i),
                        static_cast<std::size_t>(mirror_index(j, n)) * static_cast<std::size_t>(n) +
                            static_cast<std::size_t>(mirror_index(i, n)),
                        kx, ky, tau);
            }
        }
        PlanarFields result;
        result.row_stride = static_cast<std::size_t>(n);
        for (std::size_t f = 0; f < fields.size(); ++f) {
            fft.transform_2d(maps[f], FftDirection::inverse);
            for (std::size_t i = 0; i < planes[f].size(); ++i) planes[f][i] = maps[f][i].real();
            result.plane[static_cast<std::size_t>(fields[f])] = planes[f].data();
        }
        const auto outputs = vertices.outputs();
        write_rows(result, n, 0, n, {0.0, VertexMaps::settings(), outputs, {}}, cell.level);
    }

    void spectra(const CascadeModes& modes, std::size_t at, std::size_t mirror, float kx, float ky,
                 double tau) {
        const double turns =
            (static_cast<double>(modes.rate_high[at]) + static_cast<double>(modes.rate_low[at])) *
            tau;
        const auto phase = static_cast<float>((turns - std::nearbyint(turns)) * kTwoPi);
        const std::complex<float> turn(std::cos(phase), std::sin(phase));
        const std::complex<float> a = modes.h0[at];
        const std::complex<float> b = std::conj(modes.h0[mirror]);
        const std::complex<float> h = {
            (a.real() + b.real()) * turn.real() + (a.imag() - b.imag()) * turn.imag(),
            (a.imag() + b.imag()) * turn.real() + (b.real() - a.real()) * turn.imag()};
        const std::complex<float> derivative(-h.imag(), h.real());
        maps[0][at] = h;
        maps[1][at] = -kx * modes.displacement[at] * derivative;
        maps[2][at] = -ky * modes.displacement[at] * derivative;
        maps[3][at] = kx * derivative;
        maps[4][at] = ky * derivative;
    }

    Cell cell;
    std::vector<Linear> fields;
    Radix2Fft<float> fft;
    std::vector<std::vector<std::complex<float>>> maps;
    std::vector<std::vector<float>> planes;
    VertexMaps vertices;
};

}  // namespace

Subject make_radix2(const Cell& cell) {
    const auto state = std::make_shared<Radix2>(cell);
    Subject result;
    result.library = "radix-2";
    result.variant = "five complex maps, 1 thread";
    result.frame = [state](double time) { state->frame(time); };
    result.field = [state](Linear field) { return state->vertices.field(field); };
    result.normal = [state](Channel channel) { return state->vertices.normal(channel); };
    return result;
}

}  // namespace ocean::bench
