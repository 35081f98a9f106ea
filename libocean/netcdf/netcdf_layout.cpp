// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Which variable plays which part: see netcdf_layout.hpp.
#include "netcdf_layout.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>

#include "cf_units.hpp"
#include "ocean/checked_text.hpp"

namespace ocean::netcdf {
namespace {

using Words = std::initializer_list<std::string_view>;

bool among(const std::string& word, Words words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

bool has(const std::vector<std::size_t>& all, std::size_t one) {
    return std::find(all.begin(), all.end(), one) != all.end();
}

/// Some versions of WAVEWATCH III write blanks for underscores.
std::string standard_name(const Variable& variable) {
    std::string name = variable.attribute("standard_name");
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

bool is_frequency(const std::string& name, const std::string& standard) {
    return among(name, {"freq", "frequency", "frequencies", "frequencyNumber"}) ||
           among(standard, {"sea_surface_wave_frequency", "wave_frequency"});
}

bool is_direction(const std::string& name, const std::string& standard) {
    return among(name, {"dir", "direction", "directions", "directionNumber"}) ||
           among(standard, {"sea_surface_wave_from_direction", "sea_surface_wave_to_direction"});
}

/// 0: no spectrum. Directional ones before the others, well-known names before standard names.
int spectrum_rank(const Variable& variable) {
    const std::string standard = standard_name(variable);
    if (variable.is_text) return 0;
    if (variable.name == "efth") return 5;
    if (is_ecmwf(variable)) return 4;
    if (standard == "sea_surface_wave_directional_variance_spectral_density") return 3;
    if (among(variable.name, {"ef", "spectral_wave_density"})) return 2;
    return standard == "sea_surface_wave_variance_spectral_density" ? 1 : 0;
}

std::size_t find_spectrum(const Content& content) {
    std::size_t best = 0;
    int rank = 0;
    for (std::size_t i = 0; i < content.variables.size(); ++i) {
        const int own = spectrum_rank(content.variables[i]);
        if (own > rank) best = i;
        rank = std::max(rank, own);
    }
    if (rank > 0) return best;
    throw Fault(
        "holds no wave spectrum: no variable efth, ef, d2fd or spectral_wave_density, and none "
        "whose standard_name is "
        "sea_surface_wave_directional_variance_spectral_density or "
        "sea_surface_wave_variance_spectral_density");
}

class Finder {
  public:
    explicit Finder(const Content& content) : content_(content) {
        layout_.spectrum = find_spectrum(content);
        left_ = spectrum().dimensions;
    }

    Layout find() {
        std::vector<std::size_t> sorted = left_;
        std::sort(sorted.begin(), sorted.end());
        if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
            throw fail("has a dimension twice");
        }
        const auto frequency = take_axis(is_frequency, layout_.frequency);
        if (!frequency) throw fail("has no dimension of frequencies (freq, frequency)");
        layout_.frequency_dimension = *frequency;
        layout_.direction_dimension = take_axis(is_direction, layout_.direction);
        find_time();
        layout_.latitude = find_place("latitude", {"latitude", "lat"});
        layout_.longitude = find_place("longitude", {"longitude", "lon"});
        layout_.depth = find_place("sea_floor_depth_below_sea_surface", {"dpt", "depth"});
        layout_.station = find_station();
        if (!layout_.direction_dimension) layout_.buoy_directions = find_buoy_directions();
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

    /// Takes the dimension with such a name or with a coordinate of such a name.
    template <typename Test>
    std::optional<std::size_t> take_axis(Test is_axis, std::optional<std::size_t>& coordinate) {
        for (std::size_t k = 0; k < left_.size(); ++k) {
            const std::size_t dimension = left_[k];
            for (std::size_t i = 0; i < content_.variables.size() && !coordinate; ++i) {
                const Variable& v = content_.variables[i];
                const bool along = v.dimensions == std::vector{dimension} && !v.is_text;
                if (along && is_axis(v.name, standard_name(v))) coordinate = i;
            }
            if (coordinate || is_axis(dimension_name(dimension), "")) {
                left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(k));
                return dimension;
            }
        }
        return std::nullopt;
    }

    /// A variable over some of the dimensions that records are counted by.
    bool describes_records(const Variable& v) const {
        return std::all_of(v.dimensions.begin(), v.dimensions.end(), [&](std::size_t d) {
            return has(left_, d) || has(layout_.outer_dimensions, d);
        });
    }

    /// valid_time before time, which may be when the forecast began.
    void find_time() {
        int best = 0;
        for (std::size_t i = 0; i < content_.variables.size(); ++i) {
            const Variable& v = content_.variables[i];
            const int rank = v.name == "valid_time"       ? 3
                             : standard_name(v) == "time" ? 2
                             : v.name == "time"           ? 1
                                                          : 0;
            if (rank <= best || v.is_text || v.dimensions.size() > 1 || !describes_records(v)) {
                continue;
            }
            best = rank;
            layout_.time = i;
        }
        if (!layout_.time) return;
        for (const std::size_t dimension : content_.variables[*layout_.time].dimensions) {
            layout_.outer_dimensions.push_back(dimension);
            std::erase(left_, dimension);
        }
    }

    std::optional<std::size_t> find_place(std::string_view standard, Words names) const {
        std::optional<std::size_t> found;
        for (std::size_t i = 0; i < content_.variables.size(); ++i) {
            const Variable& v = content_.variables[i];
            if (v.is_text || !describes_records(v)) continue;
            if (standard_name(v) == standard) return i;
            if (!found && among(v.name, names)) found = i;
        }
        return found;
    }

    /// Names as text before numbers.
    std::optional<std::size_t> find_station() const {
        std::optional<std::size_t> found;
        for (std::size_t i = 0; i < content_.variables.size(); ++i) {
            const Variable& v = content_.variables[i];
            const bool named = among(v.name, {"station_name", "station", "site", "station_id"}) ||
                               v.attribute("cf_role") == "timeseries_id";
            if (!named || !describes_records(v)) continue;
            if (v.is_text) return i;
            if (!found) found = i;
        }
        return found;
    }

    std::optional<std::array<std::size_t, 4>> find_buoy_directions() const {
        constexpr std::array<std::string_view, 4> kNames = {"mean_wave_dir", "principal_wave_dir",
                                                            "wave_spectrum_r1", "wave_spectrum_r2"};
        std::array<std::size_t, 4> found{};
        for (std::size_t k = 0; k < kNames.size(); ++k) {
            const auto at = std::find_if(
                content_.variables.begin(), content_.variables.end(), [&](const Variable& v) {
                    return v.name == kNames[k] && !v.is_text &&
                           std::is_permutation(v.dimensions.begin(), v.dimensions.end(),
                                               spectrum().dimensions.begin(),
                                               spectrum().dimensions.end());
                });
            if (at == content_.variables.end()) return std::nullopt;
            found[k] = static_cast<std::size_t>(at - content_.variables.begin());
        }
        return found;
    }

    void require_place(std::size_t dimension) const {
        const auto& [name, size] = content_.dimensions[dimension];
        if (size <= 1) return;
        if (among(name, {"site", "station", "points", "point", "location", "node", "lat", "lon",
                         "latitude", "longitude"})) {
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
    std::vector<std::size_t> left_;  // of the spectrum's dimensions: those without a part
};

}  // namespace

bool is_ecmwf(const Variable& spectrum) {
    return spectrum.name == "d2fd";
}

std::vector<std::size_t> Layout::variables() const {
    std::vector<std::size_t> all = {spectrum};
    for (const auto& one : {frequency, direction, time, latitude, longitude, depth, station}) {
        if (one && !has(all, *one)) all.push_back(*one);
    }
    if (buoy_directions) all.insert(all.end(), buoy_directions->begin(), buoy_directions->end());
    return all;
}

Layout find_layout(const Content& content) {
    return Finder(content).find();
}

}  // namespace ocean::netcdf
