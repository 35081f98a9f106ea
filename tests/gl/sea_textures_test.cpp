// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea as textures: against the maps of the CPU, from mipmap to mipmap, foam tick by tick.
#include <epoxy/gl.h>

#include "ocean/internal/gl/context.hpp"
#include "ocean/internal/gl/sea_textures.hpp"
#include "ocean/ocean.hpp"
#include "unit/test_seas.hpp"
#include "wave/wave.hpp"

namespace ocean {
namespace {

using test::foaming_sea;
using test::relative_error;
using test::wind_sea;

struct Image {
    int size = 0;
    std::vector<float> texels;

    std::vector<float> component(std::size_t c, std::size_t components = 4) const {
        std::vector<float> values;
        for (std::size_t i = c; i < texels.size(); i += components) values.push_back(texels[i]);
        return values;
    }
};

Image read(unsigned texture, int level, GLenum format = GL_RGBA) {
    Image image;
    glBindTexture(GL_TEXTURE_2D, texture);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, level, GL_TEXTURE_WIDTH, &image.size);
    const auto texels = static_cast<std::size_t>(image.size) * static_cast<std::size_t>(image.size);
    image.texels.assign(texels * (format == GL_RGBA ? 4 : 1), std::nanf("1"));
    glGetTexImage(GL_TEXTURE_2D, level, format, GL_FLOAT, image.texels.data());
    return image;
}

class SeaTextures : public testing::Test {
  protected:
    gl::HeadlessContext context_{{.debug = true}};
    gl::HeadlessContext::Current current_{context_};

    void TearDown() override {
        for (const std::string& message : context_.messages()) ADD_FAILURE() << message;
    }
};

TEST_F(SeaTextures, CascadesAreThoseOfTheCpu) {
    Parameters parameters = wind_sea(64, 400.0);
    parameters.grid.cascades = 3;
    Ocean sea(parameters);
    gl::SeaTextures textures({.cascade_resolution = 128});
    textures.show(sea.open_sea(), 7.5);
    ASSERT_EQ(textures.cascades().size(), 3u);
    for (std::size_t c = 0; c < 3; ++c) {
        const gl::CascadeTextures& cascade = textures.cascades()[c];
        EXPECT_EQ(cascade.period, sea.modes().cascades[c].lattice.period);
        const std::pair<unsigned, std::vector<Linear>> textures_of[] = {
            {cascade.displacement,
             {Linear::displacement_x, Linear::displacement_y, Linear::height, Linear::gradient_xy}},
            {cascade.gradients,
             {Linear::slope_x, Linear::slope_y, Linear::gradient_xx, Linear::gradient_yy}}};
        for (const auto& [texture, fields] : textures_of) {
            const Image image = read(texture, 0);
            ASSERT_EQ(image.size, 128);
            for (std::size_t i = 0; i < 4; ++i) {
                std::vector<float> expected(128 * 128);
                const MapOutput output{expected.data(), 1, {{{fields[i], 1.0f}}}};
                sea.evaluate_cascade_into(c, 7.5, {&output, 1}, 128);
                EXPECT_LE(relative_error(image.component(i), expected), 1e-6) << c << " " << i;
            }
        }
    }
}

TEST_F(SeaTextures, CascadesAreLayersOfOneArray) {
    Parameters parameters = wind_sea(64, 400.0);
    parameters.grid.cascades = 3;
    Ocean sea(parameters);
    gl::SeaTextures textures;
    textures.show(sea.open_sea(), 7.5);
    const gl::CascadeArrays arrays = textures.arrays();
    ASSERT_EQ(arrays.resolution, 64);
    constexpr int kLevel = 2;
    constexpr std::size_t kTexels = 4 * 16 * 16;
    const auto expect_layers = [&](unsigned array, unsigned gl::CascadeTextures::*of) {
        std::vector<float> all(3 * kTexels);
        glBindTexture(GL_TEXTURE_2D_ARRAY, array);
        glGetTexImage(GL_TEXTURE_2D_ARRAY, kLevel, GL_RGBA, GL_FLOAT, all.data());
        for (std::size_t c = 0; c < 3; ++c) {
            const auto begin = all.begin() + static_cast<std::ptrdiff_t>(c * kTexels);
            const std::vector<float> layer(begin, begin + kTexels);
            EXPECT_EQ(read(textures.cascades()[c].*of, kLevel).texels, layer) << c;
        }
    };
    expect_layers(arrays.displacement, &gl::CascadeTextures::displacement);
    expect_layers(arrays.gradients, &gl::CascadeTextures::gradients);
    expect_layers(arrays.moments, &gl::CascadeTextures::moments);
}

TEST_F(SeaTextures, OfAnotherSeaAreThatSeas) {
    gl::SeaTextures textures;
    for (const double wind : {6.0, 14.0}) {
        Parameters parameters = wind_sea(64, 100.0);
        parameters.waves.front().wind_speed = wind;
        Ocean sea(parameters);
        textures.show(sea.open_sea(), 3.0);
        const Surface map = sea.evaluate(3.0, {Channel::height});
        const Image image = read(textures.cascades()[0].displacement, 0);
        EXPECT_LE(relative_error(image.component(2), map.channel(Channel::height)), 1e-6) << wind;
    }
}

TEST_F(SeaTextures, MipmapsAreMeansAndMomentsGiveTheVarianceInATexel) {
    Ocean sea(wind_sea(64, 100.0));
    gl::SeaTextures textures;
    textures.show(sea.open_sea(), 3.0);
    const gl::CascadeTextures& cascade = textures.cascades()[0];
    const Image fine = read(cascade.gradients, 0);
    const Image coarse = read(cascade.gradients, 3);
    const Image moments = read(cascade.moments, 3);
    ASSERT_EQ(coarse.size, 8);
    for (const std::size_t block : {0, 5}) {
        std::array<double, 2> mean{};
        std::array<double, 4> square{};
        for (std::size_t j = 0; j < 8; ++j) {
            for (std::size_t i = 0; i < 8; ++i) {
                const float* const texel = &fine.texels[4 * ((8 * block + j) * 64 + 8 * block + i)];
                const double x = texel[0];
                const double y = texel[1];
                const double squeezed = static_cast<double>(texel[2]) + texel[3];
                mean[0] += x / 64.0;
                mean[1] += y / 64.0;
                square[0] += x * x / 64.0;
                square[1] += y * y / 64.0;
                square[2] += x * y / 64.0;
                square[3] += squeezed * squeezed / 64.0;
            }
        }
        const std::size_t at = 4 * (8 * block + block);
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_NEAR(coarse.texels[at + i], mean[i], 1e-6);
            EXPECT_GT(square[i] - mean[i] * mean[i], 1e-4);
        }
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_NEAR(moments.texels[at + i], square[i], 1e-6) << i;
        }
        // No two of them are alike.
        EXPECT_GT(std::abs(square[3] - square[0] - square[1]), 1e-4);
        EXPECT_GT(std::abs(square[2]), 1e-5);
    }
    const Image last = read(cascade.moments, 6);
    ASSERT_EQ(last.size, 1);
    const Surface map = sea.evaluate(3.0, {Channel::slope_x, Channel::slope_y});
    EXPECT_NEAR(last.texels[0], test::variance(map.channel(Channel::slope_x)), 1e-5);
    EXPECT_NEAR(last.texels[1], test::variance(map.channel(Channel::slope_y)), 1e-5);
}

/// Expects the foam that a renderer shows at the texels of the foam lattice to be that of the map.
void expect_foam(const gl::FoamTexture& foam, Ocean& cpu, double time) {
    const Surface expected = cpu.evaluate(time, {Channel::foam, Channel::jacobian});
    const Image left = read(foam.texture, 0, GL_RED);
    ASSERT_EQ(left.size, foam.lattice.resolution);
    ASSERT_EQ(expected.resolution(), foam.map_resolution);
    const auto n = static_cast<std::size_t>(left.size);
    const std::size_t stride = static_cast<std::size_t>(expected.resolution()) / n;
    for (std::size_t i = 0; i < n * n; ++i) {
        const std::size_t label = i / n * stride * stride * n + i % n * stride;
        const float whitecap = std::clamp(
            (foam.threshold - expected.channel(Channel::jacobian)[label]) / foam.width, 0.0f, 1.0f);
        const float shown = wave::single_precision::foam_with_whitecap(
            whitecap, foam.fade * left.texels[i], foam.alone);
        ASSERT_NEAR(shown, expected.channel(Channel::foam)[label], 2.0 / 512.0);
    }
}

TEST_F(SeaTextures, FoamIsThatOfTheCpuOnTheGpu) {
    Ocean cpu(foaming_sea());
    Ocean sea(foaming_sea());
    gl::SeaTextures textures({.foam_start = FoamStart::settled});
    for (const double time : {1.0, 1.02, 2.0, 11.0, 11.26}) {
        textures.show(sea.open_sea(), time);
        expect_foam(textures.foam(), cpu, time);
    }
}

TEST_F(SeaTextures, FoamHasThePastOfACoarserLattice) {
    Parameters parameters = foaming_sea();
    parameters.grid.resolution = 64;
    parameters.grid.cascades = 2;
    parameters.surface.foam_resolution = 64;
    Ocean cpu(parameters);
    Ocean sea(parameters);
    gl::SeaTextures textures({.foam_start = FoamStart::settled});
    for (const double time : {1.0, 1.26}) {
        textures.show(sea.open_sea(), time);
        EXPECT_EQ(textures.foam().lattice.resolution, 64);
        EXPECT_EQ(textures.foam().map_resolution, 256);
        expect_foam(textures.foam(), cpu, time);
    }
}

TEST_F(SeaTextures, FoamThatBeganEmptySettles) {
    Ocean cpu(foaming_sea());
    Ocean sea(foaming_sea());
    gl::SeaTextures textures;
    textures.show(sea.open_sea(), 0.0);
    const std::int64_t settling = textures.foam_settling_ticks();
    EXPECT_GT(settling, 100);
    double time = 0.0;
    for (int frame = 0; textures.foam_settling_ticks() > 0; ++frame) {
        ASSERT_LT(frame, 1000);
        textures.show(sea.open_sea(), time += 1.0);
    }
    expect_foam(textures.foam(), cpu, time);
    textures.foam_changed(time);
    textures.show(sea.open_sea(), time);
    expect_foam(textures.foam(), cpu, time);
    textures.foam_changed();
    textures.show(sea.open_sea(), time);
    EXPECT_EQ(textures.foam_settling_ticks(), settling);
}

}  // namespace
}  // namespace ocean
