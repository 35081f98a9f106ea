// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads and writes terrain files through the table of a terrain. A resolved file needs no other
// one: the rings of a measured spectrum stand in [terrain.measured_rings].
#include "ocean/terrainfile.hpp"

#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/subject_kind.hpp"
#include "ocean/terrain_table.hpp"
#include "rings_file.hpp"
#include "table_reader.hpp"
#include "table_writer.hpp"
#include "toml_text.hpp"

namespace ocean {
namespace {

constexpr std::string_view kOpening =
    "# A terrain, for libocean. All units are SI, angles in degrees.\n";
constexpr std::string_view kRingsTable = "measured_rings";
constexpr std::string_view kWavenumber = "wavenumber", kDensity = "density";

std::optional<std::vector<double>> numbers_at(const toml::table& table, std::string_view key) {
    const toml::node* node = table.get(key);
    const toml::array* list = node != nullptr ? node->as_array() : nullptr;
    if (list == nullptr) return std::nullopt;
    std::vector<double> numbers;
    for (const toml::node& item : *list) {
        const auto number = number_of(item);
        if (!number) return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

class TerrainReader {
  public:
    TerrainReader(const std::string& name, const std::string& base_dir)
        : name_(name), base_dir_(base_dir), reader_(terrain_table(), name, parts()) {}

    Terrain read(std::string_view text) {
        const toml::table root = parse_toml(text, name_);
        Terrain terrain = reader_.read(root);
        try {
            resolve_files(terrain, base_dir_);
        } catch (const Error& error) {
            const ErrorFields& fields = error.fields();
            throw reader_.file().in_front(error, reader_.file().line_of_parameter(fields.parameter),
                                          fields.parameter + " = " + fields.value + ": ");
        }
        try {
            validate(terrain);
        } catch (const Error& error) {
            throw reader_.file().in_front(error);
        }
        return terrain;
    }

  private:
    OwnParts<Terrain> parts() {
        return {.read_key = [this](Terrain& terrain, std::string_view section, std::size_t,
                                   const TomlEntry& entry) {
            return read_rings_table(terrain, section, entry);
        }};
    }

    bool read_rings_table(Terrain& terrain, std::string_view section,
                          const TomlEntry& entry) const {
        const toml::table* table = entry.node->as_table();
        if (section != kTerrainKind || entry.key != kRingsTable || table == nullptr) return false;
        auto wavenumber = numbers_at(*table, kWavenumber), density = numbers_at(*table, kDensity);
        if (!wavenumber || !density || table->size() != 2) {
            throw reader_.file().fail(entry.line,
                                      {.what = "is not a measured spectrum",
                                       .parameter = "terrain." + std::string(kRingsTable),
                                       .value = shown(*entry.node),
                                       .allowed = "wavenumber and density, two lists of numbers"});
        }
        MeasuredRings rings{*std::move(wavenumber), *std::move(density)};
        try {
            validate_rings(rings, "terrain." + std::string(kRingsTable));
        } catch (const Error& error) {
            throw reader_.file().in_front(error, entry.line);
        }
        terrain.rings = std::make_shared<const MeasuredRings>(std::move(rings));
        return true;
    }

    const std::string& name_;
    const std::string& base_dir_;
    TableReader<Terrain> reader_;
};

std::string rings_text(const Terrain& terrain) {
    if (terrain.rings == nullptr) return "";
    constexpr std::size_t kPerLine = 6;
    return "\n[terrain." + std::string(kRingsTable) + "]\n" + std::string(kWavenumber) + " = " +
           toml_lines(terrain.rings->wavenumber, kPerLine) + "\n" + std::string(kDensity) + " = " +
           toml_lines(terrain.rings->density, kPerLine) + "\n";
}

}  // namespace

void resolve_files(Terrain& terrain, const std::string& base_dir) {
    if (terrain.measured.empty() || terrain.rings != nullptr) return;
    try {
        const std::string path = text::to_utf8(utf8_path(base_dir) / utf8_path(terrain.measured));
        terrain.rings = std::make_shared<const MeasuredRings>(read_measured_rings(path));
    } catch (const Error& error) {
        throw text::error_of_text(error, "terrain.measured", terrain.measured);
    }
}

std::vector<std::string> named_files(const Terrain& terrain) {
    if (terrain.measured.empty()) return {};
    return {terrain.measured};
}

Terrain parse_terrain(std::string_view toml, const std::string& name, const std::string& base_dir) {
    return TerrainReader(name, base_dir).read(toml);
}

Terrain read_terrain(const std::string& path) {
    const std::string content = text::read_file(path, kMaxSeaFileBytes);
    return parse_terrain(content, path, text::to_utf8(utf8_path(path).parent_path()));
}

std::string write_terrain(const Terrain& terrain) {
    validate(terrain);
    const auto line = [&](const RefOf<Terrain>& ref) { return parameter_line(terrain, ref); };
    const auto rings = [&](std::string_view section, std::size_t) {
        return section == kTerrainKind ? rings_text(terrain) : std::string();
    };
    return std::string(kOpening) + table_text<Terrain>(terrain_table(), terrain, line, rings);
}

}  // namespace ocean
