// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "record_flags.hpp"

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

std::string label(const SpectrumRecord& record) {
    return "record " + record.time + (record.station.empty() ? "" : " " + record.station) + ": ";
}

RecordFlags::RecordFlags(const Content& content, const Layout& layout)
    : content_(content), layout_(layout) {
    for (const auto& [flag, judged] : layout.flags) {
        flags_.push_back({&content.variables[flag], &content.variables[judged],
                          QualityFlags(content.variables[flag])});
    }
}

Verdict RecordFlags::judge(SpectrumRecord& result, const Variable& judged,
                           std::vector<std::size_t> at) const {
    Verdict verdict;
    for (const Flags& flags : flags_) {
        if (flags.judged != &judged) continue;
        const std::vector<std::size_t>& over = flags.flags->dimensions;
        const bool by_frequency =
            std::find(over.begin(), over.end(), layout_.frequency_dimension) != over.end();
        const std::size_t count =
            by_frequency ? content_.dimensions[layout_.frequency_dimension].size : 1;
        std::size_t bad = 0;
        std::size_t doubtful = 0;
        for (std::size_t k = 0; k < count; ++k) {
            at[layout_.frequency_dimension] = k;
            const double flag = flags.flags->values[offset(content_, *flags.flags, at)];
            const Quality quality = flags.meaning.quality(flag);
            doubtful += quality == Quality::doubtful ? 1 : 0;
            if (quality != Quality::bad) continue;
            ++bad;
            if (!by_frequency) {
                verdict.record_fault = text::printable(flags.flags->name) + ": " + label(result) +
                                       "its flag is " + shortest_text(flag) + ", bad";
                continue;
            }
            verdict.bad.resize(count);
            verdict.bad[k] = true;
        }
        if (&judged != &content_.variables[layout_.spectrum]) continue;
        const std::string name = text::printable(flags.flags->name);
        const std::string bands =
            by_frequency ? " of " + std::to_string(count) + " frequencies" : "";
        if (by_frequency && bad > 0) {
            result.warnings.push_back(std::to_string(bad) + bands + " are flagged as bad by " +
                                      name + ": they are left out");
        }
        if (by_frequency && doubtful > 0) {
            result.warnings.push_back(std::to_string(doubtful) + bands +
                                      " are flagged as doubtful by " + name +
                                      ": they are taken as they are");
        } else if (doubtful > 0) {
            result.warnings.push_back("the record is flagged as doubtful by " + name +
                                      ": it is taken as it is");
        }
    }
    return verdict;
}

}  // namespace ocean::netcdf
