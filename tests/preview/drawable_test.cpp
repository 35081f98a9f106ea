// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: a drawable that is added to the renderer and the water hide each other as their distances
// along each line of sight say, for eyes from 2 m to 10 km above the water and for distances from 2
// m to 10 km; neither knows of the other.
#include "drawable.hpp"

#include "preview_fixture.hpp"
#include "projection.hpp"
#include "shader_text.hpp"
#include "wave/wave.hpp"

namespace ocean::preview {
namespace {

constexpr int kSide = 96;
constexpr float kMark = -7.0f;  // of a pixel that shows the wall

gl::Shader compile(GLenum kind, const std::string& main) {
    const std::string text =
        gl::program_text(gl::load_shader("preview/on_screen.glsl"), "", kind) + main;
    gl::Shader shader(glCreateShader(kind));
    const char* source = text.c_str();
    glShaderSource(shader.name(), 1, &source, nullptr);
    glCompileShader(shader.name());
    GLint good = GL_FALSE;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &good);
    EXPECT_EQ(good, GL_TRUE);
    return shader;
}

/// A plane square to +x, as wide as the sight and as high above the water as below: one rectangle,
/// whose depth therefore is written by its fragments.
class Wall : public Drawable {
  public:
    Wall(double distance, double height) : distance_(distance), height_(height) {
        const gl::Shader vertex = compile(GL_VERTEX_SHADER, R"(
            uniform vec2 wall;  // distance, height [m]
            void main() {
                vec2 corner = 2.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1) - 1.0;
                float level = -drop_at(vec2(wall.x, 0.0));
                gl_Position = on_screen(vec3(wall.x, 4.0 * wall.x * corner.x,
                                             level + wall.y * corner.y));
            })");
        const gl::Shader fragment = compile(GL_FRAGMENT_SHADER, R"(
            layout(location = 0) out vec4 colour;
            void main() {
                gl_FragDepth = depth_at(1.0 / gl_FragCoord.w);
                colour = vec4(-7.0);
            })");
        glAttachShader(program_.name(), vertex.name());
        glAttachShader(program_.name(), fragment.name());
        glLinkProgram(program_.name());
    }

    double farthest(const PictureFrame&) const override { return 5.0 * distance_; }
    void draw(const PictureFrame&) override {
        if (!is_shown) return;
        glUseProgram(program_.name());
        PictureFrame::attach(program_.name());
        glUniform2f(glGetUniformLocation(program_.name(), "wall"), static_cast<float>(distance_),
                    static_cast<float>(height_));
        glBindVertexArray(array_.name());
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }

    bool is_shown = true;

  private:
    double distance_, height_;
    gl::Program program_{glCreateProgram()};
    gl::VertexArray array_ = gl::make_vertex_array();
};

/// The line of sight of a pixel, from a camera that looks along +x.
struct Sight {
    double ahead,
        up;        // of a vector whose length is that of its horizontal part, where that is `ahead`
    double level;  // its horizontal part
};

Sight sight_of(const Camera& camera, int i, int j) {
    const double half = std::tan(0.5 * kRadians * camera.field_of_view);
    const double right = half * (2.0 * (i + 0.5) / kSide - 1.0);
    const double above = half * (2.0 * (j + 0.5) / kSide - 1.0);
    const double c = std::cos(kRadians * camera.pitch), s = std::sin(kRadians * camera.pitch);
    const double ahead = c - above * s;
    return {ahead, s + above * c, std::hypot(ahead, right)};
}

/// Returns the distance ahead [m] at which a sight is over the level of a water point, whose height
/// over still water is known; infinity if it is not within 100 km.
double distance_of(const Sight& sight, double eye, double height) {
    using wave::double_precision::earth_drop;
    double steps = (height - eye) / sight.up;
    for (int i = 0; i < 60; ++i) {
        steps = (height - earth_drop(steps * sight.level) - eye) / sight.up;
        if (!(std::abs(steps) < 1e5)) return INFINITY;
    }
    return steps * sight.ahead;
}

struct Counts {
    int wall = 0, water = 0, wrong = 0;
};

class DrawableTest : public PreviewTest {
  protected:
    Counts hidden(const DrawnSea& sea, const Camera& camera, double distance) {
        Renderer renderer({.cells = 64});
        const double height = 0.4 * std::hypot(distance, camera.eye[2]);
        const auto wall = std::make_shared<Wall>(distance, height);
        renderer.add(wall);
        const Canvas canvas(kSide, kSide, GL_RGBA32F);
        const auto drawn = [&](bool with_wall) {
            wall->is_shown = with_wall;
            renderer.draw(sea, camera, {},
                          {.width = kSide, .height = kSide, .view = View::numbers});
            return canvas.rgba();
        };
        canvas.bind();
        const auto water = drawn(false), both = drawn(true);
        Counts counts;
        for (int j = 0; j < kSide; ++j) {
            for (int i = 0; i < kSide; ++i) {
                const auto p = 4 * static_cast<std::size_t>(j * kSide + i);
                const Sight sight = sight_of(camera, i, j);
                const double level =
                    camera.eye[2] + distance * sight.up / sight.ahead +
                    wave::double_precision::earth_drop(distance);  // where it meets the wall
                if (std::abs(level) > 0.98 * height) continue;
                // A centimetre of height is so much of the distance, where the sight is flat.
                const double unknown = 0.01 / std::abs(sight.up) / distance;
                if (unknown > 0.01) continue;
                const bool is_water = water[p + 3] != 0.0f || water[p] != 0.0f;
                const double away =
                    is_water ? distance_of(sight, camera.eye[2], static_cast<double>(water[p]))
                             : INFINITY;
                if (std::abs(away / distance - 1.0) < 0.003 + unknown) continue;
                const bool shows_wall = both[p] == kMark;
                (away > distance ? counts.wall : counts.water) += 1;
                counts.wrong += shows_wall == (away > distance) ? 0 : 1;
            }
        }
        return counts;
    }
};

TEST_F(DrawableTest, AWallAndTheWaterHideEachOtherFromAnyHeightAndDistance) {
    Ocean sea(two_cascades(), {.foam_start = FoamStart::empty});
    SeaMaps maps({.compute = false, .foam_resolution = 64});
    const DrawnSea shown = maps.show(sea, 5.0);
    struct Case {
        double eye, distance, field_of_view;
    };
    for (const auto& [eye, distance, field_of_view] : {Case{2.0, 5000.0, 60.0},
                                                       {2.0, 5000.0, 1.5},
                                                       {20.0, 5000.0, 2.0},
                                                       {200.0, 5000.0, 2.0},
                                                       {200.0, 5000.0, 60.0},
                                                       {2000.0, 5000.0, 60.0},
                                                       {10000.0, 5000.0, 60.0},
                                                       {10000.0, 5000.0, 2.0},
                                                       {3.0, 2.0, 60.0},
                                                       {3.0, 20.0, 60.0},
                                                       {8.0, 200.0, 30.0},
                                                       {50.0, 2000.0, 10.0},
                                                       {300.0, 10000.0, 4.0}}) {
        Camera camera{.eye = {123.0, -45.0, eye}, .field_of_view = field_of_view};
        camera.pitch = -std::atan2(eye, distance) / kRadians;
        const Counts counts = hidden(shown, camera, distance);
        EXPECT_EQ(counts.wrong, 0) << eye << " m, wall at " << distance << " m";
        EXPECT_GT(counts.wall, kSide * kSide / 10) << eye << " m, wall at " << distance << " m";
        EXPECT_GT(counts.water, kSide * kSide / 20) << eye << " m, wall at " << distance << " m";
    }
}

}  // namespace
}  // namespace ocean::preview
