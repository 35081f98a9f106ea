// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Wakes on flat water as regions show them, against Kelvin, Michell and a towing tank.
#include <algorithm>
#include <array>
#include <complex>
#include <functional>
#include <memory>
#include <string>

#include "bench.hpp"
#include "literature.hpp"
#include "map_statistics.hpp"
#include "ocean/internal/fft.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::verify {
namespace {

/// Returns a track to the east, at (0, 0) at time 0.
std::shared_ptr<const HullTrack> straight(double speed, double from, double to) {
    auto track = std::make_shared<HullTrack>();
    track->rows = {{from, from * speed, 0.0}, {to, to * speed, 0.0}};
    return track;
}

Parameters calm_with(const Hull& hull, double depth) {
    Parameters parameters = wind_sea(0.0, 100e3, 32, 100.0);
    parameters.water.surface_tension = 0.0;
    parameters.water.depth = depth;
    parameters.hulls = {hull};
    return parameters;
}

constexpr double kDeep = std::numeric_limits<double>::infinity();

/// Heights of a wake on its own square, sample (0, 0) of which lies at `x`, `y`.
struct WakeMap {
    int side = 0;
    double x = 0.0, y = 0.0, cell = 0.0;
    std::vector<double> heights;

    double at(int i, int j) const {
        return heights[static_cast<std::size_t>(j) * static_cast<std::size_t>(side) +
                       static_cast<std::size_t>(i)];
    }
    int column(double place) const { return static_cast<int>(std::lround((place - x) / cell)); }
    int row(double place) const { return static_cast<int>(std::lround((place - y) / cell)); }
};

/// A factor of waves by k, k along x and k along y [rad/m].
using Filter = std::function<double(double k, double kx, double ky)>;

WakeMap filtered_wake(const Hull& hull, double depth, const Filter& filter, Bench& bench) {
    Ocean sea(calm_with(hull, depth), bench.options());
    const Domain domain = sea.wake_domain(0, 0.0);
    WakeMap map{domain.samples[0], domain.origin[0], domain.origin[1], domain.step(0), {}};
    std::vector<float> heights(domain.count());
    const MapOutput output{heights.data(), 1, {{{Channel::height, 1.0f}}}};
    sea.wake_into(0, 0.0, domain, {&output, 1});
    std::vector<std::complex<double>> waves = coefficients(heights);
    const double dk = 2.0 * kPi / (map.cell * map.side);
    for (int j = 0; j < map.side; ++j) {
        for (int i = 0; i < map.side; ++i) {
            const double kx = dk * wave_index(i, map.side);
            const double ky = dk * wave_index(j, map.side);
            waves[static_cast<std::size_t>(j * map.side + i)] *= filter(std::hypot(kx, ky), kx, ky);
        }
    }
    Radix2Fft<double>(map.side).transform_2d(waves, FftDirection::inverse);
    for (const auto& height : waves) map.heights.push_back(height.real());
    return map;
}

/// A hull so short that its waves come from one place, without the shortest of them, so that bow
/// and stern do not interfere.
WakeMap point_wake(double speed, double size, Bench& bench) {
    Hull hull;
    hull.length = 0.5;
    hull.beam = 0.1;
    hull.draught = 0.05;
    hull.factor = 10.0;
    hull.wake_size = size;
    hull.wake_resolution = 512;
    hull.wake_age = std::min(3600.0, 1.2 * size / speed);
    hull.track = straight(speed, -4000.0, 4000.0);
    const double blur = 0.05 * 2.0 * kPi * speed * speed / kG;
    return filtered_wake(
        hull, kDeep,
        [blur](double k, double kx, double ky) {
            return 1e4 * std::exp(-0.5 * blur * blur * ky * ky) / (1.0 + kx * kx * 7.5 * 7.5) /
                   (1.0 + 1.5 * k);
        },
        bench);
}

/// Returns the length of the waves on the line behind the hull, from the zeros of the height.
double transverse_length(const WakeMap& wake, double near, double far) {
    std::vector<Point> zeros;
    const int row = wake.row(0.0);
    for (int i = wake.column(-far); i < wake.column(-near); ++i) {
        const double a = wake.at(i, row), b = wake.at(i + 1, row);
        if (a * b > 0.0) continue;
        const auto count = static_cast<double>(zeros.size());
        zeros.push_back({count, wake.x + wake.cell * (i + a / (a - b))});
    }
    return 2.0 * slope_of(zeros);
}

/// Returns where the envelope of the crests has fallen, outside its highest, to the share of Airy's
/// function at the edge of the wedge: points of half a wedge.
std::vector<Point> wedge(const WakeMap& wake, double length, double near, double far) {
    constexpr double kLevel = 0.663;  // Ai(0) / max Ai
    std::vector<Point> edge;
    for (double x = near; x < far; x += 0.25 * length) {
        std::vector<double> envelope;
        for (int j = 1; j * wake.cell < 0.75 * far; ++j) {
            double top = 0.0;
            for (int i = wake.column(-x - 0.5 * length); i <= wake.column(-x + 0.5 * length); ++i) {
                top = std::max(top, std::abs(wake.at(i, wake.row(0.0) + j)));
            }
            envelope.push_back(top);
        }
        const auto peak = std::ranges::max_element(envelope);
        const auto below =
            std::find_if(peak, envelope.end(), [&](double e) { return e < kLevel * *peak; });
        const double before = *(below - 1);
        const double part = (before - kLevel * *peak) / (before - *below);
        edge.push_back({x, wake.cell * (static_cast<double>(below - envelope.begin()) + part)});
    }
    return edge;
}

void kelvin_rows(Bench& bench) {
    for (const double froude : {0.25, 0.4, 0.5}) {
        const double speed = froude * std::sqrt(kG * 30.0);
        const double length = 2.0 * kPi * speed * speed / kG;
        const double size = std::exp2(std::ceil(std::log2(52.0 * length)));
        const WakeMap wake = point_wake(speed, size, bench);
        const std::string number = plain_text(froude);
        const std::string method = "a hull of 0.5 m at " + significant_text(speed, 3) +
                                   " m/s, 512^2 samples of " + plain_text(wake.cell) + " m";
        bench.add({.id = "hulls.transverse_" + number,
                   .claim = "Length of transverse waves at " + significant_text(speed, 3) + " m/s",
                   .reference = "[Lamb 1932], Kelvin: 2 pi U^2/g",
                   .method = "zeros on the line behind " + method,
                   .unit = "m",
                   .expected = length,
                   .measured = transverse_length(wake, 15.0 + 2.0 * length, 0.4 * size),
                   .tolerance = 0.02 * length,
                   .bound = "2 %"});
        if (froude > 0.4) continue;
        const std::vector<Point> edge = wedge(wake, length, 6.0 * length, 0.5 * size);
        const double half_angle = std::asin(1.0 / 3.0);
        Row row{
            .id = "hulls.wedge_" + number,
            .claim = "Half-angle of the wake at " + significant_text(speed, 3) + " m/s",
            .reference = "[Lamb 1932], Kelvin: asin(1/3)",
            .method = "slope of the edge, where the envelope has fallen to Ai(0)/max Ai; " + method,
            .unit = "degrees",
            .expected = half_angle * 180.0 / kPi,
            .measured = std::atan(slope_of(edge)) * 180.0 / kPi,
            .tolerance = 0.5,
            .bound = "0.5 degrees",
            .plot = {.title = "Edge of the wake at " + significant_text(speed, 3) + " m/s",
                     .x_label = "distance behind the hull [m]",
                     .y_label = "distance of the edge [m]"}};
        const double offset = mean_of([&] {
            std::vector<double> offsets;
            for (const Point& point : edge) {
                offsets.push_back(point.y - std::tan(half_angle) * point.x);
            }
            return offsets;
        }());
        for (std::size_t i = 0; i < edge.size(); i += 3) row.plot.measured.push_back(edge[i]);
        for (const Point& point : {edge.front(), edge.back()}) {
            row.plot.curve.push_back({point.x, offset + std::tan(half_angle) * point.x});
        }
        bench.add(std::move(row));
    }
}

/// Returns Michell's resistance over rho [m^4/s^2] in deep water, of the waves that a lattice with
/// that Nyquist wavenumber holds: they fade out from 0.8 of it on.
double michell(const Hull& hull, double speed, double nyquist) {
    const double nu = kG / (speed * speed);
    const bool wigley = hull.shape == HullShape::wigley;
    const double volume = hull.length * hull.beam * hull.draught * (wigley ? 4.0 / 9.0 : 2.0 / 3.0);
    const auto term = [&](double x) {
        const double m = std::cosh(x), k = nu * m * m, along = nu * m;
        const double u = 0.5 * along * hull.length;
        const double water_line = 3.0 * (std::sin(u) - u * std::cos(u)) / (u * u * u);
        const double q = k * hull.draught;
        const double down =
            wigley ? 1.5 * integral([&](double s) { return (1.0 - s * s) * std::exp(-q * s); }, 0.0,
                                    1.0, 40)
                   : -std::expm1(-q) / q;
        const double t = std::clamp((k / nyquist - 0.8) / 0.2, 0.0, 1.0);
        const double kept = 1.0 - t * t * t * (10.0 + t * (6.0 * t - 15.0));
        return std::pow(along * 0.5 * volume * water_line * down * kept * m, 2.0);
    };
    return 4.0 * kG * kG / (kPi * speed * speed) * integral(term, 0.0, 3.2);
}

void shallow_row(Bench& bench) {
    constexpr double kDepth = 4.0, kSpeed = 9.0, kSize = 768.0;
    Hull hull;
    hull.length = 24.0;
    hull.beam = 4.0;
    hull.draught = 1.0;
    hull.wake_size = kSize;
    hull.wake_resolution = 512;
    hull.wake_age = 1.5 * kSize / kSpeed;
    hull.track = straight(kSpeed, -4000.0, 4000.0);
    const WakeMap wake = filtered_wake(
        hull, kDepth, [](double, double, double ky) { return std::exp(-0.5 * 2.25 * ky * ky); },
        bench);
    std::vector<Point> crests;
    for (double x = 60.0; x < 300.0; x += 4.0) {
        const int i = wake.column(-x), middle = wake.row(0.0);
        double highest = 0.0;
        for (int j = middle; j + 1 < wake.side; ++j) highest = std::max(highest, wake.at(i, j));
        int outermost = 0;
        for (int j = middle + 1; j + 1 < wake.side; ++j) {
            if (wake.at(i, j) > wake.at(i, j - 1) && wake.at(i, j) >= wake.at(i, j + 1) &&
                wake.at(i, j) > 0.06 * highest) {
                outermost = j - middle;
            }
        }
        if (outermost * wake.cell > 0.28 * kSize) continue;
        crests.push_back({-(wake.x + i * wake.cell), outermost * wake.cell});
    }
    bench.add({.id = "hulls.supercritical",
               .claim = "Angle of the foremost waves at 9 m/s in 4 m of water",
               .reference = "asin(sqrt(g d)/U)",
               .method =
                   "outermost crests from 60 to 300 m behind a hull of 24 m, 512^2 samples of "
                   "1.5 m",
               .unit = "degrees",
               .expected = std::asin(std::sqrt(kG * kDepth) / kSpeed) * 180.0 / kPi,
               .measured = std::atan(slope_of(crests)) * 180.0 / kPi,
               .tolerance = 0.5,
               .bound = "0.5 degrees"});
}

/// The profile along the side of Wigley's model, L : B : T = 16 : 1.6 : 1, at the Froude number
/// 0.25: place from the middle of the hull astern in half lengths, height times 2 g/U^2.
constexpr Point kTank[] = {
    {-1.0, 0.177},  {-0.95, 0.378}, {-0.9, 0.374},  {-0.85, 0.281}, {-0.8, 0.151},
    {-0.7, -0.077}, {-0.6, -0.174}, {-0.5, -0.191}, {-0.4, -0.120}, {-0.3, -0.050},
    {-0.2, -0.016}, {-0.1, 0.022},  {0.0, 0.014},   {0.1, -0.027},  {0.2, -0.073},
    {0.3, -0.086},  {0.4, -0.080},  {0.5, -0.056},  {0.6, -0.046},  {0.7, -0.003},
    {0.8, 0.012},   {0.85, 0.013},  {0.9, 0.027},   {0.95, 0.070},  {1.0, 0.187}};

void tank_rows(Bench& bench) {
    constexpr double kLength = 100.0;
    const double speed = 0.25 * std::sqrt(kG * kLength);
    Hull hull;
    hull.length = kLength;
    hull.beam = kLength / 10.0;
    hull.draught = kLength / 16.0;
    hull.shape = HullShape::wigley;
    hull.wake_size = 6.0 * kLength;
    hull.wake_resolution = 512;
    hull.track = straight(speed, -1000.0, 1000.0);
    Ocean sea(calm_with(hull, kDeep), bench.options());
    // The centre plane stands for the side of a thin hull: samples 2.5 m apart.
    const Domain line{{-50.0, 0.0}, {100.0, 2.5}, {41, 2}, false};
    std::vector<float> heights(line.count());
    const MapOutput output{heights.data(), 1, {{{Channel::height, 1.0f}}}};
    sea.wake_into(0, 0.0, line, {&output, 1});
    Plot plot{.title = "Along the side of Wigley's model, and in the tank",
              .x_label = "place, in half lengths from the middle astern",
              .y_label = "height times 2 g/U^2"};
    double error = 0.0, energy = 0.0, bow = 0.0, measured_bow = 0.0;
    for (const Point& there : kTank) {
        const double column = std::round((1.0 - there.x) * 20.0);
        const double height = static_cast<double>(heights[static_cast<std::size_t>(column)]) * 2.0 *
                              kG / (speed * speed);
        plot.curve.push_back(there);
        plot.measured.push_back({there.x, height});
        error += std::pow(height - there.y, 2.0);
        energy += there.y * there.y;
        bow = std::max(bow, height);
        measured_bow = std::max(measured_bow, there.y);
    }
    const std::string reference =
        "[ITTC 1983], towing tank of IHI: Wigley's model, Froude number 0.25";
    const std::string method =
        "heights on the centre plane, which stands for the side of a thin "
        "hull, of 512^2 samples of 6 lengths";
    bench.add({.id = "hulls.bow_wave",
               .claim = "Bow wave of Wigley's model",
               .kind = Kind::physics,
               .reference = reference,
               .method = "the highest of " + method,
               .unit = "U^2/2g",
               .expected = measured_bow,
               .measured = bow,
               .tolerance = 0.05 * measured_bow,
               .bound = "5 %",
               .plot = std::move(plot)});
    bench.add({.id = "hulls.profile",
               .claim = "Profile along the side of Wigley's model",
               .kind = Kind::physics,
               .reference = reference,
               .method = "rms of the difference over the rms of the profile, of " + method,
               .measured = std::sqrt(error / energy),
               .tolerance = 0.45,
               .bound =
                   "theory of thin hulls has no boundary layer: the hollow behind the middle is "
                   "too deep, the rise at the stern missing"});
}

}  // namespace

Row michell_row(Bench& bench, Hull hull, double speed, Row row) {
    const double size = 25.6 * hull.length;
    hull.track = straight(speed, 0.0, 2.0 * size / speed);
    hull.wake_size = size;
    hull.wake_resolution = 512;
    hull.wake_age = 3600.0;
    hull.factor = 1.0;
    Ocean sea(calm_with(hull, kDeep), bench.options());
    std::vector<Point> energies;
    // All waves of such runs are well within the square.
    for (const double run : {0.24, 0.34, 0.44, 0.54}) {
        const double time = run * size / speed;
        const Domain domain = sea.wake_domain(0, time);
        std::vector<float> heights(domain.count()), rates(domain.count());
        const std::array<MapOutput, 2> outputs = {
            MapOutput{heights.data(), 1, {{{Channel::height, 1.0f}}}},
            MapOutput{rates.data(), 1, {{{Channel::vz, 1.0f}}}}};
        sea.wake_into(0, time, domain, outputs);
        const auto height = coefficients(heights), rate = coefficients(rates);
        double energy = 0.0;
        for (std::size_t at = 1; at < height.size(); ++at) {
            const double k =
                2.0 * kPi / size * std::hypot(wave_index(at % 512, 512), wave_index(at / 512, 512));
            energy += kG * std::norm(height[at]) + std::norm(rate[at]) / k;
        }
        energies.push_back({run * size, 0.5 * size * size * energy});
    }
    row.reference =
        "[Michell 1898]: the resistance by waves of a thin hull, of those that the "
        "lattice holds";
    row.method = "energy of the waves gained per metre, rho = 1, at " + significant_text(speed, 3) +
                 " m/s; 512^2 samples of " + significant_text(size / 512.0, 3) + " m" + row.method;
    row.unit = "m^4/s^2";
    row.expected = michell(hull, speed, kPi * 512.0 / size);
    row.measured = slope_of(energies);
    row.tolerance = 0.01 * row.expected;
    row.bound = "1 %";
    return row;
}

void verify_hulls(Bench& bench) {
    kelvin_rows(bench);
    Hull hull;
    hull.length = 10.0;
    hull.beam = 1.0;
    hull.draught = 0.625;
    for (const HullShape shape : {HullShape::wall_sided, HullShape::wigley}) {
        hull.shape = shape;
        for (const double froude : {0.32, 0.5, 1.0}) {
            const bool wigley = shape == HullShape::wigley;
            bench.add(michell_row(bench, hull, froude * std::sqrt(kG * hull.length),
                                  {.id = std::string("hulls.michell_") +
                                         (wigley ? "wigley_" : "wall_sided_") + plain_text(froude),
                                   .claim = std::string("Energy of the wake of a ") +
                                            (wigley ? "Wigley" : "wall-sided") +
                                            " hull at Froude number " + plain_text(froude),
                                   .method = ", length 10 m"}));
        }
    }
    shallow_row(bench);
    tank_rows(bench);
}

}  // namespace ocean::verify
