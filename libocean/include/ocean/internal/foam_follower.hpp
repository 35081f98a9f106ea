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
#include <optional>
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
    /// The earlier foam of a moment: foam = max(W, fade * map), set to 0 below `cutoff`. If `kept`
    /// is not null, that foam belongs there, and the foam of the moment is max(W, kept).
    struct Layer {
        const Map* map = nullptr;  // null: no earlier foam
        float fade = 0.0f;
        float cutoff = 0.0f;
        Map* kept = nullptr;
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
        const Tick* last = find(moment.tick);
        if (last == nullptr) {
            begin(moment.tick, source);
            source.tick(clock_.time_of(moment.tick), before_next(kept_, moment.tick, source),
                        next_->tick.foam);
            keep();
            last = &kept_.back();
        }
        return {&last->foam, fade(moment.since, source.lifetime(time)), 0.0f};
    }
    /// Returns the earlier foam for the map of a time [s], as layer() does. A missing tick of this
    /// very time is left to the map: the layer's `kept` is the tick's own map, and after it is
    /// written keep() must be called.
    Layer layer_of_map(double time, const Source& source) {
        const FoamClock::Moment moment = clock_.moment(time);
        const bool is_tick = moment.since == 0.0 && source.lifetime(time) > 0.0;
        if (!is_tick || find(moment.tick) != nullptr) return layer(time, source);
        begin(moment.tick, source);
        Layer layer = before_next(kept_, moment.tick, source);
        layer.kept = &next_->tick.foam;
        return layer;
    }
    /// Keeps the tick whose map layer_of_map() has left to the caller.
    void keep() {
        append(kept_, std::move(next_->tick), kKept);
        settling_ = next_->settling;
        next_.reset();
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

    const Tick* find(std::int64_t tick) const {
        const auto found = std::find_if(kept_.begin(), kept_.end(),
                                        [tick](const Tick& kept) { return kept.number == tick; });
        return found != kept_.end() ? &*found : nullptr;
    }

    /// Makes the ticks before a missing tick, and begins that tick: next_.
    void begin(std::int64_t tick, const Source& source) {
        drop_next();
        const std::int64_t ahead =
            kept_.empty() ? 0 : clock_.ticks_between(kept_.back().number, tick);
        if (ahead == 1 && settling_ == 0) {
            next_ = {after(kept_, tick), 0};
            return;
        }
        const std::int64_t preroll = preroll_ticks(clock_, tick, source.lifetime);
        if (ahead > 0 && ahead <= preroll) {
            for (std::int64_t i = ahead - 1; i > 0; --i) {
                step(kept_, clock_.before(tick, i), source, kKept);
            }
        } else {
            kept_ = preroll_to(tick, start_ == FoamStart::settled ? preroll : 0, source);
        }
        next_ = {after(kept_, tick), 0};
        const bool settled = start_ == FoamStart::settled || next_->tick.age >= preroll;
        if (!settled) next_->settling = preroll - next_->tick.age;
    }

    /// Returns the last ticks of a pre-roll but the last of all, `tick`.
    std::vector<Tick> preroll_to(std::int64_t tick, std::int64_t preroll, const Source& source) {
        std::vector<Tick> kept;
        for (std::int64_t i = preroll; i >= 0; --i) {
            if (source.progress) source.progress(preroll - i, preroll + 1);
            if (i == 0) break;
            // The first ticks need one map only; the last kKept ticks are kept.
            const bool passing = i >= static_cast<std::int64_t>(kKept);
            step(kept, clock_.before(tick, i), source, passing ? 1 : kKept);
        }
        return kept;
    }

    void step(std::vector<Tick>& kept, std::int64_t tick, const Source& source, std::size_t keep) {
        Tick next = after(kept, tick);
        source.tick(clock_.time_of(tick), before_next(kept, tick, source), next.foam);
        append(kept, std::move(next), keep);
    }

    /// Returns the tick after the kept ones, without its foam.
    Tick after(const std::vector<Tick>& kept, std::int64_t tick) {
        Tick next{tick, kept.empty() ? 0 : kept.back().age + 1, std::move(spare_)};
        spare_ = Map();
        return next;
    }

    /// Returns the earlier foam of the tick after the kept ones.
    Layer before_next(const std::vector<Tick>& kept, std::int64_t tick,
                      const Source& source) const {
        if (kept.empty()) return {nullptr, 0.0f, kMinFoam};
        const double lifetime = source.lifetime(clock_.time_of(tick));
        return {&kept.back().foam, fade(clock_.step, lifetime), kMinFoam};
    }

    void append(std::vector<Tick>& kept, Tick next, std::size_t keep) {
        kept.push_back(std::move(next));
        if (kept.size() > keep) {
            spare_ = std::move(kept.front().foam);
            kept.erase(kept.begin());
        }
    }

    /// Drops a tick whose map was not written.
    void drop_next() {
        if (next_) spare_ = std::move(next_->tick.foam);
        next_.reset();
    }

    /// The tick that is being made.
    struct Next {
        Tick tick;
        std::int64_t settling;  // once it is kept
    };

    FoamClock clock_;
    FoamStart start_;
    std::vector<Tick> kept_;  // the last ticks, the newest at the back
    std::optional<Next> next_;
    Map spare_{};  // of a dropped tick, reused for the next
    std::int64_t settling_ = 0;
};

}  // namespace ocean
