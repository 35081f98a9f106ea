// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads sea files, strictly: a key that does nothing is an error, never a silence. From text to
// a validated Sea through the parameter table, its records and its take inside.
#include <algorithm>
#include <map>
#include <memory>
#include <span>

#include "measured_record.hpp"
#include "measured_record_reader.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/seafile.hpp"
#include "take.hpp"
#include "toml_input.hpp"

namespace ocean {
namespace {

constexpr std::string_view kVersionKey = "libocean";
constexpr std::string_view kWaves = "waves";

/// Every section of the table once, in its order.
std::vector<std::string_view> section_names() {
    std::vector<std::string_view> names;
    for (const ParameterInfo& info : parameter_table()) {
        if (std::find(names.begin(), names.end(), info.section) == names.end()) {
            names.push_back(info.section);
        }
    }
    return names;
}

const ParameterInfo* find_in_section(std::string_view section, std::string_view key) {
    for (const ParameterInfo& info : parameter_table()) {
        if (info.section == section && info.key == key) return &info;
    }
    return nullptr;
}

RecordChoice choice_of(const WaveSystem& system);
/// Reads `file` and keeps the record asked for.
void load_record(WaveSystem& system, const std::string& base_dir, const SpectrumReader& reader);

class SeaReader {
  public:
    SeaReader(const std::string& name, const std::string& base_dir, const SpectrumReader& reader)
        : name_(name), base_dir_(base_dir), spectra_(reader) {}

    Sea read(std::string_view text);

  private:
    Error fail(std::size_t line, const std::string& message,
               ErrorKind kind = ErrorKind::invalid_value) const {
        return text::error_at(kind, name_, line, message);
    }
    /// Runs a step of core or of another reader; its error gets this file and line in front.
    template <typename Step>
    void at_line(std::size_t line, const std::string& prefix, Step step) const {
        try {
            step();
        } catch (const Error& error) {
            throw fail(line, prefix + error.what(), error.kind());
        }
    }

    void read_version(const toml::table& root) const;
    void read_root_entry(const TomlEntry& entry);
    void read_waves(const TomlEntry& entry);
    void read_section(const toml::table& table, std::string_view section, std::size_t wave);
    void read_value(const ParameterRef& ref, const TomlEntry& entry);
    ParameterValue value_for(const ParameterRef& ref, const toml::node& node) const;
    void resolve_record(std::size_t wave);
    void read_take(Sea& sea) const;
    void read_take_lines(Sea& sea) const;
    std::size_t line_named_by(std::string_view message) const;
    [[noreturn]] void refuse_key(std::string_view section, std::size_t wave,
                                 const TomlEntry& entry) const;
    [[noreturn]] void refuse_root_key(const TomlEntry& entry) const;

    const std::string& name_;
    const std::string& base_dir_;
    const SpectrumReader& spectra_;
    Parameters parameters_;
    std::map<std::string, std::size_t, std::less<>> lines_;  // of the paths that were given
    const toml::node* take_ = nullptr;                       // inlined
};

Sea SeaReader::read(std::string_view text) {
    const toml::table root = parse_toml(text, name_);
    read_version(root);
    for (const TomlEntry& entry : in_file_order(root)) read_root_entry(entry);
    for (std::size_t wave = 0; wave < parameters_.waves.size(); ++wave) resolve_record(wave);
    Sea sea{std::move(parameters_), {}};
    read_take(sea);
    try {
        validate(sea);
    } catch (const Error& error) {
        throw fail(line_named_by(error.what()), error.what(), error.kind());
    }
    return sea;
}

void SeaReader::read_version(const toml::table& root) const {
    const toml::node* version = root.get(kVersionKey);
    const std::string wanted = "libocean = " + std::to_string(kSeaFileVersion);
    if (version == nullptr) {
        throw fail(0, "is not a sea file: the line '" + wanted + "' is missing",
                   ErrorKind::bad_file);
    }
    const auto* number = version->as_integer();
    if (number == nullptr || number->get() != kSeaFileVersion) {
        throw fail(line_of(*version),
                   "libocean = " + shown(*version) +
                       ": this version of libocean does not read that format; allowed: " + wanted,
                   ErrorKind::bad_file);
    }
}

void SeaReader::read_root_entry(const TomlEntry& entry) {
    if (entry.key == kVersionKey) return;
    if (entry.key == kWaves) return read_waves(entry);
    if (entry.key == kTakeSection) {
        take_ = entry.node;  // names parameters that may stand below it
        return;
    }
    const std::vector<std::string_view> names = section_names();
    if (std::find(names.begin(), names.end(), entry.key) == names.end()) refuse_root_key(entry);
    const toml::table* table = entry.node->as_table();
    const std::string section(entry.key);
    if (table == nullptr) {
        throw fail(entry.line, section + " = " + shown(*entry.node) +
                                   ": is a section; allowed: one [" + section + "] with keys");
    }
    read_section(*table, section, 0);
}

void SeaReader::read_waves(const TomlEntry& entry) {
    const toml::array* systems = entry.node->as_array();
    if (systems == nullptr || systems->empty() || !systems->is_array_of_tables()) {
        throw fail(entry.line, "waves = " + shown(*entry.node) +
                                   ": is not a list of wave systems; allowed: [[waves]], in double "
                                   "brackets, once for each system");
    }
    if (systems->size() > kMaxWaveSystems) {
        throw fail(line_of((*systems)[kMaxWaveSystems]),
                   "waves: " + std::to_string(systems->size()) + " wave systems; allowed: 1 .. " +
                       std::to_string(kMaxWaveSystems));
    }
    parameters_.waves.assign(systems->size(), WaveSystem{});
    for (std::size_t wave = 0; wave < systems->size(); ++wave) {
        const toml::table& table = *(*systems)[wave].as_table();
        lines_["waves." + std::to_string(wave)] = line_of(table);
        read_section(table, kWaves, wave);
    }
}

void SeaReader::read_section(const toml::table& table, std::string_view section, std::size_t wave) {
    for (const TomlEntry& entry : in_file_order(table)) {
        const ParameterInfo* info = find_in_section(section, entry.key);
        const toml::table* inlined = entry.node->as_table();
        if (info != nullptr) {
            read_value({info, wave}, entry);
        } else if (section == kWaves && entry.key == kMeasuredRecord && inlined != nullptr) {
            const std::string path = "waves." + std::to_string(wave) + "." + std::string(entry.key);
            parameters_.waves[wave].measured =
                std::make_shared<const SpectrumRecord>(read_measured_record(*inlined, name_, path));
        } else {
            refuse_key(section, wave, entry);
        }
    }
}

void SeaReader::read_value(const ParameterRef& ref, const TomlEntry& entry) {
    const ParameterValue value = value_for(ref, *entry.node);
    lines_[ref.info->path(ref.wave)] = entry.line;
    at_line(entry.line, "", [&] { assign(parameters_, ref, value); });
}

/// Checks the type. A whole number may stand for a float, nothing else stands for anything else.
ParameterValue SeaReader::value_for(const ParameterRef& ref, const toml::node& node) const {
    const std::string_view type = ref.info->type();
    const auto wrong = [&](const std::string& what) {
        return fail(line_of(node), ref.info->path(ref.wave) + " = " + shown(node) + ": " + what +
                                       "; allowed: " + allowed_values(*ref.info));
    };
    if (type == "float") {
        const std::optional<double> number = number_of(node);
        if (!number) throw wrong("is not a number");
        return *number;
    }
    if (type == "int") {
        if (!node.is_integer()) throw wrong("is not a whole number");
        return node.as_integer()->get();
    }
    if (type == "list") {
        const toml::array* list = node.as_array();
        if (list == nullptr || list->size() > 64) throw wrong("is not a short list");
        std::vector<std::int64_t> items;
        for (const toml::node& item : *list) {
            if (!item.is_integer()) throw wrong("holds " + shown(item) + ", not a whole number");
            items.push_back(item.as_integer()->get());
        }
        return items;
    }
    if (!node.is_string()) throw wrong("is not a text in quotes");
    return node.as_string()->get();
}

/// Before the record is looked for: what the sea file itself can be blamed for.
void SeaReader::resolve_record(std::size_t wave) {
    WaveSystem& system = parameters_.waves[wave];
    const std::string path = "waves." + std::to_string(wave);
    if (system.measured != nullptr) {
        // Stale after an edit? The inlined record must be the one that `record` asks for.
        at_line(line_named_by(path + ".record"), path + ".", [&] {
            choose_record({system.measured.get(), 1}, choice_of(system),
                          "[waves." + std::string(kMeasuredRecord) + "]");
        });
    } else if (system.spectrum == SpectrumKind::measured) {
        const std::string given = path + (system.file.empty() ? ".spectrum" : ".file");
        const std::string value = system.file.empty() ? "measured" : text::printable(system.file);
        at_line(line_named_by(given), given + " = \"" + value + "\": ", [&] {
            load_record(system, base_dir_, spectra_);
        });
    }
}

/// Its lines give errors of their own; that of an unreadable file belongs to the line that names
/// it.
void SeaReader::read_take(Sea& sea) const {
    if (take_ != nullptr) return read_take_lines(sea);
    const std::size_t line = line_named_by("time.take");
    try {
        resolve_take(sea, base_dir_);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::bad_file) throw;
        const std::string file = text::printable(sea.parameters.time.take);
        throw fail(line, "time.take = \"" + file + "\": " + error.what(), error.kind());
    }
}

void SeaReader::read_take_lines(Sea& sea) const {
    const toml::table* table = take_->as_table();
    const toml::array* lines = table != nullptr ? (*table)[kTakeLines].as_array() : nullptr;
    if (lines == nullptr || table->size() != 1) {
        throw fail(line_of(*take_), "take = " + shown(*take_) +
                                        ": is not a take; allowed: [take] with the one key lines, "
                                        "an array of texts SECONDS NAME VALUE");
    }
    TakeReader reader(sea.parameters, name_);
    for (const toml::node& line : *lines) {
        if (!line.is_string()) {
            throw fail(line_of(line),
                       "take.lines: holds " + shown(line) + ", not a text in quotes");
        }
        reader.add(line.as_string()->get(), line_of(line));
    }
    sea.take = {reader.finish(), sea.parameters.time.take};
}

/// A message of core begins with the path it is about; 0 if that path was not given in the file.
std::size_t SeaReader::line_named_by(std::string_view message) const {
    std::string_view path = message.substr(0, message.find_first_of(" =:"));
    while (true) {
        if (const auto found = lines_.find(path); found != lines_.end()) return found->second;
        const std::size_t dot = path.rfind('.');
        if (dot == std::string_view::npos) return 0;
        path = path.substr(0, dot);
    }
}

void SeaReader::refuse_key(std::string_view section, std::size_t wave,
                           const TomlEntry& entry) const {
    std::string path(section);
    if (section == kWaves) path += "." + std::to_string(wave);
    path += "." + text::printable(entry.key);
    const std::string given = path + " = " + shown(*entry.node) + ": ";
    at_line(entry.line, given, [&] { find_parameter(path); });  // throws, naming the nearest
    throw fail(entry.line, given + "no such key");
}

void SeaReader::refuse_root_key(const TomlEntry& entry) const {
    const std::string key = text::printable(entry.key);
    for (const ParameterInfo& info : parameter_table()) {
        if (info.key != entry.key || entry.node->is_table()) continue;
        const std::string brackets =
            info.per_wave_system() ? "[[waves]]" : "[" + std::string(info.section) + "]";
        throw fail(entry.line, key + " = " + shown(*entry.node) +
                                   ": stands outside its section; allowed: below " + brackets);
    }
    const std::vector<std::string_view> names = section_names();
    std::string allowed;
    for (std::string_view name : names) {
        allowed += std::string(name) + ", ";
    }
    allowed += kTakeSection;
    const std::string_view nearest = nearest_name(entry.key, names);
    std::string message = key + ": no such section";
    if (!nearest.empty()) message += "; did you mean " + std::string(nearest) + "?";
    throw fail(entry.line, message + "; allowed: " + allowed);
}

RecordChoice choice_of(const WaveSystem& system) {
    return {system.record, system.place};
}

void load_record(WaveSystem& system, const std::string& base_dir, const SpectrumReader& reader) {
    if (system.file.empty()) {
        throw Error(ErrorKind::invalid_value,
                    "needs the measured spectra; allowed: file = a path, relative to the sea file");
    }
    const std::string file = text::to_utf8(utf8_path(base_dir) / utf8_path(system.file));
    const std::vector<SpectrumRecord> records = reader(file);
    const SpectrumRecord& chosen = choose_record(records, choice_of(system), file);
    SpectrumRecord record = chosen;
    const auto passed_over = std::span(records.data(), &chosen);
    const bool one_is_bad = std::ranges::any_of(passed_over, [&](const SpectrumRecord& before) {
        return !before.fault.empty() && before.station == chosen.station;
    });
    if (system.record.empty() && one_is_bad) {
        record.warnings.push_back("is of " + record.time +
                                  ": an earlier record cannot be read (`ocean records` says why)");
    }
    system.measured = std::make_shared<const SpectrumRecord>(std::move(record));
}

}  // namespace

void resolve_files(Sea& sea, const std::string& base_dir, const SpectrumReader& reader) {
    for (WaveSystem& system : sea.parameters.waves) {
        const bool needed = system.spectrum == SpectrumKind::measured &&
                            system.measured == nullptr && !system.file.empty();
        if (needed) load_record(system, base_dir, reader);
    }
    resolve_take(sea, base_dir);
}

std::vector<std::string> named_files(const Sea& sea) {
    std::vector<std::string> files;
    const auto add = [&](const std::string& file) {
        if (!file.empty()) files.push_back(file);
    };
    add(sea.parameters.time.take);
    for (const WaveSystem& system : sea.parameters.waves) add(system.file);
    return files;
}

Sea parse_sea(std::string_view toml, const std::string& name, const std::string& base_dir,
              const SpectrumReader& reader) {
    return SeaReader(name, base_dir, reader).read(toml);
}

Sea read_sea(const std::string& path, const SpectrumReader& reader) {
    const std::string content = text::read_file(path, kMaxSeaFileBytes);
    return parse_sea(content, path, text::to_utf8(utf8_path(path).parent_path()), reader);
}

}  // namespace ocean
