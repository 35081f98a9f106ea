// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea that runs: its clock, and changes of it while it runs.
#pragma once

#include <memory>
#include <string>

#include "ocean/ocean.hpp"
#include "ocean/preview/sea_maps.hpp"

namespace ocean::app {

/// Seconds of the sea over those of the wall.
class SeaClock {
  public:
    explicit SeaClock(double start) : time_(start) {}

    double time() const { return time_; }
    /// Goes on by so many seconds of the wall; a pause is no time.
    void advance(double wall_seconds) {
        if (!paused) time_ += speed * wall_seconds;
    }
    void go_to(double time) { time_ = time; }

    bool paused = false;
    double speed = 1.0;

  private:
    double time_;
};

class LiveSea {
  public:
    /// maps: as SeaMaps takes them; the context must be current. most_cascades: the renderer's.
    LiveSea(Sea sea, int threads, const preview::SeaMapsOptions& maps, std::size_t most_cascades);

    preview::ShownSea show();
    /// So many seconds of the wall go by, for the clock and for a sea that fades into another.
    void advance(double wall_seconds);
    bool fading() const { return before_ != nullptr; }
    /// A live parameter glides to it from now on, as in a take; the others, and all of a sea that
    /// has a loop, make another sea, into which this one fades over a second. Throws Error, and
    /// changes nothing, of a live parameter at a time before the last that was performed too.
    void set(const std::string& name, const std::string& value);
    /// Another sea, its clock at its start.
    void open(Sea sea);

    /// With everything that was performed.
    const Sea& sea() const { return ocean_.sea(); }
    /// Of the sea at its time, gliding: what is shown.
    const Parameters& now();
    Ocean& ocean() { return ocean_; }
    /// Seconds until foam that began empty is what it always is.
    double foam_settling() const {
        return static_cast<double>(maps_->foam_settling_ticks(ocean_)) *
               ocean_.parameters().surface.foam_step;
    }

    /// The last time that something was performed at; the start where nothing was.
    double performed_until() const { return performed_until_; }

    SeaClock clock;

  private:
    void change(Sea sea);

    OceanOptions options_;
    Ocean ocean_;
    std::unique_ptr<preview::SeaMaps> maps_;
    std::size_t most_cascades_;
    // The sea that fades away, its own clock, and how far it has gone: 0 .. 1.
    std::unique_ptr<Ocean> before_;
    std::unique_ptr<preview::SeaMaps> maps_before_;
    double time_before_ = 0.0;
    double faded_ = 0.0;
    double performed_until_;
    Parameters now_;
    double now_time_ = 0.0;
    bool now_known_ = false;
};

}  // namespace ocean::app
