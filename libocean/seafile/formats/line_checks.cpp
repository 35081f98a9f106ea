// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See line_checks.hpp.
#include "line_checks.hpp"

#include <optional>

#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/text.hpp"

namespace ocean {

double number_within(const LineReader& lines, std::string_view word, double low, double high,
                     std::string_view what) {
    const std::optional<double> value = text::parse_number(word);
    if (value && *value >= low && *value <= high) return *value;
    throw lines.fail("'" + text::printable(word, 20) + "' is not " + std::string(what) +
                     " within " + shortest_text(low) + " .. " + shortest_text(high));
}

std::vector<std::string_view> exact_fields(const LineReader& lines, std::size_t count,
                                           const std::string& than) {
    auto fields = csv::fields_of(lines, ',', count);
    if (fields.size() == count) return fields;
    const bool fewer = fields.size() < count;
    if (fewer && lines.cut_off()) throw lines.fail("the file ends within this line");
    throw lines.fail((fewer ? "fewer " : "more ") + than);
}

void append_frequency(const LineReader& lines, double frequency, std::vector<double>& frequencies) {
    if (!frequencies.empty() && !(frequency > frequencies.back())) {
        throw lines.fail("the frequencies do not ascend at bin " +
                         std::to_string(frequencies.size() + 1));
    }
    if (frequencies.size() == kMaxFrequencies) throw lines.fail("more than 4096 frequencies");
    frequencies.push_back(frequency);
}

DirectionAxis direction_axis(const LineReader& lines, std::span<const double> degrees,
                             DirectionConvention convention) {
    const std::string fault = DirectionAxis::fault(degrees);
    if (!fault.empty()) throw lines.fail(fault);
    return DirectionAxis(degrees, convention);
}

void require_directional_size(const LineReader& lines, std::size_t values) {
    if (values <= kMaxDirectionalValues) return;
    throw lines.fail("a spectrum has at most 131072 values over frequency and direction");
}

void require_room(const LineReader& lines, std::size_t records, std::size_t values_of_each) {
    if (records >= kMaxRecords) throw lines.fail("more than 100000 records");
    if ((records + 1) * values_of_each > kMaxFileValues) {
        throw lines.fail("more than 67108864 values over all records");
    }
}

}  // namespace ocean
