// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The declarations of a sea for POV-Ray scenes: parameters and derived quantities, existing frames,
// and the optics of the water. They are loops over the parameter table and the table of water
// types.
#include "ocean/internal/io/povray_declarations.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>

#include "ocean/internal/io/subject_words.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/internal/water_types.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/terrain_table.hpp"
#include "ocean/version.hpp"

namespace ocean::io {
namespace {

/// Returns a number; infinity becomes 1e308, because POV-Ray's parser has no word for it.
constexpr double kInfinity = 1e30;
constexpr std::string_view kSeaPrefix = "Ocean_";

std::string number(double value) {
    if (std::isinf(value)) value = value > 0 ? kInfinity : -kInfinity;
    return shortest_text(value);
}

/// Returns a number with eight decimals, on which all machines agree.
double rounded_variance(double variance) {
    return std::round(variance * 1e8) / 1e8;
}
double variance_of(const DetailBand& band) {
    return rounded_variance(band.variance.mean_square_slope());
}

/// Returns a string literal of POV-Ray, whose strings hold UCS-2 and whose files are ASCII: other
/// characters are \uXXXX, or two of these beyond the first plane; control characters are blanks.
std::string string_literal(std::string_view text) {
    std::string result = "\"";
    while (!text.empty()) {
        const std::size_t length = utf8_character(text);
        const char c = text.front();
        if (length > 1) {
            std::uint32_t code = static_cast<std::uint8_t>(c) & (0x7Fu >> length);
            for (const char next : text.substr(1, length - 1)) {
                code = code << 6 | (static_cast<std::uint8_t>(next) & 0x3Fu);
            }
            if (code >= 0x10000) {
                result += format_text("\\u%04x", 0xD800 + ((code - 0x10000) >> 10));
                code = 0xDC00 + ((code - 0x10000) & 0x3FF);
            }
            result += format_text("\\u%04x", code);
        } else if (length == 0) {
            result += '?';
        } else {
            if (c == '"' || c == '\\') result += '\\';
            result += std::iscntrl(static_cast<unsigned char>(c)) != 0 ? ' ' : c;
        }
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return result + "\"";
}

/// Returns "Ocean_Waves_0_Wind_Speed" for "waves.0.wind_speed" and the prefix "Ocean_".
std::string identifier(std::string_view path, std::string_view prefix = kSeaPrefix) {
    std::string name(prefix);
    for (const char c : path) {
        const char next = c == '.' ? '_' : c;
        const bool begins = name.empty() || name.back() == '_';
        name += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(next))) : next;
    }
    return name;
}

void declare(std::string& text, const std::string& name, const std::string& value,
             const std::string& comment = "") {
    text += "#declare " + name + " = " + value + ";";
    if (!comment.empty()) text += "  // " + comment;
    text += "\n";
}

/// Returns "Ocean_Frame_Sea_"; names that scenes should not use end in '_'.
std::string frame_id_name(const SubjectWords& words) {
    const std::string kind = identifier(words.kind).substr(kSeaPrefix.size());
    return words.prefix() + "Frame_" + kind + "_";
}

/// Undefines the parameters that another sea in the same scene may have declared. It uses no
/// #ifdef: POV-Ray 3.7 loses its position after a file with conditions that a macro includes, in
/// some cases (measured).
void forget(std::string& text, const std::string& name) {
    text += "#declare " + name + " = 0; #undef " + name + "\n";
}

template <typename Range, typename Item>
std::string array_of(const Range& values, const Item& item) {
    std::string text = "array[" + std::to_string(values.size()) + "] { ";
    bool first = true;
    for (const auto& value : values) {
        text += (first ? "" : ", ") + item(value);
        first = false;
    }
    return text + " }";
}

std::string vector(const Rgb& colour) {
    return "<" + number(colour[0]) + ", " + number(colour[1]) + ", " + number(colour[2]) + ">";
}

struct ValueText {
    std::string operator()(double value) const { return number(value); }
    std::string operator()(std::int64_t value) const { return std::to_string(value); }
    std::string operator()(bool value) const { return value ? "true" : "false"; }
    std::string operator()(const std::string& value) const { return string_literal(value); }
    std::string operator()(const std::vector<std::int64_t>& values) const {
        return array_of(values, [](std::int64_t value) { return std::to_string(value); });
    }
    std::string operator()(const std::vector<double>& values) const {
        return array_of(values, [](double value) { return number(value); });
    }
    std::string operator()(const NumberPairs& values) const {
        return array_of(values, [](const std::array<double, 2>& pair) {
            return "<" + number(pair[0]) + ", " + number(pair[1]) + ">";
        });
    }
};

bool is_set(const ParameterValue& value, const ParameterSpec& spec) {
    if (const auto* list = std::get_if<std::vector<std::int64_t>>(&value)) return !list->empty();
    if (const auto* numbers = std::get_if<std::vector<double>>(&value)) return !numbers->empty();
    if (const auto* pairs = std::get_if<NumberPairs>(&value)) return !pairs->empty();
    return !spec.is_unset(value);
}

void declare_parameters(std::string& text, const Parameters& parameters) {
    text += "\n// ---- Parameters, those that are set ----\n";
    declare(text, "Ocean_Waves", std::to_string(parameters.waves.size()), "wave systems");
    for (const ParameterInfo& info : parameter_table()) {
        for (std::size_t item = 0; item < info.member.items(parameters); ++item) {
            text += povray_parameter_declaration(info, item, value_of(parameters, {&info, item}));
        }
    }
}

void declare_frames(std::string& text, const PovrayFolder& folder) {
    text += "\n// ---- Frames ----\n";
    declare(text, "Ocean_First_Frame", std::to_string(folder.frames.front()));
    declare(text, "Ocean_Last_Frame", std::to_string(folder.frames.back()));
    declare(text, "Ocean_Frames",
            array_of(folder.frames, [](int frame) { return std::to_string(frame); }));
    declare(text, "Ocean_Frames_Text_", string_literal(folder.frames_text));
}

void declare_water(std::string& text) {
    const auto types = water_types();
    text += "\n// ---- Sea water: Jerlov's types, the clearest first; 1/m, linear rgb ----\n";
    const auto column = [&](const char* name, const auto& item) {
        declare(text, name, array_of(types, item));
    };
    column("Ocean_Water_Names", [](const WaterType& type) { return string_literal(type.name); });
    column("Ocean_Water_Absorption", [](const WaterType& type) { return vector(type.absorption); });
    column("Ocean_Water_Scattering", [](const WaterType& type) { return vector(type.scattering); });
    text += "// Of a deep body of it, seen from above less the surface's reflection.\n";
    column("Ocean_Water_Albedo",
           [](const WaterType& type) { return vector(type.water_leaving_albedo()); });
    text += "// Of crests with the sun behind them.\n";
    column("Ocean_Water_Crest", [](const WaterType& type) { return vector(type.crest_colour()); });
    declare(text, "Ocean_Water_Ior", number(kWaterIor));
    declare(text, "Ocean_Water_Anisotropy", number(kScatteringAnisotropy));
    declare(text, "Ocean_Foam_Albedo", number(kFoamAlbedo));
}

/// Returns a place or two sides as <east, 0, north>.
std::string ground_vector(const std::array<double, 2>& pair) {
    return "<" + number(pair[0]) + ", 0, " + number(pair[1]) + ">";
}

}  // namespace

std::string povray_parameter_declaration(const ParameterSpec& spec, std::size_t item,
                                         const ParameterValue& value, std::string_view prefix) {
    std::string text;
    const std::string name = identifier(spec.path(item), prefix);
    if (is_set(value, spec)) {
        declare(text, name, std::visit(ValueText(), value), std::string(spec.unit));
    } else {
        forget(text, name);
    }
    return text;
}

std::string povray_declarations(const PovrayFolder& folder) {
    const Parameters& parameters = folder.sea.parameters;
    std::string text =
        "//   Persistence of Vision Ray Tracer Include File\n"
        "//   File: ocean_parameters.inc\n"
        "//   Vers: 3.7\n"
        "//   Desc: The sea of this folder, by libocean " OCEAN_VERSION
        ". Written anew by each\n"
        "//         export: change the sea file instead. Metres, seconds, degrees.\n";
    declare(text, "Ocean_Data_Version", std::to_string(kPovrayDataVersion));
    declare(text, "Ocean_Sea_", string_literal(folder.sea_id), "its frames say the same");
    declare(text, "Ocean_Format", string_literal(folder.format));
    declare(text, "Ocean_Samples", std::to_string(folder.maps.front()), "along a side");
    declare(text, "Ocean_Period", number(parameters.grid.patch_size), "m, in both directions");
    declare(text, "Ocean_Maps", std::to_string(folder.maps.size()),
            "each of half the samples of the one before");
    declare(text, "Ocean_Fine_Samples", std::to_string(folder.fine_map),
            "of the map for heights of places; 0: there is none");
    const auto lost_slopes = [&](int resolution) {
        double shown = 0.0;
        for (const MapSlope& map : folder.state.map_slopes) {
            if (map.resolution == resolution) shown = map.mean_square_slope;
        }
        return number(std::max(0.0, folder.state.mean_square_slope.asked - shown));
    };
    declare(text, "Ocean_Lost_Slopes", array_of(folder.maps, lost_slopes),
            "mean square slope of the waves that each leaves out");
    declare(text, "Ocean_Mean_Square_Slope", number(folder.state.mean_square_slope.asked));
    declare(text, "Ocean_Hs", number(folder.state.significant_wave_height.resolved),
            "m, significant wave height");
    declare(text, "Ocean_Tp", number(folder.state.peak_period.resolved), "s, peak period");
    declare(text, "Ocean_Direction", number(folder.state.mean_direction.resolved),
            "degrees from x towards z: where the waves travel to");
    declare_frames(text, folder);
    declare_parameters(text, parameters);
    declare_water(text);
    return text;
}

std::string povray_land_map_declarations(const Domain& domain) {
    std::string text;
    const auto [columns, rows] = domain.samples;
    declare(text, "Terrain_Repeats", domain.wraps ? "true" : "false");
    declare(text, "Terrain_Samples", std::to_string(std::max(columns, rows)),
            domain.wraps ? "along a side of the tile" : "along the longer side");
    declare(text, "Terrain_Columns", std::to_string(columns), "samples to the east");
    declare(text, "Terrain_Rows", std::to_string(rows), "samples to the north");
    declare(text, "Terrain_Cell", number(domain.step(0)), "m, between samples");
    declare(text, "Terrain_Corner", ground_vector(domain.origin), "m, the south-west one");
    declare(text, "Terrain_Extent", ground_vector(domain.size), "m, its sides");
    if (domain.wraps) {
        declare(text, "Terrain_Period", number(domain.size[0]), "m, in both directions");
    } else {
        forget(text, "Terrain_Period");
    }
    return text;
}

std::string povray_region_declarations(const Domain& domain, const Domain* bed,
                                       std::string_view id) {
    std::string text = bed != nullptr
                           ? "\n// ---- Coast: the map of the water over the bed ----\n"
                           : "\n// ---- Hulls: the map of the water with their wakes ----\n";
    if (bed == nullptr) declare(text, "Ocean_Coast_Hulls_", "true");
    declare(text, "Ocean_Coast_Id_", string_literal(id), "its frames say the same");
    declare(text, "Ocean_Coast_Columns", std::to_string(domain.samples[0]), "samples to the east");
    declare(text, "Ocean_Coast_Rows", std::to_string(domain.samples[1]), "samples to the north");
    declare(text, "Ocean_Coast_Cell", number(domain.step(0)), "m, between samples");
    declare(text, "Ocean_Coast_Corner", ground_vector(domain.origin), "m, the south-west one");
    declare(text, "Ocean_Coast_Extent", ground_vector(domain.size), "m, its sides");
    // A side belongs to the bed if its last sample does: the bed fades into the open sea by itself.
    std::array<bool, 4> fades{true, true, true, true};
    for (std::size_t axis = 0; bed != nullptr && axis < 2; ++axis) {
        const double cell = domain.step(axis);
        fades[2 * axis] = domain.origin[axis] > bed->origin[axis] + cell;
        fades[2 * axis + 1] =
            domain.origin[axis] + domain.size[axis] < bed->origin[axis] + bed->size[axis] - cell;
    }
    declare(text, "Ocean_Coast_Fades",
            array_of(fades, [](bool fade) { return std::string(fade ? "true" : "false"); }),
            "west, east, south, north: no side of the bed");
    return text;
}

std::string povray_declarations(const PovrayTerrain& folder) {
    const TerrainModel& terrain = folder.terrain;
    std::string text =
        "//   Persistence of Vision Ray Tracer Include File\n"
        "//   File: terrain_parameters.inc\n"
        "//   Vers: 3.7\n"
        "//   Desc: The terrain of this folder, by libocean " OCEAN_VERSION
        ". Each export writes it\n"
        "//         again: change the terrain file instead. Metres, degrees.\n";
    declare(text, "Terrain_Data_Version", std::to_string(kPovrayTerrainVersion));
    declare(text, "Terrain_Id_", string_literal(folder.id), "its map says the same");
    declare(text, "Terrain_Format", string_literal(folder.format));
    text += povray_land_map_declarations(folder.domain);
    declare(text, "Terrain_Water_Level", number(terrain.coast_level.value_or(0.0)), "m");
    text += "\n// ---- This land ----\n";
    declare(text, "Terrain_Rms_Height", number(folder.state.rms.resolved), "m");
    declare(text, "Terrain_Mean_Height", number(folder.state.mean), "m");
    declare(text, "Terrain_Rms_Slope", number(folder.state.rms_slope.resolved));
    text += "\n// ---- Parameters, those that are set ----\n";
    for (const TerrainRow& row : terrain_table().rows) {
        for (std::size_t item = 0; item < row.member.items(terrain); ++item) {
            text += povray_parameter_declaration(row, item, value_of(terrain, {&row, item}), "");
        }
    }
    return text;
}

std::string povray_frame_declarations(const Provenance& provenance) {
    const SubjectWords words = subject_words(provenance.kind);
    std::string text;
    declare(text, words.prefix() + "Frame_Number", std::to_string(provenance.frame.value_or(0)));
    declare(text, words.prefix() + "Time", number(provenance.time.value_or(0.0)), "s");
    declare(text, frame_id_name(words), string_literal(provenance.id));
    return text;
}

bool declares_sea(std::string_view text, std::string_view sea_id) {
    std::string line;
    declare(line, frame_id_name(subject_words(kSeaKind)), string_literal(sea_id));
    return text.find(line) != std::string_view::npos;
}

std::string povray_detail_declarations(const Detail& detail) {
    std::string text;
    declare(text, "Ocean_Detail_Bands_", std::to_string(detail.bands().size()),
            "slope tiles of waves too short for the map, the longest first");
    if (detail.bands().empty()) return text;
    const auto column = [&](const char* name, const char* comment, const auto& value) {
        declare(
            text, name,
            array_of(detail.bands(), [&](const DetailBand& band) { return number(value(band)); }),
            comment);
    };
    column("Ocean_Detail_Tiles_", "m", [](const DetailBand& band) { return band.tile; });
    column("Ocean_Detail_Shortest_", "m, waves",
           [](const DetailBand& band) { return band.shortest_wave; });
    column("Ocean_Detail_Longest_", "m", [](const DetailBand& band) { return band.longest_wave; });
    column("Ocean_Detail_Slopes_", "mean square slope of each",
           [](const DetailBand& band) { return variance_of(band); });
    declare(text, "Ocean_Detail_Residual_", number(rounded_variance(detail.residual())),
            "mean square slope of shorter waves");
    return text;
}

}  // namespace ocean::io
