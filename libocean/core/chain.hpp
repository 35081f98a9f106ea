// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The chain of one time: parameters -> spectrum -> modes -> settings of the displayed surface. Each
// stage is computed when it is first needed and kept until a parameter dirties it.
//
// Every stage has a revision, which changes whenever its parameters do; a result of another
// revision is computed again. Outdated modes keep their arrays, which are filled again, unless a
// copy of the chain shares them.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <vector>

#include "base/shared_value.hpp"
#include "ocean/internal/foam.hpp"
#include "ocean/internal/modes.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/sea.hpp"

namespace ocean {

class ModeLattice;
struct SeaState;

/// A copy shares all results with the original; it is for another thread.
class Chain {
  public:
    /// Expected changes. animated: every time has other parameters, as with a take, so data that
    /// only rebuilds need is kept from the first build on. static_sea: from the second build on.
    enum class Reuse { static_sea, animated };

    /// Has no parameters yet.
    Chain() = default;

    /// Sets the parameters, which must be valid, and dirties the stages that they change. passage:
    /// the states between which the waves are interpolated.
    void set_parameters(Parameters parameters, std::optional<Passage> passage, Reuse reuse);
    const Parameters& parameters() const { return parameters_; }

    // The results are valid until the next set_parameters.
    const DirectionalSpectrum& spectrum(ThreadPool& pool, StageRuns& runs);
    const Modes& modes(ThreadPool& pool, StageRuns& runs);
    bool has_modes() const;
    /// The waves of both ends of a passage.
    struct ModesBetween {
        const Modes& from;
        const Modes& to;
        float share;
    };
    /// Returns the ends of the passage; none if the waves are not interpolated.
    std::optional<ModesBetween> modes_between(ThreadPool& pool, StageRuns& runs);
    /// Returns the revision of the result of spectrum().
    const Revision& spectrum_revision() const { return revision(Stage::spectrum); }
    /// Returns the surface settings with the whitecaps' threshold of maps of that resolution.
    const SurfaceSettings& shown_settings(int resolution, ThreadPool& pool, StageRuns& runs);
    /// Returns the surface settings with the threshold of a foam lattice's whitecaps.
    const SurfaceSettings& past_settings(const FoamLattice& lattice, ThreadPool& pool,
                                         StageRuns& runs);
    /// Returns the exponent p of cover = foam^p.
    double shown_cover_power(const ShownFoam& foam, ThreadPool& pool, StageRuns& runs);
    /// Adds the crests of the sea to a state of it.
    void add_crests(ThreadPool& pool, StageRuns& runs, SeaState& state);

  private:
    static constexpr std::size_t kStages = static_cast<std::size_t>(Stage::clock) + 1;

    const Revision& revision(Stage stage) const {
        return revisions_[static_cast<std::size_t>(stage)];
    }
    /// The waves of one set of parameters.
    struct State {
        Parameters parameters;
        SharedValue<Modes> modes;  // with a revision once they are complete

        bool is_made() const { return modes.get() != nullptr && modes.get()->revision; }
    };

    void dirty(Stage first);
    /// Makes the waves of parameters of this lattice in `modes`, whose arrays it keeps. Returns the
    /// gain of the energy of each cascade.
    std::vector<double> make_modes(const Parameters& parameters,
                                   const DirectionalSpectrum& spectrum, SharedValue<Modes>& modes,
                                   ThreadPool& pool, StageRuns& runs);
    void make_state(const Parameters& parameters, State& state, ThreadPool& pool, StageRuns& runs);
    /// Returns the modes with the wind and the covariances of this time. Their amplitudes may be
    /// those of another.
    const Modes& statistics(ThreadPool& pool, StageRuns& runs);

    template <typename T>
    struct Cached {
        Revision revision;
        T value{};
    };

    Parameters parameters_;
    std::optional<Passage> passage_;
    Reuse reuse_ = Reuse::static_sea;
    std::array<Revision, kStages> revisions_;
    Cached<std::shared_ptr<const DirectionalSpectrum>> spectrum_;
    std::shared_ptr<const ModeLattice> lattice_;
    Revision lattice_revision_;
    SharedValue<Modes> modes_;      // with their own revision
    Revision statistics_revision_;  // of their wind and covariances, while the waves pass
    std::array<State, 2> states_;   // of the ends of a passage, in any order
    std::vector<double> gains_;     // of the energy of each of their cascades
    std::map<int, Cached<SurfaceSettings>> shown_;
    std::map<FoamLattice, Cached<SurfaceSettings>> past_;  // of spread lattices
    std::map<ShownFoam, Cached<double>> cover_powers_;
};

}  // namespace ocean
