// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The `dft` backend: the definition of the surface, summed term by term in double precision, along
// x and then along y. Slow; every other backend is measured against it.

#include "ocean/internal/make_surface.hpp"
#include "ocean/internal/map_request.hpp"
#include "ocean/thread_pool.hpp"
#include "waves/synthesis/mode_grid.hpp"

namespace ocean {

namespace {

/// out[j] = sum_k in[k] exp(+2 pi i j k / N) for values `stride` apart.
class DirectSum {
  public:
    explicit DirectSum(int n) : root_(static_cast<std::size_t>(n)), line_(root_.size()) {
        for (std::size_t i = 0; i < root_.size(); ++i) {
            root_[i] = std::polar(1.0, kTwoPi * static_cast<double>(i) / n);
        }
    }

    void inverse(std::complex<double>* data, std::size_t stride) {
        const std::size_t n = root_.size();
        for (std::size_t k = 0; k < n; ++k) line_[k] = data[k * stride];
        for (std::size_t j = 0; j < n; ++j) {
            double re = 0.0;
            double im = 0.0;
            std::size_t turn = 0;
            for (std::size_t k = 0; k < n; ++k) {
                re += line_[k].real() * root_[turn].real() - line_[k].imag() * root_[turn].imag();
                im += line_[k].real() * root_[turn].imag() + line_[k].imag() * root_[turn].real();
                turn = (turn + j) & (n - 1);
            }
            data[j * stride] = {re, im};
        }
    }

  private:
    std::vector<std::complex<double>> root_;
    std::vector<std::complex<double>> line_;
};

}  // namespace

LinearPlanes<double> synthesize_dft(const MapModes& modes, LinearSet fields, ThreadPool& pool) {
    LinearPlanes<double> planes;
    const auto size = static_cast<std::size_t>(modes.resolution);
    for (const Linear field : kLinears) {
        if (!fields.contains(field)) continue;
        std::vector<std::complex<double>> grid = coefficient_grid<double>(modes, field);
        const auto along = [&](std::size_t line_step, std::size_t stride) {
            pool.for_each_range(modes.resolution, [&](int first, int last) {
                DirectSum sum(modes.resolution);
                for (int line = first; line < last; ++line) {
                    sum.inverse(grid.data() + static_cast<std::size_t>(line) * line_step, stride);
                }
            });
        };
        along(size, 1);
        along(1, size);
        planes[field].resize(grid.size());
        for (std::size_t i = 0; i < grid.size(); ++i) planes[field][i] = grid[i].real();
    }
    return planes;
}

}  // namespace ocean
