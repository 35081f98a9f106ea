// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Foam that is followed tick by tick, for any storage of its maps: memory, or textures of a GPU.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "ocean/internal/foam_clock.hpp"

namespace ocean {

/// Computes F_n = max(W_n, d F_(n-1)), d = exp(-step / lifetime), where values below 1/512 become
/// 0. Computes only ticks that it does not have. Keeps the last three ticks, so that sub-frames may
/// step back. `Map` is default-constructible and movable. One thread at a time.
template <typename Map>
class FoamFollower {
  public:
    /// The earlier foam of a moment: foam = max(W, fade * map), set to 0 below `cutoff`.
    struct Layer {
        const Map* map = nullptr;  // null: no earlier foam
        float fade = 0.0f;
        float cutoff = 0.0f;
    };
    /// The callbacks that make the maps.
    struct Source {
        std::function<double(double time)> lifetime;  // [s]
        /// Makes the foam of the tick at `time`: W over the layer of the tick before. `foam` is a
        /// map that is no longer needed, or a new one, Map().
        std::function<void(double time, const Layer& before, Map& foam)> tick;
        /// Called before each tick of a pre-roll; may be empty. If it throws, the pre-roll stops
        /// and the state stays as it was.
        std::function<void(std::int64_t done, std::int64_t total)> progress;
    };

    explicit FoamFollower(FoamClock clock, FoamStart start = FoamStart::settled)
        : clock_(clock), start_(start) {}

    /// Returns the earlier foam at a time t [s], F_n exp(-(t - t_n) / lifetime) with n the last
    /// tick at or before t; the caller lays W(t) over it. Valid until the next call. An exception
    /// of the source passes through and leaves a state that can be used further.
    Layer layer(double time, const Source& source) {
        const FoamClock::Moment moment = clock_.moment(time);
        const Tick& last = reach(moment.tick, source);
        return {&last.foam, fade(moment.since, source.lifetime(time)), 0.0f};
    }
    /// Drops the ticks from that time [s] on, because the sea has changed there.
    void forget_from(double time) {
        std::erase_if(kept_, [&](const Tick& kept) { return clock_.time_of(kept.number) >= time; });
    }
    /// Returns how many ticks must pass until a state that began empty shows all the foam of a
    /// settled one.
    std::int64_t settling_ticks() const { return settling_; }
    const FoamClock& clock() const { return clock_; }

  private:
    static constexpr std::size_t kKept = 3;  // the newest, and two that sub-frames step back to
    static constexpr float kMinFoam = 1.0f / 512.0f;

    struct Tick {
        std::int64_t number;
        std::int64_t age;  // ticks since the state began
        Map foam;
    };

    static float fade(double seconds, double lifetime) {
        return lifetime > 0.0 ? static_cast<float>(std::exp(-seconds / lifetime)) : 0.0f;
    }

    const Tick& reach(std::int64_t tick, const Source& source) {
        const auto found = std::find_if(kept_.begin(), kept_.end(),
                                        [tick](const Tick& kept) { return kept.number == tick; });
        if (found != kept_.end()) return *found;

        const std::int64_t ahead =
            kept_.empty() ? 0 : clock_.ticks_between(kept_.back().number, tick);
        if (ahead == 1 && settling_ == 0) {
            step(kept_, tick, source);
            return kept_.back();
        }
        const std::int64_t preroll = preroll_ticks(clock_, tick, source.lifetime);
        if (ahead > 0 && ahead <= preroll) {
            for (std::int64_t i = ahead - 1; i >= 0; --i) {
                step(kept_, clock_.before(tick, i), source);
            }
        } else {
            kept_ = begin(tick, start_ == FoamStart::settled ? preroll : 0, source);
        }
        const bool settled = start_ == FoamStart::settled || kept_.back().age >= preroll;
        settling_ = settled ? 0 : preroll - kept_.back().age;
        return kept_.back();
    }

    std::vector<Tick> begin(std::int64_t tick, std::int64_t preroll, const Source& source) {
        std::vector<Tick> kept;
        for (std::int64_t i = preroll; i >= 0; --i) {
            if (source.progress) source.progress(preroll - i, preroll + 1);
            // The first ticks need one map only; the last kKept ticks are kept.
            const bool passing = i >= static_cast<std::int64_t>(kKept);
            step(kept, clock_.before(tick, i), source, passing ? 1 : kKept);
        }
        return kept;
    }

    void step(std::vector<Tick>& kept, std::int64_t tick, const Source& source,
              std::size_t keep = kKept) {
        const double time = clock_.time_of(tick);
        Layer before{nullptr, 0.0f, kMinFoam};
        if (!kept.empty()) {
            before.map = &kept.back().foam;
            before.fade = fade(clock_.step, source.lifetime(time));
        }
        Tick next{tick, kept.empty() ? 0 : kept.back().age + 1, std::move(spare_)};
        spare_ = Map();
        source.tick(time, before, next.foam);
        kept.push_back(std::move(next));
        if (kept.size() > keep) {
            spare_ = std::move(kept.front().foam);
            kept.erase(kept.begin());
        }
    }

    FoamClock clock_;
    FoamStart start_;
    std::vector<Tick> kept_;  // the last ticks, the newest at the back
    Map spare_{};             // of a dropped tick, reused for the next
    std::int64_t settling_ = 0;
};

}  // namespace ocean
