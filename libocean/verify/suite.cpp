// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The table of the groups, and the verdict on a row.
#include "ocean/internal/verify.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bench.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/fft.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::verify {
namespace {

using RunGroup = void (*)(Bench&);
constexpr std::array kGroups = {Group{"spectra", "Spectra and directions"},
                                Group{"statistics", "Energy of maps over seeds, grids and patches"},
                                Group{"propagation", "Speed and direction of waves"},
                                Group{"foam", "Whitecaps and foam"},
                                Group{"terrain", "Terrain"},
                                Group{"coast", "Waves at a coast"},
                                Group{"hulls", "Wakes of hulls"},
                                Group{"backends", "Instruction sets, reference backends and GPU"},
                                Group{"sea", "The given sea"}};
constexpr std::array<RunGroup, kGroups.size()> kRuns = {
    verify_spectra, verify_statistics, verify_propagation, verify_foam, verify_terrain,
    verify_coast,   verify_hulls,      verify_backends,    verify_sea};

constexpr std::array<std::string_view, 9> kNotModelled = {
    "Waves that overturn, splash or exchange energy: the sea is a sum of linear waves with a "
    "choppy displacement, and of second order where a file asks for it.",
    "Currents, tides and the growth of waves while the wind blows: a sea has one state, or that of "
    "its take.",
    "Diffraction, reflection, and wave-driven currents at a coast.",
    "Waves at a coast that turn by more than 75 degrees; in lees, any but the first to arrive.",
    "Set-up by radiation stress: it is a ramp to the measured height.",
    "Foam that drifts with a current, and foam that a wake leaves behind.",
    "Planing hulls, propellers, the sheet of water at the bow, drift, banks.",
    "Refraction of a wake by the sea's own waves, and waves that both bind.",
    "A spectrum's tail beyond the last frequency of a measurement."};

bool is_asked(const Request& request, const Group& group) {
    if (group.name == "sea" && !request.sea) return false;
    return request.only.empty() || std::ranges::count(request.only, group.name) > 0;
}

}  // namespace

std::string_view verdict_name(Verdict verdict) {
    switch (verdict) {
        case Verdict::pass:
            return "pass";
        case Verdict::fail:
            return "fail";
        case Verdict::shortfall:
            return "shortfall";
        case Verdict::not_run:
            break;
    }
    return "not run";
}

Verdict Row::verdict() const {
    if (!not_run.empty()) return Verdict::not_run;
    // A NaN is no pass.
    if (std::abs(measured - expected) <= tolerance) return Verdict::pass;
    return shortfall.empty() ? Verdict::fail : Verdict::shortfall;
}

double Row::digits() const {
    const double error =
        std::abs(measured - expected) / (expected == 0.0 ? 1.0 : std::abs(expected));
    return std::clamp(-std::log10(std::max(error, 1e-15)), 0.0, 15.0);
}

std::span<const Group> groups() {
    return kGroups;
}
std::span<const std::string_view> not_modelled() {
    return kNotModelled;
}

Parameters wind_sea(double wind, double fetch, int resolution, double patch_size) {
    Parameters parameters;
    parameters.grid.resolution = resolution;
    parameters.grid.patch_size = patch_size;
    WaveSystem& system = parameters.waves.front();
    system.spectrum = SpectrumKind::jonswap;
    system.spreading = SpreadingKind::hasselmann;
    system.wind_speed = wind;
    system.fetch = fetch;
    return parameters;
}

double slope_of(std::span<const Point> points, double (*weight)(const Point&)) {
    double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const Point& point : points) {
        const double w = weight(point);
        n += w;
        x += w * point.x;
        y += w * point.y;
        xx += w * point.x * point.x;
        xy += w * point.x * point.y;
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

std::vector<std::complex<double>> coefficients(std::span<const float> map) {
    std::vector<std::complex<double>> values(map.begin(), map.end());
    const auto side = static_cast<int>(std::lround(std::sqrt(static_cast<double>(map.size()))));
    Radix2Fft<double>(side).transform_2d(values, FftDirection::forward);
    for (auto& value : values) value /= static_cast<double>(values.size());
    return values;
}

std::vector<Row> run(const Request& request) {
    for (const std::string& name : request.only) {
        if (std::ranges::count(kGroups, name, &Group::name) > 0) continue;
        throw Error(ErrorKind::invalid_value,
                    "unknown group '" + name + "'" + did_you_mean(name, kGroups, &Group::name) +
                        "; known: " + joined(kGroups, ", ", &Group::name));
    }
    Bench bench(request);
    for (std::size_t i = 0; i < kGroups.size(); ++i) {
        if (!is_asked(request, kGroups[i])) continue;
        if (request.begin) request.begin(kGroups[i]);
        kRuns[i](bench);
    }
    return std::move(bench.rows);
}

}  // namespace ocean::verify
