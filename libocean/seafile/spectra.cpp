// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reading spectrum files of any format: recognise by content, read, check. This is the stage
// between a file of a buoy or a wave model and the record of a wave system.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <set>
#include <system_error>
#include <utility>

#include "archive.hpp"
#include "gzip.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/csv_rows.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/internal/utc_time.hpp"
#include "ocean/seafile.hpp"
#include "spectrum_format.hpp"

namespace ocean {
namespace {

/// The formats, in the order in which they are tried: CSV, which accepts the most, comes last.
constexpr std::array kFormats = {&kNdbcRealtime, &kNdbcHistorical, &kNdbcFiveDay, &kSpotterCsv,
                                 &kSpotterJson,  &kDatawell,       &kTriaxys,     &kAwac,
                                 &kObscape,      &kOctopus,        &kWavewatch,   &kSwan,
                                 &kCsv};

/// The limit is far beyond any sea (the highest storms reach 10^3), but low enough to keep sums
/// finite.
constexpr double kMaxDensity = 1e6;
/// Moments are printed with two digits or more: the limit is 1 plus the max rounding error.
constexpr double kMaxMoment = 1.005;

std::string bin(std::size_t i) {
    return " of bin " + std::to_string(i + 1);
}

std::string energy_fault(const SpectrumRecord& record) {
    const std::size_t count = record.frequency.size();
    if (count < 2) return "a spectrum needs at least 2 frequencies";
    if (count > kMaxFrequencies) return "a spectrum has at most 4096 frequencies";
    if (record.density.size() != count) return "density and frequency differ in length";
    double below = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double f = record.frequency[i];
        const double s = record.density[i];
        if (!(f >= kMinFrequency && f <= kMaxFrequency)) {
            return "the frequency" + bin(i) + " is not within " + std::string(kFrequencyRange);
        }
        if (!(f > below)) return "the frequency" + bin(i) + " does not ascend";
        if (!(s >= 0.0 && s <= kMaxDensity)) {
            return "the density" + bin(i) + " is not within 0 .. 1e6 m^2/Hz";
        }
        below = f;
    }
    return "";
}

std::string moment_fault(const SpectrumRecord& record) {
    const std::array moments = {&record.a1, &record.b1, &record.a2, &record.b2};
    for (const std::vector<double>* moment : moments) {
        if (moment->size() != record.a1.size()) return "a1, b1, a2 and b2 differ in length";
        for (std::size_t i = 0; i < moment->size(); ++i) {
            const double m = (*moment)[i];
            if (!std::isnan(m) && !(std::abs(m) <= kMaxMoment)) {
                return "a directional moment" + bin(i) + " is beyond 1";
            }
        }
    }
    if (record.has_moments() && record.a1.size() != record.frequency.size()) {
        return "the directional moments and frequency differ in length";
    }
    return "";
}

std::string direction_fault(const SpectrumRecord& record) {
    const std::size_t count = record.direction.size();
    const std::size_t values = record.directional_density.size();
    if (count == 0 && values == 0) return "";
    if (record.has_moments()) return "has directional moments and a density over directions";
    if (count < 3) return "a directional spectrum needs at least 3 directions";
    if (count > kMaxDirections + 2) return "a spectrum has at most 720 directions";
    if (values != count * record.frequency.size()) {
        return "the directional density has not a value for each frequency and direction";
    }
    if (values > kMaxDirectionalValues) {
        return "a spectrum has at most 131072 values over frequency and direction";
    }
    double below = -1.0;
    for (const double d : record.direction) {
        if (!(d >= 0.0 && d < 360.0 && d > below)) {
            return "the directions do not ascend within 0 .. 360 degrees";
        }
        below = d;
    }
    for (std::size_t i = 0; i < values; ++i) {
        const double s = record.directional_density[i];
        if (!(s >= 0.0 && s <= kMaxDensity)) {
            return "the directional density" + bin(i / count) +
                   " is not within 0 .. 1e6 m^2/Hz/deg";
        }
    }
    return "";
}

std::string place_fault(const SpectrumRecord& record) {
    const auto outside = [](double value, double low, double high) {
        return !std::isnan(value) && !(value >= low && value <= high);
    };
    if (outside(record.latitude, -90.0, 90.0)) return "the latitude is not within -90 .. 90";
    if (outside(record.longitude, -180.0, 360.0)) return "the longitude is not within -180 .. 360";
    if (outside(record.depth, 0.01, 20000.0)) return "the depth is not within 0.01 .. 20000 m";
    if (!record.time.empty() && !parse_utc_time(record.time)) {
        return "the time is not like 2020-06-08T03:50";
    }
    return "";
}

/// Clears a record with a fault except for its time and place.
void keep_time_and_place(SpectrumRecord& record) {
    SpectrumRecord kept;
    kept.station = std::move(record.station);
    kept.time = std::move(record.time);
    kept.fault = std::move(record.fault);
    kept.latitude = record.latitude;
    kept.longitude = record.longitude;
    record = std::move(kept);
}

std::string known_formats() {
    return joined(kFormats, "; ", &SpectrumFormat::name);
}

/// Returns the text of a file, unpacked if it is gzip.
std::string read_content(const std::string& path) {
    std::string content = text::read_file(path, kMaxSpectrumFileBytes);
    return is_gzip(content) ? gunzip(content, path, kMaxSpectrumFileBytes) : content;
}

std::optional<std::string> read_companion(const std::string& path) {
    std::error_code ignored;
    if (!std::filesystem::exists(utf8_path(path), ignored)) return std::nullopt;
    return read_content(path);
}

}  // namespace

std::string record_fault(const SpectrumRecord& record) {
    if (!record.fault.empty()) return record.fault;
    for (const auto fault : {energy_fault, moment_fault, direction_fault, place_fault}) {
        if (std::string message = fault(record); !message.empty()) return message;
    }
    return "";
}

void require_readable(std::span<const SpectrumRecord> records) {
    const auto readable = [](const SpectrumRecord& record) { return record.fault.empty(); };
    if (records.empty() || std::any_of(records.begin(), records.end(), readable)) return;
    throw Error(ErrorKind::bad_file, records.front().fault);
}

std::vector<SpectrumRecord> read_format(const SpectrumFormat& format,
                                        const SpectrumSource& source) {
    const auto fail = [&](const std::string& message) {
        return text::error_at(ErrorKind::bad_file, source.name, 0, message);
    };
    std::vector<SpectrumRecord> records = format.read(source);
    if (records.empty()) throw fail("holds no spectrum");
    for (SpectrumRecord& record : records) {
        if (!record.fault.empty()) continue;
        clean_record(record);
        const std::string fault = record_fault(record);
        if (fault.empty()) continue;
        record.fault = fail("the record" + (record.time.empty() ? "" : " of " + record.time) +
                            (record.station.empty() ? "" : ", " + record.station) + ": " + fault)
                           .what();
    }
    require_readable(records);
    for (SpectrumRecord& record : records) {
        if (!record.fault.empty()) keep_time_and_place(record);
    }
    return records;
}

namespace {

/// Returns the first format that recognises the text; none if its format is unknown.
const SpectrumFormat* format_of(std::string_view content) {
    // Skips blank lines before the first word, so that not every format has to.
    const std::size_t first = content.find_first_not_of(" \t\r\n");
    const std::string_view words = content.substr(std::min(first, content.size()));
    for (const SpectrumFormat* format : kFormats) {
        if (format->recognises(words)) return format;
    }
    return nullptr;
}

/// Reads a member of an archive as a file of its own.
std::vector<SpectrumRecord> read_member(
    const ArchiveMember& member, const SpectrumSource& archive, const SpectrumFormat& format,
    const std::function<std::optional<std::string>(const std::string&)>& companion) {
    const std::string name = std::string(archive.name) + "/" + member.name;
    std::vector<SpectrumRecord> records;
    std::string fault;
    catch_fault(fault, [&] { records = read_format(format, {member.content, name, companion}); });
    if (fault.empty()) return records;
    SpectrumRecord record;
    record.fault = fault;
    return {record};
}

/// Reads all spectra of an archive that have the format of its first spectrum. A table that belongs
/// to another one (see SpectrumSource::companion) is read together with it.
std::vector<SpectrumRecord> read_archive(const SpectrumSource& source) {
    std::string cut_off;
    const auto members = tar_members(source.content, std::string(source.name), cut_off);
    const std::string folder = std::string(source.name) + "/";
    std::set<std::string> companions;
    const auto companion = [&](const std::string& path) -> std::optional<std::string> {
        for (const ArchiveMember& member : members) {
            if (path != folder + member.name) continue;
            companions.insert(member.name);
            return std::string(member.content);
        }
        return std::nullopt;
    };
    const SpectrumFormat* format = nullptr;
    std::vector<std::pair<std::string, std::vector<SpectrumRecord>>> read;
    std::vector<std::string> skipped;
    for (const ArchiveMember& member : members) {
        const SpectrumFormat* its = format_of(member.content);
        if (format == nullptr) format = its;
        if (its == nullptr || its != format) {
            skipped.push_back(member.name);
        } else {
            read.emplace_back(member.name, read_member(member, source, *format, companion));
        }
    }
    std::vector<SpectrumRecord> records;
    for (auto& [name, of_member] : read) {
        if (companions.contains(name)) continue;
        if (records.size() + of_member.size() > kMaxRecords) {
            throw text::error_at(ErrorKind::bad_file, source.name, 0, "more than 100000 records");
        }
        std::move(of_member.begin(), of_member.end(), std::back_inserter(records));
    }
    if (records.empty()) {
        throw text::error_at(
            ErrorKind::bad_file, source.name, 0,
            "is an archive without a spectrum file of a known format; known: " + known_formats());
    }
    require_readable(records);
    if (!cut_off.empty()) skipped.push_back(cut_off + " (cut off)");
    if (skipped.empty()) return records;
    const std::string warning =
        text::printable(std::to_string(skipped.size()) + " of " +
                            std::to_string(members.size() + (cut_off.empty() ? 0 : 1)) +
                            " files of the archive are left out, the first of them " +
                            (cut_off.empty() ? skipped.front() : skipped.back()),
                        kMaxRecordWarningBytes - 10);
    for (SpectrumRecord& record : records) {
        if (record.fault.empty()) record.warnings.push_back(warning);
    }
    return records;
}

}  // namespace

std::vector<SpectrumRecord> read_spectra_from(const SpectrumSource& original) {
    const std::optional<std::string> converted = csv::converted(original.content);
    const SpectrumSource source = {converted ? std::string_view(*converted) : original.content,
                                   original.name, original.companion};
    const auto fail = [&](const std::string& message) {
        return text::error_at(ErrorKind::bad_file, source.name, 0, message);
    };
    if (source.content.empty()) throw fail("the file is empty");
    if (is_tar(source.content)) return read_archive(source);
    if (const SpectrumFormat* format = format_of(source.content)) {
        return read_format(*format, source);
    }
    if (source.content.starts_with("CDF") || source.content.starts_with("\x89HDF")) {
        throw fail(
            "is NetCDF, which the `ocean` command alone reads, and only unpacked; a sea that it "
            "saves (`ocean info SEA --sea-file`) holds the record and needs the file no more");
    }
    if (source.content.starts_with("PK\x03\x04")) {
        throw fail("is a zip archive (or a spreadsheet): unpack it, or save the table as CSV");
    }
    throw fail("is not a spectrum file of a known format; known: " + known_formats());
}

std::vector<SpectrumRecord> read_spectra(const std::string& path) {
    const std::string content = read_content(path);
    return read_spectra_from({content, path, read_companion});
}

}  // namespace ocean
