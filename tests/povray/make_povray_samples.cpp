// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes what test_baked_files.py renders: make_povray_samples FOLDER. Six sine waves of known
// height, flat and choppy, as a height_field and as patch meshes. For test_foam.py foam_lace.csv:
// calls of functions of ocean.inc and what the formulas of shaders/wave/foam_lace.glsl say of them;
// for test_detail.py slope_tiles.csv, the same of slope_tiles.glsl and copies.glsl.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <string>

#include "ocean/internal/grid.hpp"
#include "ocean/internal/io/height_field.hpp"
#include "ocean/internal/io/mesh2.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/io/product_image.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/io/mesh.hpp"
#include "wave/wave.hpp"

using namespace ocean;

namespace {

constexpr int kSamples = 128;
constexpr double kPeriod = 100.0;

// Waves per period in x and y, amplitude in metres, phase. test_baked_files.py has the same table.
struct Wave {
    int n, m;
    double amplitude, phase;
};
constexpr std::array<Wave, 6> kWaves{{{1, 2, 1.2, 0.3},
                                      {3, -1, 0.8, 1.1},
                                      {-2, 5, 0.5, 2.2},
                                      {6, 4, 0.25, 4.0},
                                      {9, -7, 0.1, 5.0},
                                      {14, 3, 0.05, 0.7}}};

// Gerstner's displacement: D = -C k/|k| a cos(phase), which sharpens the crests of a sin(phase).
void add_wave(Surface& surface, const Wave& wave, double choppiness) {
    const double kx = kTwoPi * wave.n / kPeriod, ky = kTwoPi * wave.m / kPeriod;
    const double k = std::hypot(kx, ky);
    for (int j = 0; j < kSamples; ++j) {
        for (int i = 0; i < kSamples; ++i) {
            const auto at = static_cast<std::size_t>(j * kSamples + i);
            const double phase = (kx * i + ky * j) * kPeriod / kSamples + wave.phase;
            const double offset = choppiness * wave.amplitude * std::cos(phase) / k;
            const double slope = wave.amplitude * std::cos(phase);
            surface.channel(Channel::height)[at] +=
                static_cast<float>(wave.amplitude * std::sin(phase));
            surface.channel(Channel::dx)[at] += static_cast<float>(offset * kx);
            surface.channel(Channel::dy)[at] += static_cast<float>(offset * ky);
            surface.channel(Channel::nx)[at] -= static_cast<float>(slope * kx);
            surface.channel(Channel::ny)[at] -= static_cast<float>(slope * ky);
        }
    }
}

Surface make_sample(double choppiness) {
    using enum Channel;
    Surface surface(Lattice{kSamples, kPeriod}, 3.5, {dx, dy, height, nx, ny, nz});
    for (int c = 0; c < kChannelCount; ++c) {
        std::ranges::fill(surface.channel(static_cast<Channel>(c)), 0.0f);
    }
    for (const Wave& wave : kWaves) add_wave(surface, wave, choppiness);
    for (std::size_t at = 0; at < surface.channel(nz).size(); ++at) {
        const double x = surface.channel(nx)[at], y = surface.channel(ny)[at];
        const double length = std::sqrt(x * x + y * y + 1.0);
        surface.channel(nx)[at] = static_cast<float>(x / length);
        surface.channel(ny)[at] = static_cast<float>(y / length);
        surface.channel(nz)[at] = static_cast<float>(1.0 / length);
    }
    return surface;
}

using Formula = double (*)(double, double, double);

void add_calls(std::string& lines, const char* name, Formula formula,
               std::initializer_list<double> thirds) {
    constexpr std::array kValues = {0.0,   0.004, 0.02, 0.049, 0.1, 0.3,
                                    0.351, 0.7,   0.96, 0.999, 1.0};
    for (const double a : kValues) {
        for (const double b : kValues) {
            for (const double c : thirds) {
                lines +=
                    format_text("%s,%.17g,%.17g,%.17g,%.17g\n", name, a, b, c, formula(a, b, c));
            }
        }
    }
}

std::string foam_lace_calls() {
    namespace wave = wave::double_precision;
    std::string lines;
    add_calls(lines, "Ocean_Add_Uniform_", wave::add_uniform, {0.001, 0.3, 1.0});
    add_calls(lines, "Ocean_Unite_Uniform_", wave::unite_uniform, {0.0, 0.08, 1.0});
    add_calls(lines, "Ocean_Foam_Mask_", wave::foam_mask, {0.001, 0.1, 1.0});
    add_calls(lines, "Ocean_Foam_Thickness_", wave::foam_thickness, {0.35, 1.0});
    const auto mean_thickness = [](double cover, double, double span) {
        return wave::foam_mean_thickness(cover, span);
    };
    add_calls(lines, "Ocean_Foam_Mean_Thickness_", mean_thickness, {0.35, 1.0});
    const auto faded = [](double mask, double cover, double footprint) {
        return wave::foam_faded(mask, cover, footprint, 0.86);
    };
    add_calls(lines, "Ocean_Foam_Faded_", faded, {0.0, 0.35, 1.0, 2.4, 3.0});
    return lines;
}

/// copy_corner takes a place in a square, as a place on the grid and its triangle do in ocean.inc.
std::string slope_tile_calls() {
    namespace wave = wave::double_precision;
    std::string lines;
    for (const double x : {0.05, 0.3, 0.61, 0.97}) {
        for (const double y : {0.02, 0.44, 0.72, 0.93}) {
            for (const double square : {0.0, -7.0, 1234.0}) {
                for (int corner = 0; corner < 3; ++corner) {
                    lines += format_text("Ocean_Weight_,%.17g,%.17g,%d,%d,%.17g\n", square + x,
                                         2.0 * square + y, x + y > 1.0 ? 1 : 0, corner,
                                         wave::copy_corner(x, y, corner).weight);
                }
            }
        }
    }
    for (const double shortest : {0.012, 0.1, 1.3}) {
        for (const double longest : {2.0 * shortest, 6.0 * shortest}) {
            for (double footprint = 0.0; footprint < 10.0; footprint = 1.3 * footprint + 0.003) {
                const double fade = wave::slope_tile_fade(footprint, shortest, longest);
                lines += format_text("Ocean_Tile_Fade_,%.17g,%.17g,%.17g,%.17g\n", footprint,
                                     shortest, longest, fade);
                lines += format_text("Ocean_Tile_Left_,%.17g,%.17g,%.17g\n", fade, shortest,
                                     wave::slope_tile_left(fade, shortest));
            }
        }
    }
    return lines;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const std::string folder = std::string(argv[1]) + "/";
    const Surface flat = make_sample(0.0), choppy = make_sample(1.0);
    const io::Provenance label{.kind = "sea",
                               .text = "libocean = 1\n",
                               .frame = 4,
                               .time = 3.5,
                               .domain = Domain::tile(kPeriod)};
    const Product* const heights[] = {&find_product("height")};
    const io::Image image = io::product_image(heights, {}, label, flat);
    io::write_height_field(image, folder + "height.png");
    io::write_file_atomically(folder + "height.png.txt", io::height_field_description(image));
    io::write_file_atomically(folder + "height.png.inc", io::height_field_declarations(image));
    io::write_mesh2(io::make_patch_mesh(flat), label, folder + "flat.inc");
    io::write_mesh2(io::make_patch_mesh(choppy), label, folder + "choppy.inc");
    io::write_file_atomically(folder + "foam_lace.csv", foam_lace_calls());
    io::write_file_atomically(folder + "slope_tiles.csv", slope_tile_calls());
    return 0;
}
