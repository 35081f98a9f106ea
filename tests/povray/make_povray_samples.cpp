// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes what test_baked_files.py renders: make_povray_samples FOLDER. Six sine waves of known
// height, flat and choppy, as a height_field and as patch meshes.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "ocean/io/height_field.hpp"
#include "ocean/io/mesh.hpp"
#include "ocean/io/mesh2.hpp"
#include "ocean/io/output_file.hpp"
#include "ocean/io/product_image.hpp"

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

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const std::string folder = std::string(argv[1]) + "/";
    const Surface flat = make_sample(0.0), choppy = make_sample(1.0);
    const io::FrameLabel label{"libocean = 1\n", 4, 3.5, kPeriod};
    const Product* const heights[] = {&find_product("height")};
    const io::Image image = io::product_image(heights, {}, label, flat);
    io::write_height_field(image, folder + "height.png");
    io::write_file_atomically(folder + "height.png.txt", io::height_field_description(image));
    io::write_file_atomically(folder + "height.png.inc", io::height_field_declarations(image));
    io::write_mesh2(io::make_patch_mesh(flat), label, folder + "flat.inc");
    io::write_mesh2(io::make_patch_mesh(choppy), label, folder + "choppy.inc");
    return 0;
}
