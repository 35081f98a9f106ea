// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The modes that no pair of a coast holds; see band_signals.hpp.
#include <algorithm>
#include <complex>
#include <cstdlib>

#include "coast/loops/band_lattice.hpp"
#include "coast/loops/band_signals.hpp"

namespace ocean {

namespace {

/// The sums over a shell of |h0|^2 k^4 (coth(kd) / k)^2, the trace of its covariance of gradients.
struct ShellGradients {
    double all = 0.0;
    double remaining = 0.0;
};

void remove_band_sectors(const ShoreBands& bands, double patch_step, CascadeModes& cascade) {
    const int size = cascade.lattice.resolution;
    const double step = cascade.lattice.wavenumber_step();
    std::vector<ShellGradients> shells(cascade.shell_covariance.size());
    for (int m = -size / 2; m < size / 2; ++m) {
        for (int n = -size / 2; n < size / 2; ++n) {
            std::complex<float>& h0 = cascade.h0[mode_index(n, m, size)];
            if (h0 == 0.0f) continue;
            const double k2 =
                step * step * (static_cast<double>(n) * n + static_cast<double>(m) * m);
            const double factor = k2 * cascade.displacement[mode_index(n, m, size)];
            const double gradient = std::norm(std::complex<double>(h0)) * factor * factor;
            const bool in_pair =
                band_sector_of(bands, patch_step, n * cascade.divisor, m * cascade.divisor) >= 0;
            const auto shell = static_cast<std::size_t>(std::max(std::abs(n), std::abs(m)));
            if (shell < shells.size()) {
                shells[shell].all += gradient;
                if (!in_pair) shells[shell].remaining += gradient;
            }
            if (in_pair) h0 = 0.0f;
        }
    }
    for (std::size_t s = 0; s < shells.size(); ++s) {
        if (shells[s].all > 0.0) {
            cascade.shell_covariance[s] *= shells[s].remaining / shells[s].all;
        }
    }
}

}  // namespace

Modes open_remainder(const Modes& modes, const ShoreBands& bands) {
    Modes remainder = modes;
    for (CascadeModes& cascade : remainder.cascades) {
        remove_band_sectors(bands, modes.lattice.wavenumber_step(), cascade);
    }
    remainder.revision = Revision::begin();
    return remainder;
}

}  // namespace ocean
