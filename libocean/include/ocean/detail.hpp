// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Detail: the waves too short for the map that a host shows, half of all slope, as small periodic
// maps of the same sea at the same time. Surface's little sister: from the spectrum to slopes that
// a material adds to the mesh's own; shaders/wave/slope_tiles.glsl says how they are read.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "ocean/channel.hpp"
#include "ocean/page_vector.hpp"
#include "ocean/parameters.hpp"
#include "ocean/subject_kind.hpp"

namespace ocean {

class DirectionalSpectrum;
class ThreadPool;
struct Backend;

/// m, where the last band ends: shorter ripples are left to the roughness. The tables of the
/// spectra reach to 0.01 m.
inline constexpr double kShortestDetail = 0.012;
inline constexpr int kMostDetailBands = 3;
inline constexpr int kLeastDetailSamples = 256;
inline constexpr int kMostDetailSamples = 1024;

/// Beside which map, and how fine.
struct DetailSettings {
    int resolution = 0;  // of the map that is shown; 0 = default_map_resolution
    int samples = 512;   // a side of each tile: a power of two, 256 .. 1024
    auto operator<=>(const DetailSettings&) const = default;
};

/// Of dh/dx and dh/dy: E[hx^2], E[hy^2], E[hx hy].
struct SlopeVariance {
    double x = 0.0;
    double y = 0.0;
    double xy = 0.0;

    double mean_square_slope() const { return x + y; }
};

/// The waves of one tile. The first band begins where the map ends, at the edge of its square of
/// wavenumbers, each other one where the one before it ends: none is shown twice, none left out.
struct DetailBand {
    double shortest_wave = 0.0;  // m
    double longest_wave = 0.0;   // m; of the first band along an axis: less in the map's corners
    double tile = 0.0;           // m, side and period of the map: at least 1, 8.3 longest waves
    SlopeVariance variance;      // the integral of k k^T E over the band, no random draw
};

/// Wavelengths and tiles of the bands, variances left out: they follow from the grid and the limits
/// alone, whatever the waves. One where the map ends at 0.144 m or finer, two to 2 m, then three,
/// 6 times apart; the last ends at kShortestDetail, the sea's shortest_wavelength, or what its
/// samples hold (of maps that end at more than 13 m with 512). None where the map holds all that.
/// Needs validated parameters. Throws Error invalid_value for settings out of range.
std::vector<DetailBand> detail_bands(const Parameters& parameters, const DetailSettings& settings);

/// The slopes that a map of that resolution lacks, by band, at one time.
struct DetailBudget {
    std::vector<DetailBand> bands;
    /// Mean square slope of the waves shorter than the last band: roughness at any distance. The
    /// map's own (SeaState::map_slopes), the bands' and this are the sea's.
    double residual = 0.0;
};

/// Of a sea with that spectrum, without any map: a few milliseconds. Ocean keeps what it takes.
DetailBudget detail_budget(const Parameters& parameters, const DirectionalSpectrum& spectrum,
                           const DetailSettings& settings, ThreadPool& pool);
/// Memory that makes the maps, at most, the maps themselves left out.
std::uint64_t detail_bytes(const Parameters& parameters, const DetailSettings& settings,
                           const Backend& backend);

/// As users ask for them: all bands, or one. Each is the slope of its own waves.
inline constexpr auto kDetailProducts = [] {
    constexpr std::array<std::string_view, 1 + kMostDetailBands> kNames = {"detail", "detail1",
                                                                           "detail2", "detail3"};
    std::array<Product, kNames.size()> rows{};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i] = detail::product(kNames[i], {Channel::slope_x, Channel::slope_y}, Precision::half,
                                  RunLengths::always);
        rows[i].subject = kSeaKind;
    }
    return rows;
}();

/// Slope maps of one time, by label: linear fields, as `slope` of a Surface is. Row-major [j][i],
/// sample (i, j) at (i, j) * tile / samples, dh/dx and dh/dy interleaved. Each wave is so much
/// higher that, read bilinearly, slopes have the band's variance: a wave along a side by 3 % at 10
/// samples, by 22 % at 4.
class Detail {
  public:
    Detail() = default;
    /// The maps are not filled.
    Detail(double time, int samples, DetailBudget budget);

    double time() const { return time_; }
    int samples() const { return samples_; }
    const std::vector<DetailBand>& bands() const { return budget_.bands; }
    double residual() const { return budget_.residual; }
    /// 2 samples^2 values of a band.
    std::span<const float> slopes(std::size_t band) const { return maps_[band]; }
    std::span<float> slopes(std::size_t band) { return maps_[band]; }

  private:
    double time_ = 0.0;
    int samples_ = 0;
    DetailBudget budget_;
    std::vector<PageVector<float>> maps_;
};

}  // namespace ocean
