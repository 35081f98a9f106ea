// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A running sea: its clock, its changes while it runs, and their recording.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "ocean/ocean.hpp"
#include "ocean/preview/sea_maps.hpp"

namespace ocean::app {

/// How a sea is computed: by compute shaders in the current context if `maps` say so, else by the
/// sea's own backend.
struct Computing {
    Backend backend = Backend::cpu;
    preview::SeaMapsOptions maps;

    bool operator==(const Computing&) const = default;
};

struct LiveSeaOptions {
    int threads = 0;
    /// Returns how to compute a sea. Throws Error if it cannot be computed.
    std::function<Computing(const Sea&)> computing;
    /// Start of the foam of the sea's own backend; `computing` has that of compute shaders.
    FoamStart foam_start = FoamStart::empty;
};

/// The OpenGL context of the constructor must be current in every call, also in the destructor. A
/// function that throws Error has changed nothing.
class LiveSea {
  public:
    LiveSea(Sea sea, LiveSeaOptions options);

    /// Returns the sea at its time, or two seas that are faded into each other. Throws Error.
    preview::ShownSea show();

    // The clock of the sea [s].
    double time() const { return time_; }
    /// Advances the clock by `speed` times so many seconds, unless it is paused. A cross-fade
    /// advances also in a pause.
    void advance(double wall_seconds);
    /// Sets the clock. A step back ends a recording, and gliding parameters have their saved
    /// values.
    void go_to(double time);
    bool paused = false;
    /// Shows the waves too short for the maps.
    bool near_detail = true;
    double speed = 1.0;  // seconds of the sea in a second
    /// Seconds from the sea's start after which it starts again, except while it records; nothing:
    /// it goes on.
    std::optional<double> play_again_after;

    // Changes.
    /// Sets a parameter. A live parameter glides to the value from now on, unless the sea has a
    /// loop; any other change makes another sea, into which this one fades over a second. Throws
    /// Error, also for a live parameter that the take plays while nothing is recorded.
    void set(const std::string& name, const std::string& value);
    /// Gives gliding parameters their final values and ends a cross-fade. Gliding goes on while it
    /// records.
    void settle();
    /// Fades into another sea, its clock at its start. Throws Error.
    void open(Sea sea);
    /// Called after set() and open(); may be empty.
    std::function<void(const std::string& name, const std::string& value)> after_set;
    std::function<void()> after_open;
    /// Computes the sea anew if the options' `computing` has another answer. Throws Error.
    void compute_anew();
    bool fading() const { return before_ != nullptr; }

    // The take.
    /// Makes live changes events of the take from now on, and drops later events that it has.
    /// Throws Error for a sea with a loop.
    void start_recording();
    void stop_recording();
    bool recording() const { return recording_; }
    /// Returns the time of the last event, or of the start if the take has none [s].
    double take_end() const;

    /// Returns the sea to save: as it was opened or changed, with its take.
    const Sea& sea() const { return recording_ ? ocean_->sea() : kept_; }
    /// Returns the shown parameters: those of the sea at its time, gliding.
    const Parameters& now();
    Ocean& ocean() { return *ocean_; }
    const Computing& computing() const { return computing_; }
    /// Returns the seconds until foam that began empty has settled.
    double foam_settling() const;
    /// Returns whether the sea will look different although its clock stands; see SeaMaps.
    preview::Pending pending() const { return maps_->pending(); }

  private:
    OceanOptions ocean_options(const Computing& computing) const;
    /// Shows another sea with its clock at a time, into which the sea before fades. The change
    /// waits if a fade is in progress and would jump.
    void fade_to(const Sea& sea, double time);
    /// Shows another sea at once.
    void become(const Sea& sea);
    void perform(const std::string& name, const std::string& value);

    LiveSeaOptions options_;
    Computing computing_;
    Sea kept_;  // what is saved while nothing is recorded
    bool recording_ = false;
    double time_;
    double performed_until_;        // no change may be performed before
    std::unique_ptr<Ocean> ocean_;  // the shown sea, with glides that no take has
    std::unique_ptr<preview::SeaMaps> maps_;
    // The sea that fades away, its clock, its progress 0 .. 1, and the correlation of its waves
    // with those of the shown sea.
    std::unique_ptr<Ocean> before_;
    std::unique_ptr<preview::SeaMaps> maps_before_;
    double time_before_ = 0.0;
    double faded_ = 0.0;
    double correlation_ = 0.0;
    bool waiting_ = false;  // another sea follows when this one has faded in
    Parameters now_;
    std::optional<double> now_time_;  // of now_; nothing if it is out of date
};

}  // namespace ocean::app
