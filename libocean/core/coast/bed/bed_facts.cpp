// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Facts and warnings of a bed; see sea_bed.hpp.
#include <algorithm>
#include <cmath>

#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/internal/dispersion.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/sea_bed.hpp"

namespace ocean {
namespace {

// Limits of a plausible bed: heights beyond them occur on no coast.
constexpr double kMostRange = 9000.0;  // from a summit to a deep-sea plain [m]
constexpr double kLeastRange = 0.1;    // [m]
constexpr double kFarthest = 200.0;    // max distance of a whole bed from still water [m]
/// Below this share of water a coast is more likely upside down.
constexpr double kNearlyDry = 0.02;

std::string metres(double value) {
    return significant_text(value, 4) + " m";
}

}  // namespace

SeaBedSummary summarize(const SeaBed& bed, const Water& water) {
    SeaBedSummary facts{.samples = bed.domain.samples, .cell = bed.cell(), .sha256 = bed.sha256};
    const auto [lowest, highest] = std::ranges::minmax(bed.heights);
    facts.lowest = double{lowest};
    facts.highest = double{highest};
    double sum = 0.0;
    std::size_t wet = 0, shallow = 0;
    for (const float h : bed.heights) {
        sum += double{h};
        wet += h < 0.0f ? 1u : 0u;
        shallow += h < 0.0f && -double{h} < water.depth ? 1u : 0u;
    }
    const double count = static_cast<double>(bed.heights.size());
    facts.mean = sum / count;
    facts.wet = static_cast<double>(wet) / count;
    facts.shallow = static_cast<double>(shallow) / count;
    return facts;
}

std::vector<std::string> bed_warnings(const SeaBed& bed, const Water& water) {
    std::vector<std::string> warnings;
    const auto warn = [&](const std::string& text) { warnings.push_back("water.seabed: " + text); };
    for (const std::string& note : bed.notes) warn(note);
    const SeaBedSummary facts = summarize(bed, water);
    const std::string range = metres(facts.lowest) + " to " + metres(facts.highest);
    if (facts.wet == 0.0) {
        warn("the bed is land alone, from " + range +
             " over still water: check seabed_sign and level");
    } else if (facts.wet < kNearlyDry) {
        warn("only " + significant_text(100.0 * facts.wet, 2) +
             " % of the bed lies below still water, from " + range +
             ": its heights may be depths, which seabed_sign = \"down\" turns over");
    }
    if (facts.highest < 0.0) {
        warn("the bed is water alone, from " + metres(-facts.highest) + " to " +
             metres(-facts.lowest) + " deep: it has no shore");
    }
    if (facts.shallow == 0.0 && facts.wet > 0.0) {
        warn("no water over the bed is shallower than water.depth = " + metres(water.depth) +
             ": the waves do not feel it");
    }
    const double height = facts.highest - facts.lowest;
    if (height > kMostRange) {
        warn("its heights differ by " + metres(height) +
             ", more than on any coast: check seabed_unit");
    }
    if (height < kLeastRange) {
        warn("its heights differ by " + metres(height) +
             ", less than on any coast: check "
             "seabed_unit");
    }
    const bool is_high = facts.lowest > kFarthest, is_deep = facts.highest < -kFarthest;
    if (is_high || is_deep) {
        warn("the whole bed lies more than " + metres(is_high ? facts.lowest : -facts.highest) +
             (is_high ? " above" : " below") + " still water: level = " + metres(water.level) +
             " may count from another datum");
    }
    return warnings;
}

namespace {

/// Water of at least this share of a depth counts as that deep.
constexpr double kAsDeep = 0.98;

/// The bed along the sides by which waves come in.
struct Inflow {
    std::size_t samples = 0;
    std::size_t dry = 0;
    std::size_t shallow = 0;   // wet samples shallower than half a wavelength
    double shallowest = 1e30;  // of the wet samples [m]
    double deepest = 0.0;      // [m]
    double depths = 0.0;       // sum over the wet samples [m]

    double mean_depth() const { return dry < samples ? depths / double(samples - dry) : 0.0; }
};

/// Returns the sides by which waves with a travel direction [rad] come in.
Inflow inflow_of(const SeaBed& bed, double direction, double enough) {
    // Waves that run along a side do not enter by it.
    constexpr double kLeast = 0.2;
    const int columns = bed.domain.samples[0];
    const int rows = bed.domain.samples[1];
    Inflow inflow;
    const auto add = [&](int i, int j) {
        const double depth =
            -double{bed.heights[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) +
                                static_cast<std::size_t>(i)]};
        ++inflow.samples;
        if (depth <= 0.0) {
            ++inflow.dry;
            return;
        }
        inflow.shallow += depth < enough ? 1u : 0u;
        inflow.shallowest = std::min(inflow.shallowest, depth);
        inflow.deepest = std::max(inflow.deepest, depth);
        inflow.depths += depth;
    };
    const double x = std::cos(direction);
    const double y = std::sin(direction);
    for (int j = 0; j < rows && std::abs(x) > kLeast; ++j) add(x > 0.0 ? 0 : columns - 1, j);
    for (int i = 0; i < columns && std::abs(y) > kLeast; ++i) add(i, y > 0.0 ? 0 : rows - 1);
    return inflow;
}

std::string percent(std::size_t part, std::size_t whole) {
    return significant_text(100.0 * static_cast<double>(part) / static_cast<double>(whole), 3) +
           " %";
}

double wavelength_of(double omega, const Water& water) {
    return omega > 0.0 ? kTwoPi / Dispersion(water).wavenumber(omega) : 0.0;
}

SpectralMoments moments_of(const Parameters& parameters) {
    return make_directional_spectrum(parameters)
        .moments(parameters.water, parameters.surface.shortest_wavelength,
                 parameters.surface.longest_wavelength);
}

}  // namespace

IncomingWaves incoming_waves(const Parameters& parameters) {
    const Water& water = parameters.water;
    const SpectralMoments all = moments_of(parameters);
    IncomingWaves waves{.systems = {},
                        .peak_wavelength = wavelength_of(all.peak_omega, water),
                        .period = parameters.grid.patch_size,
                        .depth = water.depth};
    Parameters alone = parameters;
    for (std::size_t i = 0; i < parameters.waves.size(); ++i) {
        const bool is_only = parameters.waves.size() == 1;
        if (!is_only) alone.waves = {parameters.waves[i]};
        const SpectralMoments system = is_only ? all : moments_of(alone);
        if (!(system.m0 > 0.0)) continue;
        waves.systems.push_back({is_only ? "" : "waves." + std::to_string(i),
                                 wavelength_of(system.peak_omega, water), system.mean_direction});
    }
    return waves;
}

namespace {

/// Returns a sentence if the waves of every system come from land that has more and deeper water
/// behind it. This excludes the mouth of a bay, which is deeper than the bay, an island, whose far
/// side is land too, and a lake, whose sides are alike.
std::string turned_over_warning(const SeaBed& bed, const IncomingWaves& waves) {
    std::string text;
    for (const IncomingWaves::System& system : waves.systems) {
        const Inflow in = inflow_of(bed, system.direction, 0.0);
        const Inflow out = inflow_of(bed, system.direction + kPi, 0.0);
        // A quarter of the sides, since oblique waves share two sides with the waves from behind.
        const bool is_turned = 2 * in.dry > in.samples && 4 * in.dry > 4 * out.dry + in.samples &&
                               out.mean_depth() > in.mean_depth();
        if (!is_turned) return "";
        if (!text.empty()) continue;
        text = "the waves come in by sides that are " + percent(in.dry, in.samples) +
               " land, and those behind are " + percent(out.samples - out.dry, out.samples) +
               " water, " + metres(out.mean_depth()) +
               " deep in the mean: the bed may be upside down, which seabed_sign = \"" +
               (bed.sign == BedSign::up ? "down" : "up") + "\" turns over";
    }
    return text;
}

/// Returns a sentence if the sea and the bed where its waves come in differ in depth as a foot and
/// a metre do.
std::string unit_warning(const SeaBed& bed, const IncomingWaves& waves) {
    constexpr double kSame = 0.02;
    const bool is_metres = bed.unit == BedUnit::m;
    const double foot = metres_of(is_metres ? BedUnit::ft : bed.unit);
    for (const IncomingWaves::System& system : waves.systems) {
        const double deepest = inflow_of(bed, system.direction, 0.0).deepest;
        const double ratio = deepest / waves.depth;
        if (std::abs(ratio * (is_metres ? foot : 1.0 / foot) - 1.0) > kSame) continue;
        return "it is " + metres(deepest) + " deep where the waves come in, " +
               significant_text(ratio, 3) + " times water.depth = " + metres(waves.depth) +
               ", as heights in " + (is_metres ? "feet" : "metres") + " are that count as " +
               (is_metres ? "metres" : "feet") + ": check seabed_unit";
    }
    return "";
}

}  // namespace

std::vector<std::string> coast_warnings(const SeaBed& bed, const IncomingWaves& waves) {
    std::vector<std::string> warnings;
    const auto warn = [&](const std::string& text) { warnings.push_back("water.seabed: " + text); };
    for (const IncomingWaves::System& system : waves.systems) {
        const double enough = kAsDeep * std::min(0.5 * system.peak_wavelength, waves.depth);
        const Inflow inflow = inflow_of(bed, system.direction, enough);
        const std::string of = system.name.empty() ? "" : " of " + system.name;
        if (inflow.dry == inflow.samples) {
            warn("the sides by which the waves" + of +
                 " come in are land alone: no wave reaches the bed");
        } else if (inflow.shallow > 0) {
            warn("the waves" + of + " come in over " + percent(inflow.shallow, inflow.samples) +
                 " of those sides in water shallower than half a peak wavelength, " +
                 metres(0.5 * system.peak_wavelength) + ", down to " + metres(inflow.shallowest) +
                 ": what the bed beyond has done to them is not known; a larger bed shows it");
        }
    }
    for (const std::string& text : {turned_over_warning(bed, waves), unit_warning(bed, waves)}) {
        if (!text.empty()) warn(text);
    }
    // Deeper ground counts as level at water.depth: waves twice as long as that depth do not feel
    // it.
    const auto is_deeper = [&](float h) { return -kAsDeep * double{h} > waves.depth; };
    const auto deeper = static_cast<std::size_t>(std::ranges::count_if(bed.heights, is_deeper));
    if (deeper > 0 && waves.depth < 0.5 * waves.peak_wavelength) {
        warn(percent(deeper, bed.heights.size()) + " of the bed is deeper than water.depth = " +
             metres(waves.depth) + ", less than half a peak wavelength: the waves are as over " +
             metres(waves.depth) + " there; a larger water.depth lets them feel the bed");
    }
    constexpr double kCoarse = 1.0 / 8.0;  // of a wavelength
    if (bed.cell() > kCoarse * waves.peak_wavelength) {
        warn("its cells of " + metres(bed.cell()) + " are coarse for waves of " +
             metres(waves.peak_wavelength) + ": where these break it has few samples");
    }
    const double size = std::max(bed.domain.size[0], bed.domain.size[1]);
    if (size < waves.peak_wavelength) {
        warn("the bed is " + metres(size) + " long, less than a peak wavelength, " +
             metres(waves.peak_wavelength) + ": check the unit of its cells");
    }
    if (size > waves.period) {
        warn("the bed is " + metres(size) + " long and the waves offshore repeat every " +
             metres(waves.period) + ": a larger grid.patch_size hides the repeat");
    }
    return warnings;
}

std::vector<std::string> region_warnings(const SeaBed& bed, const Domain& region) {
    std::size_t beyond = 0;
    for (int j = 0; j < region.samples[1]; ++j) {
        for (int i = 0; i < region.samples[0]; ++i) {
            const auto [x, y] = region.place(i, j);
            beyond += is_over(bed, x, y) ? 0u : 1u;
        }
    }
    if (beyond == 0) return {};
    const auto side = [&](std::size_t axis, const char* name) {
        constexpr int kDigits = 9;
        const double first = bed.domain.origin[axis];
        return significant_text(first, kDigits) + " .. " +
               significant_text(first + bed.domain.size[axis], kDigits) + " m along " + name;
    };
    return {"water.seabed: " + percent(beyond, region.count()) +
            " of the region lies beyond the bed, " + side(0, "x") + " and " + side(1, "y") +
            ": the sea is open there, whatever ground its depth is over"};
}

}  // namespace ocean
