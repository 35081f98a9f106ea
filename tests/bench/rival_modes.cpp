// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// From Modes of one cascade to the arrays of the rivals.
#include "rival_modes.hpp"

#include "ocean/internal/directional_spectrum.hpp"

namespace ocean::bench {

RivalModes::RivalModes(const Modes& modes, int columns)
    : columns_(static_cast<std::size_t>(columns)) {
    const CascadeModes& cascade = modes.cascades.front();
    const int n = cascade.lattice.resolution;
    const auto width = static_cast<std::size_t>(n);
    const auto step = static_cast<float>(cascade.lattice.wavenumber_step());
    const auto wavenumber = [&](int i) {
        return step * static_cast<float>(signed_wavenumber(i, n));
    };
    for (int i = 0; i < columns; ++i) kx_.push_back(wavenumber(i));
    for (int j = 0; j < n; ++j) ky_.push_back(wavenumber(j));

    for (HugeArray<float>* array :
         {&p_re_, &p_im_, &q_re_, &q_im_, &rate_high_, &rate_low_, &displacement_}) {
        *array = HugeArray<float>(width * columns_);
    }
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < columns; ++i) {
            const std::size_t from =
                static_cast<std::size_t>(j) * width + static_cast<std::size_t>(i);
            const std::size_t mirror = static_cast<std::size_t>(mirror_index(j, n)) * width +
                                       static_cast<std::size_t>(mirror_index(i, n));
            const std::size_t to =
                static_cast<std::size_t>(j) * columns_ + static_cast<std::size_t>(i);
            const std::complex<float> a = cascade.h0[from];
            const std::complex<float> b = std::conj(cascade.h0[mirror]);
            p_re_[to] = a.real() + b.real();
            p_im_[to] = a.imag() + b.imag();
            q_re_[to] = a.imag() - b.imag();
            q_im_[to] = b.real() - a.real();
            rate_high_[to] = cascade.rate_high[from];
            rate_low_[to] = cascade.rate_low[from];
            displacement_[to] = cascade.displacement[from];
        }
    }
}

SpectralRow RivalModes::row(int j, double tau) const {
    const std::size_t at = static_cast<std::size_t>(j) * columns_;
    const auto tau_high = static_cast<float>(tau);
    return {p_re_.data() + at,
            p_im_.data() + at,
            q_re_.data() + at,
            q_im_.data() + at,
            rate_high_.data() + at,
            rate_low_.data() + at,
            displacement_.data() + at,
            kx_.data(),
            ky_[static_cast<std::size_t>(j)],
            tau_high,
            static_cast<float>(tau - static_cast<double>(tau_high)),
            static_cast<int>(columns_)};
}

namespace {

Parameters sea_parameters(int resolution) {
    Parameters parameters;
    parameters.grid.resolution = resolution;
    parameters.grid.patch_size = 0.5 * resolution;
    parameters.water.depth = 200.0;
    parameters.water.surface_tension = 0.0;
    return parameters;
}

}  // namespace

Sea::Sea(int resolution, ThreadPool& pool)
    : parameters(sea_parameters(resolution)),
      modes(make_modes(make_directional_spectrum(parameters), parameters, pool)) {}

}  // namespace ocean::bench
