// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The roles of variables: see netcdf_layout.hpp.
#include "netcdf_layout.hpp"

#include <algorithm>
#include <string_view>

#include "bin_directions.hpp"
#include "cf_units.hpp"
#include "names.hpp"
#include "ocean/internal/checked_text.hpp"

namespace ocean::netcdf {
namespace {

bool has(const std::vector<std::size_t>& all, std::size_t one) {
    return std::find(all.begin(), all.end(), one) != all.end();
}

/// Compares standard names; some versions of WAVEWATCH III write blanks for underscores.
std::string standard_name(const Variable& variable) {
    std::string name = variable.attribute("standard_name");
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

bool is_frequency(const std::string& name, const std::string& standard) {
    const std::string plain = plain_name(name);
    return among(plain, {"freq", "freqs", "frequency", "frequencies", "frequencynumber",
                         "wavefrequency", "wavefrequencies", "centerfrequency", "f"}) ||
           plain.starts_with("wavewpm") ||
           among(standard, {"sea_surface_wave_frequency", "wave_frequency"});
}

bool is_direction(const std::string& name, const std::string& standard) {
    return among(plain_name(name), {"dir", "dirs", "direction", "directions", "directionnumber",
                                    "wavedirection", "wavedirections", "wavedirectionbins",
                                    "directionbins", "directionbin", "theta"}) ||
           among(standard, {"sea_surface_wave_from_direction", "sea_surface_wave_to_direction"});
}

constexpr std::string_view kDirectional = "sea_surface_wave_directional_variance_spectral_density";
constexpr std::string_view kOmnidirectional = "sea_surface_wave_variance_spectral_density";

/// Returns the rank of a variable as the spectrum: well-known names before standard names before
/// units. 0 means that it is not a spectrum.
int spectrum_rank(const Variable& variable) {
    if (variable.is_text || plain_name(variable.name).starts_with("std")) return 0;
    const std::string plain = plain_name(variable.name);
    const std::string standard = standard_name(variable);
    if (among(plain, {"efth", "ef", "d2fd", "spectralwavedensity", "waveenergydensity",
                      "directionalwaveenergydensity", "vspec1d", "swden", "c11", "energy1d",
                      "spectraldensity", "variancedensity", "directionalvariancedensity"})) {
        return 3;
    }
    if (standard == kDirectional || standard == kOmnidirectional) return 2;
    return parse_density_units(variable.attribute("units"), DensityOver::frequency).fault.empty() ||
                   parse_density_units(variable.attribute("units"),
                                       DensityOver::frequency_and_direction)
                       .fault.empty()
               ? 1
               : 0;
}

/// A candidate of a search with its rank.
struct Candidate {
    std::size_t variable = 0;
    int rank = 0;
};

class Finder {
  public:
    explicit Finder(const Content& content) : content_(content) {
        layout_.spectrum = find_spectrum();
        left_ = spectrum().dimensions;
    }

    Layout find() {
        std::vector<std::size_t> sorted = left_;
        std::sort(sorted.begin(), sorted.end());
        if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
            throw fail("has a dimension twice");
        }
        const auto frequency = find_axis(spectrum(), is_frequency, layout_.frequency);
        if (!frequency) throw fail("has no dimension of frequencies (freq, frequency)");
        layout_.frequency_dimension = *frequency;
        std::erase(left_, *frequency);
        layout_.direction_dimension = find_axis(spectrum(), is_direction, layout_.direction);
        if (layout_.direction_dimension) std::erase(left_, *layout_.direction_dimension);
        if (!layout_.frequency) layout_.frequency = find_frequencies_of_records();
        find_time();
        layout_.latitude =
            find_place("latitude", {"latitude", "lat", "metastationlatitude", "metadeploylatitude",
                                    "metalatitude", "gpslatitude"});
        layout_.longitude =
            find_place("longitude", {"longitude", "lon", "metastationlongitude",
                                     "metadeploylongitude", "metalongitude", "gpslongitude"});
        layout_.depth =
            find_place("sea_floor_depth_below_sea_surface",
                       {"dpt", "depth", "waterdepth", "metawaterdepth", "bath", "nominaldepth"});
        layout_.station = find_station();
        layout_.scale = find_scale();
        if (!layout_.direction_dimension) find_bins();
        find_flags();
        for (const std::size_t dimension : left_) require_place(dimension);
        layout_.outer_dimensions.insert(layout_.outer_dimensions.end(), left_.begin(), left_.end());
        return std::move(layout_);
    }

  private:
    const Variable& spectrum() const { return content_.variables[layout_.spectrum]; }
    const std::string& dimension_name(std::size_t dimension) const {
        return content_.dimensions[dimension].name;
    }
    Fault fail(const std::string& message) const { return {spectrum().name, message}; }

    /// Returns the variable of the best rank, the first one of equals.
    template <typename Rank>
    std::optional<std::size_t> best(Rank rank_of) const {
        Candidate found;
        for (std::size_t i = 0; i < content_.variables.size(); ++i) {
            const int rank = rank_of(content_.variables[i]);
            if (rank > found.rank) found = {i, rank};
        }
        return found.rank > 0 ? std::optional(found.variable) : std::nullopt;
    }

    /// Finds the spectrum; one over directions precedes others.
    std::size_t find_spectrum() const {
        const auto found = best([&](const Variable& v) {
            const int rank = spectrum_rank(v);
            std::optional<std::size_t> unused;
            if (rank == 0 || (rank == 1 && !find_axis(v, is_frequency, unused))) return 0;
            unused.reset();
            return rank + (find_axis(v, is_direction, unused) || is_ecmwf(v) ? 10 : 0);
        });
        if (found) return *found;
        throw Fault(
            "holds no wave spectrum: no variable efth, ef, d2fd or spectral_wave_density, none "
            "whose standard_name is " +
            std::string(kDirectional) + " or " + std::string(kOmnidirectional) +
            ", and none over frequencies whose units are those of a spectral density");
    }

    /// Returns the dimension of a variable that has such a name, or whose coordinate has.
    template <typename Test>
    std::optional<std::size_t> find_axis(const Variable& variable, Test is_axis,
                                         std::optional<std::size_t>& coordinate) const {
        for (const std::size_t dimension : variable.dimensions) {
            for (std::size_t i = 0; i < content_.variables.size() && !coordinate; ++i) {
                const Variable& v = content_.variables[i];
                const bool along = v.dimensions == std::vector{dimension} && !v.is_text;
                if (along && is_axis(v.name, standard_name(v))) coordinate = i;
            }
            if (coordinate || is_axis(dimension_name(dimension), "")) return dimension;
        }
        return std::nullopt;
    }

    /// Finds the frequencies, which Copernicus' files repeat for each time.
    std::optional<std::size_t> find_frequencies_of_records() const {
        return best([&](const Variable& v) {
            return !v.is_text && is_over_bins(v) && is_frequency(v.name, standard_name(v)) ? 1 : 0;
        });
    }

    /// Returns true for a variable over the frequency and some of the outer dimensions.
    bool is_over_bins(const Variable& v) const {
        return has(v.dimensions, layout_.frequency_dimension) &&
               std::all_of(v.dimensions.begin(), v.dimensions.end(), [&](std::size_t d) {
                   return d == layout_.frequency_dimension || has(left_, d) ||
                          has(layout_.outer_dimensions, d);
               });
    }

    /// Returns true for a variable over some of the outer dimensions.
    bool describes_records(const Variable& v) const {
        return std::all_of(v.dimensions.begin(), v.dimensions.end(), [&](std::size_t d) {
            return has(left_, d) || has(layout_.outer_dimensions, d);
        });
    }

    /// Finds the time: valid_time before time, which may be the start of the forecast.
    void find_time() {
        layout_.time = best([&](const Variable& v) {
            if (v.is_text || v.dimensions.size() > 1 || !describes_records(v)) return 0;
            const std::string plain = plain_name(v.name);
            const int rank = plain == "validtime"                                       ? 4
                             : standard_name(v) == "time"                               ? 3
                             : among(plain, {"time", "wavetime", "timeindex", "times"}) ? 2
                             : v.attribute("units").find(" since ") != std::string::npos &&
                                     plain.find("time") != std::string::npos
                                 ? 1
                                 : 0;
            // A time for each record precedes a single time of the file.
            return rank == 0 ? 0 : 2 * rank + (v.dimensions.empty() ? 0 : 1);
        });
        if (!layout_.time) return;
        for (const std::size_t dimension : content_.variables[*layout_.time].dimensions) {
            layout_.outer_dimensions.push_back(dimension);
            std::erase(left_, dimension);
        }
    }

    /// Finds the place, which may have dimensions of its own: one point, or one for each time.
    std::optional<std::size_t> find_place(std::string_view standard, Words names) {
        const auto found = best([&](const Variable& v) {
            if (v.is_text) return 0;
            const bool near = describes_records(v);
            if (!near && !is_parallel(v)) return 0;
            const int rank = standard_name(v) == standard       ? 2
                             : among(plain_name(v.name), names) ? 1
                                                                : 0;
            return rank == 0 ? 0 : 2 * rank + (near ? 1 : 0);
        });
        if (!found) return found;
        const Variable& v = content_.variables[*found];
        if (!describes_records(v) && content_.dimensions[v.dimensions[0]].size > 1) {
            layout_.parallel_dimensions.emplace_back(v.dimensions[0],
                                                     layout_.outer_dimensions.front());
        }
        return found;
    }
    bool is_parallel(const Variable& v) const {
        if (v.dimensions.size() != 1) return false;
        const std::size_t dimension = v.dimensions[0];
        const std::size_t size = content_.dimensions[dimension].size;
        if (dimension == layout_.frequency_dimension || dimension == layout_.direction_dimension) {
            return false;
        }
        return size == 1 || (!layout_.outer_dimensions.empty() &&
                             size == content_.dimensions[layout_.outer_dimensions.front()].size);
    }

    /// Finds the station: names as text before numbers.
    std::optional<std::size_t> find_station() const {
        return best([&](const Variable& v) {
            const bool named =
                among(plain_name(v.name),
                      {"stationname", "station", "site", "stationid", "metastationname",
                       "platformcode", "gid", "buoyid", "spotterid"}) ||
                v.attribute("cf_role") == "timeseries_id";
            return named && describes_records(v) ? (v.is_text ? 2 : 1) : 0;
        });
    }

    std::optional<std::size_t> find_scale() const {
        return best([&](const Variable& v) {
            return v.name == "scale_" + spectrum().name && !v.is_text && describes_records(v) ? 1
                                                                                              : 0;
        });
    }

    void find_bins() {
        for (std::size_t q = 0; q < kBinQuantities; ++q) {
            layout_.bins[q] = best([&](const Variable& v) {
                if (v.is_text || &v == &spectrum() || !is_over_bins(v)) return 0;
                return bin_rank(static_cast<BinQuantity>(q), v.name, standard_name(v));
            });
        }
    }

    /// Finds the flags that a variable names, and flags that are named after it.
    void find_flags() {
        add_flags_of(layout_.spectrum);
        for (const auto& bin : layout_.bins) {
            if (bin) add_flags_of(*bin);
        }
    }
    void add_flags_of(std::size_t judged) {
        const Variable& variable = content_.variables[judged];
        const std::string ancillary = " " + variable.attribute("ancillary_variables") + " ";
        const std::string own = plain_name(variable.name);
        const bool is_spectrum = judged == layout_.spectrum;
        for (std::size_t i = 0; i < content_.variables.size(); ++i) {
            const Variable& v = content_.variables[i];
            const std::string plain = plain_name(v.name);
            // Secondary flags give reasons, with numbers of another list.
            if (v.is_text || plain.find("secondary") != std::string::npos) continue;
            const bool named =
                ancillary.find(" " + v.name + " ") != std::string::npos ||
                among(plain, {own + "qc", own + "flag", own + "qcflag", own + "qualityflag"}) ||
                (is_spectrum && among(plain, {"waveflagprimary", "wavefrequencyflagprimary",
                                              "qcflage", "qcflagd", "qcflag", "timeqc"}));
            const bool flag = plain.find("flag") != std::string::npos ||
                              plain.find("qc") != std::string::npos ||
                              !v.attribute("flag_meanings").empty();
            if (named && flag && (describes_records(v) || is_over_bins(v))) {
                layout_.flags.emplace_back(i, judged);
            }
        }
    }

    void require_place(std::size_t dimension) const {
        const auto& [name, size] = content_.dimensions[dimension];
        if (size <= 1) return;
        if (among(plain_name(name),
                  {"site",     "sites",      "station",   "stations", "points", "point",
                   "location", "locations",  "node",      "nodes",    "lat",    "lon",
                   "latitude", "longitude",  "gid",       "x",        "y",      "xc",
                   "yc",       "depth",      "run",       "buoy",     "buoys",  "platform",
                   "spotter",  "trajectory", "instrument"})) {
            return;
        }
        for (const auto& place : {layout_.latitude, layout_.longitude, layout_.station}) {
            if (place && has(content_.variables[*place].dimensions, dimension)) return;
        }
        throw fail("the dimension " + text::printable(name) + " of " + std::to_string(size) +
                   " is neither time nor place, frequency nor direction: choose one of it before");
    }

    const Content& content_;
    Layout layout_;
    std::vector<std::size_t> left_;  // dimensions of the spectrum without a role
};

}  // namespace

bool is_ecmwf(const Variable& spectrum) {
    return spectrum.name == "d2fd";
}

std::vector<std::size_t> Layout::variables() const {
    std::vector<std::size_t> all = {spectrum};
    const auto add = [&](const std::optional<std::size_t>& one) {
        if (one && !has(all, *one)) all.push_back(*one);
    };
    for (const auto& one :
         {frequency, direction, time, latitude, longitude, depth, station, scale}) {
        add(one);
    }
    for (const auto& one : bins) add(one);
    for (const auto& [flag, judged] : flags) add(flag);
    return all;
}

Layout find_layout(const Content& content) {
    return Finder(content).find();
}

}  // namespace ocean::netcdf
