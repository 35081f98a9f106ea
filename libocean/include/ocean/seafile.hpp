// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Sea files: strict reading, writing that round-trips, presets, takes, the spectra of buoys and
// wave models; and a sea as a Subject, with the way back for code that only a sea has.
//
//     Sea sea = read_sea("storm.toml");
//     Sea gale = parse_sea(find_preset("beaufort_8").toml, "beaufort_8", "");
//     set_parameter(sea.parameters, "waves.0.file", "buoy.spec");
//     resolve_files(sea, ".");           // reads the record that `file` names
//     std::string text = write_sea(sea);  // needs no other file
//     for (const Preset& preset : presets()) menu.add(preset.name, preset.description);
//     std::unique_ptr<Subject> subject = make_subject(sea);  // for a bake
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/parameters.hpp"
#include "ocean/sea.hpp"
#include "ocean/subject.hpp"

namespace ocean {

class Ocean;
struct Region;

/// The format version that this library reads and writes.
inline constexpr int kSeaFileVersion = 1;
inline constexpr std::size_t kMaxSeaFileBytes = std::size_t{4} << 20;

/// Returns all records of a spectrum file, in file order. The format is recognised by its content:
/// all text formats, and with zlib their .gz. A record that cannot be read has its `fault` set and
/// does not affect the others. Throws Error bad_file "PATH:LINE: ..." if no record can be read.
std::vector<SpectrumRecord> read_spectra(const std::string& path);
/// read_spectra, or a program's own reader of formats that need further libraries.
using SpectrumReader = std::function<std::vector<SpectrumRecord>(const std::string& path)>;

/// Reads a sea file. A relative `file`, `seabed` or `take` in it is relative to the sea file.
/// Throws Error with "PATH:LINE: section.key = VALUE: FAULT; allowed: RANGE".
Sea read_sea(const std::string& path, const SpectrumReader& reader = read_spectra);
/// Reads the text of a sea file. `name` stands for the path in messages; a relative `file`,
/// `seabed` or `take` is relative to base_dir (empty: the current directory). Throws as read_sea.
Sea parse_sea(std::string_view toml, const std::string& name, const std::string& base_dir,
              const SpectrumReader& reader = read_spectra);
/// Reads the files that the parameters name and the sea has not read yet, after set_parameter: the
/// record of each measured system that has none, the track of each hull that has none, the bed of a
/// sea that has none, and a take other than the present one. Throws as read_spectra, choose_record,
/// read_terrain, read_elevation, make_sea_bed and parse_take, as errors of the parameter that names
/// the file.
void resolve_files(Sea& sea, const std::string& base_dir,
                   const SpectrumReader& reader = read_spectra);
/// Returns the files that a sea names, as its own file spells them: its bed, its take,
/// its spectra and the tracks of its hulls.
std::vector<std::string> named_files(const Sea& sea);
/// Returns the resolved sea as text: every key of the table that is set and not neutral
/// (OptionalColumns in table.hpp), the chosen records inlined as [waves.measured_record], the
/// tracks of hulls as `track`, the take as [take] and the bed as [water.bed_terrain] or, up to 1
/// MB, [water.bed_heights], which a reader prefers to `file`, `take` and `seabed`; for a larger bed
/// the text has the hash alone. parse_sea(write_sea(s)) gives the same sea bit by bit. Throws Error
/// invalid_value for a text that is not UTF-8 and for a sea that breaks a rule between parameters,
/// which parse_sea would refuse.
std::string write_sea(const Sea& sea);

/// A parameter's name and value, as set_parameter takes them, or a table that a resolved file
/// carries beside its parameters: "[take]", "[waves.0.measured_record]", "[hulls.0.track]",
/// "[water.bed_heights]" or "[water.bed_terrain]" with its lines.
struct NamedText {
    std::string name;
    std::string value;
};
struct NamedValue {
    std::string_view name;
    std::string_view value;
};
/// Returns every parameter of a sea in the order of the table, "" for one that is not set, then the
/// tables that its file carries. Throws as write_sea.
std::vector<NamedText> sea_values(const Sea& sea);
/// Returns the sea file with these values, each spelled as given: a host keeps the text as long as
/// its values stay. Leaves out empty and neutral values. Checks no value; throws Error
/// invalid_value for an unknown name, a text that is not UTF-8 and a number of several lines.
std::string text_of_values(std::span<const NamedValue> values);

/// Returns the kind of subject that the text of a file describes by its sections, "sea" or
/// "terrain"; "" for a text that has no such section or is not TOML.
std::string kind_of_file_text(std::string_view toml);

/// Parses a take: lines "SECONDS NAME VALUE" ordered by time, names as in the parameter table; '#'
/// begins a comment. Throws Error "NAME:LINE: name = value: FAULT; allowed: RANGE".
Take parse_take(std::string_view text, const std::string& name, const Parameters& parameters);
/// Returns the take as text, a line for each event, which parse_take reads back to the same bits.
std::string write_take(const Take& take);

struct Preset {
    std::string name;
    std::string description;  // one line
    std::string toml;         // a whole sea file with comments
};
/// Returns all presets, in the order in which they are listed.
std::span<const Preset> presets();
/// Returns the preset of that name. Throws Error not_found naming the nearest.
const Preset& find_preset(std::string_view name);

/// Selects one of several records; empty members select the first.
struct RecordChoice {
    std::string time;   // ISO 8601: the nearest within 30 minutes
    std::string place;  // a station's name, or "LATITUDE,LONGITUDE": the nearest within 50 km
};
/// Returns the chosen record; the place is applied first. `file` is named in messages. Throws Error
/// invalid_value for a time or place that cannot be parsed, not_found naming the nearest record,
/// bad_file with the fault of the chosen record.
const SpectrumRecord& choose_record(std::span<const SpectrumRecord> records,
                                    const RecordChoice& choice, const std::string& file);
/// Returns JSON, one object for each record: time, station, latitude, longitude, depth,
/// significant_wave_height [m], peak_period, energy_period, mean_period [s], mean_direction
/// [degrees counter-clockwise from +x, travelling to], coming_from [degrees clockwise from north],
/// directional_spread [degrees], directions ("none", "moments" or "full"), frequencies [a count],
/// warnings; unknown values are null. Records with a fault are left out: records_warnings names
/// them.
std::string records_json(std::span<const SpectrumRecord> records);
/// Returns the warnings of the readers, a sentence for each warning and each record that cannot be
/// read; a sentence that several records share appears once, with their number.
std::vector<std::string> records_warnings(std::span<const SpectrumRecord> records);

/// Returns the direction that waves come from, as sailors name it [degrees clockwise from north], 0
/// <= d < 360, for the direction that they travel to [degrees counter-clockwise from +x]. NaN for
/// NaN.
double coming_from(double travelling_to);

/// Integrals of a record as measured, over its listed frequencies by the trapezoid rule.
struct RecordSummary {
    double m0 = 0.0;                  // [m^2]
    double peak_period = 0.0;         // of the listed frequency with the highest density [s]
    double energy_period = 0.0;       // Te = m-1 / m0 [s]; 0 without energy
    double mean_period = 0.0;         // Tm01 = m0 / m1 [s]; 0 without energy
    double mean_direction = 0.0;      // travelling to, energy-weighted [rad]; NaN if unknown
    double directional_spread = 0.0;  // sqrt(2 (1 - |c1|)) [rad]; NaN if unknown
};
/// Returns the integrals of a record.
RecordSummary summarize(const SpectrumRecord& record);

// ---- Seas as subjects

/// Returns a valid, resolved sea as a subject: one period of an open sea, or the whole bed of a sea
/// over a bed.
std::unique_ptr<Subject> make_subject(Sea sea);
/// Returns a region of a sea over a bed or with hulls as a subject. Throws Error unsupported for a
/// sea without either, and as domain_of(region).
std::unique_ptr<Subject> make_region_subject(Sea sea, const Region& region);
/// Returns the sea or region that the text() of its subject describes. `name` stands for a path in
/// messages. Throws Error as parse_sea.
std::unique_ptr<Subject> parse_sea_subject(std::string_view text, const std::string& name);

/// Returns the sea of a subject, or null for a subject of another kind.
const Sea* find_sea(const Subject& subject);
/// Returns the sea of a subject. Throws Error unsupported for a subject of another kind.
const Sea& sea_of(const Subject& subject);
/// Returns the Ocean that makes a sea's maps. Throws Error unsupported for maps of another kind.
Ocean& ocean_of(SubjectMaps& maps);

}  // namespace ocean
