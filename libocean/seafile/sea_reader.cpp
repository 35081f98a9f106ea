// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads sea files, strictly: from text to a validated Sea through the parameter table, including
// its records, its tracks and its take.
#include <algorithm>
#include <memory>
#include <span>

#include "bed_file.hpp"
#include "measured_record.hpp"
#include "measured_record_reader.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/seafile.hpp"
#include "table_reader.hpp"
#include "take.hpp"
#include "track_file.hpp"

namespace ocean {
namespace {

RecordChoice choice_of(const WaveSystem& system) {
    return {system.record, system.place};
}

SpectrumRecord read_chosen(const WaveSystem& system, const std::string& base_dir,
                           const SpectrumReader& reader) {
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
    return record;
}

/// Reads `file` of waves.`wave` and stores the requested record. Throws errors of the parameter
/// that names or needs the file.
void load_record(WaveSystem& system, std::size_t wave, const std::string& base_dir,
                 const SpectrumReader& reader) {
    const std::string path = "waves." + std::to_string(wave) + ".";
    if (system.file.empty()) {
        throw text::error_of_text(
            Error(ErrorKind::invalid_value,
                  "needs the measured spectra; allowed: file = a path, relative to the sea file"),
            path + "spectrum", "measured");
    }
    try {
        system.measured =
            std::make_shared<const SpectrumRecord>(read_chosen(system, base_dir, reader));
    } catch (const Error& error) {
        throw text::error_of_text(error, path + "file", system.file);
    }
}

class SeaReader {
  public:
    SeaReader(const std::string& name, const std::string& base_dir, const SpectrumReader& reader)
        : name_(name), base_dir_(base_dir), spectra_(reader), reader_(sea_table(), name, parts()) {}

    Sea read(std::string_view text) {
        const toml::table root = parse_toml(text, name_);
        Sea sea{reader_.read(root), {}};
        std::vector<WaveSystem>& waves = sea.parameters.waves;
        for (std::size_t wave = 0; wave < waves.size(); ++wave) resolve_record(waves[wave], wave);
        file().at_parameter([&] { resolve_bed(sea.parameters.water, base_dir_, std::move(bed_)); });
        std::vector<Hull>& hulls = sea.parameters.hulls;
        for (std::size_t hull = 0; hull < hulls.size(); ++hull) {
            file().at_parameter([&] { resolve_track(hulls[hull], hull, base_dir_); });
        }
        read_take(sea);
        try {
            validate(sea);
        } catch (const Error& error) {
            throw file().in_front(error);
        }
        return sea;
    }

  private:
    const TableFile& file() const { return reader_.file(); }

    /// Returns the model's own parts of the file. The take is read last, because it names
    /// parameters that may follow it in the file.
    OwnParts<Parameters> parts() {
        return {.roots = {kTakeSection},
                .read_root = [this](const TomlEntry& entry) { take_ = entry.node; },
                .read_key =
                    [this](Parameters& parameters, std::string_view section, std::size_t item,
                           const TomlEntry& entry) {
                        return read_record(parameters, section, item, entry) ||
                               read_bed(section, entry) ||
                               read_track(parameters, section, item, entry);
                    }};
    }

    bool read_record(Parameters& parameters, std::string_view section, std::size_t wave,
                     const TomlEntry& entry) const {
        const toml::table* inlined = entry.node->as_table();
        if (section != "waves" || entry.key != kMeasuredRecord || inlined == nullptr) return false;
        const std::string path = "waves." + std::to_string(wave) + "." + std::string(entry.key);
        parameters.waves[wave].measured =
            std::make_shared<const SpectrumRecord>(read_measured_record(*inlined, name_, path));
        return true;
    }

    bool read_bed(std::string_view section, const TomlEntry& entry) {
        return section == "water" &&
               file().at_line(entry.line, [&] { return read_bed_table(entry, bed_); });
    }

    bool read_track(Parameters& parameters, std::string_view section, std::size_t hull,
                    const TomlEntry& entry) const {
        if (section != "hulls" || entry.key != kTrackKey) return false;
        const std::string name = "hulls." + std::to_string(hull) + "." + std::string(kTrackKey);
        file().at_line(entry.line, [&] {
            auto track = std::make_shared<const HullTrack>(read_track_rows(entry, name));
            require_track(*track, name);
            parameters.hulls[hull].track = std::move(track);
        });
        return true;
    }

    /// Checks the wave system before its record is searched, so that errors of the sea file itself
    /// come first.
    void resolve_record(WaveSystem& system, std::size_t wave) const {
        if (system.measured != nullptr) return check_inlined(system, wave);
        if (system.spectrum != SpectrumKind::measured) return;
        file().at_parameter([&] { load_record(system, wave, base_dir_, spectra_); });
    }

    /// Throws unless `record` and `place` request the inlined record, which may be stale after an
    /// edit.
    void check_inlined(const WaveSystem& system, std::size_t wave) const {
        const std::string path = "waves." + std::to_string(wave) + ".";
        try {
            choose_record({system.measured.get(), 1}, choice_of(system),
                          "[waves." + std::string(kMeasuredRecord) + "]");
        } catch (const Error& error) {
            ErrorFields fields = error.fields();
            const bool is_timed = !system.record.empty();
            fields.parameter = path + (is_timed ? "record" : "place");
            fields.value = "\"" + text::printable(is_timed ? system.record : system.place) + "\"";
            throw file().in_front(Error(error.kind(), error.what(), fields),
                                  file().line_of_parameter(path + "record"), path);
        }
    }

    /// Reads the take. Errors of its lines name these lines; the error of an unreadable file names
    /// the line of the sea file.
    void read_take(Sea& sea) const {
        if (take_ != nullptr) return read_take_lines(sea);
        try {
            resolve_take(sea, base_dir_);
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::bad_file) throw;
            throw file().in_line_of_parameter(error);
        }
    }

    void read_take_lines(Sea& sea) const {
        const toml::table* table = take_->as_table();
        const toml::array* lines = table != nullptr ? (*table)[kTakeLines].as_array() : nullptr;
        if (lines == nullptr || table->size() != 1) {
            throw file().fail(line_of(*take_),
                              {.what = "is not a take",
                               .parameter = std::string(kTakeSection),
                               .value = shown(*take_),
                               .allowed = "[take] with the one key lines, an array "
                                          "of texts SECONDS NAME VALUE"});
        }
        TakeReader reader(sea.parameters, name_);
        for (const toml::node& line : *lines) {
            if (!line.is_string()) {
                throw file().fail(line_of(line),
                                  {.what = "holds " + shown(line) + ", not a text in quotes",
                                   .parameter = "take.lines"});
            }
            reader.add(line.as_string()->get(), line_of(line));
        }
        sea.take = {reader.finish(), sea.parameters.time.take};
    }

    const std::string& name_;
    const std::string& base_dir_;
    const SpectrumReader& spectra_;
    TableReader<Parameters> reader_;
    const toml::node* take_ = nullptr;  // the inlined take
    InlinedBed bed_;
};

/// Reads the bed of a sea whose text has been read before. If its file cannot be read, throws an
/// Error that also states why the file is needed although the text may hold heights.
void read_bed_again(Water& water, const std::string& base_dir) {
    try {
        resolve_bed(water, base_dir);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::bad_file) throw;
        throw Error(error.kind(),
                    "water.seabed = \"" + water.seabed + "\": " + error.what() +
                        "; with seabed or seabed_unit set, the bed is read from this file: name "
                        "one that can be read, or leave both as they were",
                    error.fields());
    }
}

}  // namespace

void resolve_files(Sea& sea, const std::string& base_dir, const SpectrumReader& reader) {
    std::vector<WaveSystem>& waves = sea.parameters.waves;
    for (std::size_t wave = 0; wave < waves.size(); ++wave) {
        const WaveSystem& system = waves[wave];
        const bool needed = system.spectrum == SpectrumKind::measured &&
                            system.measured == nullptr && !system.file.empty();
        if (needed) load_record(waves[wave], wave, base_dir, reader);
    }
    Water& water = sea.parameters.water;
    if (!water.seabed.empty() && water.bed == nullptr) read_bed_again(water, base_dir);
    std::vector<Hull>& hulls = sea.parameters.hulls;
    for (std::size_t hull = 0; hull < hulls.size(); ++hull) {
        resolve_track(hulls[hull], hull, base_dir);
    }
    resolve_take(sea, base_dir);
}

std::vector<std::string> named_files(const Sea& sea) {
    std::vector<std::string> files;
    const auto add = [&](const std::string& file) {
        if (!file.empty()) files.push_back(file);
    };
    add(sea.parameters.water.seabed);
    add(sea.parameters.time.take);
    for (const WaveSystem& system : sea.parameters.waves) add(system.file);
    for (const Hull& hull : sea.parameters.hulls) add(hull.track_file);
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
