// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads and writes terrain files through the table of a terrain. A resolved file needs no other
// file: the rings of a measured spectrum stand in [terrain.measured_rings], a base of at most 1 MB
// in [terrain.base_heights].
#include "ocean/terrainfile.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "measured_land.hpp"
#include "ocean/channel.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/terrain_table.hpp"
#include "table_reader.hpp"
#include "table_writer.hpp"
#include "toml_text.hpp"

namespace ocean {
namespace {

constexpr std::string_view kTerrainOpening =
    "# A terrain, for libocean. All units are SI, angles in degrees.\n";
constexpr std::string_view kRingsTable = "measured_rings";
constexpr std::string_view kWavenumber = "wavenumber", kDensity = "density";

std::optional<std::vector<double>> numbers_at(const toml::table& table, std::string_view key) {
    const toml::node* node = table.get(key);
    return node != nullptr ? numbers_of(*node) : std::nullopt;
}

class TerrainReader {
  public:
    TerrainReader(const std::string& name, const std::string& base_dir)
        : name_(name), base_dir_(base_dir), reader_(terrain_table(), name, parts()) {}

    TerrainModel read(std::string_view text) {
        const toml::table root = parse_toml(text, name_);
        TerrainModel terrain = reader_.read(root);
        reader_.file().at_parameter([&] {
            resolve_files(terrain, base_dir_);
            require_hash(terrain);
        });
        try {
            validate(terrain);
        } catch (const Error& error) {
            throw reader_.file().in_front(error);
        }
        return terrain;
    }

  private:
    OwnParts<TerrainModel> parts() {
        return {.read_key =
                    [this](TerrainModel& terrain, std::string_view section, std::size_t,
                           const TomlEntry& entry) {
                        return read_rings_table(terrain, section, entry) ||
                               read_base_table(terrain, section, entry);
                    },
                .begin_section = switch_on};
    }

    /// Gives the first key of a section of erosion or shore a typical value, which the section's
    /// own keys may replace: the section's presence switches it on.
    static void switch_on(TerrainModel& terrain, std::string_view section) {
        if (section == "terrain.gullies") terrain.gullies.depth = GullySettings{}.depth;
        if (section == "terrain.stream") terrain.stream.slope = StreamSettings{}.slope;
        if (section == "terrain.coast") terrain.coast.beach_slope = ShorelineSettings{}.beach_slope;
    }

    bool read_base_table(TerrainModel& terrain, std::string_view section, const TomlEntry& entry) {
        const toml::table* table = entry.node->as_table();
        if (section != kTerrainKind || entry.key != kBaseTable || table == nullptr) return false;
        BaseHeights base =
            reader_.file().at_line(entry.line, [&] { return ocean::read_base_table(*table); });
        terrain.base_model = std::move(base.model);
        base_hash_ = std::move(base.hash);
        return true;
    }

    /// Throws if the base's file does not match the text's hash.
    void require_hash(TerrainModel& terrain) const {
        if (base_hash_.empty()) return;
        if (terrain.base_model == nullptr) {
            throw Error(ErrorKind::invalid_value, {.what = "has a hash, but no file",
                                                   .parameter = "terrain.base",
                                                   .value = quoted_text(terrain.base),
                                                   .allowed = "the path of its elevation model"});
        }
        auto stated = base_with_hash(terrain.base_model, base_hash_);
        if (stated != nullptr) {
            terrain.base_model = std::move(stated);
            return;
        }
        throw Error(ErrorKind::invalid_value,
                    {.what = "is another elevation model: its hash is " + terrain.base_model->hash,
                     .parameter = "terrain.base",
                     .value = quoted_text(terrain.base),
                     .allowed = "the model with the hash " + base_hash_});
    }

    bool read_rings_table(TerrainModel& terrain, std::string_view section,
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
        reader_.file().at_line(
            entry.line, [&] { validate_rings(rings, "terrain." + std::string(kRingsTable)); });
        terrain.rings = std::make_shared<const MeasuredRings>(std::move(rings));
        return true;
    }

    const std::string& name_;
    const std::string& base_dir_;
    std::string base_hash_;  // hash in [terrain.base_heights]
    TableReader<TerrainModel> reader_;
};

std::string rings_text(const TerrainModel& terrain) {
    if (terrain.rings == nullptr) return "";
    constexpr std::size_t kPerLine = 6;
    return "\n[terrain." + std::string(kRingsTable) + "]\n" + std::string(kWavenumber) + " = " +
           toml_lines(terrain.rings->wavenumber, kPerLine) + "\n" + std::string(kDensity) + " = " +
           toml_lines(terrain.rings->density, kPerLine) + "\n";
}

}  // namespace

namespace {

/// Calls read(path) with the path of a file that a parameter names, relative to base_dir.
template <typename Read>
void read_named(const std::string& base_dir, const char* parameter, const std::string& file,
                const Read& read) {
    try {
        read(text::to_utf8(utf8_path(base_dir) / utf8_path(file)));
    } catch (const Error& error) {
        throw text::error_of_text(error, parameter, file);
    }
}

}  // namespace

void resolve_files(TerrainModel& terrain, const std::string& base_dir) {
    if (!terrain.measured.empty() && terrain.rings == nullptr) {
        read_named(base_dir, "terrain.measured", terrain.measured, [&](const std::string& path) {
            terrain.rings = std::make_shared<const MeasuredRings>(read_measured_rings(path));
        });
    }
    if (!terrain.base.empty() && terrain.base_model == nullptr) {
        read_named(base_dir, "terrain.base", terrain.base,
                   [&](const std::string& path) { terrain.base_model = read_base(path); });
    }
}

std::vector<std::string> named_files(const TerrainModel& terrain) {
    std::vector<std::string> files;
    for (const std::string& file : {terrain.measured, terrain.base}) {
        if (!file.empty()) files.push_back(file);
    }
    return files;
}

TerrainModel parse_terrain(std::string_view toml, const std::string& name,
                           const std::string& base_dir) {
    return TerrainReader(name, base_dir).read(toml);
}

TerrainModel read_terrain(const std::string& path) {
    const std::string content = text::read_file(path, kMaxSeaFileBytes);
    return parse_terrain(content, path, text::to_utf8(utf8_path(path).parent_path()));
}

namespace {

/// Returns true if a key of a section differs from its neutral value. The text then has the
/// section's header, which a reader takes as switched on unless the switch says otherwise.
bool has_other_keys(const TerrainModel& terrain, const TerrainRow& first) {
    return std::ranges::any_of(terrain_table().rows, [&](const TerrainRow& row) {
        return row.section == first.section && &row != &first &&
               !row.is_left_out(row.member.get(terrain, 0));
    });
}

}  // namespace

std::string write_terrain(const TerrainModel& terrain) {
    validate(terrain);
    const auto line = [&](const RefOf<TerrainModel>& ref) {
        const std::string own = parameter_line(terrain, ref);
        const bool must_say_off =
            own.empty() && switch_of(*ref.info) == ref.info && has_other_keys(terrain, *ref.info);
        return must_say_off ? std::string(ref.info->key) + " = 0.0\n" : own;
    };
    const auto rings = [&](std::string_view section, std::size_t) {
        if (section != kTerrainKind) return std::string();
        return rings_text(terrain) +
               (terrain.base_model != nullptr ? base_text(*terrain.base_model) : "");
    };
    return std::string(kTerrainOpening) +
           table_text<TerrainModel>(terrain_table(), terrain, line, rings);
}

}  // namespace ocean
