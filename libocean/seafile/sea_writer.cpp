// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes sea files that read back to the same parameters bit by bit. The files are saved, baked
// into image headers and sent to farms, so that they must not depend on other files: the record of
// a measured system is inlined as [waves.measured_record]. `file` and `record` are kept beside it
// as its source: a reader that finds the table opens no file, and refuses the sea if `record` was
// edited to request another time. To choose again, delete the table. A take is inlined too, as
// [take], the tracks of hulls as their rows, and a bed as bed_file.hpp says.
#include "bed_file.hpp"
#include "measured_record.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/seafile.hpp"
#include "table_writer.hpp"
#include "take.hpp"
#include "toml_text.hpp"
#include "track_file.hpp"

namespace ocean {
namespace {

constexpr std::string_view kSeaOpening =
    "# A sea, for libocean. All units are SI, angles in degrees.\n";

std::string text_if_known(const std::string& value) {
    return value.empty() ? "" : toml_string(value);
}
std::string text_if_known(double value) {
    return value != value ? "" : toml_number(value);
}
std::string text_if_known(const std::vector<std::string>& texts) {
    std::string out;
    for (const std::string& text : texts) out += "\n    " + toml_string(text) + ",";
    return out.empty() ? "" : "[" + out + "\n]";
}
std::string text_if_known(const std::vector<double>& values) {
    constexpr std::size_t kPerLine = 8;
    return values.empty() ? "" : toml_lines(values, kPerLine);
}

std::string measured_record_text(const WaveSystem& system) {
    if (system.measured == nullptr) return "";
    std::string out = "\n[waves." + std::string(kMeasuredRecord) + "]\n";
    for (const RecordKey& key : kRecordKeys) {
        const std::string value = std::visit(
            [&](auto member) { return text_if_known((*system.measured).*member); }, key.member);
        if (!value.empty()) out += std::string(key.key) + " = " + value + "\n";
    }
    return out;
}

/// Returns the take of a sea that names a take, even one without events.
std::string take_text(const Sea& sea) {
    if (sea.take.empty() && sea.parameters.time.take.empty()) return "";
    std::string out =
        "\n[" + std::string(kTakeSection) + "]\n" + std::string(kTakeLines) + " = [\n";
    for (const TakeEvent& event : sea.take.events) out += "    \"" + take_line(event) + "\",\n";
    return out + "]\n";
}

}  // namespace

std::string write_sea(const Sea& sea) {
    validate(sea);
    const Parameters& parameters = sea.parameters;
    const auto line = [&](const ParameterRef& ref) { return parameter_line(parameters, ref); };
    const auto inlined = [&](std::string_view section, std::size_t item) {
        if (section == "water") return bed_text(parameters.water);
        if (section == "hulls") return track_text(parameters.hulls[item]);
        return section == "waves" ? measured_record_text(parameters.waves[item]) : "";
    };
    return std::string(kSeaOpening) +
           table_text<Parameters>(sea_table(), parameters, line, inlined) + take_text(sea);
}

}  // namespace ocean
