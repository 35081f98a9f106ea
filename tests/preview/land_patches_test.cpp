// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: the vertices that the GPU shows are those of land_vertex(), with the heights of the
// function; they meet bit by bit; a live picture without its patches is coarser and has no holes;
// textures and triangles stay within their bounds; land that exists once ends at its edge, in water
// if it has a coast.
#include <thread>

#include "height_ranges.hpp"
#include "land_vertices.hpp"
#include "ocean/internal/land_mesh.hpp"
#include "ocean/internal/land_quadtree.hpp"
#include "ocean/internal/preview/land_maps.hpp"
#include "ocean/ocean.hpp"
#include "preview_fixture.hpp"

namespace ocean::preview {
namespace {

class LandPatchesTest : public PreviewTest {
  protected:
    /// Draws a land with a renderer, and returns the pixels of a view.
    std::vector<float> drawn(Renderer& renderer, const DrawnLand& shown, const Camera& camera,
                             View view = View::numbers, int width = 96, int height = 54) {
        const Canvas canvas(width, height, GL_RGBA32F);
        renderer.draw(shown, camera, {}, {.width = width, .height = height, .view = view});
        return canvas.rgba();
    }
    static std::size_t empty_pixels(const std::vector<float>& pixels) {
        std::size_t empty = 0;
        for (std::size_t i = 0; i < pixels.size(); i += 4) empty += pixels[i] == 0.0f ? 1 : 0;
        return empty;
    }
    static Camera over(const DrawnLand& shown, double x, double y, double above) {
        Camera camera;
        camera.eye = {x, y, shown.surface_at(x, y) + above};
        camera.pitch = -15.0;
        return camera;
    }

    LandMaps maps_;
    ThreadPool pool_{1};
};

/// Returns the heights of a function at single points.
HeightSampler sampler_of(const LandFunction& function, ThreadPool& pool) {
    return [&](std::span<const WorldPoint> points, double spacing, std::span<float> heights) {
        std::vector<QuerySample> samples(points.size());
        function.query(points, samples, spacing, pool);
        for (std::size_t i = 0; i < points.size(); ++i) {
            heights[i] = static_cast<float>(samples[i].height);
        }
    };
}

/// Expects each vertex where land_vertex() shows it, also where it snaps to another one.
void expect_labels(const std::vector<GpuVertex>& vertices, const QuadtreeSettings& settings,
                   const LandView& view) {
    int partial = 0, diagonal = 0, straight = 0;
    for (const GpuVertex& vertex : vertices) {
        const auto level = static_cast<int>(vertex.index[2]);
        const double spacing = settings.spacing_of(level);
        const auto index = [&](std::size_t axis) {
            const double snapped = std::floor(view.eye[axis] / settings.spacing);
            return (static_cast<std::int64_t>(snapped) +
                    static_cast<std::int64_t>(vertex.index[axis])) >>
                   level;
        };
        const LandIndex at{index(0), index(1)};
        // Rounding decides if a vertex at this very distance snaps.
        const double distance = plane_distance(view, land_label(settings, level, at));
        if (std::abs(distance / spacing - (settings.range - 0.25)) < 1e-3) continue;
        const LandVertex expected = land_vertex(settings, view, level, at);
        const double rounding = 1e-5 * (spacing + distance);
        const double x = expected.shown.x - view.eye[0], y = expected.shown.y - view.eye[1];
        ASSERT_NEAR(static_cast<double>(vertex.label[0]), x, rounding) << level << " " << at.i;
        ASSERT_NEAR(static_cast<double>(vertex.label[1]), y, rounding) << level << " " << at.j;
        ASSERT_NEAR(static_cast<double>(vertex.place[2]), expected.share, 1e-4);
        partial += expected.share > 0.45 && expected.share < 0.55 ? 1 : 0;
        const bool odd_i = (at.i & 1) != 0, odd_j = (at.j & 1) != 0;
        if (!snaps_at(settings, level, distance)) continue;
        diagonal += odd_i && odd_j ? 1 : 0;
        straight += odd_i != odd_j ? 1 : 0;
    }
    EXPECT_GT(partial, 1000);
    EXPECT_GT(diagonal, 100);
    EXPECT_GT(straight, 100);
}

TEST_F(LandPatchesTest, ShownVerticesAreThoseOfTheQuadtreeWithTheHeightsOfTheField) {
    for (const TerrainModel& terrain : {hills(), gullied(), island()}) {
        Terrain land(terrain, {.threads = 1});
        const DrawnLand shown = maps_.show(land, 128);
        Renderer renderer({.land_threads = 1});
        VertexReader reader;
        Camera camera = over(shown, 1717.3, 1903.7, 40.0);
        camera.heading = 33.0;
        drawn(renderer, shown, camera);
        constexpr GLint kHeightsUnit = 3;  // after sky, map and masks
        const std::vector<GpuVertex> vertices =
            reader.read(renderer.land_statistics(), kHeightsUnit);
        ASSERT_GT(vertices.size(), 10000u);

        // The same view on the CPU, all round to a distance that most vertices are within.
        QuadtreeSettings settings;
        settings.farthest = 3000.0;
        const Domain& domain = shown.function->domain();
        if (!domain.wraps) {
            settings.edge =
                LandEdge{domain.origin,
                         {domain.origin[0] + domain.size[0], domain.origin[1] + domain.size[1]}};
        }
        QuerySample calm{};
        const WorldPoint place{camera.eye[0], camera.eye[1]};
        shown.function->query({&place, 1}, {&calm, 1}, 32.0, pool_);
        const LandView view{camera.eye, calm.height};
        const std::vector<LandPatch> patches = select(settings, view, {});
        std::map<std::pair<long, long>, double> heights;  // by the place in 1/16 m
        const auto key = [](double x, double y) {
            return std::pair{std::lround(16.0 * x), std::lround(16.0 * y)};
        };
        for (const LandPatch& patch : patches) {
            const double spacing = settings.spacing_of(patch.level);
            if (domain.wraps && spacing * 16.0 > domain.size[0]) continue;  // they show the mean
            const LandMesh mesh =
                make_land_mesh(settings, {&patch, 1}, view, sampler_of(*shown.function, pool_));
            for (const auto& p : mesh.positions) heights[key(p[0], p[1])] = p[2];
        }
        std::size_t compared = 0;
        double worst = 0.0;
        for (const GpuVertex& v : vertices) {
            const auto found = heights.find(key(camera.eye[0] + static_cast<double>(v.label[0]),
                                                camera.eye[1] + static_cast<double>(v.label[1])));
            if (found == heights.end()) continue;
            const double x = static_cast<double>(v.label[0]), y = static_cast<double>(v.label[1]);
            const double drop = (x * x + y * y) / (2.0 * 6371000.0);
            worst = std::max(worst,
                             std::abs(static_cast<double>(v.position[2]) + drop - found->second));
            ++compared;
        }
        EXPECT_LT(worst, 1e-5 * *terrain.rms);
        EXPECT_GT(compared, vertices.size() / 2);
        expect_labels(vertices, settings, view);
        if (domain.wraps) continue;
        for (const GpuVertex& v : vertices) {
            for (std::size_t axis = 0; axis < 2; ++axis) {
                const double at = camera.eye[axis] + static_cast<double>(v.label[axis]);
                ASSERT_GE(at, settings.edge->low[axis] - 1e-3);
                ASSERT_LE(at, settings.edge->high[axis] + 1e-3);
            }
        }
    }
}

TEST_F(LandPatchesTest, TrianglesShareTheirEdgesBitByBit) {
    // Each edge inside the picture's mesh belongs to two triangles. Open edges lie on the border of
    // the selection: there the frustum has left out the neighbour.
    Terrain land(gullied(), {.threads = 1});
    const DrawnLand shown = maps_.show(land, 128);
    Renderer renderer({.land_threads = 1});
    VertexReader reader;
    Camera camera = over(shown, 517.0, 303.0, 60.0);
    camera.pitch = -89.0;
    camera.field_of_view = 100.0;
    drawn(renderer, shown, camera);
    const std::vector<GpuVertex> vertices = reader.read(renderer.land_statistics(), 3);
    using Point = std::array<float, 3>;
    std::map<std::pair<Point, Point>, int> edges;
    double reach = 0.0;
    int turned = 0;  // triangles that are seen from below
    for (std::size_t t = 0; t + 2 < vertices.size(); t += 3) {
        std::array<Point, 3> corner;
        for (std::size_t c = 0; c < 3; ++c) {
            std::copy_n(vertices[t + c].position, 3, corner[c].begin());
            reach = std::max(reach, static_cast<double>(std::abs(corner[c][0])));
        }
        const auto side = [&](std::size_t to, std::size_t axis) {
            return static_cast<double>(corner[to][axis]) - static_cast<double>(corner[0][axis]);
        };
        turned += side(1, 0) * side(2, 1) - side(1, 1) * side(2, 0) < 0.0 ? 1 : 0;
        if (corner[0] == corner[1] || corner[1] == corner[2] || corner[0] == corner[2]) continue;
        for (std::size_t c = 0; c < 3; ++c) {
            const Point &a = corner[c], &b = corner[(c + 1) % 3];
            if (a == b) continue;
            ++edges[std::minmax(a, b)];
        }
    }
    int open_inside = 0, shared = 0;
    for (const auto& [edge, count] : edges) {
        shared += count == 2 ? 1 : 0;
        if (count == 2) continue;
        const float x = 0.5f * (edge.first[0] + edge.second[0]);
        const float y = 0.5f * (edge.first[1] + edge.second[1]);
        open_inside += std::hypot(x, y) < 50.0f ? 1 : 0;
    }
    EXPECT_EQ(open_inside, 0);
    EXPECT_EQ(turned, 0);
    EXPECT_GT(shared, 10000);
    EXPECT_GT(reach, 70.0);  // level 1 begins there
}

TEST_F(LandPatchesTest, APictureWithoutItsPatchesIsCoarserAndHasNoHoles) {
    Terrain land(gullied(), {.threads = 1});
    const DrawnLand shown = maps_.show(land, 128);
    Renderer live({.land_threads = 1, .land_patience = 0.0, .live = true});
    Renderer waiting({.land_threads = 1});
    Camera camera = over(shown, 517.0, 303.0, 300.0);
    camera.pitch = -60.0;
    const std::vector<float> whole = drawn(waiting, shown, camera);
    const std::vector<float> first = drawn(live, shown, camera);
    EXPECT_EQ(waiting.pending(), Pending::nothing);
    EXPECT_NE(live.pending(), Pending::nothing);
    EXPECT_EQ(empty_pixels(first), 0u);
    EXPECT_LT(live.land_statistics().triangles, waiting.land_statistics().triangles);
    std::vector<float> later = first;
    for (int picture = 0; picture < 1000 && live.pending() != Pending::nothing; ++picture) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        later = drawn(live, shown, camera);
        ASSERT_EQ(empty_pixels(later), 0u);
    }
    EXPECT_EQ(later, whole);
}

TEST_F(LandPatchesTest, TrianglesAndTexturesStayWithinTheirBounds) {
    Terrain land(hills(), {.threads = 1});
    const DrawnLand shown = maps_.show(land, 128);
    Renderer renderer({.land_threads = 2});
    std::size_t most = 0;
    for (const double above : {2.0, 40.0, 100.0, 300.0, 900.0}) {
        for (int turn = 0; turn < 3; ++turn) {
            Camera camera = over(shown, 300.0 * above + 91.0 * turn, -700.0, above);
            camera.pitch = -20.0 * (turn % 3);
            camera.heading = 120.0 * turn + 3.0;
            drawn(renderer, shown, camera);
            const LandStatistics mesh = renderer.land_statistics();
            most = std::max(most, mesh.triangles);
            EXPECT_LE(mesh.triangles, 300'000u) << above << " " << camera.heading;
            EXPECT_LE(mesh.resident_bytes, std::uint64_t{512} << 20);
        }
    }
    RecordProperty("triangles", std::to_string(most));
}

TEST_F(LandPatchesTest, AFrameOfLandTakesAtMostOneAndAHalfOfTheSeas) {
    constexpr int kCells = 64, kShadowSteps = 12;  // of a window without a GPU
    TerrainModel terrain = hills();
    terrain.resolution = 512;
    terrain.patch_size = 8192.0;
    Terrain land(terrain);
    const DrawnLand shown_land = maps_.show(land, 512);
    Parameters parameters = two_cascades();
    parameters.grid.cascades = 3;
    Ocean ocean(Sea{parameters, {}});
    SeaMaps sea_maps({.detail = false});  // as in a window without a GPU
    const DrawnSea shown_sea = sea_maps.show(ocean, 1.0);
    Renderer renderer({.cells = kCells, .shadow_steps = kShadowSteps});
    const Canvas canvas(640, 360, GL_RGBA8);
    const DrawOptions options{.width = 640, .height = 360};
    Look look;
    look.foam_amount = 0.0;  // a sea with foam takes longer
    const Camera above_land = over(shown_land, 700.0, 900.0, 40.0);
    const auto time_of = [&](const auto& shown, const Camera& camera) {
        const auto start = std::chrono::steady_clock::now();
        canvas.bind();
        renderer.draw(shown, camera, look, options);
        glFinish();
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    double of_land = 1e9, of_sea = 1e9;
    for (int frame = 0; frame < 4; ++frame) {
        of_land = std::min(of_land, time_of(shown_land, above_land));
        of_sea = std::min(of_sea, time_of(shown_sea, Camera{}));
    }
    RecordProperty("land_to_sea", std::to_string(of_land / of_sea));
    EXPECT_LT(of_land, 1.5 * of_sea);
}

TEST_F(LandPatchesTest, RowsMakeRoomForNewPatches) {
    constexpr int kVertices = 4;
    PatchRows rows(kVertices);
    const PatchValues heights(2 * kVertices, 1.0f);
    const int capacity = rows.slots.capacity();
    for (int n = 0; n < capacity; ++n) rows.add({{0, n, 0}, heights});
    rows.slots.begin_picture();
    EXPECT_TRUE(rows.slots.hold({0, 0, 0}));
    rows.add({{1, 0, 0}, heights});
    EXPECT_TRUE(rows.slots.contains({1, 0, 0}));
    EXPECT_TRUE(rows.slots.contains({0, 0, 0}));
    int left = 0;
    for (int n = 0; n < capacity; ++n) left += rows.slots.contains({0, n, 0}) ? 1 : 0;
    EXPECT_EQ(left, capacity - capacity / 4);
    // The patches of one picture do not take each other's rows.
    rows.slots.begin_picture();
    for (int n = 0; n < capacity; ++n) {
        rows.add({{2, n, 0}, heights});
        rows.slots.hold({2, n, 0});
    }
    rows.slots.begin_picture();
    for (int n = 0; n < capacity; ++n) ASSERT_TRUE(rows.slots.hold({2, n, 0})) << n;
    rows.add({{3, 0, 0}, heights});
    EXPECT_FALSE(rows.slots.contains({3, 0, 0}));
}

TEST_F(LandPatchesTest, RangesHoldTheHeightsOfTheirSquares) {
    for (const TerrainModel& terrain : {hills(), island()}) {
        Terrain land(terrain, {.threads = 1});
        const DrawnLand shown = maps_.show(land, 128);
        const HeightRanges ranges(*shown.image, 1.0 + 2.0 * shown.rms_slope * texel_of(shown));
        for (int n = 0; n < 200; ++n) {
            const double side = 4.0 * std::exp2(n % 12);
            const double x = 731.0 * n - 60e3, y = 17e3 - 293.0 * n;
            const auto [low, high] = ranges.in(x, y, side);
            for (int p = 0; p < 20; ++p) {
                const double height =
                    shown.ground_at(x + side * (p % 5) / 4.0, y + side * p / 19.0);
                ASSERT_GE(height, static_cast<double>(low)) << n;
                ASSERT_LE(height, static_cast<double>(high)) << n;
            }
        }
    }
}

TEST_F(LandPatchesTest, AnIslandStandsInWaterAndEndsAtItsEdge) {
    Terrain land(island(), {.threads = 1});
    const DrawnLand shown = maps_.show(land, 128);
    ASSERT_TRUE(shown.water_level);
    Renderer renderer({.land_threads = 1});
    // Outside, over the continued sea bed: no ground below, but water.
    Camera camera = over(shown, -1500.0, 2048.0, 300.0);
    EXPECT_EQ(shown.surface_at(-1500.0, 2048.0), *shown.water_level);
    EXPECT_EQ(shown.ground_at(-1500.0, 2048.0), shown.ground_at(0.0, 2048.0));
    camera.pitch = -80.0;
    const std::vector<float> below = drawn(renderer, shown, camera);
    EXPECT_EQ(empty_pixels(below), below.size() / 4);
    const std::vector<float> water = drawn(renderer, shown, camera, View::shaded);
    EXPECT_GT(water[2], 1.2f * water[0]);  // blue
    // Towards the island both are seen.
    camera.pitch = -5.0;
    camera.heading = 0.0;
    const std::size_t pixels = 96 * 54;
    const std::size_t empty = empty_pixels(drawn(renderer, shown, camera));
    EXPECT_GT(empty, pixels / 10);
    EXPECT_LT(empty, pixels * 9 / 10);
}

}  // namespace
}  // namespace ocean::preview
