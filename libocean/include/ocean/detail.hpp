// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Detail: the waves too short for the map that a host displays, about half of all slope, as small
// periodic slope maps of the same sea at the same time. A material adds these slopes to the mesh's
// slopes; shaders/wave/slope_tiles.glsl reads them without visible repetition.
//
//     const DetailSettings settings{.resolution = 1024};  // of the map that the host displays
//     const Detail detail = ocean.detail(12.0, settings);
//     for (std::size_t band = 0; band < detail.bands().size(); ++band) {
//         upload(detail.slopes(band), detail.samples(), detail.bands()[band].tile);
//     }
//     material.roughness = roughness_of(detail.residual());
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "ocean/channel.hpp"
#include "ocean/page_vector.hpp"
#include "ocean/parameters.hpp"

namespace ocean {

class DirectionalSpectrum;
class ThreadPool;
struct Backend;

/// Wavelength at which the last band ends [m]: shorter ripples become roughness. The tables of the
/// spectra reach down to 0.01 m.
inline constexpr double kShortestDetail = 0.012;
inline constexpr int kMaxDetailBands = 3;
inline constexpr int kMinDetailSamples = 256;
inline constexpr int kMaxDetailSamples = 1024;

/// The map that the detail completes, and the resolution of its tiles.
struct DetailSettings {
    int resolution = 0;  // of the displayed map; 0 = default_map_resolution
    int samples = 512;   // along a side of each tile, a power of two, 256 .. 1024
    auto operator<=>(const DetailSettings&) const = default;
};

/// Variances of the slopes hx = dh/dx and hy = dh/dy: E[hx^2], E[hy^2], E[hx hy].
struct SlopeVariance {
    double x = 0.0;
    double y = 0.0;
    double xy = 0.0;

    double mean_square_slope() const { return x + y; }
};

/// The waves of one tile. The first band begins at the edge of the square of wavenumbers that the
/// map holds, each other band where the previous band ends, so that no wave appears twice or is
/// missing.
struct DetailBand {
    double shortest_wave = 0.0;  // [m]
    double longest_wave = 0.0;   // [m]; of the first band along an axis, shorter in the corners
    double tile = 0.0;           // side and period [m]: at least 1 and 8.3 longest waves
    SlopeVariance variance;      // integral of k k^T E over the band, without a random draw
};

/// Returns wavelengths and tiles of the bands, without their variances. They depend only on the
/// grid and the wavelength limits, not on the waves. One band for a map that ends at 0.144 m or
/// finer, two up to 2 m, then three; each spans a factor of 6. The last ends at kShortestDetail, at
/// the sea's shortest_wavelength, or at the shortest wave its samples hold (for maps that end above
/// 13 m, with 512 samples). Empty if the map holds all these waves. Needs validated parameters.
/// Throws Error invalid_value for settings out of range.
std::vector<DetailBand> detail_bands(const Parameters& parameters, const DetailSettings& settings);

/// The slopes that a map lacks at one time, by band.
struct DetailBudget {
    std::vector<DetailBand> bands;
    /// Mean square slope of the waves shorter than the last band: roughness at any distance. The
    /// map's own (SeaState::map_slopes), the bands' and this add up to the sea's.
    double residual = 0.0;
};

/// Returns the budget of a sea with that spectrum without computing any map, in a few milliseconds.
/// Ocean::detail_budget keeps it.
DetailBudget detail_budget(const Parameters& parameters, const DirectionalSpectrum& spectrum,
                           const DetailSettings& settings, ThreadPool& pool);
/// Returns an upper bound of the bytes needed to make the maps, the maps themselves left out.
std::uint64_t detail_bytes(const Parameters& parameters, const DetailSettings& settings,
                           const Backend& backend);

/// The products by which users request detail: all bands together, or one band. Each is the slope
/// of its own waves.
inline constexpr auto kDetailProducts = [] {
    constexpr std::array<std::string_view, 1 + kMaxDetailBands> kNames = {"detail", "detail1",
                                                                          "detail2", "detail3"};
    constexpr std::array<std::string_view, kNames.size()> kHelps = {
        "Slope of the waves too short for the map, as a tile", "The first band of these waves",
        "Their second band", "Their third band"};
    std::array<Product, kNames.size()> rows{};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i] = detail::product(kNames[i], {Channel::slope_x, Channel::slope_y}, Precision::half,
                                  RunLengths::always, kHelps[i]);
        rows[i].subject = kSeaKind;
    }
    return rows;
}();

/// Slope maps of one time, by label, row-major [j][i]: sample (i, j) lies at (i, j) * tile /
/// samples and has dh/dx and dh/dy, interleaved. They are linear fields, as `slope` of a Surface.
/// Each wave is amplified so that, read bilinearly, the slopes have the band's variance: a wave
/// along a side by 3 % at 10 samples, by 22 % at 4.
class Detail {
  public:
    Detail() = default;
    /// Allocates the maps and leaves them uninitialised.
    Detail(double time, int samples, DetailBudget budget);

    double time() const { return time_; }
    int samples() const { return samples_; }
    const std::vector<DetailBand>& bands() const { return budget_.bands; }
    double residual() const { return budget_.residual; }
    /// Returns the 2 samples^2 values of a band.
    std::span<const float> slopes(std::size_t band) const { return maps_[band]; }
    std::span<float> slopes(std::size_t band) { return maps_[band]; }

  private:
    double time_ = 0.0;
    int samples_ = 0;
    DetailBudget budget_;
    std::vector<PageVector<float>> maps_;
};

}  // namespace ocean
