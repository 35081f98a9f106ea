// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The record of a measured sea inside a sea file, [waves.measured_record]. One table of its keys
// serves reader and writer. The record makes a saved sea independent of the buoy's file.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "ocean/parameters.hpp"
#include "spectrum_format.hpp"

namespace ocean {

inline constexpr std::string_view kMeasuredRecord = "measured_record";

struct RecordKey {
    std::string_view key;
    std::variant<std::string SpectrumRecord::*, double SpectrumRecord::*,
                 std::vector<double> SpectrumRecord::*, std::vector<std::string> SpectrumRecord::*>
        member;
    bool may_be_nan = false;             // whether elements of a list may be NaN
    std::size_t most = kMaxFrequencies;  // max elements of a list
};

inline constexpr std::array<RecordKey, 14> kRecordKeys = {{
    {"station", &SpectrumRecord::station},
    {"time", &SpectrumRecord::time},
    {"latitude", &SpectrumRecord::latitude},
    {"longitude", &SpectrumRecord::longitude},
    {"depth", &SpectrumRecord::depth},
    {"frequency", &SpectrumRecord::frequency},
    {"density", &SpectrumRecord::density},
    {"a1", &SpectrumRecord::a1, true},
    {"b1", &SpectrumRecord::b1, true},
    {"a2", &SpectrumRecord::a2, true},
    {"b2", &SpectrumRecord::b2, true},
    {"direction", &SpectrumRecord::direction},
    {"directional_density", &SpectrumRecord::directional_density, false, kMaxDirectionalValues},
    {"warnings", &SpectrumRecord::warnings, false, kMaxRecordWarnings},
}};

}  // namespace ocean
