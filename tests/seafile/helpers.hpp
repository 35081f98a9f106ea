// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Helpers of the tests of ocean::seafile: errors as values, and bitwise equality of seas.
#pragma once

#include <bit>
#include <cstdint>

#include "ocean/parameter_table.hpp"
#include "ocean/seafile.hpp"
#include "paths.hpp"
#include "refusal.hpp"
#include "spectrum_format.hpp"

namespace ocean::test {

inline const std::string kData = data_dir();
inline const std::string kBuoy = kData + "/spectra/ndbc_41010.data_spec";

/// Expects that a file was refused by a sentence with these words.
template <typename... Words>
void expect_bad_file(const Refusal& refusal, const Words&... words) {
    EXPECT_EQ(refusal.kind, ErrorKind::bad_file) << refusal.message;
    EXPECT_TRUE(refusal.says(words...));
}

/// Returns the fault of a file, or of the first of its records that cannot be read.
template <typename Read>
Refusal first_fault_of(Read read) {
    std::vector<SpectrumRecord> records;
    const Refusal whole = refusal_of([&] { records = read(); });
    if (whole.refused) return whole;
    for (const SpectrumRecord& record : records) {
        if (!record.fault.empty()) return {true, ErrorKind::bad_file, record.fault};
    }
    return {};
}

/// Parses `body` under the line "libocean = 1", so that the body begins on line 2 of "test.toml".
inline Sea parse(const std::string& body) {
    return parse_sea("libocean = 1\n" + body, "test.toml", kData + "/spectra");
}
inline Refusal refusal_of_sea(const std::string& body) {
    return refusal_of([&] { parse(body); });
}

/// Contents by their paths: files that exist in memory only.
using Files = std::map<std::string, std::string>;

/// Reads one of the files, with the others as those that lie beside it.
inline std::vector<SpectrumRecord> read_files(const Files& files, const std::string& name) {
    const auto companion = [&](const std::string& path) -> std::optional<std::string> {
        const auto found = files.find(path);
        if (found == files.end()) return std::nullopt;
        return found->second;
    };
    return read_spectra_from({files.at(name), name, companion});
}

/// Returns a text with another one in place of the first `from`, which it has.
inline std::string replaced(std::string content, const std::string& from, const std::string& to) {
    return content.replace(content.find(from), from.size(), to);
}

inline bool same_bits(double a, double b) {
    return (std::isnan(a) && std::isnan(b)) ||
           std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
inline bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!same_bits(a[i], b[i])) return false;
    }
    return true;
}
inline bool same_record(const SpectrumRecord& a, const SpectrumRecord& b) {
    return a.station == b.station && a.time == b.time && same_bits(a.latitude, b.latitude) &&
           same_bits(a.longitude, b.longitude) && same_bits(a.depth, b.depth) &&
           same_bits(a.frequency, b.frequency) && same_bits(a.density, b.density) &&
           same_bits(a.a1, b.a1) && same_bits(a.b1, b.b1) && same_bits(a.a2, b.a2) &&
           same_bits(a.b2, b.b2) && a.warnings == b.warnings;
}
inline bool same_value(const ParameterValue& a, const ParameterValue& b) {
    const auto* x = std::get_if<double>(&a);
    const auto* y = std::get_if<double>(&b);
    return x != nullptr && y != nullptr ? same_bits(*x, *y) : a == b;
}

/// Returns the first parameter in which two seas differ in any bit; empty if they are equal.
inline std::string difference(const Sea& a, const Sea& b) {
    if (a.parameters.waves.size() != b.parameters.waves.size()) return "waves";
    if (a.parameters.hulls != b.parameters.hulls) return "hulls";
    if (a.parameters.crests.size() != b.parameters.crests.size()) return "crests";
    for (const ParameterInfo& info : parameter_table()) {
        for (std::size_t item = 0; item < info.member.items(a.parameters); ++item) {
            const ParameterRef ref{&info, item};
            if (!same_value(value_of(a.parameters, ref), value_of(b.parameters, ref))) {
                return info.path(item);
            }
        }
    }
    for (std::size_t wave = 0; wave < a.parameters.waves.size(); ++wave) {
        const auto& x = a.parameters.waves[wave].measured;
        const auto& y = b.parameters.waves[wave].measured;
        if ((x == nullptr) != (y == nullptr)) return "measured_record";
        if (x != nullptr && !same_record(*x, *y)) return "measured_record";
    }
    if (a.take.file != b.take.file) return "take.file";
    if (a.take.events.size() != b.take.events.size()) return "take";
    for (std::size_t i = 0; i < a.take.events.size(); ++i) {
        const TakeEvent& x = a.take.events[i];
        const TakeEvent& y = b.take.events[i];
        if (!same_bits(x.seconds, y.seconds) || x.parameter.info != y.parameter.info ||
            x.parameter.item != y.parameter.item || !same_value(x.value, y.value)) {
            return "take.events." + std::to_string(i);
        }
    }
    return "";
}

}  // namespace ocean::test
