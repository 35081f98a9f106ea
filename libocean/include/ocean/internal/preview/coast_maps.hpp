// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The part of a sea that does not repeat, for the renderer: nested windows around the eye of a
// coast's surface or of a sea with hulls, computed by the CPU, and the bed of a coast as ground.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "ocean/domain.hpp"
#include "ocean/internal/foam.hpp"
#include "ocean/internal/preview/land_maps.hpp"
#include "ocean/sea_bed.hpp"

namespace ocean {
class Ocean;
}

namespace ocean::preview {

inline constexpr std::size_t kMaxWindows = 4;

/// A square of samples on a lattice that is fixed in the world: sample positions are whole numbers
/// of cells from (0, 0).
struct CoastWindow {
    std::array<std::int64_t, 2> corner{};  // of sample (0, 0) [cells]
    double cell = 0.0;                     // [m]
    int samples = 0;                       // along a side

    Domain domain() const;
    bool operator==(const CoastWindow&) const = default;
};

/// The values of a window, row-major [j][i]. The textures of DrawnCoast document the components.
struct CoastImage {
    CoastWindow window;
    std::vector<float> shape, gradients, moments, traces;  // four floats a sample
};

/// A coast, or a sea with hulls, at a time. Its textures are valid until the next show() of its
/// CoastMaps.
struct DrawnCoast {
    // Arrays of textures with a layer for each window.
    unsigned shape = 0;      // Dx, Dy at choppiness 1, height, depth of the water over the bed [m]
    unsigned gradients = 0;  // slope x, slope y, dDx/dx, dDy/dy
    unsigned moments = 0;    // squares of the slopes, their product, dDx/dy
    // Cover of the foam of breaking waves, its bubbles, wetness of the ground where the last number
    // is above 0: the greatest depth of the water that wetted it [m]. Without a bed the last is the
    // cover of the whitecaps of a sea with hulls.
    unsigned traces = 0;
    /// The finest window first; empty while the coast is being computed, when the open sea is
    /// shown.
    std::vector<CoastImage> windows;
    Domain area;                        // beside it the open sea is shown
    std::shared_ptr<const SeaBed> bed;  // null: a sea with hulls
    DrawnLand ground;                   // the bed as land, without a field
    double highest = 0.0;  // greatest distance of the surface from still water, over water [m]

    /// Returns the height of the bed [m]; beyond the bed, the height of its edge. There is a bed.
    double ground_at(double x, double y) const;
    /// Returns the height of the water, or of dry ground [m]. The water is displaced sideways by
    /// less than a cell of its window.
    double surface_at(double x, double y) const;
};

struct CoastMapsOptions {
    int samples = 192;                  // along a side of a window
    double finest = 0.5;                // cell of the finest window for an eye near the water [m]
    std::size_t windows = kMaxWindows;  // each has cells four times as large as the previous
    FoamStart foam_start = FoamStart::empty;

    bool operator==(const CoastMapsOptions&) const = default;
};

/// Returns the windows around an eye [m], the finest first: their cells grow with the eye's height.
std::vector<CoastWindow> coast_windows(const std::array<double, 3>& eye,
                                       const CoastMapsOptions& options);

/// Every call, the destructor too, needs the context that was current at construction. OpenGL 4.1
/// core.
class CoastMaps {
  public:
    explicit CoastMaps(const CoastMapsOptions& options);
    ~CoastMaps();
    CoastMaps(const CoastMaps&) = delete;
    CoastMaps& operator=(const CoastMaps&) = delete;

    /// Returns the coast of a sea with a bed, or the wakes of a sea with hulls, at a time [s] for
    /// an eye [m]. Foam of breaking waves and wet ground are followed from call to call at samples
    /// that are fixed in the world; new samples of a window begin with the values of the coarser
    /// window. cover_power: of whitecaps, which is their cover. Throws Error.
    std::shared_ptr<const DrawnCoast> show(Ocean& sea, double time,
                                           const std::array<double, 3>& eye,
                                           double cover_power = 1.0);
    /// Returns the ground alone, for a coast that is still being computed.
    std::shared_ptr<const DrawnCoast> show_ground(const std::shared_ptr<const SeaBed>& bed);
    /// Fades from an earlier coast of the same windows, whose share is 1 - `share`. Other windows
    /// are left out.
    std::shared_ptr<const DrawnCoast> fade_from(const DrawnCoast& before, double share);

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace ocean::preview
