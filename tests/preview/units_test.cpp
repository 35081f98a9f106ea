// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: five cascades with foam and near detail take 16 texture units or fewer, and so do two
// such seas in a cross-fade; a part that does not fit is left out with the numbers, never in
// silence.
#include "ocean/error.hpp"
#include "preview_fixture.hpp"

namespace ocean::preview {
namespace {

constexpr int kUnits = 16;  // the fewest that OpenGL 4.1 allows

/// Returns the samplers of the current program that its fragment shader reads.
int fragment_samplers() {
    GLint program = 0, uniforms = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &program);
    glGetProgramiv(static_cast<GLuint>(program), GL_ACTIVE_UNIFORMS, &uniforms);
    int samplers = 0;
    for (GLint u = 0; u < uniforms; ++u) {
        char name[64] = {};
        GLint size = 0;
        GLenum type = GL_NONE;
        glGetActiveUniform(static_cast<GLuint>(program), static_cast<GLuint>(u), sizeof name,
                           nullptr, &size, &type, name);
        const bool is_sampler = type == GL_SAMPLER_2D || type == GL_SAMPLER_2D_ARRAY;
        // The vertex shader alone reads the shape, by units of its own.
        if (is_sampler && !std::string_view(name).starts_with("shape_maps")) samplers += size;
    }
    return samplers;
}

class UnitsTest : public PreviewTest {
  protected:
    static Parameters foaming(double wind) {
        Parameters parameters = test::wind_sea(32, 400.0);
        parameters.waves.front().wind_speed = wind;
        parameters.grid.cascades = 5;
        return parameters;
    }
    std::vector<std::uint8_t> drawn(Renderer& renderer, const DrawnSea& sea) {
        return picture(renderer, sea, {.eye = {0.0, 0.0, 12.0}, .pitch = -25.0}, {}, 48, 32);
    }

    Ocean sea_{foaming(15.0), {.foam_start = FoamStart::settled}};
    SeaMaps maps_{{.compute = false, .foam_resolution = 64, .detail = true}};
    DrawnSea shown_ = maps_.show(sea_, 5.0);
};

TEST_F(UnitsTest, FiveCascadesWithFoamAndNearDetailFit) {
    ASSERT_EQ(shown_.cascades.size(), 5u);
    ASSERT_TRUE(shown_.has_foam);
    // The finest maps of five cascades leave no wave to the tiles: those of another sea stand in.
    Ocean coarse(test::wind_sea(32, 400.0), {.foam_start = FoamStart::empty});
    SeaMaps coarse_maps({.compute = false, .foam_resolution = 64, .detail = true});
    DrawnSea other = coarse_maps.show(coarse, 5.0);
    ASSERT_FALSE(other.tiles.empty());
    shown_.tiles = other.tiles;
    Renderer renderer({.cells = 16, .max_texture_units = kUnits});
    drawn(renderer, shown_);
    EXPECT_EQ(text(renderer.left_out()), "");
    EXPECT_EQ(renderer.left_out().required_units, 10);
    EXPECT_EQ(fragment_samplers(), 10);

    // Two seas: their arrays are not the same.
    Ocean second(foaming(16.0), {.foam_start = FoamStart::settled});
    SeaMaps second_maps({.compute = false, .foam_resolution = 64, .detail = true});
    DrawnSea to = second_maps.show(second, 5.0);
    SeaMaps more_tiles({.compute = false, .foam_resolution = 64, .detail = true});
    to.tiles = more_tiles.show(coarse, 6.0).tiles;
    drawn(renderer, cross_fade(shown_, to, 0.5));
    EXPECT_EQ(text(renderer.left_out()), "");
    EXPECT_EQ(renderer.left_out().required_units, 15);
    EXPECT_EQ(fragment_samplers(), 15);
}

TEST_F(UnitsTest, APartThatDoesNotFitIsLeftOutWithTheNumbers) {
    Ocean sea(test::wind_sea(32, 400.0), {.foam_start = FoamStart::settled});
    DrawnSea shown = maps_.show(sea, 5.0);
    ASSERT_FALSE(shown.tiles.empty());
    Renderer all({.cells = 16}), nine({.cells = 16, .max_texture_units = 9});
    DrawnSea bare = shown;
    bare.tiles.clear();
    EXPECT_NE(drawn(all, shown), drawn(all, bare));
    EXPECT_EQ(drawn(nine, shown), drawn(all, bare));
    EXPECT_TRUE(nine.left_out().near_detail);
    EXPECT_FALSE(nine.left_out().foam_pattern);
    EXPECT_EQ(
        text(nine.left_out()),
        "near detail is left out: the water needs 10 texture units in a fragment shader; this "
        "driver has 9");

    Renderer six({.cells = 16, .max_texture_units = 6}),
        four({.cells = 16, .max_texture_units = 4});
    drawn(six, shown);
    EXPECT_TRUE(six.left_out().foam_pattern);
    EXPECT_FALSE(six.left_out().near_detail);
    EXPECT_THROW(drawn(four, shown), Error);
}

}  // namespace
}  // namespace ocean::preview
