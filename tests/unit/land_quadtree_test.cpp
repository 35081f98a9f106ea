// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The quadtree of land by numbers: how many triangles, no pop in time. Its meshes are closed:
// land_mesh_test.cpp.
#include "ocean/internal/land_quadtree.hpp"

#include "field/bilinear.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/grid.hpp"
#include "ocean/terrain.hpp"
#include "quadtree_probe.hpp"

namespace ocean {
namespace {

using CameraPlanes = std::array<std::array<double, 4>, 5>;

constexpr double kWidth = 1280.0, kHeight = 720.0;  // [pixels]
const double kFocal = 0.5 * kWidth / std::tan(kPi / 6.0);

/// A camera of 60 degrees across and 16:9.
struct Camera {
    std::array<double, 3> eye{}, forward{}, right{}, up{};

    Camera(std::array<double, 3> at, double yaw, double pitch) : eye(at) {
        forward = {std::cos(yaw) * std::cos(pitch), std::sin(yaw) * std::cos(pitch),
                   std::sin(pitch)};
        right = {std::sin(yaw), -std::cos(yaw), 0.0};
        up = {-std::cos(yaw) * std::sin(pitch), -std::sin(yaw) * std::sin(pitch), std::cos(pitch)};
    }

    CameraPlanes planes() const {
        const double across = 0.5 * kWidth / kFocal, high = 0.5 * kHeight / kFocal;
        const auto plane = [&](double a, double b, double c) {
            std::array<double, 4> p{};
            for (std::size_t n = 0; n < 3; ++n) {
                p[n] = a * forward[n] + b * right[n] + c * up[n];
                p[3] -= p[n] * eye[n];
            }
            return p;
        };
        return {plane(1.0, 0.0, 0.0), plane(across, 1.0, 0.0), plane(across, -1.0, 0.0),
                plane(high, 0.0, 1.0), plane(high, 0.0, -1.0)};
    }

    /// Returns the pixel of a point, from the middle of the picture.
    std::array<double, 2> pixel(const Position& p) const {
        double x = 0.0, y = 0.0, z = 0.0;
        for (std::size_t n = 0; n < 3; ++n) {
            x += (p[n] - eye[n]) * right[n];
            y += (p[n] - eye[n]) * up[n];
            z += (p[n] - eye[n]) * forward[n];
        }
        return {kFocal * x / z, kFocal * y / z};
    }
};

/// The lowest and highest heights of a periodic map in squares of 2^n cells.
class HeightPyramid {
  public:
    explicit HeightPyramid(const Surface& map)
        : cell_(map.domain().step(0)), side_(map.resolution()) {
        const auto values = map.channel(Channel::height);
        std::vector<std::pair<float, float>> finest;
        for (const float h : values) finest.emplace_back(h - 2.0f, h + 2.0f);
        levels_.push_back(std::move(finest));
        for (int side = side_ / 2; side >= 1; side /= 2) {
            const auto& fine = levels_.back();
            std::vector<std::pair<float, float>> coarse;
            for (const auto [i, j] : test::pairs(side, side)) {
                std::pair<float, float> box = fine[index(2 * i, 2 * j, 2 * side)];
                for (const auto& [a, b] : {std::pair{1, 0}, {0, 1}, {1, 1}}) {
                    const auto& other = fine[index(2 * i + a, 2 * j + b, 2 * side)];
                    box = {std::min(box.first, other.first), std::max(box.second, other.second)};
                }
                coarse.push_back(box);
            }
            levels_.push_back(std::move(coarse));
        }
    }

    std::pair<float, float> operator()(double x, double y, double side) const {
        const int level = std::clamp(static_cast<int>(std::lround(std::log2(side / cell_))), 0,
                                     static_cast<int>(levels_.size()) - 1);
        const double size = cell_ * (1 << level);
        return levels_[static_cast<std::size_t>(level)]
                      [index(static_cast<std::int64_t>(std::floor(x / size)),
                             static_cast<std::int64_t>(std::floor(y / size)), side_ >> level)];
    }
    double height(double x, double y) const {
        return double{levels_[0][index(static_cast<std::int64_t>(std::floor(x / cell_)),
                                       static_cast<std::int64_t>(std::floor(y / cell_)), side_)]
                          .first} +
               2.0;
    }

  private:
    static std::size_t index(std::int64_t i, std::int64_t j, std::int64_t side) {
        return static_cast<std::size_t>((j & (side - 1)) * side + (i & (side - 1)));
    }
    double cell_;
    int side_;
    std::vector<std::vector<std::pair<float, float>>> levels_;
};

/// Mountains with a period of 131 km.
Surface mountains() {
    TerrainModel terrain;
    terrain.resolution = 1024;
    terrain.patch_size = 131072.0;
    terrain.beta = 1.8;
    terrain.outer_scale = 22000.0;
    terrain.rms = 500.0;
    terrain.seed = 3;
    Terrain land(terrain);
    return land.surface({Channel::height});
}

struct Pose {
    Camera camera;
    double ground;
};

std::vector<Pose> random_poses(const HeightPyramid& heights, int count) {
    std::mt19937 random(0);
    std::vector<Pose> poses;
    for (int n = 0; n < count; ++n) {
        const double x = uniform(random, -6e4, 6e4), y = uniform(random, -6e4, 6e4);
        const double above = 2.0 * std::pow(10.0, uniform(random, 0.0, 3.4));
        const double yaw = uniform(random, 0.0, kTwoPi),
                     pitch = uniform(random, -50.0, 15.0) * kPi / 180.0;
        const double ground = heights.height(x, y);
        poses.push_back({Camera({x, y, ground + above}, yaw, pitch), ground});
    }
    return poses;
}

/// Large patches, which need fewer draws and pop more.
QuadtreeSettings large_patches() {
    return {.patch = 32, .levels = 14, .range = 120.0, .morph_start = 0.7};
}

TEST(LandQuadtree, DrawsAtMost300ThousandTrianglesInAnyOfTwoThousandPoses) {
    const Surface map = mountains();
    const HeightPyramid pyramid(map);
    const HeightBounds bounds = std::cref(pyramid);
    const std::vector<Pose> poses = random_poses(pyramid, 2000);
    for (const QuadtreeSettings& settings : {QuadtreeSettings{}, large_patches()}) {
        std::vector<LandPatch> patches;
        std::uint64_t max = 0, sum = 0;
        std::size_t draws = 0;
        for (const Pose& pose : poses) {
            const CameraPlanes planes = pose.camera.planes();
            select(settings, {pose.camera.eye, pose.ground, planes}, bounds, patches);
            const std::uint64_t triangles = triangles_of(settings, patches);
            max = std::max(max, triangles);
            sum += triangles;
            draws = std::max(draws, patches.size());
        }
        EXPECT_LE(max, 300'000u);
        EXPECT_GT(sum / poses.size(), 80'000u);
        EXPECT_LE(draws, 800u);
    }
}

TEST(LandQuadtree, BelowTheMinRangeValidateRefuses) {
    QuadtreeSettings settings = large_patches();
    settings.range = 62.0;
    settings.morph_start = 0.88;
    ASSERT_NO_THROW(validate(settings));
    settings.morph_start = 0.82;
    EXPECT_THROW(validate(settings), Error);
    EXPECT_THROW(select(settings, {}, {}), Error);
    settings.range = min_range(settings);
    EXPECT_NO_THROW(validate(settings));
    settings.range = std::nextafter(settings.range, 0.0);
    EXPECT_THROW(validate(settings), Error);
}

// ---- Time.

/// Land of 1024 m whose heights for a spacing are the waves that such samples hold.
class RoughLand {
  public:
    RoughLand(double slope, double period) : kPeriod(period), kStep(period / kSide) {
        TerrainModel terrain;
        terrain.resolution = kSide;
        terrain.patch_size = kPeriod;
        terrain.beta = 2.0;
        terrain.shortest_wavelength = 2.0;
        Terrain land(terrain);
        for (int side = kSide; side >= 32; side /= 2) {
            const Surface map = land.surface({Channel::height}, side);
            const auto values = map.channel(Channel::height);
            maps_.emplace_back(values.begin(), values.end());
        }
        const auto height = [&](int i, int j) { return double{maps_[0][index(i, j, kSide)]}; };
        double squares = 0.0;
        for (const auto [i, j] : test::pairs(kSide, kSide)) {
            const double x = (height(i + 1, j) - height(i, j)) / kStep;
            const double y = (height(i, j + 1) - height(i, j)) / kStep;
            squares += x * x + y * y;
        }
        const double scale = slope / std::sqrt(squares / (kSide * kSide));
        for (auto& heights : maps_) {
            for (float& h : heights) h *= static_cast<float>(scale);
        }
    }

    float operator()(WorldPoint point, double spacing) const {
        const auto level =
            std::min(static_cast<std::size_t>(std::ilogb(spacing / kStep)), maps_.size() - 1);
        const double cell = kStep * (1 << level);
        return maps_[level][index(std::llround(point.x / cell), std::llround(point.y / cell),
                                  kSide >> level)];
    }

  private:
    static constexpr int kSide = 2048;
    double kPeriod, kStep;
    static std::size_t index(std::int64_t i, std::int64_t j, std::int64_t side) {
        return static_cast<std::size_t>((j & (side - 1)) * side + (i & (side - 1)));
    }
    std::vector<std::vector<float>> maps_;
};

/// How far shown points move between frames beyond the camera's own motion [pixels].
struct Pops {
    double moved = 0.0;     // at most
    double switched = 0.0;  // at most, of points whose level changes
    int switches = 0;
};

/// One frame of a flight.
struct Frame {
    Camera camera;
    LandView view;
    PatchMap map;
};

/// A flight at 30 m/s and 24 frames/s, above the land of 32 m waves and more.
struct Flight {
    double above;           // [m]
    double ground_spacing;  // of the heights that give the ground under the eye [m]
};

constexpr double kYaw = 0.29, kPitch = -0.1;

/// Returns the height at any point, bilinear between vertices `spacing` apart.
double ground_at(const RoughLand& land, double spacing, double x, double y) {
    const double i = std::floor(x / spacing), j = std::floor(y / spacing);
    const double u = x / spacing - i, v = y / spacing - j;
    const auto height = [&](double a, double b) {
        return double{land({(i + a) * spacing, (j + b) * spacing}, spacing)};
    };
    return bilinear(height(0, 0), height(1, 0), height(0, 1), height(1, 1), u, v);
}

Frame frame_of(const QuadtreeSettings& settings, const RoughLand& land, const Flight& flight,
               int number) {
    const double way = 30.0 * number / 24.0;
    const double x = way * std::cos(kYaw), y = way * std::sin(kYaw);
    const Camera camera({x, y, ground_at(land, 32.0, x, y) + flight.above}, kYaw, kPitch);
    const LandView view{camera.eye, ground_at(land, flight.ground_spacing, x, y)};
    return {camera, view, PatchMap(settings, select(settings, view, {}))};
}

Pops fly(const QuadtreeSettings& settings, const RoughLand& land, const Flight& flight) {
    constexpr int kFrames = 240, kLabels = 1200;
    const PointHeight height = std::cref(land);
    std::mt19937 random(1);
    Pops pops;
    Frame before = frame_of(settings, land, flight, 0);
    for (int number = 1; number <= kFrames; ++number) {
        Frame now = frame_of(settings, land, flight, number);
        for (int n = 0; n < kLabels; ++n) {
            const double yaw = kYaw + uniform(random, -kPi / 6.0, kPi / 6.0);
            const double u = uniform(random, 0.0, 1.0), distance = 32.0 * std::exp2(7.0 * u * u);
            WorldPoint p{now.view.eye[0] + distance * std::cos(yaw),
                         now.view.eye[1] + distance * std::sin(yaw)};
            const LandPatch *patch = now.map.find(p.x, p.y), *old = before.map.find(p.x, p.y);
            if (patch == nullptr || old == nullptr) continue;
            // Between vertices the surface moves less.
            const double s = settings.spacing_of(std::min(patch->level, old->level));
            p = {std::floor(p.x / s) * s, std::floor(p.y / s) * s};
            const auto z0 = shown_height(settings, before.view, before.map, height, p);
            const auto z1 = shown_height(settings, now.view, now.map, height, p);
            if (!z0 || !z1) {
                ADD_FAILURE() << "no triangle at " << p.x << ", " << p.y;
                return pops;
            }
            const auto a = now.camera.pixel({p.x, p.y, *z0});
            const auto b = now.camera.pixel({p.x, p.y, *z1});
            if (std::abs(b[0]) > 0.5 * kWidth || std::abs(b[1]) > 0.5 * kHeight) continue;
            const double move = std::hypot(a[0] - b[0], a[1] - b[1]);
            pops.moved = std::max(pops.moved, move);
            if (patch->level == old->level) continue;
            ++pops.switches;
            pops.switched = std::max(pops.switched, move);
        }
        before = std::move(now);
    }
    return pops;
}

TEST(LandQuadtree, NoShownPointMovesByAFifthOfAPixelInAFrame) {
    const RoughLand land(0.35, 1024.0);
    QuadtreeSettings settings;
    settings.farthest = 8e3;
    for (const Flight& flight : {Flight{2.0, 32.0}, Flight{12.0, 0.5}}) {
        const Pops pops = fly(settings, land, flight);
        EXPECT_LE(pops.moved, 0.2);
        EXPECT_GT(pops.moved, 0.05);
        // A frame's way is longer than the last spacings of level 0, where nothing changes.
        EXPECT_LE(pops.switched, 0.02);
        EXPECT_GT(pops.switches, 500);
    }
}

}  // namespace
}  // namespace ocean
