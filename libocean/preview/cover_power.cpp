// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "cover_power.hpp"

#include <atomic>
#include <chrono>
#include <future>
#include <utility>

#include "ocean/internal/foam.hpp"

namespace ocean::preview {
namespace {

struct Stopped {};

}  // namespace

/// A solution in work. It owns all that it reads, because the sea changes meanwhile.
struct CoverPower::Job {
    Job(DirectionalSpectrum of, Parameters at, const FoamWhitecaps& whitecaps)
        : spectrum(std::move(of)),
          parameters(std::move(at)),
          power(std::async(std::launch::async, [this, whitecaps] {
              ThreadPool pool(1);
              pool.set_interrupt([this] {
                  if (stopped) throw Stopped();
              });
              return cover_power({spectrum, parameters}, whitecaps, pool);
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

double CoverPower::of(OpenSea& sea, double time, const ShownFoam& foam) {
    if (job_ && job_->done()) power_ = std::exchange(job_, nullptr)->power.get();
    if (job_) return power_;
    const Modes& modes = sea.modes(time);
    Parameters parameters = sea.sea().at(time);
    const bool known =
        modes.revision == revision_ && parameters.surface == settings_ && foam == foam_;
    if (known) return power_;
    revision_ = modes.revision;
    settings_ = parameters.surface;
    foam_ = foam;
    const SurfaceSettings past = lattice_settings(modes, parameters, foam.past);
    const SurfaceSettings shown =
        foam.is_past_alone() ? past : with_threshold(settings_, modes, foam.whitecaps_held_by);
    const FoamWhitecaps whitecaps = foam_whitecaps(modes, foam, past, shown);
    job_ = std::make_unique<Job>(sea.spectrum(time), std::move(parameters), whitecaps);
    return power_;
}

Pending CoverPower::pending() const {
    if (!job_) return Pending::nothing;
    return job_->done() ? Pending::ready : Pending::in_work;
}

}  // namespace ocean::preview
