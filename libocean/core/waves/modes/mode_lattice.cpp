// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The properties of a lattice's modes that do not depend on the waves: the position of their cells,
// their noise, their rates. A mode and its three mirror images in the axes have the same frequency
// and weight and, up to signs, direction: everything is computed for one quadrant, a row of modes
// at a time.
#include "waves/modes/mode_lattice.hpp"

#include <algorithm>
#include <cmath>

#include "base/noise_row.hpp"
#include "base/noise_streams.hpp"
#include "ocean/internal/dispersion.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

namespace {

/// Returns the first n in from .. to - 1 for which `beyond` holds; `to` if there is none. `beyond`
/// must hold for all later n too.
template <typename Predicate>
int first_where(int from, int to, const Predicate& beyond) {
    while (from < to) {
        const int middle = from + (to - from) / 2;
        if (beyond(middle)) {
            to = middle;
        } else {
            from = middle + 1;
        }
    }
    return from;
}

/// Appends the point at (x, y) steps of the lattice from the origin.
void add_point(const Dispersion& dispersion, double step, double x, double y, double share,
               QuadrantRow& row) {
    const double k = step * std::sqrt(x * x + y * y);
    const DispersionPoint wave = dispersion.at(k);
    row.omega.push_back(wave.angular_frequency);
    row.direction.push_back(std::atan2(y, x) / kTwoPi);
    row.weight.push_back(share * wave.group_velocity / k * step * step);
}

/// Returns the parameters without those that affect the waves alone, which a live tool may change.
Parameters without_waves(Parameters parameters) {
    parameters.waves.clear();
    return parameters;
}

}  // namespace

ModeLattice::ModeLattice(const Parameters& parameters, Memory memory, ThreadPool& pool)
    : parameters_(without_waves(parameters)),
      kept_(memory == Memory::keep && parameters.grid.resolution <= kLargestKept) {
    for (const CascadeBand& band : cascade_bands(parameters.grid)) {
        add(band, noise_stream(NoiseStream::cascades, static_cast<std::uint32_t>(cascades_.size())),
            pool);
    }
}

ModeLattice::ModeLattice(const Parameters& parameters, const CascadeBand& band, std::uint32_t noise,
                         Memory memory, ThreadPool& pool)
    : parameters_(without_waves(parameters)),
      kept_(memory == Memory::keep && parameters.grid.resolution <= kLargestKept) {
    add(band, noise, pool);
}

void ModeLattice::add(const CascadeBand& band, std::uint32_t noise_number, ThreadPool& pool) {
    const int size = parameters_.grid.resolution;
    const Lattice lattice{size, parameters_.grid.patch_size / band.divisor};
    Cascade& cascade = cascades_.emplace_back(Cascade{band, noise_number, lattice, {}, {}});
    if (!kept_) return;
    cascade.rows.resize(static_cast<std::size_t>(size / 2));
    cascade.noise.resize(lattice.size());
    pool.for_each_range(size / 2, [&](int first, int last) {
        for (int m = first; m < last; ++m) {
            QuadrantRow& row = cascade.rows[static_cast<std::size_t>(m)];
            row = make_row(cascade, m);
            const auto width = static_cast<std::size_t>(size);
            for (const int ky : {m, -m}) {
                const auto at = static_cast<std::size_t>(fft_index(ky, size)) * width;
                const ModeRange all{row.begin, row.end};
                draw_row(cascade, ky, all, all, std::span(cascade.noise).subspan(at, width));
            }
        }
    });
}

std::uint64_t ModeLattice::kept_bytes(const Grid& grid) {
    if (grid.resolution > kLargestKept) return 0;
    // One point for each mode of the quadrant, and further points near the origin.
    constexpr std::uint64_t kMorePoints = 1 << 17;
    const std::uint64_t modes = Lattice{grid.resolution, grid.patch_size}.size();
    const std::uint64_t points = modes / 4 + kMorePoints;
    return static_cast<std::uint64_t>(grid.cascades) *
           (modes * sizeof(std::complex<float>) + points * 3 * sizeof(double));
}

bool ModeLattice::is_of(const Parameters& parameters) const {
    const SurfaceSettings& mine = parameters_.surface;
    const SurfaceSettings& other = parameters.surface;
    return parameters_.grid == parameters.grid && parameters_.water == parameters.water &&
           parameters_.seed == parameters.seed &&
           parameters_.time.loop_period == parameters.time.loop_period &&
           mine.shortest_wavelength == other.shortest_wavelength &&
           mine.longest_wavelength == other.longest_wavelength;
}

QuadrantRow ModeLattice::make_row(const Cascade& cascade, int m) const {
    const int half = cascade.lattice.resolution / 2;
    const double step = cascade.lattice.wavenumber_step();
    const Dispersion dispersion(parameters_.water);
    const auto side_of = [&](int n) { return band_side(parameters_, cascade.band, n, m); };
    const auto cell_side = [&](int n) { return samples_per_cell_side(std::hypot(n, m)); };
    QuadrantRow row;
    row.begin = first_where(0, half, [&](int n) { return side_of(n) != BandSide::too_long; });
    row.end =
        first_where(row.begin, half, [&](int n) { return side_of(n) == BandSide::too_short; });
    row.several = first_where(row.begin, row.end, [&](int n) { return cell_side(n) == 1; });
    for (int n = row.begin; n < row.end; ++n) {
        const int side = n < row.several ? cell_side(n) : 1;
        // A mode on an axis belongs to both neighbouring quadrants and is counted in each.
        const double share = (n == 0 || m == 0 ? 0.5 : 1.0) / (side * side);
        for (int b = 0; b < side; ++b) {
            for (int a = 0; a < side; ++a) {
                add_point(dispersion, step, std::abs(n + sample_offset(a, side)),
                          std::abs(m + sample_offset(b, side)), share, row);
            }
        }
        if (n < row.several) row.points.push_back(static_cast<std::uint32_t>(side * side));
    }
    return row;
}

void ModeLattice::draw_row(const Cascade& cascade, int m, ModeRange east, ModeRange west,
                           std::span<std::complex<float>> noise) const {
    std::fill(noise.begin(), noise.end(), std::complex<float>(0.0f));
    const auto draw = [&](int first, int last) {  // n = first .. last - 1
        if (first >= last) return;
        const auto at = static_cast<std::size_t>(fft_index(first, cascade.lattice.resolution));
        noise_row(parameters_.seed, cascade.noise_number, first, m,
                  noise.subspan(at, static_cast<std::size_t>(last - first)));
    };
    draw(east.begin, east.end);
    draw(1 - west.end, std::min(1 - west.begin, 0));
}

Modes ModeLattice::still_modes(ThreadPool& pool) const {
    Modes modes;
    modes.lattice = {parameters_.grid.resolution, parameters_.grid.patch_size};
    modes.loop_period = parameters_.time.loop_period;
    const int half = modes.lattice.resolution / 2;
    for (const Cascade& cascade : cascades_) {
        CascadeModes& still = modes.cascades.emplace_back();
        still.divisor = cascade.band.divisor;
        still.lattice = cascade.lattice;
        const std::size_t size = cascade.lattice.size();
        still.h0.resize(size);
        still.rate_high.resize(size);
        still.rate_low.resize(size);
        still.displacement.resize(size);
        still.shell_covariance.resize(static_cast<std::size_t>(half));
        pool.for_each_range(half, [&](int first, int last) {
            for (int m = first; m < last; ++m) {
                clear_row(m, still);
                clear_row(m == 0 ? -half : -m, still);
                set_rates(cascade, m, still);
            }
        });
    }
    return modes;
}

/// Clears a row in the thread that will fill it: the first touch of new memory costs about as much
/// as writing its values.
void ModeLattice::clear_row(int m, CascadeModes& modes) {
    const auto width = static_cast<std::size_t>(modes.lattice.resolution);
    const auto at = static_cast<std::size_t>(fft_index(m, modes.lattice.resolution)) * width;
    std::fill_n(&modes.h0[at], width, std::complex<float>(0.0f));
    std::fill_n(&modes.rate_high[at], width, 0.0f);
    std::fill_n(&modes.rate_low[at], width, 0.0f);
    std::fill_n(&modes.displacement[at], width, 0.0f);
}

void ModeLattice::set_rates(const Cascade& cascade, int m, CascadeModes& modes) const {
    const int size = cascade.lattice.resolution;
    // Computed on the lattice of the patch, a mode has the same k to the bit in all cascades that
    // cover it: otherwise the last bit might decide how many turns fit into a loop.
    const double step = kTwoPi / parameters_.grid.patch_size;
    const double y = static_cast<double>(cascade.band.divisor) * m;
    const double loop = parameters_.time.loop_period;
    const Dispersion dispersion(parameters_.water);
    for (int n = m == 0 ? 1 : 0; n < size / 2; ++n) {
        const double x = static_cast<double>(cascade.band.divisor) * n;
        const double k = step * std::sqrt(x * x + y * y);
        const DispersionPoint wave = dispersion.at(k);
        const double omega = wave.angular_frequency;
        const double rate = loop > 0.0 ? turns_per_loop(omega, loop) : omega / kTwoPi;
        const auto high = static_cast<float>(rate);
        const auto low = static_cast<float>(rate - static_cast<double>(high));
        const auto displacement = static_cast<float>(wave.horizontal_displacement / k);
        for (const int ky : {m, -m}) {
            for (const int kx : {n, -n}) {
                const std::size_t at = mode_index(kx, ky, size);
                modes.rate_high[at] = high;
                modes.rate_low[at] = low;
                modes.displacement[at] = displacement;
            }
        }
    }
}

const QuadrantRow& ModeLattice::row_of(const Cascade& cascade, int m, QuadrantRow& made) const {
    if (kept_) return cascade.rows[static_cast<std::size_t>(m)];
    made = make_row(cascade, m);
    return made;
}

}  // namespace ocean
