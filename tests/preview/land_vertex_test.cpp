// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claim: each vertex of a picture stands where land_vertex() of ocean/internal/land_quadtree.hpp
// shows it, also where it snaps to another one.
#include <cmath>
#include <cstdint>

#include "land_vertices.hpp"
#include "ocean/internal/land_quadtree.hpp"
#include "ocean/internal/preview/land_maps.hpp"
#include "ocean/terrain.hpp"
#include "preview_fixture.hpp"

namespace ocean::preview {
namespace {

class LandVertexTest : public PreviewTest {};

TEST_F(LandVertexTest, EachVertexOfThePictureStandsWhereTheQuadtreeShowsIt) {
    LandMaps maps;
    ThreadPool pool(1);
    for (const TerrainModel& terrain : {hills(), island()}) {
        Terrain land(terrain, {.threads = 1});
        const DrawnLand shown = maps.show(land, 128);
        Renderer renderer({.land_threads = 1});
        Camera camera;
        camera.eye = {1717.3, 1903.7, shown.surface_at(1717.3, 1903.7) + 40.0};
        camera.pitch = -30.0;
        const Canvas canvas(16, 16, GL_RGBA32F);
        renderer.draw(shown, camera, {}, {.width = 16, .height = 16, .view = View::numbers});
        VertexReader reader;
        constexpr GLint kHeightsUnit = 3;  // after sky, map and masks
        const std::vector<GpuVertex> vertices =
            reader.read(renderer.land_statistics(), kHeightsUnit);

        QuadtreeSettings settings;
        const Domain& domain = shown.function->domain();
        if (!domain.wraps) {
            settings.edge =
                LandEdge{domain.origin,
                         {domain.origin[0] + domain.size[0], domain.origin[1] + domain.size[1]}};
        }
        QuerySample calm{};
        const WorldPoint place{camera.eye[0], camera.eye[1]};
        shown.function->query({&place, 1}, {&calm, 1}, 32.0, pool);
        const LandView view{camera.eye, calm.height};
        int partial = 0, diagonal = 0, straight = 0;
        for (const GpuVertex& vertex : vertices) {
            const auto level = static_cast<int>(vertex.index[2]);
            const double spacing = settings.spacing_of(level);
            const auto index = [&](std::size_t axis) {
                const double snapped = std::floor(camera.eye[axis] / settings.spacing);
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
            ASSERT_NEAR(static_cast<double>(vertex.label[0]), expected.shown.x - camera.eye[0],
                        rounding)
                << level << " " << at.i << " " << at.j;
            ASSERT_NEAR(static_cast<double>(vertex.label[1]), expected.shown.y - camera.eye[1],
                        rounding)
                << level << " " << at.i << " " << at.j;
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
}

}  // namespace
}  // namespace ocean::preview
