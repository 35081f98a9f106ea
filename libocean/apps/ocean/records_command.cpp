// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean records`: lists the records in a file of measured spectra, before a sea uses one.
#include <cmath>
#include <memory>

#include "any_spectra.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/seafile.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

std::string cell(double value, const char* number) {
    return std::isnan(value) ? "-" : format_text(number, value);
}

std::string direction_cell(const RecordSummary& summary) {
    // Rounds to degrees first, so that 359.7 is 0 and not 360.
    return cell(std::fmod(std::round(coming_from(summary.mean_direction * 180.0 / kPi)), 360.0),
                "%.0f");
}

std::string line(const SpectrumRecord& record) {
    const auto known = [](const std::string& text) { return text.empty() ? "-" : text; };
    if (!record.fault.empty()) {
        return format_text("%-16s  %-12s cannot be read\n", known(record.time).c_str(),
                           known(record.station).c_str());
    }
    const RecordSummary summary = summarize(record);
    return format_text(
        "%-16s  %-12s %9s %10s %7s %7s %6s %6s %6s %5s %6s\n", known(record.time).c_str(),
        known(record.station).c_str(), cell(record.latitude, "%.4f").c_str(),
        cell(record.longitude, "%.4f").c_str(), cell(record.depth, "%.4g").c_str(),
        cell(4.0 * std::sqrt(summary.m0), "%.2f").c_str(),
        cell(summary.peak_period, "%.1f").c_str(), cell(summary.energy_period, "%.1f").c_str(),
        cell(summary.mean_period, "%.1f").c_str(), direction_cell(summary).c_str(),
        cell(summary.directional_spread * 180.0 / kPi, "%.0f").c_str());
}

void run(const std::string& file, const Context& context) {
    const std::vector<SpectrumRecord> records = read_any_spectra(file);
    for (const std::string& warning : records_warnings(records)) context.console.warning(warning);
    if (context.options.json) return context.console.data(records_json(records));
    context.console.data(format_text("%-16s  %-12s %9s %10s %7s %7s %6s %6s %6s %5s %6s\n",
                                     "time, UTC", "station", "latitude", "longitude", "depth/m",
                                     "Hs/m", "Tp/s", "Te/s", "Tm01/s", "from", "spread"));
    for (const SpectrumRecord& record : records) context.console.data(line(record));
}

constexpr char kRecordsFooter[] =
    R"(Reads NDBC real-time, hourly, five-day and historical tables, Sofar Spotter CSV
and JSON, Datawell .spt, TRIAXYS spectra, Nortek AWAC (NMEA), Obscape, Octopus,
WAVEWATCH III point output, SWAN spectra, CSV and NetCDF, packed with gzip or
not, or several text files in a tar; recognised by their content. `Tp` is the
period of the maximal density, `Te` = m-1 / m0 the energy period, `Tm01` = m0 /
m1 the mean period. `from` is the mean direction from which the waves come, in
degrees clockwise from north; `spread` is the circular standard deviation. A
record that cannot be read is marked, and a warning has the reason. A sea uses
one record by spectrum = "measured", file, record = a time, and place = a
station or LATITUDE,LONGITUDE.)";

}  // namespace

Command records_command() {
    auto file = std::make_shared<std::string>();
    return {
        .name = "records",
        .summary = "List the records in a file of measured spectra",
        .options = {{"",
                     {{"FILE", file.get(), "", "Spectra of a buoy or a wave model", kRequired}}},
                    run_options("Print one JSON array")},
        .footer = kRecordsFooter,
        .run = [file](const Context& context) { run(*file, context); },
    };
}

}  // namespace ocean::app
