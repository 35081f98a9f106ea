// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Records of the variables of a NetCDF file: see netcdf_records.hpp.
#include "netcdf_records.hpp"

#include <algorithm>
#include <cmath>

#include "bin_directions.hpp"
#include "cf_units.hpp"
#include "direction_sense.hpp"
#include "names.hpp"
#include "netcdf_layout.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/directional_record.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/internal/record_rules.hpp"
#include "ocean/internal/text.hpp"
#include "record_flags.hpp"
#include "spectrum_axes.hpp"

namespace ocean::netcdf {
namespace {

constexpr double kPerRadian = kPi / 180.0;  // [m^2 s/rad] to [m^2/Hz/degree]

class RecordMaker {
  public:
    explicit RecordMaker(const Content& content)
        : content_(content),
          layout_(find_layout(content)),
          spectrum_(content.variables[layout_.spectrum]),
          bins_(content, layout_),
          flags_(content, layout_) {}

    std::vector<SpectrumRecord> make() {
        if (spectrum_.values.empty()) throw fail("has no values");
        axes_ = read_axes(content_, layout_);
        for (const std::string& warning : axes_.warnings) warn(warning);
        read_units();
        if (layout_.time) read_time_units();
        for (const std::string& warning : bins_.warnings()) warn(warning);
        std::vector<SpectrumRecord> records;
        // The record's point in all dimensions of the content.
        std::vector<std::size_t> at(content_.dimensions.size(), 0);
        do {
            for (const auto& [place, time] : layout_.parallel_dimensions) at[place] = at[time];
            gather(at);
            if (!has_values()) continue;
            if (records.size() == kMaxRecords) throw fail("more than 100000 records");
            records.push_back(record(at));
        } while (advance(at));
        if (records.empty()) throw fail("all values are missing");
        return records;
    }

  private:
    Fault fail(const std::string& message) const { return {spectrum_.name, message}; }
    const Variable* variable(const std::optional<std::size_t>& index) const {
        return index ? &content_.variables[*index] : nullptr;
    }
    std::size_t size(std::size_t dimension) const { return content_.dimensions[dimension].size; }
    /// Adds a warning to all records.
    void warn(const std::string& warning) { warnings_.push_back(warning); }

    void read_units() {
        const std::string units = spectrum_.attribute("units");
        const bool directional = layout_.direction_dimension.has_value();
        if (is_ecmwf(spectrum_)) {
            if (!directional) throw fail("has no dimension of directions");
            units_.factor = kPerRadian;
            return;
        }
        if (units.empty()) return assume_units(directional);
        units_ = parse_density_units(
            units, directional ? DensityOver::frequency_and_direction : DensityOver::frequency);
        if (!units_.fault.empty()) throw fail(units_.fault);
        if (!axes_.angular_frequency || names_frequency(units, directional)) return;
        units_.factor *= 2.0 * kPi;
        warn("the density in '" + text::printable(units) +
             "' over frequencies in rad/s is taken as one per rad/s");
    }

    /// Returns true if the units name the frequency: by Hz, or by one angle more than the
    /// directions.
    static bool names_frequency(const std::string& units, bool directional) {
        const std::string plain = lower_case(units);
        if (plain.find('h') != std::string::npos) return true;  // Hz, hertz, cph
        std::size_t angles = plain.find("-2") != std::string::npos ? 1 : 0;
        for (const std::string_view angle : {"rad", "deg"}) {
            for (std::size_t at = 0; (at = plain.find(angle, at)) != std::string::npos; ++at) {
                ++angles;
            }
        }
        return angles > (directional ? 1u : 0u);
    }

    /// Assumes the units of a spectrum without any. wavespectra's files need no warning.
    void assume_units(bool directional) {
        const Variable* direction = variable(layout_.direction);
        units_.factor = directional && axes_.radian_bins ? kPerRadian : 1.0;
        if (directional && direction != nullptr && direction->name == "dir") return;
        warn(text::printable(spectrum_.name) + " has no unit: m2/Hz" +
             (!directional        ? ""
              : axes_.radian_bins ? "/rad"
                                  : "/degree") +
             " is taken");
    }

    void read_time_units() {
        const Variable& v = *variable(layout_.time);
        std::string calendar = v.attribute("calendar");
        calendar = lower_case(calendar);
        // SWAN gives the standard calendar this name: its seconds are those since 1970.
        if (calendar == "julian") {
            if (!is_swan(content_, spectrum_)) {
                warn("the calendar 'julian' is taken as the standard one, as SWAN means it");
            }
            calendar.clear();
        }
        if (!calendar.empty() && calendar != "standard" && calendar != "gregorian" &&
            calendar != "proleptic_gregorian") {
            throw Fault(v.name, "calendar '" + text::printable(calendar) +
                                    "'; allowed: standard, gregorian, proleptic_gregorian");
        }
        const std::string units = v.attribute("units");
        const std::optional<TimeUnits> parsed = parse_time_units(units);
        if (!parsed) {
            throw Fault(v.name, "units '" + text::printable(units) +
                                    "'; allowed: seconds, minutes, hours or days since a date in "
                                    "UTC from 1800 on, like 1990-01-01 00:00:00");
        }
        time_units_ = *parsed;
    }

    bool advance(std::vector<std::size_t>& at) const {
        for (std::size_t k = layout_.outer_dimensions.size(); k-- > 0;) {
            const std::size_t d = layout_.outer_dimensions[k];
            if (++at[d] < size(d)) return true;
            at[d] = 0;
        }
        return false;
    }

    /// Copies the spectrum at a point into gathered_: [frequency, ascending][direction, as in the
    /// file].
    void gather(const std::vector<std::size_t>& at) {
        const std::size_t origin = offset(content_, spectrum_, at);
        const std::size_t row = stride(content_, spectrum_, layout_.frequency_dimension);
        const auto& direction = layout_.direction_dimension;
        const std::size_t step = direction ? stride(content_, spectrum_, *direction) : 0;
        const std::size_t width = direction ? size(*direction) : 1;
        gathered_.clear();
        for (const std::size_t i : axes_.frequency_order) {
            for (std::size_t j = 0; j < width; ++j) {
                gathered_.push_back(spectrum_.values[origin + i * row + j * step]);
            }
        }
    }
    /// Returns true if enough bins have values. Without directions, missing bins are left out and
    /// at least two are required.
    bool has_values() const {
        const auto missing = std::count_if(gathered_.begin(), gathered_.end(),
                                           [](double value) { return std::isnan(value); });
        const std::size_t present = gathered_.size() - static_cast<std::size_t>(missing);
        return present >= (axes_.directions ? 1u : 2u);
    }

    /// Returns the record at a point; a record that cannot be used has time, place and fault alone.
    SpectrumRecord record(const std::vector<std::size_t>& at) {
        SpectrumRecord result;
        try {
            describe(result, at);
            result.warnings = warnings_;
            fill(result, at);
            clean_record(result);
            const std::string fault = record_fault(result);
            if (!fault.empty()) throw fail(label(result) + fault);
        } catch (const Fault& fault) {
            SpectrumRecord bad;
            bad.station = result.station;
            bad.time = result.time;
            bad.latitude = result.latitude;
            bad.longitude = result.longitude;
            bad.depth = result.depth;
            // A name from the child may contain anything, also a zero byte that would end what().
            const std::string name = text::printable(fault.variable);
            bad.fault = (name.empty() ? "" : name + ": ") + fault.message;
            return bad;
        }
        if (result.warnings.size() > kMaxRecordWarnings) result.warnings.resize(kMaxRecordWarnings);
        return result;
    }

    void fill(SpectrumRecord& result, std::vector<std::size_t> at) {
        const Verdict verdict = flags_.judge(result, spectrum_, at);
        if (!verdict.record_fault.empty()) throw Fault(verdict.record_fault);
        const double scale = layout_.scale ? value_at(variable(layout_.scale), at) : 1.0;
        if (std::isnan(scale))
            throw Fault(variable(layout_.scale)->name, label(result) + "is missing");
        for (double& value : gathered_) value = density(value * scale, result);
        require_noise_only(result);
        if (axes_.directions) return fill_directions(result, verdict);

        std::vector<std::pair<const Variable*, Verdict>> bin_verdicts;
        for (const auto& bin : layout_.bins) {
            if (const Variable* v = variable(bin))
                bin_verdicts.emplace_back(v, flags_.judge(result, *v, at));
        }
        const auto value_of = [&](const Variable& v) {
            for (const auto& [judged, said] : bin_verdicts) {
                const bool bad = judged == &v &&
                                 (!said.record_fault.empty() ||
                                  (!said.bad.empty() && said.bad[at[layout_.frequency_dimension]]));
                if (bad) return kMissing;
            }
            return v.values[offset(content_, v, at)];
        };
        for (std::size_t i = 0; i < axes_.frequency.size(); ++i) {
            const std::size_t band = axes_.frequency_order[i];
            const bool bad = !verdict.bad.empty() && verdict.bad[band];
            if (std::isnan(gathered_[i]) || bad) continue;  // as if the file did not have the bin
            result.frequency.push_back(axes_.frequency[i]);
            result.density.push_back(gathered_[i] * units_.factor);
            at[layout_.frequency_dimension] = band;
            try {
                bins_.append(result, value_of);
            } catch (const Fault& fault) {
                throw Fault(fault.variable, label(result) + fault.message);
            }
        }
        drop_unknown_moments(result);
    }

    /// Checks densities. Estimators give values slightly below 0, which clean_record treats as
    /// noise.
    void require_noise_only(const SpectrumRecord& record) const {
        double min = 0.0;
        double max = 0.0;
        for (const double value : gathered_) {
            min = std::min(min, value);  // ignores NaN
            max = std::max(max, value);
        }
        if (min >= -kMaxNoise * max) return;
        throw fail(label(record) + "a density of " + shown(min) +
                   "; allowed: 0 .. 1e6 m^2/Hz/degree");
    }

    void fill_directions(SpectrumRecord& result, const Verdict& verdict) {
        if (verdict.bad.empty()) {
            result.frequency = axes_.frequency;
        } else {
            const std::size_t width = gathered_.size() / axes_.frequency.size();
            std::vector<double> good;
            for (std::size_t i = 0; i < axes_.frequency.size(); ++i) {
                if (verdict.bad[axes_.frequency_order[i]]) continue;
                const auto row = gathered_.begin() + static_cast<std::ptrdiff_t>(i * width);
                good.insert(good.end(), row, row + static_cast<std::ptrdiff_t>(width));
                result.frequency.push_back(axes_.frequency[i]);
            }
            gathered_ = std::move(good);
        }
        axes_.directions->fill(result, gathered_, units_.factor);
    }

    double density(double value, const SpectrumRecord& record) const {
        if (is_ecmwf(spectrum_)) value = std::pow(10.0, value);
        // The offset keeps zeros finite in the file; rounding may give less.
        if (units_.log10) value = std::max(std::pow(10.0, value) - 1e-12, 0.0);
        if (std::isnan(value) || std::abs(value) <= 1e8) return value;
        throw fail(label(record) + "a density of " + shown(value) +
                   "; allowed: 0 .. 1e6 m^2/Hz/degree");
    }

    double value_at(const Variable* v, const std::vector<std::size_t>& at) const {
        return v == nullptr ? kMissing : v->values[offset(content_, *v, at)];
    }

    void describe(SpectrumRecord& record, const std::vector<std::size_t>& at) const {
        record.station = station(at);
        if (const Variable* v = variable(layout_.time)) {
            const std::optional<UtcTime> time = time_at(time_units_, value_at(v, at));
            if (!time) throw Fault(v->name, shown(value_at(v, at)) + " is no time in 1800 .. 2999");
            record.time = time->text();
        }
        record.latitude = within(layout_.latitude, at, -90.0, 90.0);
        record.longitude = within(layout_.longitude, at, -180.0, 360.0);
        record.depth = within(layout_.depth, at, -12000.0, 12000.0);
        if (record.depth < 0.01) record.depth = kMissing;  // dry, or a height
    }

    double within(const std::optional<std::size_t>& index, const std::vector<std::size_t>& at,
                  double low, double high) const {
        const Variable* v = variable(index);
        const double value = value_at(v, at);
        if (std::isnan(value) || (value >= low && value <= high)) return value;
        throw Fault(v->name, shown(value) + " is not within " + std::to_string(std::lround(low)) +
                                 " .. " + std::to_string(std::lround(high)));
    }

    /// Returns the station that attributes of the file give for all records.
    std::string file_station() const {
        for (const char* key : {"station", "platform_code", "wmo_platform_code", "site_code",
                                "station_id", "cdip_station_id", "station_name", "wmo_id"}) {
            const auto found = content_.attributes.find(key);
            if (found != content_.attributes.end()) return text::printable(found->second);
        }
        return "";
    }

    /// Returns the station of a record; a number serves as a name if there is no other.
    std::string station(const std::vector<std::size_t>& at) const {
        const Variable* v = variable(layout_.station);
        if (v == nullptr) return file_station();
        if (v->is_text) return text::printable(v->texts[offset(content_, *v, at)]);
        const double number = value_at(v, at);
        const bool whole = std::abs(number) < 1e9 && number == std::floor(number);
        return whole ? std::to_string(std::lround(number)) : "";
    }

    const Content& content_;
    const Layout layout_;
    const Variable& spectrum_;
    DensityUnits units_;
    TimeUnits time_units_;
    SpectrumAxes axes_;
    BinDirections bins_;
    RecordFlags flags_;
    std::vector<std::string> warnings_;
    std::vector<double> gathered_;
};

}  // namespace

std::vector<SpectrumRecord> records_from(const Content& content) {
    return RecordMaker(content).make();
}

}  // namespace ocean::netcdf
