// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads of the signals, by the loop of this machine's instruction set; see signal_code.hpp.
#include "coast/loops/band_signals.hpp"
#include "coast/loops/signal_task.hpp"
#include "ocean/error.hpp"

namespace ocean {

void BandSignals::read(std::size_t index, std::size_t n, const double* x, const double* y,
                       const SignalOutputs& out) const {
    if (out.has_rate() && !has_rates_) {
        throw Error(ErrorKind::invalid_value, "the signals were made without their rates");
    }
    CoastBandSector pair;
    describe(index, pair);
    SignalTask task{};
    task.count = n;
    task.x = x;
    task.y = y;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        task.cells_per_metre[axis] = pair.cells_per_metre[axis];
        task.mask[axis] = pair.mask[axis];
        task.half_turns[axis] = pair.half_turns[axis];
    }
    task.value = {pair.values.data(), pair.pitch};
    task.rate = {pair.rates.data(), pair.pitch};
    task.out = out;
    loop_(task);
}

void BandSignals::describe(std::size_t index, CoastBandSector& pair) const {
    const BandSector& of = band_sectors_[index];
    const double period = of.lattice.period;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        pair.cells_per_metre[axis] = of.side[axis] / period;
        pair.mask[axis] = static_cast<std::uint32_t>(of.side[axis] - 1);
        pair.half_turns[axis] = 2.0 * of.lattice.carrier[axis] / period;
    }
    pair.pitch = of.map[0].pitch;
    pair.values = of.map[0].values;
    pair.rates = of.map[1].values;
}

}  // namespace ocean
