// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// POV-Ray's height_field as a 16-bit grey PNG, the only image that it reads without loss. Pixel
// centres are the samples, the first row is far; the wrapped last row and column make tiles meet.
#include <png.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "../file/output_file.hpp"
#include "ocean/error.hpp"
#include "ocean/io.hpp"

namespace ocean::io {
namespace {

// POV-Ray's height is code/65536, not /65535.
constexpr double kCodes = 65536.0;
// The heights fill the middle three quarters of the codes. A quarter would make the normals of a
// `smooth` height_field, which POV-Ray keeps as short integers of slope in codes per pixel, a
// little better (0.28 degrees of noise instead of 0.4), and the heights three times worse; who
// needs good normals takes a mesh.
constexpr double kRangeShare = 0.75;

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
    const auto [least, most] = std::minmax_element(heights.begin(), heights.end());
    HeightScale fit{*least, *most, 0.0, 1.0};
    if (fit.hi > fit.lo) fit.scale = (fit.hi - fit.lo) / kRangeShare;
    fit.base = 0.5 * (fit.lo + fit.hi) - 0.5 * fit.scale;
    return fit;
}

std::vector<std::uint16_t> encode(const Surface& surface, const HeightScale& fit) {
    const auto heights = surface.channel(Channel::height);
    const auto n = static_cast<std::size_t>(surface.resolution());
    std::vector<std::uint16_t> codes((n + 1) * (n + 1));
    for (std::size_t row = 0; row <= n; ++row) {
        const std::size_t j = (n - row) % n;
        for (std::size_t i = 0; i <= n; ++i) {
            const double code = (heights[j * n + i % n] - fit.base) / fit.scale * kCodes;
            codes[row * (n + 1) + i] = static_cast<std::uint16_t>(std::lround(code));
        }
    }
    return codes;
}

std::string number(double value) {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

// "key = value" lines: a person can read them, and so can TOML.
std::string describe(const Frame& frame, const HeightScale& fit) {
    const auto samples = std::to_string(frame.surface.resolution() + 1);
    std::string text = "# height = base + scale * code / 65536, in metres\n";
    text += "lo = " + number(fit.lo) + "\nhi = " + number(fit.hi) + "\nunit = \"m\"\n";
    text += "base = " + number(fit.base) + "\nscale = " + number(fit.scale) + "\n";
    text += "quantum = " + number(fit.scale / kCodes) + "  # a height is right to half of it\n";
    text += "samples = " + samples + "  # along each side, the first repeated as the last\n";
    text += "period = " + number(frame.surface.period()) + "\n";
    text += "frame = " + std::to_string(frame.number) + "\ntime = " + number(frame.time) + "\n";
    text += "# POV-Ray: height_field { png \"...\" smooth scale <" +
            number(frame.surface.period()) + ", " + number(fit.scale) + ", " +
            number(frame.surface.period()) + "> translate " + number(fit.base) + "*y }\n";
    return text;
}

std::string declare(const Frame& frame, const HeightScale& fit) {
    return "// height = Ocean_Base + Ocean_Scale * code / 65536, in metres\n"
           "#declare Ocean_Base = " +
           number(fit.base) + ";\n#declare Ocean_Scale = " + number(fit.scale) +
           ";\n#declare Ocean_Frame_Number = " + std::to_string(frame.number) +
           ";\n#declare Ocean_Time = " + number(frame.time) + ";\n";
}

}  // namespace

void write_height_field(const Frame& frame, const std::string& path) {
    if (!frame.surface.has(Channel::height)) {
        throw Error(ErrorKind::invalid_value, "a height_field needs the channel height");
    }
    const HeightScale fit = fit_scale(frame.surface.channel(Channel::height));
    const std::vector<std::uint16_t> codes = encode(frame.surface, fit);

    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = image.height = static_cast<png_uint_32>(frame.surface.resolution() + 1);
    image.format = PNG_FORMAT_LINEAR_Y;
    OutputFile file(path);
    const bool written =
        png_image_write_to_stdio(&image, file.stream(), 0, codes.data(), 0, nullptr);
    // A full disk is told better by the stream itself.
    if (!written && std::ferror(file.stream()) == 0) {
        throw Error(ErrorKind::output, "cannot write '" + path + "': " + image.message);
    }
    file.commit();
    write_file_atomically(path + ".txt", describe(frame, fit));
    write_file_atomically(path + ".inc", declare(frame, fit));
}

void read_height_field(const std::string& path, const ByteSink& sink) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    const auto refuse = [&](const char* reason) {
        png_image_free(&image);
        throw Error(ErrorKind::bad_file, "cannot read '" + path + "': " + reason);
    };
    if (!png_image_begin_read_from_file(&image, path.c_str())) refuse(image.message);
    if (image.format != PNG_FORMAT_LINEAR_Y || image.width != image.height ||
        image.width > kMaxResolution + 1) {
        refuse("it is not a square 16-bit height field");
    }
    std::vector<std::uint16_t> codes(std::size_t{image.width} * image.height);
    if (!png_image_finish_read(&image, nullptr, codes.data(), 0, nullptr)) refuse(image.message);
    sink({reinterpret_cast<const char*>(codes.data()), codes.size() * sizeof(std::uint16_t)});
}

}  // namespace ocean::io
