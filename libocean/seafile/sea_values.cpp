// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea file as names and values, and back. Hosts that keep a sea in their own properties, as
// Blender does, read and write it with these two functions, without TOML.
#include <algorithm>
#include <map>

#include "bed_file.hpp"
#include "measured_record.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/seafile.hpp"
#include "table_writer.hpp"
#include "take.hpp"
#include "toml_text.hpp"
#include "track_file.hpp"

namespace ocean {
namespace {

/// Returns "[waves.0.measured_record]", the name of a system's record among the values.
std::string record_name(std::size_t system) {
    return "[waves." + std::to_string(system) + "." + std::string(kMeasuredRecord) + "]";
}
/// Returns "[hulls.0.track]", the name of a hull's rows among the values.
std::string track_name(std::size_t hull) {
    return "[hulls." + std::to_string(hull) + "." + std::string(kTrackKey) + "]";
}
std::string take_name() {
    return "[" + std::string(kTakeSection) + "]";
}

/// Returns "[water.bed_heights]" for the table "bed_heights".
std::string bed_name(std::string_view table) {
    return "[water." + std::string(table) + "]";
}
bool is_bed_name(std::string_view name) {
    return name == bed_name(kBedHeights) || name == bed_name(kBedTerrain);
}

/// Returns the text cut before each line that opens a table.
std::vector<std::string> cut_at_tables(std::string_view text) {
    std::vector<std::string> tables(1);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
        if (text.front() == '[') tables.emplace_back();
        tables.back() += text.substr(0, end);
        text.remove_prefix(end);
    }
    return tables;
}

[[noreturn]] void refuse(std::string_view name, std::string_view value,
                         const std::string& allowed) {
    throw Error(ErrorKind::invalid_value,
                {.parameter = std::string(name), .value = std::string(value), .allowed = allowed});
}

/// The values of a text, ordered as a file has them.
class ValueList {
  public:
    void add(const NamedValue& given) {
        if (given.name == take_name()) {
            take_ = given.value;
        } else if (is_bed_name(given.name)) {
            bed_ = given.value;
        } else if (given.name.starts_with("[hulls.")) {
            tracks_[hull_of_track(given.name)] = given.value;
        } else if (given.name.starts_with('[')) {
            records_[system_of_record(given.name)] = given.value;
        } else {
            add_parameter(given);
        }
    }

    std::string text() const {
        std::string out = "libocean = " + std::to_string(kSeaFileVersion) + "\n";
        for (const TableSection& section : sea_table().sections) {
            if (section.is_list()) {
                out += list_items(section.name);
            } else if (const std::string lines = section_lines(section.name, 0); !lines.empty()) {
                out += "\n[" + std::string(section.name) + "]\n" + lines;
            }
            if (section.name == "water" && !bed_.empty()) out += "\n" + std::string(bed_);
        }
        return take_.empty() ? out : out + "\n" + std::string(take_);
    }

  private:
    using Key = std::pair<const ParameterInfo*, std::size_t>;

    std::size_t system_of_record(std::string_view name) {
        for (std::size_t system = 0; system < kMaxWaveSystems; ++system) {
            if (name != record_name(system)) continue;
            std::size_t& systems = items_["waves"];
            systems = std::max(systems, system + 1);
            return system;
        }
        refuse("name", name,
               "a parameter, " + take_name() + ", " + bed_name(kBedHeights) + ", " +
                   bed_name(kBedTerrain) + ", or " + record_name(0) + " .. " +
                   record_name(kMaxWaveSystems - 1));
    }

    std::size_t hull_of_track(std::string_view name) {
        for (std::size_t hull = 0; hull < kMaxHulls; ++hull) {
            if (name != track_name(hull)) continue;
            std::size_t& hulls = items_["hulls"];
            hulls = std::max(hulls, hull + 1);
            return hull;
        }
        refuse("name", name, track_name(0) + " .. " + track_name(kMaxHulls - 1));
    }

    void add_parameter(const NamedValue& given) {
        const ParameterRef ref = find_parameter(given.name);
        if (ref.info->in_list()) {
            const std::size_t max = section_of(*ref.info).max_items;
            if (ref.item >= max) refuse_item(*ref.info, ref.item, max);
            std::size_t& items = items_[ref.info->section];
            items = std::max(items, ref.item + 1);
        }
        if (!is_word(*ref.info) && given.value.find_first_of("\r\n") != std::string_view::npos) {
            refuse(given.name, given.value, "one line");
        }
        values_[{ref.info, ref.item}] = given.value;
    }

    static const TableSection& section_of(const ParameterSpec& spec) {
        return *std::ranges::find(sea_table().sections, spec.section, &TableSection::name);
    }

    static bool is_word(const ParameterSpec& spec) {
        return spec.type() == "enum" || spec.type() == "text";
    }

    /// Returns true for the neutral value of a row; a number may have any spelling.
    static bool is_neutral(const ParameterInfo& row, std::string_view value) {
        if (!row.neutral || value == *row.neutral) return row.neutral.has_value();
        const auto number = text::parse_number(*row.neutral);
        return !is_word(row) && number && text::parse_number(value) == number;
    }

    std::string line(const ParameterInfo& row, std::size_t item) const {
        const auto found = values_.find({&row, item});
        if (found == values_.end()) return "";
        const std::string_view value = found->second;
        if ((value.empty() && row.type() != "text") || is_neutral(row, value)) return "";
        const bool is_text =
            is_word(row) || (row.type() == "wave_height" && !text::parse_number(value));
        return std::string(row.key) + " = " + (is_text ? toml_string(value) : std::string(value)) +
               "\n";
    }

    std::string section_lines(std::string_view section, std::size_t item) const {
        std::string out;
        for (const ParameterInfo& row : parameter_table()) {
            if (row.section == section) out += line(row, item);
        }
        return out;
    }

    std::string list_items(std::string_view section) const {
        std::string out;
        const auto items = items_.find(section);
        for (std::size_t item = 0; items != items_.end() && item < items->second; ++item) {
            out += "\n[[" + std::string(section) + "]]\n" + section_lines(section, item);
            const auto record = records_.find(item);
            if (section == "waves" && record != records_.end()) {
                out += "\n" + std::string(record->second);
            }
            const auto track = tracks_.find(item);
            if (section == "hulls" && track != tracks_.end()) out += track->second;
        }
        return out;
    }

    std::map<Key, std::string_view> values_;
    std::map<std::size_t, std::string_view> records_;
    std::map<std::size_t, std::string_view> tracks_;
    std::string_view take_;
    std::string_view bed_;
    std::map<std::string_view, std::size_t> items_;  // of each section that is a list
};

}  // namespace

std::vector<NamedText> sea_values(const Sea& sea) {
    std::vector<NamedText> values;
    const Parameters& parameters = sea.parameters;
    for (const TableSection& section : sea_table().sections) {
        const std::size_t items = items_of(sea_table(), section.name, parameters);
        for (std::size_t item = 0; item < items; ++item) {
            for (const ParameterInfo& row : parameter_table()) {
                if (row.section != section.name) continue;
                values.push_back({row.path(item), to_text(value_of(parameters, {&row, item}))});
            }
        }
    }
    for (std::size_t hull = 0; hull < parameters.hulls.size(); ++hull) {
        const std::string track = track_text(parameters.hulls[hull]);
        if (!track.empty()) values.push_back({track_name(hull), track});
    }
    std::size_t systems = 0;
    for (const std::string& table : cut_at_tables(write_sea(sea))) {
        if (table.starts_with("[[waves]]")) ++systems;
        if (table.starts_with("[waves." + std::string(kMeasuredRecord) + "]")) {
            values.push_back({record_name(systems - 1), table});
        }
        for (const std::string_view bed : {kBedHeights, kBedTerrain}) {
            if (table.starts_with(bed_name(bed))) values.push_back({bed_name(bed), table});
        }
        if (table.starts_with(take_name())) values.push_back({take_name(), table});
    }
    return values;
}

std::string text_of_values(std::span<const NamedValue> values) {
    ValueList list;
    for (const NamedValue& value : values) list.add(value);
    return list.text();
}

}  // namespace ocean
