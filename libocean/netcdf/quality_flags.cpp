// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Meanings of flags: see quality_flags.hpp.
#include "quality_flags.hpp"

#include <algorithm>

#include "names.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::netcdf {
namespace {

/// Splits a text at blanks and commas.
std::vector<std::string> parts_of(std::string text) {
    std::replace(text.begin(), text.end(), ',', ' ');
    std::vector<std::string> parts;
    for (const auto& part : split(text, ' ')) {
        if (!part.empty()) parts.emplace_back(part);
    }
    return parts;
}

Quality quality_of(const std::string& meaning) {
    const std::string words = lower_case(meaning);
    const auto says = [&](Words some) {
        return std::any_of(some.begin(), some.end(), [&](std::string_view word) {
            return words.find(word) != std::string::npos;
        });
    };
    if (says({"not_bad", "not_eval"})) return Quality::good;
    if (says({"bad", "fail", "missing", "erroneous", "wrong", "reject", "invalid"})) {
        return Quality::bad;
    }
    return says({"questionable", "suspect", "doubt"}) ? Quality::doubtful : Quality::good;
}

}  // namespace

QualityFlags::QualityFlags(const Variable& flags) {
    const std::vector<std::string> values = parts_of(flags.attribute("flag_values"));
    const std::vector<std::string> meanings = parts_of(flags.attribute("flag_meanings"));
    if (!values.empty() && values.size() == meanings.size()) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            const auto value = text::parse_number(values[i]);
            if (value) known_.emplace_back(*value, quality_of(meanings[i]));
        }
    }
    if (known_.empty()) {
        known_ = {{3.0, Quality::doubtful}, {4.0, Quality::bad}, {9.0, Quality::bad}};
    }
}

Quality QualityFlags::quality(double flag) const {
    const auto found = std::find_if(known_.begin(), known_.end(),
                                    [&](const auto& known) { return known.first == flag; });
    return found == known_.end() ? Quality::good : found->second;
}

}  // namespace ocean::netcdf
