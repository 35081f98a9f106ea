// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The windows around the eye of a sea that does not repeat, their values by its surface, and the
// foam and wet ground that breaking waves have left at their samples.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "ocean/internal/preview/coast_maps.hpp"
#include "ocean/ocean.hpp"

namespace ocean::preview {

inline constexpr std::size_t kWindowComponents = 4;  // of a texel

/// Reads a component of the finest window that holds a place, linear between samples; nothing where
/// none does.
std::optional<double> read_windows(const std::vector<CoastImage>& windows,
                                   std::vector<float> CoastImage::*image, std::size_t component,
                                   double x, double y);

/// Foam and wet ground that breaking waves have left at the samples of a window.
struct CoastTraces {
    CoastWindow window;
    std::vector<float> foam, wet;  // 0 .. 1
    std::vector<float> reach;      // greatest depth of the water that has left the ground wet [m]
};

/// The part of a window that lies in the area of the bed or of the wakes, and its surface.
struct CoastPart {
    std::array<int, 2> first{};  // sample
    Surface surface = {};        // empty: none of the window does
};

class CoastSurface {
  public:
    explicit CoastSurface(const CoastMapsOptions& options) : options_(options) {}

    /// Returns the windows at a time [s] around an eye [m]. cover_power: of whitecaps, which is
    /// their cover. Valid until the next call. Throws Error.
    std::vector<CoastImage>& at(Ocean& sea, double time, const std::array<double, 3>& eye,
                                double cover_power = 1.0);
    /// Returns the area beside which the sea is the open sea, of the last call: the bed, or the box
    /// of all wakes.
    const Domain& area() const { return area_; }

  private:
    /// Follows the traces up to a time, and returns the surface of each window.
    std::vector<CoastPart> follow(Ocean& sea, double time, ChannelSet channels);
    void move_traces(const std::vector<CoastWindow>& windows);
    void settle(Ocean& sea, double time);
    /// The shares of foam and of wetness that are left at a later time than that of the traces.
    struct Left {
        float foam, wet;
    };
    Left left_until(double time, double lifetime) const;

    CoastMapsOptions options_;
    std::vector<CoastTraces> traces_;
    std::optional<double> followed_;  // time of the traces
    std::uint64_t revision_ = 0;      // of the sea that they are of
    Domain area_;
    std::vector<CoastImage> images_;
};

}  // namespace ocean::preview
