// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Raw floats with header and projection: see elevation.hpp.
#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <vector>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/elevation_rules.hpp"
#include "ocean/internal/io/elevation.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::io {
namespace {

constexpr float kHole = -9999.0f;
constexpr std::string_view kCreator = "creator libocean";

static_assert(std::endian::native == std::endian::little);

/// Returns a number with at most 15 digits, so that a cell of 30 m is not 29.999999999999996.
std::string digits(double value) {
    return significant_text(value, 15);
}

std::string beside(const std::string& path, const char* extension) {
    std::filesystem::path file = utf8_path(path);
    file.replace_extension(extension);
    return text::to_utf8(file);
}

void write_heights(const ElevationModel& model, OutputFile& file) {
    const std::size_t columns = static_cast<std::size_t>(model.domain.samples[0]);
    std::vector<float> row(columns);
    for (int j = model.domain.samples[1] - 1; j >= 0; --j) {  // files begin in the north
        for (std::size_t i = 0; i < columns; ++i) {
            const float height = model.heights[static_cast<std::size_t>(j) * columns + i];
            row[i] = std::isnan(height) ? kHole : height;
        }
        file.write({reinterpret_cast<const char*>(row.data()), 4 * columns});
    }
}

std::string local_text(std::string name) {
    std::ranges::replace(name, '"', '\'');
    return "LOCAL_CS[\"" + name + "\",UNIT[\"metre\",1]]";
}

}  // namespace

std::string elevation_header(const ElevationModel& model) {
    const Domain& domain = model.domain;
    const std::string dx = digits(domain.step(0)), dy = digits(domain.step(1));
    std::string text = "ncols " + std::to_string(domain.samples[0]) + "\nnrows " +
                       std::to_string(domain.samples[1]) + "\nxllcenter " +
                       digits(domain.origin[0]) + "\nyllcenter " + digits(domain.origin[1]) + "\n";
    text += dx == dy ? "cellsize " + dx + "\n" : "xdim " + dx + "\nydim " + dy + "\n";
    return text + "NODATA_value -9999\nbyteorder LSBFIRST\n" + std::string(kCreator) + "\n";
}

std::string elevation_projection(const ElevationModel& model) {
    const std::string name = elevation::crs_name(model.crs);
    if (model.was_degrees) {
        return local_text("metres from " + fixed_text(model.geographic_origin[1], 6) + " N, " +
                          fixed_text(model.geographic_origin[0], 6) + " E" +
                          (name.empty() ? "" : " of " + name));
    }
    if (!model.crs_definition.empty()) return model.crs_definition;
    if (name.empty()) return local_text("metres");
    return elevation::is_geographic(model.crs) == false ? model.crs : local_text(name);
}

void write_elevation(const ElevationModel& model, const std::string& path) {
    if (utf8_path(path).extension() != ".flt") {
        throw Error(ErrorKind::invalid_value, "'" + path + "': an elevation model is NAME.flt");
    }
    OutputFile heights(path);
    write_heights(model, heights);
    OutputFile header(beside(path, ".hdr"));
    header.write(elevation_header(model));
    OutputFile projection(beside(path, ".prj"));
    projection.write(elevation_projection(model) + "\n");
    projection.commit();
    header.commit();
    heights.commit();
}

bool is_written_elevation(const std::string& path) {
    constexpr std::size_t kMaxHeaderBytes = 65536;
    const std::string header = text::first_bytes(beside(path, ".hdr"), kMaxHeaderBytes);
    return header.find("\n" + std::string(kCreator) + "\n") != std::string::npos;
}

}  // namespace ocean::io
