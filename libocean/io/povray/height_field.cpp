// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// POV-Ray's height_field as a 16-bit grey PNG, the only image that it reads without loss. Pixel
// centres are the samples, the first row is the far one; the repeated row and column close the
// seam. The header of a sea's file has no texts, because files of earlier versions have none.
#include "ocean/internal/io/height_field.hpp"

#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ocean/error.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/io/png.hpp"
#include "ocean/internal/io/subject_words.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::io {
namespace {

// POV-Ray's height is code/65536, not /65535.
constexpr double kCodes = 65536.0;
// The heights fill the middle three quarters of the codes. With one quarter the normals of a
// `smooth` height_field, which POV-Ray keeps as short integers of slope in codes per pixel, would
// have 0.28 degrees of noise instead of 0.4, but the heights would be three times as coarse. Scenes
// that need good normals should use a mesh.
constexpr double kRangeShare = 0.75;
constexpr png_uint_32 kMaxPixels = 65535;  // along a side

// height [m] = base + scale * code / 65536.
struct HeightScale {
    double lo, hi, base, scale;
};

HeightScale fit_scale(std::span<const float> heights) {
    for (const float height : heights) {
        if (!std::isfinite(height)) {
            throw Error(ErrorKind::invalid_value, "a height is not finite: nothing was written");
        }
    }
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    HeightScale fit{*low, *high, 0.0, 1.0};
    if (fit.hi > fit.lo) fit.scale = (fit.hi - fit.lo) / kRangeShare;
    fit.base = 0.5 * (fit.lo + fit.hi) - 0.5 * fit.scale;
    return fit;
}

/// Returns the code range for the heights in the image's first plane.
HeightScale fit_scale(const Image& image) {
    const std::size_t samples =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (samples == 0 || image.planes.empty() || image.planes[0].samples.size() != samples) {
        throw Error(ErrorKind::invalid_value, "a height_field needs a plane of heights");
    }
    return fit_scale(image.planes[0].samples);
}

/// Returns the columns and rows of the file: an image that wraps repeats its first row and column.
std::array<int, 2> pixels_of(const Image& image) {
    const int seam = image.wraps() ? 1 : 0;
    return {image.width + seam, image.height + seam};
}

std::vector<std::uint16_t> encode(const Image& image, const HeightScale& fit) {
    const auto heights = image.planes[0].samples;
    const auto width = static_cast<std::size_t>(image.width);
    const auto height = static_cast<std::size_t>(image.height);
    const std::size_t columns = width + (image.wraps() ? 1 : 0);
    const std::size_t rows = height + (image.wraps() ? 1 : 0);
    std::vector<std::uint16_t> codes(columns * rows);
    for (std::size_t j = 0; j < rows; ++j) {
        for (std::size_t i = 0; i < columns; ++i) {
            const double code =
                (heights[j % height * width + i % width] - fit.base) / fit.scale * kCodes;
            codes[j * columns + i] = static_cast<std::uint16_t>(std::lround(code));
        }
    }
    return codes;
}

/// Returns the words of a PNG's header by which a reader turns codes into heights.
std::vector<HeaderString> range_strings(const HeightScale& fit) {
    const std::string base = shortest_text(fit.base), scale = shortest_text(fit.scale);
    return {{"Description", "height [m] = " + base + " + " + scale + " * code / 65536"},
            {"ocean:range", base + "," + shortest_text(fit.base + fit.scale * 65535.0 / kCodes)},
            {"ocean:lo", shortest_text(fit.lo)},
            {"ocean:hi", shortest_text(fit.hi)},
            {"ocean:quantum", shortest_text(fit.scale / kCodes)}};
}

const Domain& domain_of(const Image& image) {
    if (image.domain) return *image.domain;
    throw Error(ErrorKind::invalid_value, "a height_field needs a place and a size");
}

}  // namespace

void write_height_field(const Image& image, const std::string& path) {
    const HeightScale fit = fit_scale(image);
    const std::vector<std::uint16_t> codes = encode(image, fit);
    const auto [columns, rows] = pixels_of(image);
    if (image.provenance.kind == kSeaKind) return write_grey_png(path, columns, rows, codes);
    const std::string png =
        with_png_strings(grey_png(columns, rows, codes), image.header_strings());
    write_file_atomically(path, with_png_keywords(png, range_strings(fit)));
}

// The lines are "key = value": readable text and valid TOML.
std::string height_field_description(const Image& image) {
    const HeightScale fit = fit_scale(image);
    const auto number = [](double value) { return shortest_text(value); };
    const Domain& domain = domain_of(image);
    std::string text = "# height = base + scale * code / 65536, in metres\n";
    text += "lo = " + number(fit.lo) + "\nhi = " + number(fit.hi) + "\nunit = \"m\"\n";
    text += "base = " + number(fit.base) + "\nscale = " + number(fit.scale) + "\n";
    text += "quantum = " + number(fit.scale / kCodes) + "  # a height is right to half of it\n";
    const auto [columns, rows] = pixels_of(image);
    const char* const seam = image.wraps() ? ", the first repeated as the last\n" : "\n";
    if (columns == rows) {
        text += "samples = " + std::to_string(columns) + "  # along each side" + seam;
    } else {
        text += "samples = [" + std::to_string(columns) + ", " + std::to_string(rows) +
                "]  # east, north" + seam;
    }
    if (domain.is_tile()) {
        text += "period = " + number(domain.size[0]) + "\n";
    } else {
        text += "origin = [" + number(domain.origin[0]) + ", " + number(domain.origin[1]) + "]\n";
        text += "size = [" + number(domain.size[0]) + ", " + number(domain.size[1]) + "]\n";
    }
    if (image.provenance.frame) text += "frame = " + std::to_string(*image.provenance.frame) + "\n";
    if (image.provenance.time) text += "time = " + number(*image.provenance.time) + "\n";
    text += "# POV-Ray: height_field { png \"...\" smooth scale <" + number(domain.size[0]) + ", " +
            number(fit.scale) + ", " + number(domain.size[1]) + "> translate ";
    if (domain.is_tile()) return text + number(fit.base) + "*y }\n";
    return text + "<" + number(domain.origin[0]) + ", " + number(fit.base) + ", " +
           number(domain.origin[1]) + "> }\n";
}

std::string height_field_declarations(const Image& image) {
    const HeightScale fit = fit_scale(image);
    const std::string prefix = subject_words(image.provenance.kind).prefix();
    const std::string base = prefix + "Base", scale = prefix + "Scale";
    return "// height = " + base + " + " + scale + " * code / 65536, in metres\n#declare " + base +
           " = " + shortest_text(fit.base) + ";\n#declare " + scale + " = " +
           shortest_text(fit.scale) + ";\n";
}

std::uint64_t max_height_field_bytes(const Domain& domain) {
    constexpr std::uint64_t kHead = 4096, kPerRow = 16;
    const auto columns = static_cast<std::uint64_t>(domain.samples[0]) + 1;
    const auto rows = static_cast<std::uint64_t>(domain.samples[1]) + 1;
    return rows * (2 * columns + kPerRow) + kHead;
}

void read_height_field(const std::string& path, const ByteSink& sink) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    const auto refuse = [&](const char* reason) {
        png_image_free(&image);
        throw Error(ErrorKind::bad_file, "cannot read '" + path + "': " + reason);
    };
    if (!png_image_begin_read_from_file(&image, path.c_str())) refuse(image.message);
    if (image.format != PNG_FORMAT_LINEAR_Y || image.width > kMaxPixels ||
        image.height > kMaxPixels) {
        refuse("it is not a 16-bit height field");
    }
    std::vector<std::uint16_t> codes(std::size_t{image.width} * image.height);
    if (!png_image_finish_read(&image, nullptr, codes.data(), 0, nullptr)) refuse(image.message);
    sink({reinterpret_cast<const char*>(codes.data()), codes.size() * sizeof(std::uint16_t)});
}

}  // namespace ocean::io
