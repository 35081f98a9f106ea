// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The spray of a caller that steps. Births of the ticks that still count are kept, so that the next
// frame computes new ticks alone and yet has the same bits as when it is requested alone.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "ocean/internal/foam_clock.hpp"
#include "waves/spray/spray_birth.hpp"

namespace ocean {

/// Callbacks that make the maps of spray.
struct SpraySource {
    /// Fills the map, kSprayChannels on spray_domain, at the time of a tick.
    std::function<SprayAir(double time, Surface& map)> tick;
};

class SprayFollower {
  public:
    SprayFollower(const SpraySettings& settings, const FoamClock& clock, const Domain& domain,
                  std::uint32_t seed);

    const SpraySettings& settings() const { return settings_; }
    const Domain& domain() const { return map_.domain(); }
    /// Follows births up to a time [s], which the other functions then use. An exception of the
    /// source passes through and leaves a state that can be used further.
    void go_to(double time, const SpraySource& source);
    /// Returns all living particles, from the oldest ticks on.
    std::vector<SprayParticle> particles() const;
    std::vector<MistPuff> mist() const;
    /// Drops the ticks from that time [s] on, because the sea has changed there.
    void forget_from(double time);

  private:
    void make(std::int64_t tick, const SpraySource& source);
    /// Calls take(birth, age) for all particles born within the lifetime.
    template <typename Visit>
    void for_each_birth(const Visit& visit) const;
    void forget_far_from(std::int64_t tick);

    SpraySettings settings_;
    FoamClock clock_;
    std::uint32_t seed_;
    double lifetime_;     // s
    std::int64_t ticks_;  // ticks that may have living particles, the newest included
    std::map<std::int64_t, std::vector<SprayBirth>> born_;
    FoamClock::Moment now_{};
    Surface map_;
    std::vector<std::uint8_t> white_;         // cells white at the last tick
    std::optional<std::int64_t> white_tick_;  // its number
};

}  // namespace ocean
