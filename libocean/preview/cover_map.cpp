// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "cover_map.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <utility>

#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/internal/foam.hpp"
#include "ocean/internal/gl/textures.hpp"
#include "ocean/parameter_table.hpp"

namespace ocean::preview {
namespace {

struct Stopped {};

bool have_same_waves(const Parameters& a, const Parameters& b) {
    const auto first = first_dirty_stage(a, b);
    return !first || *first > Stage::spectrum;
}

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

const CoverPattern& CoverPatterns::of(const Parameters& parameters, ThreadPool& pool) {
    if (made_of_ && have_same_waves(parameters, *made_of_)) return pattern_;
    const SpectralMoments moments =
        make_directional_spectrum(parameters, pool).moments(parameters.water);
    const double height = moments.significant_wave_height();
    pattern_.direction = moments.mean_direction;
    pattern_.stretch = 1.5 + 0.7 * std::clamp((height - 4.0) / 3.0, 0.0, 1.0);
    pattern_.streaks = 0.3 * std::clamp((height - 2.0) / 4.0, 0.0, 1.0);
    made_of_ = parameters;
    return pattern_;
}

CoverMap::CoverMap()
    : program_({{GL_VERTEX_SHADER, "preview/sky.vert"}, {GL_FRAGMENT_SHADER, "preview/cover.frag"}},
               ""),
      no_vertices_(gl::make_vertex_array()),
      framebuffer_(gl::make_framebuffer()) {}

void CoverMap::make(unsigned foam, int resolution, float fade, double power) {
    if (!map_ || resolution != resolution_) {
        map_ = gl::make_texture(GL_RGBA16F, resolution, gl::Mipmaps::yes);
        resolution_ = resolution;
    }
    GLint viewport[4] = {};
    GLint framebuffer = 0;
    glGetIntegerv(GL_VIEWPORT, viewport);
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.name());
    glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, map_.name(),
                           0);
    glViewport(0, 0, resolution, resolution);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    program_.use();
    program_.set("foam_map", 0);
    program_.set("fade", fade);
    program_.set("cover_power", static_cast<float>(power));
    glActiveTexture(GL_TEXTURE0);
    glBindSampler(0, 0);
    glBindTexture(GL_TEXTURE_2D, foam);
    glBindVertexArray(no_vertices_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(framebuffer));
    glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
    glBindTexture(GL_TEXTURE_2D, map_.name());
    glGenerateMipmap(GL_TEXTURE_2D);
}

}  // namespace ocean::preview
