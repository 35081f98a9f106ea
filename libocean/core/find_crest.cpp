// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/internal/find_crest.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "ocean/error.hpp"
#include "ocean/internal/cascades.hpp"
#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/ocean.hpp"

namespace ocean {

namespace {

constexpr std::size_t kCandidates = 8;
constexpr int kMaxSearchMap = 1024;  // samples; finer waves count when a candidate is followed

double peak_period(Ocean& ocean) {
    const Parameters& parameters = ocean.parameters();
    const double peak = ocean.spectrum().moments(parameters.water).peak_omega;
    if (peak > 0.0) return kTwoPi / peak;
    throw Error(ErrorKind::invalid_value, "a flat sea has no crests");
}

/// Keeps the highest candidates; those within a period of time and a tenth of the patch are one
/// wave.
class Candidates {
  public:
    Candidates(double period, double patch_size) : period_(period), patch_size_(patch_size) {}

    void add(const FoundCrest& crest) {
        const auto same = std::ranges::find_if(best_, [&](const FoundCrest& other) {
            const auto apart = [&](double a, double b) {
                return std::abs(std::remainder(a - b, patch_size_)) < 0.1 * patch_size_;
            };
            return std::abs(crest.time - other.time) < period_ && apart(crest.x, other.x) &&
                   apart(crest.y, other.y);
        });
        if (same != best_.end()) {
            if (crest.height > same->height) *same = crest;
        } else {
            best_.push_back(crest);
        }
        std::ranges::sort(best_, std::greater(), &FoundCrest::height);
        if (best_.size() > kCandidates) best_.pop_back();
    }
    /// Returns true if a wave of that height could be one of the best.
    bool may_enter(double height) const {
        return best_.size() < kCandidates || height > best_.back().height;
    }
    const std::vector<FoundCrest>& best() const { return best_; }

  private:
    double period_;
    double patch_size_;
    std::vector<FoundCrest> best_;
};

/// Returns the coordinate within low .. high that equals `at` after whole periods; nothing if there
/// is none.
std::optional<double> within(double at, double low, double high, double period) {
    const double moved = at + period * std::ceil((low - at) / period);
    if (moved > high) return std::nullopt;
    return moved;
}

class Search {
  public:
    Search(Ocean& ocean, const CrestWindow& window)
        : ocean_(ocean),
          window_(window),
          patch_size_(ocean.parameters().grid.patch_size),
          period_(peak_period(ocean)),
          resolution_(std::min(kMaxSearchMap, default_map_resolution(ocean.parameters().grid))) {
        const std::array<double, 4> all = {0.0, 0.0, patch_size_, patch_size_};
        place_ = window.place.value_or(all);
    }

    FoundCrest run(const std::function<void(std::size_t)>& progress) {
        const std::size_t maps = crest_search_maps(ocean_, window_);
        Candidates candidates(period_, patch_size_);
        for (std::size_t map = 0; map < maps; ++map) {
            const double share =
                maps > 1 ? static_cast<double>(map) / static_cast<double>(maps - 1) : 0.0;
            read(window_.from + share * (window_.to - window_.from), candidates);
            if (progress) progress(map + 1);
        }
        FoundCrest highest{.height = -std::numeric_limits<double>::infinity()};
        for (const FoundCrest& candidate : candidates.best()) {
            const FoundCrest crest = follow(candidate);
            if (crest.height > highest.height) highest = crest;
        }
        return highest;
    }

  private:
    /// Adds the highest sample of a map that is displayed in the window.
    void read(double time, Candidates& candidates) const {
        const Surface map =
            ocean_.evaluate(time, {Channel::height, Channel::dx, Channel::dy}, resolution_);
        const std::span<const float> height = map.channel(Channel::height);
        const std::span<const float> dx = map.channel(Channel::dx);
        const std::span<const float> dy = map.channel(Channel::dy);
        FoundCrest highest{.time = time, .height = -std::numeric_limits<double>::infinity()};
        for (std::size_t at = 0; at < height.size(); ++at) {
            const auto metres = static_cast<double>(height[at]);
            if (metres <= highest.height || !candidates.may_enter(metres)) continue;
            const auto samples = static_cast<std::size_t>(resolution_);
            const double cell = patch_size_ / resolution_;
            const auto x = within(static_cast<double>(at % samples) * cell + dx[at], place_[0],
                                  place_[2], patch_size_);
            const auto y = within(static_cast<double>(at / samples) * cell + dy[at], place_[1],
                                  place_[3], patch_size_);
            if (x && y) highest = {time, *x, *y, metres};
        }
        if (std::isfinite(highest.height)) candidates.add(highest);
    }

    /// Follows a wave to its highest point, on ever finer grids of places and times.
    FoundCrest follow(const FoundCrest& candidate) const {
        constexpr int kSide = 9;
        FoundCrest best = candidate;
        best.height = -std::numeric_limits<double>::infinity();
        double reach = 2.0 * patch_size_ / resolution_;
        double span = period_ / 24.0;
        for (int level = 0; level < 4; ++level, reach /= 4.0, span /= 3.0) {
            const FoundCrest centre = best;
            for (const double step : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
                const double time = std::clamp(centre.time + step * span, window_.from, window_.to);
                std::vector<WorldPoint> points;
                for (int at = 0; at < kSide * kSide; ++at) {
                    const auto offset = [&](int i) {
                        return reach * (2.0 * i / (kSide - 1) - 1.0);
                    };
                    points.push_back(
                        {std::clamp(centre.x + offset(at % kSide), place_[0], place_[2]),
                         std::clamp(centre.y + offset(at / kSide), place_[1], place_[3])});
                }
                std::vector<QuerySample> samples(points.size());
                ocean_.query(time, points, samples, {.foam = false});
                for (std::size_t i = 0; i < points.size(); ++i) {
                    if (samples[i].height <= best.height) continue;
                    best = {time, points[i].x, points[i].y, samples[i].height};
                }
            }
        }
        return best;
    }

    Ocean& ocean_;
    const CrestWindow& window_;
    double patch_size_;
    double period_;
    int resolution_;  // of the maps
    std::array<double, 4> place_;
};

}  // namespace

std::size_t crest_search_maps(Ocean& ocean, const CrestWindow& window) {
    if (!(window.to >= window.from)) {
        throw Error(ErrorKind::invalid_value, "a crest is searched from a time to a later one");
    }
    const double steps = std::ceil(24.0 * (window.to - window.from) / peak_period(ocean));
    if (steps + 1.0 > static_cast<double>(kMaxCrestSearch)) {
        throw Error(
            ErrorKind::invalid_value,
            {.what = "takes " + significant_text(steps + 1.0, 3) + " maps of the sea",
             .parameter = "from " + plain_text(window.from) + " to " + plain_text(window.to) + " s",
             .allowed =
                 "at most " + std::to_string(kMaxCrestSearch) + " maps, 24 for each peak period"});
    }
    return static_cast<std::size_t>(steps) + 1;
}

FoundCrest find_highest_crest(Ocean& ocean, const CrestWindow& window,
                              const std::function<void(std::size_t done)>& progress) {
    if (window.place) {
        const auto& [west, south, east, north] = *window.place;
        if (!(east > west && north > south)) {
            throw Error(ErrorKind::invalid_value,
                        "a crest is searched from a south-western to a north-eastern place");
        }
    }
    return Search(ocean, window).run(progress);
}

}  // namespace ocean
