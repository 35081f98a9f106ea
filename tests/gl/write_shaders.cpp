// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes the text of every shader that the backend may give to a driver, a file each, for
// validators. usage: write_shaders FOLDER
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "frame_plan.hpp"
#include "ground.hpp"
#include "self_check.hpp"
#include "shader_text.hpp"
#include "water_program.hpp"

using namespace ocean;
using namespace ocean::gl;

namespace {

std::vector<Quantity> everything() {
    std::vector<Quantity> all;
    for (const Linear field : kLinears) all.emplace_back(field);
    for (int c = 0; c < kChannelCount; ++c) all.emplace_back(static_cast<Channel>(c));
    return all;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const std::filesystem::path folder(argv[1]);
    std::filesystem::create_directories(folder);
    const auto write = [&](const std::string& name, std::string_view path,
                           const std::string& defines) {
        const std::filesystem::path kind = std::filesystem::path(path).extension();
        std::ofstream file(folder / (name + kind.string()));
        file << program_text(load_shader(path), defines,
                             kind == ".comp" ? GL_COMPUTE_SHADER : GL_VERTEX_SHADER);
        if (!file.flush()) std::exit(1);
    };
    using enum Channel;
    const std::pair<const char*, std::vector<Quantity>> kAsked[] = {
        {"tick", {foam}},
        {"frame", {dx, dy, height, jacobian, nx, ny, nz, whitecap}},
        {"slopes", {slope_x, slope_y, dx_x}},
        {"all", everything()},
    };
    for (const int resolution : {32, 4096}) {
        const std::string n = std::to_string(resolution);
        const std::string size = "#define N " + n + "\n";
        write("butterfly_" + n, "compute/thesis/butterfly.comp", size + "#define STAGES 5\n");
        for (const Linear field : kLinears) {
            write("spectrum_" + std::to_string(static_cast<int>(field)) + "_" + n,
                  "compute/thesis/spectrum.comp",
                  size + "#define COEFFICIENT " + coefficient(field) + "\n");
        }
    }
    for (const char* path : {"sky.vert", "sky.frag", "cover.frag"}) {
        write(std::string("preview_") + path[0], std::string("preview/") + path, "");
    }
    for (const int taps : {0, 2}) {
        for (const char* kind : {".vert", ".frag"}) {
            for (const std::string name : {"ground", "land_water"}) {
                write(name + "_" + std::to_string(taps), "preview/" + name + kind,
                      preview::ground_defines(taps));
            }
        }
        for (const std::size_t cascades : {1, 2, 5, 10}) {
            const std::size_t covers = cascades == 1 || cascades == 5 ? 1 : 2;
            const std::size_t tiles = taps == 0 ? 2 : 0;
            const preview::WaterVariant variant{
                .cascades = {covers == 1 ? cascades : cascades - cascades / 2,
                             covers == 1 ? 0 : cascades / 2},
                .covers = covers,
                .lace = taps == 0,
                .tiles = {tiles, covers == 1 ? 0 : tiles},
                .below = cascades<5, .coast = cascades> 1};
            const std::string end = "_" + std::to_string(cascades) + std::to_string(taps);
            for (const std::string name : {"water", "seed"}) {
                for (const char* kind : {".vert", ".frag"}) {
                    write(name + end, "preview/" + name + kind,
                          preview::water_defines(variant, taps));
                }
            }
        }
    }
    for (const char* parts : {"1", "3", "4"}) {
        write(std::string("coast_waves_") + parts, "compute/coast_waves.comp",
              std::string("#define PARTS ") + parts + "\n");
    }
    write("moments", "compute/moments.comp", "");
    write("stage", "compute/thesis/stage.comp", "");
    write("permutation", "compute/thesis/permutation.comp", "");
    write("self_check", "compute/self_check.comp", self_check_defines());
    for (int resolution = 32; resolution <= 8192; resolution *= 2) {
        // With little shared memory and with much.
        for (const int shared : {32768, 49152}) {
            const PassShape shape = pass_shape(resolution, shared, 1024);
            for (const auto& [name, quantities] : kAsked) {
                const FramePlan plan = make_frame_plan(shape, quantities, false);
                const std::string end = "_" + std::string(name) + "_" + std::to_string(resolution) +
                                        "_" + std::to_string(shared);
                write("rows" + end, "compute/rows.comp", plan.rows_defines());
                write("columns" + end, "compute/columns.comp", plan.columns_defines());
            }
        }
    }
}
