// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes into a folder, make_povray_samples FOLDER, what formulas give: for test_foam.py
// foam_lace.csv, calls of functions of ocean.inc and what the formulas of
// shaders/wave/foam_lace.glsl say of them; for test_detail.py slope_tiles.csv, the same of
// slope_tiles.glsl and copies.glsl.
#include <array>
#include <initializer_list>
#include <string>

#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/text.hpp"
#include "wave/wave.hpp"

using namespace ocean;

namespace {

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
    add_calls(lines, "Ocean_Foam_Faded_", faded, {0.0, 0.06, 0.35, 1.0, 1.4});
    add_calls(lines, "Ocean_Foam_Pixel_Edge_", wave::foam_pixel_edge, {0.86});
    const auto thickness = [](double thickness, double mean, double footprint) {
        return wave::foam_pixel_thickness(thickness, mean, footprint, 0.86);
    };
    add_calls(lines, "Ocean_Foam_Pixel_Thickness_", thickness, {0.0, 0.2, 1.0});
    add_calls(lines, "Ocean_Foam_In_Streaks_", wave::foam_in_streaks, {0.0, 0.3, 1.0});
    add_calls(lines, "Ocean_Foam_Bubbles_", wave::foam_bubbles, {0.0, 0.3, 1.0});
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
    io::write_file_atomically(folder + "foam_lace.csv", foam_lace_calls());
    io::write_file_atomically(folder + "slope_tiles.csv", slope_tile_calls());
    return 0;
}
