// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A running sea: its clock, its changes while it runs, and their recording.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "coast_work.hpp"
#include "ocean/internal/hull_drive.hpp"
#include "ocean/internal/preview/sea_maps.hpp"
#include "ocean/ocean.hpp"

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
    std::function<void(std::int64_t done, std::int64_t total)> foam_progress = {};
    gl::AfterStage after_stage = {};  // of SeaMaps
    /// The first picture waits for the coast of a sea over a bed; else the open sea stands for it.
    bool waits_for_coast = false;
};

/// The OpenGL context of the constructor must be current in every call, also in the destructor. A
/// function that throws Error has changed nothing.
class LiveSea {
  public:
    LiveSea(Sea sea, LiveSeaOptions options);

    /// Returns the sea at its time, or two seas that are faded into each other. eye: the place that
    /// the windows of a coast surround [m]. Throws Error.
    preview::DrawnSea show(const std::array<double, 3>& eye = {});

    // The clock of the sea [s].
    double time() const { return time_; }
    /// Advances the clock by `speed` times so many seconds, unless it is paused. A cross-fade
    /// advances also in a pause, and a coast that is ready replaces the one before. Throws Error if
    /// the coast could not be computed; the one before stays.
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
    /// loop, a bed or crests on cue; any other change makes another sea, into which this one fades
    /// over a second, over a bed once its coast is computed. Throws Error, also for a live
    /// parameter that the take plays while nothing is recorded.
    void set(const std::string& name, const std::string& value);
    /// Shows a changed sea, into which this one fades, at the time of the clock. Throws Error.
    void change(Sea sea);
    /// Gives gliding parameters their final values, waits for a coast that is in work and ends a
    /// cross-fade. Gliding goes on while it records.
    void settle();
    /// Fades into another sea, its clock at its start. Throws Error.
    void open(Sea sea);
    /// Called after set() and open(); may be empty.
    std::function<void(const std::string& name, const std::string& value)> after_set;
    std::function<void()> after_open;
    /// Computes the sea anew if the options' `computing` has another answer. Throws Error.
    void compute_anew();
    bool fading() const { return before_ != nullptr; }
    /// Returns what is computed of a coast that is in work, and its share: "delays 40 %"; else "".
    std::string coast_progress() const { return work_ ? work_->progress() : ""; }
    bool coast_in_work() const { return work_ != nullptr; }
    /// Returns whether a query does not wait for the coast.
    bool can_query() const { return has_coast_ || !ocean_->parameters().water.bed; }

    // The take.
    /// Makes live changes events of the take from now on, and drops later events that it has.
    /// Throws Error for a sea with a loop, a bed or crests on cue.
    void start_recording();
    void stop_recording();
    bool recording() const { return recording_; }
    /// Returns the time of the last event, or of the start if the take has none [s].
    double take_end() const;

    // A hull that is driven.
    /// Drives a hull from now on: its track ends here, and goes on as drive() says. Of a hull that
    /// was driven the track stays. Throws Error for a hull that the sea does not have, a loop and a
    /// bed.
    void start_drive(std::size_t hull);
    /// Adds a hull of the default size, at rest at a place [m] with a heading [degrees], and drives
    /// it. Throws Error.
    void drive_new_hull(double x, double y, double heading);
    /// Ends the track of the driven hull where it is now.
    void stop_drive();
    /// Returns the motion of the driven hull; null while none is driven.
    HullDrive* drive() { return drive_ ? &drive_->motion : nullptr; }
    const HullDrive* drive() const { return drive_ ? &drive_->motion : nullptr; }
    /// Returns the number of the driven hull.
    std::size_t driven_hull() const { return drive_->hull; }

    /// Returns the sea to save: as it was opened or changed, with its take.
    const Sea& sea() const { return recording_ ? ocean_->sea() : kept_; }
    /// Returns the shown parameters: those of the sea at its time, gliding.
    const Parameters& now();
    Ocean& ocean() { return *ocean_; }
    const Computing& computing() const { return computing_; }
    /// Returns the seconds until foam that began empty has settled.
    double foam_settling() const;
    /// Returns whether the sea will look different although its clock stands; see SeaMaps.
    preview::Pending pending() const;

  private:
    OceanOptions ocean_options(const Computing& computing) const;
    std::unique_ptr<preview::SeaMaps> make_maps(const Computing& computing) const;
    /// Shows another sea with its clock at a time, into which the sea before fades. The change
    /// waits if a fade is in progress and would jump.
    void fade_to(const Sea& sea, double time);
    /// Shows a sea whose modes are made, into which the one before fades.
    void fade_in(std::unique_ptr<Ocean> next, const Computing& computing, double correlation,
                 double time);
    /// Begins to compute the coast of a sea, which replaces the shown one when it is ready. time:
    /// of its clock then; nothing: the clock goes on.
    void begin_coast(const Sea& sea, std::optional<double> time);
    void end_coast();
    /// Shows another sea at once.
    void become(const Sea& sea);
    void perform(const std::string& name, const std::string& value);
    void begin_drive(Sea sea, std::size_t hull);
    /// Writes the driven hull up to now. Ends the drive, and throws Error, if its track is full.
    void follow_drive();
    /// Gives the driven hull another track, in the shown sea and in the kept one.
    void set_track(std::shared_ptr<const HullTrack> track);
    /// Forgets the drive if the kept sea has another hull in its place.
    void check_drive();

    struct Drive {
        std::size_t hull;
        HullDrive motion;
        std::shared_ptr<const HullTrack> shown;  // its track in both seas
    };

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
    bool waiting_ = false;             // another sea follows when this one has faded in
    std::unique_ptr<CoastWork> work_;  // of kept_
    std::optional<double> work_time_;  // of its clock when it is shown
    bool has_coast_ = false;           // the shown sea's is computed
    bool had_coast_ = false;           // of the sea that fades away
    std::optional<Drive> drive_;
    Parameters now_;
    std::optional<double> now_time_;  // of now_; nothing if it is out of date
};

}  // namespace ocean::app
