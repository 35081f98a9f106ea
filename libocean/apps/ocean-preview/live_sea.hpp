// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea that runs: its clock, changes of it while it runs, and what of them is recorded.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "ocean/ocean.hpp"
#include "ocean/preview/sea_maps.hpp"

namespace ocean::app {

/// How a sea is computed: by compute shaders in the current context, as `maps` say, or else by the
/// sea's own backend.
struct Computing {
    Backend backend = Backend::cpu;
    preview::SeaMapsOptions maps;

    bool operator==(const Computing&) const = default;
};

struct LiveSeaOptions {
    int threads = 0;
    /// Throws Error where it cannot be computed.
    std::function<Computing(const Sea&)> computing;
    /// Of foam by the sea's backend; that of computed maps is in `computing`.
    FoamStart foam_start = FoamStart::empty;
};

/// Needs the context that was current when it was made to be current in every call, the destructor
/// too. All that throws Error then has changed nothing.
class LiveSea {
  public:
    LiveSea(Sea sea, LiveSeaOptions options);

    preview::ShownSea show();

    // The clock: seconds of the sea over those of the wall.
    double time() const { return time_; }
    /// So many seconds of the wall go by; a pause is none, but for a sea that fades into another.
    void advance(double wall_seconds);
    /// Back in time a recording ends, and what glided is as it was saved.
    void go_to(double time);
    bool paused = false;
    /// The waves too short for the maps are shown too.
    bool near_detail = true;
    double speed = 1.0;
    /// Seconds from the sea's start after which it plays from there again; nothing: it goes on.
    /// Not while it records.
    std::optional<double> play_again_after;

    // Changes of it.
    /// A live parameter glides to the value from now on, unless the sea has a loop; what else is
    /// changed makes another sea, into which this one fades over a second. Throws Error, of what
    /// the take plays while nothing is recorded too.
    void set(const std::string& name, const std::string& value);
    /// What glides is where it was going, at once. Not while it records.
    void settle();
    /// Another sea, its clock at its start.
    void open(Sea sea);
    /// Called when they have: for who must be told.
    std::function<void(const std::string& name, const std::string& value)> after_set;
    std::function<void()> after_open;
    /// The options' `computing` has another answer.
    void compute_anew();
    bool fading() const { return before_ != nullptr; }

    // The take.
    /// From now on live changes are events of the take; those that it had from now on are dropped.
    /// Throws Error of a sea with a loop.
    void start_recording();
    void stop_recording();
    bool recording() const { return recording_; }
    /// When the last event is; the start where there is none.
    double take_end() const;

    /// What is to be saved: the sea as it was opened or changed, and its take.
    const Sea& sea() const { return recording_ ? ocean_->sea() : kept_; }
    /// Of the sea at its time, gliding: what is shown.
    const Parameters& now();
    Ocean& ocean() { return *ocean_; }
    const Computing& computing() const { return computing_; }
    /// Seconds until foam that began empty is what it always is.
    double foam_settling() const;
    /// Returns whether the sea will look otherwise though its clock stands; see SeaMaps.
    preview::Pending pending() const { return maps_->pending(); }

  private:
    OceanOptions ocean_options(const Computing& computing) const;
    /// The shown sea is another one from now on, its clock at that time, and the one before fades
    /// into it. Where that would be a jump, for one fades already, it waits.
    void fade_to(const Sea& sea, double time);
    /// The shown sea is that one, at once.
    void become(const Sea& sea);
    void perform(const std::string& name, const std::string& value);

    LiveSeaOptions options_;
    Computing computing_;
    Sea kept_;  // what is saved while nothing is recorded
    bool recording_ = false;
    double time_;
    double performed_until_;        // nothing may be performed before
    std::unique_ptr<Ocean> ocean_;  // what is shown: with glides that no take has
    std::unique_ptr<preview::SeaMaps> maps_;
    // The sea that fades away, its own clock, how far it has gone: 0 .. 1, and how much of its
    // waves the other one has too.
    std::unique_ptr<Ocean> before_;
    std::unique_ptr<preview::SeaMaps> maps_before_;
    double time_before_ = 0.0;
    double faded_ = 0.0;
    double correlation_ = 0.0;
    bool waiting_ = false;  // another sea is to come when this one has faded in
    Parameters now_;
    std::optional<double> now_time_;  // of them; nothing if they are not known
};

}  // namespace ocean::app
