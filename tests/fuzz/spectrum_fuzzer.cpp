// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as a spectrum file: either records that keep the promises of record_fault, or one Error
// whose message is safe to print. A form feed ends the file and begins the next of its companions.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "ocean/error.hpp"
#include "ocean/seafile.hpp"
#include "spectrum_format.hpp"

namespace {

constexpr std::array<std::string_view, 5> kFiles = {"fuzz.data_spec", "fuzz.swdir", "fuzz.swdir2",
                                                    "fuzz.swr1", "fuzz.swr2"};

void require(bool condition) {
    if (!condition) std::abort();
}

std::array<std::string_view, 5> split(std::string_view bytes) {
    std::array<std::string_view, 5> parts;
    for (std::string_view& part : parts) {
        part = bytes.substr(0, bytes.find('\f'));
        bytes.remove_prefix(std::min(part.size() + 1, bytes.size()));
    }
    return parts;
}

void check(const ocean::SpectrumRecord& record) {
    require(ocean::record_fault(record).empty());
    const ocean::RecordSummary summary = ocean::summarize(record);
    require(std::isfinite(summary.m0) && summary.m0 >= 0.0);
    require(std::isfinite(summary.peak_period) && summary.peak_period >= 0.0);
    require(std::isnan(summary.mean_direction) || std::abs(summary.mean_direction) < 4.0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto parts = split({reinterpret_cast<const char*>(data), size});
    const auto companion = [&](const std::string& path) -> std::optional<std::string> {
        const auto found = std::find(kFiles.begin(), kFiles.end(), path);
        if (found == kFiles.end()) return std::nullopt;
        const std::string_view part = parts[static_cast<std::size_t>(found - kFiles.begin())];
        if (part.empty()) return std::nullopt;
        return std::string(part);
    };
    try {
        const auto records =
            ocean::read_spectra_from({parts[0], std::string(kFiles[0]), companion});
        for (const ocean::SpectrumRecord& record : records) check(record);
        ocean::records_json(records);
        const std::string& last = records.back().time;
        require(ocean::choose_record(records, last, "fuzz").frequency.size() >= 2);
    } catch (const ocean::Error& error) {
        for (char c : std::string_view(error.what())) {
            require(static_cast<unsigned char>(c) >= 0x20);
        }
    }
    return 0;
}
