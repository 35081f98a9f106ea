// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The pattern of the foam as it is drawn: as much of the water is white as the cover says, from any
// distance, and a label keeps its foam.
#include "foam_variance.hpp"
#include "lace_maps.hpp"
#include "ocean/thread_pool.hpp"
#include "preview_fixture.hpp"
#include "wave/wave.hpp"

namespace ocean::preview {
namespace {

/// After which the net, the large net and the bubbles are where they were, m.
constexpr double kNet = 132.0;
constexpr double kAll = 13.0 * kNet;

TEST(LaceMaps, EveryLevelIsUniform) {
    ThreadPool pool(0);
    for (const FoamTextureInfo& info : kFoamTextures) {
        const std::vector<LaceLevel> levels = lace_levels({info.kind, 256}, pool);
        ASSERT_EQ(levels.size(), 4u);
        for (std::size_t l = 0; l < levels.size(); ++l) {
            const std::size_t side = std::size_t{256} >> l;
            ASSERT_EQ(levels[l].means.size(), side * side);
            ASSERT_EQ(levels[l].shares.size(), std::size_t{kLaceShares});
            const auto at = [&](std::size_t x, std::size_t y) {
                return static_cast<double>(levels[l].means[(y % side) * side + x % side]);
            };
            // Reads at places that no level was made for.
            constexpr int kSteps = 2039;
            std::array<int, 4> below{};
            constexpr std::array kCovers = {0.02, 0.1, 0.3, 0.7};
            for (int j = 0; j < kSteps; ++j) {
                for (int i = 0; i < kSteps; ++i) {
                    const double u = (i + 0.29) * static_cast<double>(side) / kSteps;
                    const double v = (j + 0.71) * static_cast<double>(side) / kSteps;
                    const auto x = static_cast<std::size_t>(u), y = static_cast<std::size_t>(v);
                    const double a = u - static_cast<double>(x), b = v - static_cast<double>(y);
                    const double read = (1.0 - b) * ((1.0 - a) * at(x, y) + a * at(x + 1, y)) +
                                        b * ((1.0 - a) * at(x, y + 1) + a * at(x + 1, y + 1));
                    const double place = read * (kLaceShares - 1);
                    const auto k = static_cast<std::size_t>(std::min(place, kLaceShares - 2.0));
                    const double part = place - static_cast<double>(k);
                    const auto& shares = levels[l].shares;
                    const double value = (1.0 - part) * static_cast<double>(shares[k]) +
                                         part * static_cast<double>(shares[k + 1]);
                    for (std::size_t c = 0; c < 4; ++c) below[c] += value < kCovers[c] ? 1 : 0;
                }
            }
            for (std::size_t c = 0; c < 4; ++c) {
                EXPECT_NEAR(below[c] / (static_cast<double>(kSteps) * kSteps) / kCovers[c], 1.0,
                            0.02)
                    << info.name << ", level " << l << ", cover " << kCovers[c];
            }
        }
    }
}

/// Flat water with as much foam everywhere.
class LaceTest : public PreviewTest {
  protected:
    LaceTest() {
        Parameters parameters = test::wind_sea(32);
        parameters.waves.front().wind_speed = 0.0;
        sea_ = std::make_unique<Ocean>(parameters, OceanOptions{.foam_start = FoamStart::empty});
        maps_ = std::make_unique<SeaMaps>(SeaMapsOptions{.compute = false, .foam_resolution = 32});
    }

    DrawnSea covered(double cover, double time = 0.0) {
        DrawnSea shown = maps_->show(*sea_, time);
        EXPECT_FALSE(shown.has_foam);
        shown.has_foam = true;
        const auto c = static_cast<float>(cover);
        texture_ = gl::generate<gl::Texture, &glGenTextures>();
        glBindTexture(GL_TEXTURE_2D, texture_.name());
        const float texel[4] = {c, c * wave::single_precision::foam_mean_thickness(c, 0.35f), 0.0f,
                                0.0f};
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 1, 1, 0, GL_RGBA, GL_FLOAT, texel);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
        shown.covers = {{.texture = texture_.name(), .resolution = 1, .period = shown.period}};
        shown.covers[0].stretch = 1.0;
        return shown;
    }

    /// A square of `metres` a side from so high that all pixels see as much of it.
    std::vector<float> foam(const DrawnSea& sea, double x, double y, double metres, int side) {
        const Canvas canvas(side, side, GL_RGBA32F);
        const double height = 5.0 * metres;
        const Camera camera{.eye = {x, y, height},
                            .heading = 90.0,
                            .pitch = -90.0,
                            .field_of_view = 2.0 * std::atan(0.1) * 180.0 / kPi};
        canvas.bind();
        renderer_.draw(sea, camera, Look{},
                       {.width = side, .height = side, .view = View::foam_numbers});
        return canvas.rgba();
    }

  private:
    std::unique_ptr<Ocean> sea_;
    std::unique_ptr<SeaMaps> maps_;
    Renderer renderer_{{.cells = 32}};
    gl::Texture texture_;
};

TEST_F(LaceTest, AsMuchIsWhiteAsIsCoveredNearAndFar) {
    for (const double cover : {0.02, 0.1, 0.3, 0.7}) {
        const DrawnSea sea = covered(cover);
        // Pixels of 0.1 m see the pattern, those of 0.3 m to 1 m a part of it, those of 3 m none.
        for (const int side : {1320, 440, 264, 132, 44}) {
            // Larger pixels need more pictures, each shifted by a part of a pixel.
            const int beside = side < 1320 ? 3 : 1;
            double white = 0.0, squares = 0.0, thick = 0.0;
            for (int picture = 0; picture < beside * beside; ++picture) {
                const double part = kNet / side / beside;
                const auto pixels = foam(sea, 3.0 + part * (picture % beside),
                                         7.0 + part * (picture / beside), kNet, side);
                for (std::size_t p = 0; p < pixels.size(); p += 4) {
                    const double here = pixels[p + 1];
                    white += here;
                    squares += here * here;
                    thick += here * pixels[p + 2];
                }
            }
            const double count = std::pow(static_cast<double>(side) * beside, 2);
            white /= count;
            const double deviation = std::sqrt(std::max(0.0, squares / count - white * white));
            EXPECT_NEAR(white / cover, 1.0, 0.02) << cover << ", " << side << " pixels";
            const double expected_deviation =
                std::sqrt(test::foam_variance(cover, 0.1, kNet / side, 0.86));
            EXPECT_NEAR(deviation, expected_deviation, 0.1 * expected_deviation + 1e-3 * cover)
                << cover << ", " << side << " pixels";
            if (side <= 132) {  // else it varies with the pattern
                const double expected =
                    white * wave::double_precision::foam_mean_thickness(cover, 0.35);
                EXPECT_NEAR(thick / count / expected, 1.0, 0.02) << cover;
            }
        }
    }
}

TEST_F(LaceTest, ALabelKeepsItsFoamWhereverTheEyeIs) {
    constexpr int kSide = 256;
    constexpr double kMetres = 8.0;
    constexpr int kMoved = 40;  // pixels
    const double moved = kMoved * kMetres / kSide;
    constexpr double kEast = 3.3;  // whole periods from 0 would be whole numbers, exact in a float
    const auto here = foam(covered(0.3), kEast, 0.0, kMetres, kSide);
    struct Case {
        double x, time;
        int shift;
    };
    for (const Case& other : {Case{moved, 0.0, kMoved}, {0.0, 777.7, 0}, {1e5 * kAll, 0.0, 0}}) {
        const auto there = foam(covered(0.3, other.time), kEast + other.x, 0.0, kMetres, kSide);
        // The camera's right is east.
        double squares = 0.0, before = 0.0;
        int count = 0;
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x + other.shift < kSide; ++x) {
                const auto at = [&](const std::vector<float>& of, int column) {
                    return of[4 * static_cast<std::size_t>(y * kSide + column) + 3];
                };
                const double difference = at(there, x) - at(here, x + other.shift);
                squares += difference * difference;
                before += std::pow(at(here, x) - 0.5, 2);
                ++count;
            }
        }
        EXPECT_GT(std::sqrt(before / count), 0.2);
        EXPECT_LT(std::sqrt(squares / count), 0.02) << other.x << " m, " << other.time << " s";
    }
}

TEST_F(LaceTest, CellsLieAlongTheWay) {
    // A turn by a quarter is the same pattern seen from another side.
    DrawnSea sea = covered(0.3);
    sea.covers[0].stretch = 3.0;
    constexpr int kSide = 512;
    const auto change_along = [&](double direction) {
        sea.covers[0].direction = direction;
        const auto pixels = foam(sea, 0.0, 0.0, 24.0, kSide);
        std::array<double, 2> change{};
        for (int y = 0; y + 2 < kSide; ++y) {
            for (int x = 0; x + 2 < kSide; ++x) {
                const auto at = [&](int i, int j) {
                    return pixels[4 * static_cast<std::size_t>(j * kSide + i) + 3];
                };
                change[0] += std::abs(at(x + 2, y) - at(x, y));
                change[1] += std::abs(at(x, y + 2) - at(x, y));
            }
        }
        return change;
    };
    const auto east = change_along(0.0), north = change_along(0.5 * kPi);
    EXPECT_LT(east[0], 0.8 * east[1]);
    EXPECT_LT(north[1], 0.8 * north[0]);
}

}  // namespace
}  // namespace ocean::preview
