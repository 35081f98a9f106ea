// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The stages of a coast: see shoreline_profile.hpp. smoothed heights -> seas -> distances ->
// shelter and steepness of the nearest shore -> profile.
#include "ocean/internal/shoreline_profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "field/grid_blur.hpp"
#include "field/grid_lines.hpp"
#include "field/zero_line.hpp"
#include "map_seas.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/internal/text.hpp"
#include "shoreline_law.hpp"

namespace ocean {
namespace {

constexpr double kAlongShore = 60.0;  // deviation that smooths the shore's character [m]
constexpr double kLeast = 1e-4;       // height of land and depth of water at the shore [m]
constexpr int kPasses = 4 * kBlurPasses + kDistancePasses + 5;

Error refusal(const std::string& message) {
    return Error(ErrorKind::invalid_value, message);
}

void check(std::span<const float> heights, const Domain& domain,
           const ShorelineSettings& settings) {
    const auto [columns, rows] = domain.samples;
    if (domain.wraps || columns < 2 || rows < 2) {
        throw refusal("a coast needs a domain that exists once, with at least 2 x 2 samples");
    }
    // Indices of samples have 32 bits.
    if (columns > 65535 || rows > 65535) {
        throw refusal("a coast has at most 65535 samples along a side");
    }
    if (heights.size() != domain.count()) {
        throw refusal("there are " + std::to_string(heights.size()) + " heights for " +
                      std::to_string(domain.count()) + " samples");
    }
    const double x = domain.step(0), y = domain.step(1);
    if (!(x > 0.0) || !std::isfinite(x) || !(std::abs(x - y) <= 1e-6 * x)) {
        throw refusal("a coast needs square cells");
    }
    const struct {
        const char* name;
        double value, max;
    } positive[] = {{"beach_slope", settings.beach_slope, 10.0},
                    {"berm", settings.berm, 1e3},
                    {"face", settings.face, 10.0},
                    {"closure", settings.closure, 1e4},
                    {"shelf", settings.shelf, 1e5},
                    {"smooth", settings.smooth, 1e6},
                    {"shelter", settings.shelter, 1e6},
                    {"width", settings.width, 1e6}};
    for (const auto& [name, value, max] : positive) {
        if (value >= 1e-6 && value <= max) continue;
        throw Error(ErrorKind::invalid_value, {.what = "is out of range",
                                               .parameter = std::string("coast.") + name,
                                               .value = plain_text(value),
                                               .allowed = "above 0, at most " + plain_text(max)});
    }
    if (!(settings.beaches >= 0.0 && settings.beaches <= 1.0)) {
        throw refusal("coast.beaches is out of range");
    }
    if (!(std::abs(settings.level) <= 1e5)) throw refusal("the level of the water is not finite");
    if (!std::ranges::all_of(heights, [](float h) { return std::isfinite(h); })) {
        throw refusal("a height is missing or not finite: holes must be filled before");
    }
}

/// The range of a map's samples: on one side of the level or on both.
struct Sides {
    bool land = false;
    bool sea = false;
};

Sides sides_of(std::span<const float> map, double level) {
    Sides sides;
    for (const float h : map) (double{h} > level ? sides.land : sides.sea) = true;
    return sides;
}

class ShorelineShaper {
  public:
    ShorelineShaper(std::span<float> heights, const Domain& domain,
                    const ShorelineSettings& settings, ThreadPool& pool,
                    const std::function<void(double share)>& progress)
        : heights_(heights),
          grid_{domain.samples[0], domain.samples[1]},
          cell_(domain.step(0)),
          settings_(settings),
          law_(settings, cell_),
          passes_(pool, progress, kPasses) {
        require_memory(shoreline_bytes(grid_.count()), "the coast of a land");
        above_ = static_cast<float>(settings.level + kLeast);
        below_ = static_cast<float>(settings.level - kLeast);
        constexpr float kFar = std::numeric_limits<float>::max();
        if (!(double{above_} > settings.level)) above_ = std::nextafter(above_, kFar);
        if (!(double{below_} < settings.level)) below_ = std::nextafter(below_, -kFar);
    }

    ShorelineMaps shape() {
        find_line();
        const Sides sides = sides_of(smoothed_, 0.0);
        for (PageVector<float>* map :
             {&maps_.beach, &maps_.cliff, &maps_.shelter, &maps_.distance}) {
            map->resize(grid_.count());
        }
        if (sides.land && sides.sea) {
            nearest_.resize(grid_.count());
            zero_line_distance(smoothed_, grid_, maps_.beach, maps_.distance, nearest_, passes_);
            find_character();
        } else {
            std::ranges::fill(maps_.distance, sides.land ? kNoShore : -kNoShore);
            std::ranges::fill(maps_.shelter, 0.0f);
            std::ranges::fill(maps_.cliff, 0.0f);
            const Sides own = sides_of(heights_, settings_.level);
            if (!own.land || !own.sea) {
                std::ranges::fill(maps_.beach, 0.0f);
                passes_.report(1.0);
                return std::move(maps_);
            }
        }
        shape_heights();
        passes_.report(1.0);
        // The heights change only here, so that a stop before leaves them as they were.
        std::ranges::copy(smoothed_, heights_.begin());
        return std::move(maps_);
    }

  private:
    /// Calls body(index, i, j) for all samples.
    template <typename Body>
    void for_each_sample(const Body& body) {
        passes_.run(grid_.rows, [&](int first, int lanes, int) {
            for (int j = first; j < first + lanes; ++j) {
                for (int i = 0; i < grid_.columns; ++i) body(grid_.index(i, j), i, j);
            }
        });
    }

    /// Returns metres as samples, at least one.
    double samples(double metres) const { return std::max(metres / cell_, 1.0); }

    void find_line() {
        smoothed_.resize(grid_.count());
        for_each_sample([this](std::size_t at, int, int) {
            smoothed_[at] = static_cast<float>(double{heights_[at]} - settings_.level);
        });
        blur(smoothed_, grid_, samples(settings_.smooth), passes_);
        raise_cut_off_seas(smoothed_, grid_);
    }

    /// Returns the slope of the smoothed heights.
    double steepness(std::size_t at) const {
        const int i = static_cast<int>(at % static_cast<std::size_t>(grid_.columns));
        const int j = static_cast<int>(at / static_cast<std::size_t>(grid_.columns));
        const auto slope = [&](int i0, int j0, int i1, int j1) {
            const double rise =
                double{smoothed_[grid_.index(i1, j1)]} - double{smoothed_[grid_.index(i0, j0)]};
            return rise / (cell_ * (i1 - i0 + j1 - j0));
        };
        const double x = slope(std::max(i - 1, 0), j, std::min(i + 1, grid_.columns - 1), j);
        const double y = slope(i, std::max(j - 1, 0), i, std::min(j + 1, grid_.rows - 1));
        return std::sqrt(x * x + y * y);
    }

    /// Writes shelter, and into the map of cliffs the share of a cliff at the nearest shore.
    void find_character() {
        // The share of land in each cell, so that its edge moves smoothly with the line.
        PageVector<float>& share = maps_.beach;
        for_each_sample([this, &share](std::size_t at, int, int) {
            share[at] = std::clamp(0.5f + maps_.distance[at], 0.0f, 1.0f);
        });
        blur(share, grid_, samples(settings_.shelter), passes_);
        // Across a straight shore the share rises by this per sample; the line lies between
        // samples.
        const double rise = 1.0 / (std::sqrt(kTwoPi) * samples(settings_.shelter));
        // The whole profile, from the berm to the shelf, has one character.
        for_each_sample([this, &share, rise](std::size_t at, int, int) {
            const std::size_t shore = nearest_[at];
            const double at_line = double{share[shore]} - rise * double{maps_.distance[shore]};
            const double shelter = ease(0.46, 0.60, at_line + settings_.beaches);
            maps_.shelter[at] = static_cast<float>(shelter);
            maps_.cliff[at] =
                static_cast<float>((1.0 - shelter) * ease(0.12, 0.4, steepness(shore)));
        });
        for_each_sample(
            [this](std::size_t at, int, int) { maps_.distance[at] *= static_cast<float>(cell_); });
        blur(maps_.shelter, grid_, samples(kAlongShore), passes_);
        blur(maps_.cliff, grid_, samples(kAlongShore), passes_);
    }

    /// Writes the new heights over the smoothed heights, whose signs they keep.
    void shape_heights() {
        for_each_sample([this](std::size_t at, int, int) {
            const double d = double{maps_.distance[at]};
            const double shelter = std::clamp(double{maps_.shelter[at]}, 0.0, 1.0);
            const double own = double{heights_[at]} - settings_.level;
            const auto height = static_cast<float>(settings_.level + law_.height(own, d, shelter));
            smoothed_[at] =
                smoothed_[at] > 0.0f ? std::max(height, above_) : std::min(height, below_);
            maps_.shelter[at] = static_cast<float>(shelter);
            maps_.beach[at] = static_cast<float>(law_.beach(d, shelter));
            maps_.cliff[at] =
                static_cast<float>(std::clamp(double{maps_.cliff[at]}, 0.0, 1.0) * law_.cliff(d));
        });
    }

    std::span<float> heights_;
    SampleGrid grid_;
    double cell_;  // [m]
    ShorelineSettings settings_;
    ShorelineLaw law_;
    GridPasses passes_;
    float above_, below_;                // floats next to the level [m]
    PageVector<float> smoothed_;         // heights above the level, with the sign of the result [m]
    PageVector<std::uint32_t> nearest_;  // the index of the sample at the nearest shore
    ShorelineMaps maps_;
};

}  // namespace

ShorelineMaps shape_shoreline(std::span<float> heights, const Domain& domain,
                              const ShorelineSettings& settings, ThreadPool& pool,
                              const std::function<void(double share)>& progress) {
    check(heights, domain, settings);
    return ShorelineShaper(heights, domain, settings, pool, progress).shape();
}

std::uint64_t shoreline_bytes(std::size_t cells) {
    // Four maps, the smoothed heights, the nearest shore.
    return std::uint64_t{cells} * (5 * sizeof(float) + sizeof(std::uint32_t));
}

}  // namespace ocean
