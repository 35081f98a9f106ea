// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The octaves of the gullies and the choice of the loop over points; see gullies.hpp.
#include "ocean/internal/gullies.hpp"

#include <cmath>
#include <cstddef>
#include <string>

#include "land/gullies/gullies_task.hpp"
#include "land/land.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/text.hpp"

namespace ocean {

namespace {

constexpr double kNextWeight = 0.6;
constexpr double kMaxPoints = 2147483647.0;  // max points of an octave's lattice along a period

static_assert(sizeof(GullyTask::octave) == kMaxGullyOctaves * sizeof(GullyOctaveTask));

[[noreturn]] void refuse(const char* parameter, double value, const std::string& allowed) {
    throw Error(ErrorKind::invalid_value, {.what = "is out of range",
                                           .parameter = parameter,
                                           .value = shortest_text(value),
                                           .allowed = allowed});
}

void require_within(const char* parameter, double value, double lowest, double highest) {
    if (value >= lowest && value <= highest) return;
    refuse(parameter, value, shortest_text(lowest) + " .. " + shortest_text(highest));
}

void validate(const GullySettings& settings) {
    require_within("gullies.octaves", settings.octaves, 1, kMaxGullyOctaves);
    require_within("gullies.longest", settings.longest, 1e-3, 1e7);
    require_within("gullies.depth", settings.depth, 0.0, 1.0);
    require_within("gullies.crease", settings.crease, 0.0, 1.0);
    require_within("gullies.flat", settings.flat, 1e-6, 1e6);
    if (settings.period == 0.0) return;
    const double shortest = std::ldexp(settings.longest, 1 - settings.octaves);
    const double longest_period = kMaxPoints / 2.0 * shortest;
    require_within("gullies.period", settings.period, 4.0 * settings.longest, longest_period);
}

/// Returns the octaves; with a period their wavelengths are whole parts of it.
std::vector<GullyOctave> make_octaves(const GullySettings& settings) {
    std::vector<GullyOctave> octaves;
    double weight = 1.0;
    for (int o = 0; o < settings.octaves; ++o) {
        GullyOctave octave;
        octave.wavelength = std::ldexp(settings.longest, -o);
        if (settings.period > 0.0) {
            const double count = std::round(settings.period / octave.wavelength);
            octave.count = static_cast<std::uint32_t>(count);
            octave.wavelength = settings.period / count;
        }
        // Octaves of neighbouring seeds share no key.
        const auto bits = settings.seed * 0xCB1AB31Fu + static_cast<std::uint32_t>(o);
        octave.key = land::single_precision::gully_hash(bits);
        octave.weight = weight;
        weight *= kNextWeight;
        octaves.push_back(octave);
    }
    return octaves;
}

/// Returns the roundness e of ridges.
double roundness(double crease) {
    return 0.03 + 0.6 * (1.0 - crease);
}

GullyOctaveTask octave_task(const GullyOctave& octave, double depth, double share) {
    GullyOctaveTask task;
    const double count = octave.count;
    task.points_per_metre = 1.0 / octave.wavelength;
    task.count = count;
    task.periods_per_point = count > 0.0 ? 1.0 / count : 0.0;
    task.height = static_cast<float>(depth * octave.wavelength * share);
    task.steepness = static_cast<float>(kTwoPi * depth * share);
    task.weight = static_cast<float>(octave.weight * share);
    task.key = octave.key;
    task.last = octave.count - 1u;
    return task;
}

float* data_of(std::span<float> mask, std::size_t count) {
    if (mask.empty()) return nullptr;
    if (mask.size() == count) return mask.data();
    throw Error(ErrorKind::invalid_value, "a mask of gullies has not the size of the places");
}

}  // namespace

GullyTask make_gully_task(const GullyFilter& filter, double cell) {
    const GullySettings& settings = filter.settings();
    GullyTask task = {};
    const double e = roundness(settings.crease);
    task.flat_square = static_cast<float>(settings.flat * settings.flat);
    task.roundness = static_cast<float>(e);
    task.mean = static_cast<float>(gully_crease_mean(settings.crease));
    task.short_mean = static_cast<float>(gully_crease_mean(settings.crease, 0.0));
    task.profile = static_cast<float>(2.0 / (std::sqrt(1.0 + e * e) - e));
    double weights = 0.0;
    for (const GullyOctave& octave : filter.octaves()) {
        weights += octave.weight;
        const double share = gully_share(octave.wavelength, cell);
        if (share == 0.0) continue;
        task.octave[task.octaves++] = octave_task(octave, settings.depth, share);
    }
    task.wear_scale = static_cast<float>(1.0 / weights);
    return task;
}

double gully_share(double wavelength, double cell) {
    return land::double_precision::gully_share(wavelength, cell);
}

// With theta half of the phase, (1 - r cos 2 theta)/2 + e^2 = B^2 + r sin^2 theta, B^2 = (1 - r)/2
// + e^2, so that the mean of its root is (2 / pi) H E(k), H^2 = B^2 + r, k = sqrt(r) / H. E follows
// from arithmetic and geometric means a, b that begin at 1 and k' = B / H, with c = k: E = pi / (2
// a) (1 - sum of 2^(n-1) c_n^2) [Abramowitz and Stegun 1964] 17.6.3, 17.6.4. Each step squares the
// distance of the means.
double gully_crease_mean(double crease, double length) {
    const double e = roundness(crease);
    const double longer = std::sqrt(0.5 * (1.0 + length) + e * e);
    double a = 1.0;
    double b = std::sqrt(0.5 * (1.0 - length) + e * e) / longer;
    double c = std::sqrt(length) / longer;
    double sum = 0.5 * c * c;
    for (double power = 1.0; power < 1024.0; power *= 2.0) {  // 10 steps; 6 reach the last digit
        c = 0.5 * (a - b);
        const double mean = 0.5 * (a + b);
        b = std::sqrt(a * b);
        a = mean;
        sum += power * c * c;
    }
    const double mean_root = longer / a * (1.0 - sum);
    return 1.0 - 2.0 * (mean_root - e);
}

GullyFilter::GullyFilter(const GullySettings& settings) : settings_(settings) {
    validate(settings);
    octaves_ = make_octaves(settings);
}

void GullyFilter::apply(const GullyPoints& points, double cell) const {
    const std::size_t count = points.x.size();
    for (const std::size_t size :
         {points.y.size(), points.height.size(), points.slope_x.size(), points.slope_y.size()}) {
        if (size == count) continue;
        throw Error(ErrorKind::invalid_value, "places, heights and slopes differ in number");
    }
    if (!(cell >= 0.0) || !std::isfinite(cell)) refuse("cell", cell, "0 or more metres");
    const GullyArrays arrays = {count,
                                points.x.data(),
                                points.y.data(),
                                points.height.data(),
                                points.slope_x.data(),
                                points.slope_y.data(),
                                data_of(points.wear, count),
                                data_of(points.gully, count),
                                data_of(points.ridge, count)};
    gully_loop(simd_level())(make_gully_task(*this, cell), arrays);
}

}  // namespace ocean
