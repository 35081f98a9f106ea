// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The chain of one time: parameters -> spectrum -> modes -> settings of the shown surface, each
// made when it is asked for and kept while nothing dirties it.
//
// Every stage has a revision, another one whenever its parameters change; what was made for
// another revision is made again. Modes that a change has made wrong stay: their arrays are filled
// again, unless a copy of the chain has them too.
#pragma once

#include <array>
#include <map>
#include <memory>

#include "base/shared_value.hpp"
#include "ocean/modes.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/stage_runs.hpp"

namespace ocean {

class ModeLattice;

/// A copy shares what there is, for another thread.
class Chain {
  public:
    /// Whether other parameters are to be expected, as a take brings them with every time: then
    /// what only rebuilds need is kept from the first.
    enum class Lasts { until_a_change, one_time };

    /// Stands for nothing yet.
    Chain() = default;

    /// From now on for these parameters, which must be valid.
    void stand_for(Parameters parameters, Lasts lasts);
    const Parameters& parameters() const { return parameters_; }

    // Valid until the chain stands for something else.
    const DirectionalSpectrum& spectrum(ThreadPool& pool, StageRuns& runs);
    const Modes& modes(ThreadPool& pool, StageRuns& runs);
    bool has_modes() const;
    /// Of what spectrum() returns.
    const Revision& spectrum_revision() const { return revision(Stage::spectrum); }
    /// With the whitecaps' threshold found for maps of that resolution.
    const SurfaceSettings& shown_settings(int resolution, ThreadPool& pool, StageRuns& runs);
    /// The power of foam that is the cover on maps of that resolution.
    double shown_cover_power(int resolution, ThreadPool& pool, StageRuns& runs);

  private:
    static constexpr std::size_t kStages = static_cast<std::size_t>(Stage::clock) + 1;

    const Revision& revision(Stage stage) const {
        return revisions_[static_cast<std::size_t>(stage)];
    }
    void dirty(Stage first);
    void make_modes(ThreadPool& pool, StageRuns& runs);

    template <typename T>
    struct Made {
        Revision revision;
        T value{};
    };

    Parameters parameters_;
    Lasts lasts_ = Lasts::until_a_change;
    std::array<Revision, kStages> revisions_;
    Made<std::shared_ptr<const DirectionalSpectrum>> spectrum_;
    std::shared_ptr<const ModeLattice> lattice_;
    SharedValue<Modes> modes_;  // with their own revision
    std::map<int, Made<SurfaceSettings>> shown_;
    std::map<int, Made<double>> cover_powers_;
};

}  // namespace ocean
