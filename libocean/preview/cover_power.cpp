// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "cover_power.hpp"

#include <atomic>
#include <chrono>
#include <future>
#include <utility>

#include "ocean/foam.hpp"

namespace ocean::preview {
namespace {

struct Stopped {};

}  // namespace

/// A solution in work. It owns all that it reads, because the sea changes meanwhile.
struct CoverPower::Job {
    Job(DirectionalSpectrum of, Parameters shown, const FoamWaves& waves, int resolution)
        : spectrum(std::move(of)),
          parameters(std::move(shown)),
          power(std::async(std::launch::async, [this, waves, resolution] {
              ThreadPool pool(1);
              pool.set_interrupt([this] {
                  if (stopped) throw Stopped();
              });
              return cover_power({spectrum, parameters, resolution}, waves, pool);
          })) {}
    ~Job() { stopped = true; }  // the future waits for the thread

    bool done() const {
        return power.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    }

    std::atomic<bool> stopped = false;
    DirectionalSpectrum spectrum;
    Parameters parameters;
    std::future<double> power;
};

CoverPower::CoverPower() = default;
CoverPower::~CoverPower() = default;

double CoverPower::of(Ocean& sea, double time, int resolution) {
    if (job_ && job_->done()) power_ = std::exchange(job_, nullptr)->power.get();
    if (job_) return power_;
    const Modes& modes = sea.modes(time);
    Parameters parameters = sea.sea().at(time);
    const bool known =
        modes.revision == revision_ && parameters.surface == settings_ && resolution == resolution_;
    if (known) return power_;
    revision_ = modes.revision;
    settings_ = parameters.surface;
    resolution_ = resolution;
    const FoamWaves waves = foam_waves(modes, parameters, resolution);
    parameters.surface = with_threshold(settings_, modes, resolution);
    job_ = std::make_unique<Job>(sea.spectrum(time), std::move(parameters), waves, resolution);
    return power_;
}

Pending CoverPower::pending() const {
    if (!job_) return Pending::nothing;
    return job_->done() ? Pending::ready : Pending::in_work;
}

}  // namespace ocean::preview
