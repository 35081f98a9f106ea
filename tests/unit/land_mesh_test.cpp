// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Meshes of a quadtree of land: closed, turned upwards, exact at the edge of land.
#include "ocean/internal/land_mesh.hpp"

#include <set>

#include "ocean/error.hpp"
#include "quadtree_probe.hpp"

namespace ocean {
namespace {

/// Small patches and seven levels, for meshes of some 10 000 triangles.
QuadtreeSettings small_patches() {
    return {.patch = 8, .levels = 7, .range = 40.0, .morph_start = 0.65, .farthest = 500.0};
}

void sample_rough(std::span<const WorldPoint> points, double spacing, std::span<float> heights) {
    std::ranges::transform(points, heights.begin(),
                           [=](WorldPoint p) { return rough_height(p, spacing); });
}

std::vector<LandView> random_views(int count, double width) {
    std::mt19937 random(5);
    std::vector<LandView> views;
    for (int n = 0; n < count; ++n) {
        const double x = uniform(random, -width, width), y = uniform(random, -width, width);
        views.push_back({{x, y, 50.0 * std::exp2(uniform(random, -5.0, 1.0))}, 0.0});
    }
    return views;
}

/// Returns twice the area of a triangle in the plane [m2].
double doubled_area(const LandMesh& mesh, const std::array<std::uint32_t, 3>& t) {
    const Position &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Counts the faults of a mesh of these patches.
struct Faults {
    int repeated = 0;  // directed edges of two triangles: also where a mesh folds
    int holes = 0;     // edges of one triangle that are not the outer border of the patches
    int turned = 0;    // triangles without an area, or seen from below
    int vertices = 0;  // unused or equal
    double area = 0.0;

    int all() const { return repeated + holes + turned + vertices; }
    friend std::ostream& operator<<(std::ostream& out, const Faults& f) {
        return out << f.repeated << ' ' << f.holes << ' ' << f.turned << ' ' << f.vertices;
    }
};

Faults faults_of(const QuadtreeSettings& settings, std::span<const LandPatch> patches,
                 const LandMesh& mesh) {
    Faults faults;
    std::unordered_map<std::uint64_t, int> edges;
    const auto key = [](std::uint64_t from, std::uint64_t to) { return from << 32 | to; };
    std::vector<char> used(mesh.positions.size(), 0);
    for (const auto& t : mesh.triangles) {
        const double area = 0.5 * doubled_area(mesh, t);
        faults.turned += area > 0.0 ? 0 : 1;
        faults.area += area;
        for (std::size_t n = 0; n < 3; ++n) {
            used[t[n]] = 1;
            faults.repeated += edges[key(t[n], t[(n + 1) % 3])]++ > 0 ? 1 : 0;
        }
    }
    const PatchMap map(settings, patches);
    for (const auto& [edge, count] : edges) {
        const std::uint64_t from = edge >> 32, to = edge & 0xffffffffu;
        if (edges.contains(key(to, from))) continue;
        // Outside lies to the right of an edge.
        const Position &a = mesh.positions[from], &b = mesh.positions[to];
        const double x = b[0] - a[0], y = b[1] - a[1];
        const WorldPoint outside{0.5 * (a[0] + b[0]) + 1e-6 * y, 0.5 * (a[1] + b[1]) - 1e-6 * x};
        const bool beyond =
            settings.edge &&
            (outside.x < settings.edge->low[0] || outside.x > settings.edge->high[0] ||
             outside.y < settings.edge->low[1] || outside.y > settings.edge->high[1]);
        faults.holes += !beyond && map.find(outside.x, outside.y) != nullptr ? 1 : 0;
    }
    const std::set<Position> distinct(mesh.positions.begin(), mesh.positions.end());
    faults.vertices = static_cast<int>(mesh.positions.size() - distinct.size() +
                                       static_cast<std::size_t>(std::ranges::count(used, 0)));
    return faults;
}

/// Returns the area of patches within the edge [m2]; each of them has some.
double area_of(const QuadtreeSettings& settings, std::span<const LandPatch> patches) {
    double area = 0.0;
    for (const LandPatch& patch : patches) {
        const int quads = patch.quads(settings);
        const WorldPoint low =
            land_label(settings, patch.level, {patch.i * quads, patch.j * quads});
        const WorldPoint high =
            land_label(settings, patch.level, {(patch.i + 1) * quads, (patch.j + 1) * quads});
        const double part = (high.x - low.x) * (high.y - low.y);
        EXPECT_GT(part, 0.0);
        area += part;
    }
    return area;
}

TEST(LandMesh, IsClosedInsideAndSeenFromAbove) {
    QuadtreeSettings no_power_of_two = small_patches();
    no_power_of_two.spacing = 0.3;
    // The default, and large patches at the least range that validate() takes.
    const QuadtreeSettings large{.patch = 32, .levels = 14, .range = 62.0, .morph_start = 0.88};
    struct Case {
        QuadtreeSettings settings;
        int views;
        double width;
    };
    for (const auto& [settings, views, width] : {Case{small_patches(), 8, 2000.0},
                                                 {no_power_of_two, 3, 2e5},
                                                 {QuadtreeSettings{}, 2, 6e4},
                                                 {large, 2, 6e4}}) {
        for (const LandView& view : random_views(views, width)) {
            const auto patches = select(settings, view, {});
            const LandMesh mesh = make_land_mesh(settings, patches, view, sample_rough);
            const Faults faults = faults_of(settings, patches, mesh);
            EXPECT_EQ(faults.all(), 0) << faults;
            EXPECT_NEAR(faults.area, area_of(settings, patches), 1e-6 * faults.area);
            EXPECT_GT(mesh.triangles.size(), 5000u);
            EXPECT_LT(mesh.triangles.size(), triangles_of(settings, patches));
        }
    }
}

TEST(LandMesh, PatchesInsideTheFrustumAreClosed) {
    const QuadtreeSettings settings = small_patches();
    const HeightBounds bounds = [](double, double, double) { return std::pair{0.0f, 100.0f}; };
    for (LandView view : random_views(4, 2000.0)) {
        const double c = std::cos(view.eye[0]), s = std::sin(view.eye[0]);
        const std::array<std::array<double, 4>, 1> planes{
            {{c, s, 0.0, -c * view.eye[0] - s * view.eye[1]}}};
        const auto all = select(settings, view, {});
        view.planes = planes;
        const auto patches = select(settings, view, bounds);
        EXPECT_LT(patches.size(), 2 * all.size() / 3);
        EXPECT_GT(patches.size(), all.size() / 3);
        for (const LandPatch& patch : patches) {
            const int quads = patch.quads(settings);
            const WorldPoint far =
                land_label(settings, patch.level,
                           {(patch.i + (c > 0.0)) * quads, (patch.j + (s > 0.0)) * quads});
            EXPECT_GE(c * (far.x - view.eye[0]) + s * (far.y - view.eye[1]), 0.0);
        }
        const LandMesh mesh = make_land_mesh(settings, patches, view, sample_rough);
        EXPECT_EQ(faults_of(settings, patches, mesh).all(), 0);
    }
}

TEST(LandMesh, LandThatExistsOnceIsClosedAndEndsExactlyAtItsEdge) {
    std::mt19937 random(9);
    QuadtreeSettings settings = small_patches();
    settings.farthest = 2000.0;
    for (int n = 0; n < 40; ++n) {
        const double x = uniform(random, -300.0, 300.0), y = uniform(random, -300.0, 300.0);
        settings.edge = LandEdge{
            {x, y},
            {x + std::exp2(uniform(random, -2.0, 9.0)), y + std::exp2(uniform(random, -2.0, 9.0))}};
        const LandEdge& edge = *settings.edge;
        const LandView view{
            {uniform(random, -50.0, 50.0) + (n % 2 == 0 ? edge.low[0] : edge.high[0]),
             uniform(random, -50.0, 50.0) + (n % 3 == 0 ? edge.low[1] : edge.high[1]),
             uniform(random, 1.0, 60.0)},
            0.0};
        const auto patches = select(settings, view, {});
        const LandMesh mesh = make_land_mesh(settings, patches, view, sample_rough);
        const Faults faults = faults_of(settings, patches, mesh);
        EXPECT_EQ(faults.all(), 0) << n << ": " << faults;
        const double area = (edge.high[0] - edge.low[0]) * (edge.high[1] - edge.low[1]);
        EXPECT_NEAR(faults.area, area, 1e-9 * area) << n;
        EXPECT_NEAR(area_of(settings, patches), area, 1e-9 * area) << n;
        for (std::size_t axis = 0; axis < 2; ++axis) {
            double low = std::numeric_limits<double>::max(), high = -low;
            for (const Position& p : mesh.positions) {
                low = std::min(low, p[axis]);
                high = std::max(high, p[axis]);
            }
            EXPECT_EQ(low, edge.low[axis]);
            EXPECT_EQ(high, edge.high[axis]);
        }
    }
}

TEST(LandMesh, KnowsThePatchThatShowsEachVertexAndMixesFurtherValuesAsHeights) {
    QuadtreeSettings settings = small_patches();
    const HeightSampler twice = [](std::span<const WorldPoint> points, double spacing,
                                   std::span<float> values) {
        for (std::size_t n = 0; n < points.size(); ++n) {
            values[2 * n] = values[2 * n + 1] = rough_height(points[n], spacing);
        }
    };
    for (const bool has_edge : {false, true}) {
        if (has_edge) settings.edge = LandEdge{{-100.3, -90.7}, {151.1, 203.9}};
        for (const LandView& view : random_views(4, 100.0)) {
            const auto patches = select(settings, view, {});
            const LandMesh mesh = make_land_mesh(settings, patches, view, twice, 1);
            ASSERT_EQ(mesh.places.size(), mesh.positions.size());
            ASSERT_EQ(mesh.values.size(), mesh.positions.size());
            std::set<Position> at_labels;  // without their heights
            const auto vertex_at = [&](LandPlace place) {
                const LandPatch& patch = patches[place.patch];
                const int quads = patch.quads(settings);
                const std::int64_t side = quads + 1;
                return land_vertex(
                    settings, view, patch.level,
                    {patch.i * quads + place.vertex % side, patch.j * quads + place.vertex / side});
            };
            const auto is_at_label = [](const LandVertex& vertex) {
                return vertex.shown.x == vertex.label.x && vertex.shown.y == vertex.label.y;
            };
            for (std::uint32_t patch = 0; patch < patches.size(); ++patch) {
                const auto side = static_cast<std::uint32_t>(patches[patch].quads(settings)) + 1;
                for (std::uint32_t v = 0; v < side * side; ++v) {
                    const LandVertex vertex = vertex_at({patch, v});
                    if (!is_at_label(vertex)) continue;
                    at_labels.insert({vertex.shown.x + 0.0, vertex.shown.y + 0.0, 0.0});
                }
            }
            for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
                const Position& position = mesh.positions[v];
                const LandVertex vertex = vertex_at(mesh.places[v]);
                ASSERT_EQ(vertex.shown.x, position[0]);
                ASSERT_EQ(vertex.shown.y, position[1]);
                ASSERT_EQ(is_at_label(vertex), at_labels.contains({position[0], position[1], 0.0}));
                ASSERT_NEAR(mesh.values[v], position[2], 1e-4);
            }
        }
    }
}

TEST(LandMesh, AtTheEndOfItsRangeALevelShowsTheNextOne) {
    QuadtreeSettings settings = small_patches();
    const std::array<LandPatch, 1> fine = {LandPatch{1, 3, 5, false}};
    const std::array<LandPatch, 1> coarse = {LandPatch{2, 3, 5, true}};
    const PointHeight height = rough_height;
    std::mt19937 random(3);
    const double side = settings.patch * settings.spacing_of(1);
    for (const bool placed : {false, true}) {
        if (placed) {  // an edge through the quads of both
            settings.edge = LandEdge{{0.0, 0.0}, {4 * side - 1.3, 6 * side - 0.7}};
        }
        for (const double spacings : {-1.6, -0.5, -0.3, -0.2, 1.0}) {  // beyond the range
            const LandView view{{3.5 * side, 5.5 * side, (settings.range + spacings) * 1.0}, 0.0};
            const PatchMap fine_map(settings, fine), coarse_map(settings, coarse);
            for (int n = 0; n < 500; ++n) {
                const WorldPoint p{uniform(random, 3 * side, 4 * side - 1.3),
                                   uniform(random, 5 * side, 6 * side - 0.7)};
                const auto a = shown_height(settings, view, fine_map, height, p);
                const auto b = shown_height(settings, view, coarse_map, height, p);
                ASSERT_TRUE(a && b);
                EXPECT_NEAR(*a, *b, 1e-6) << placed << ' ' << spacings;
            }
        }
    }
}

TEST(LandMesh, ReusesTheVectorOfPatches) {
    const QuadtreeSettings settings = small_patches();
    std::vector<LandPatch> patches;
    patches.reserve(10'000);
    const LandPatch* const data = patches.data();
    for (const LandView& view : random_views(10, 2000.0)) {
        select(settings, view, {}, patches);
        EXPECT_FALSE(patches.empty());
        EXPECT_EQ(patches.data(), data);
        EXPECT_FALSE(PatchMap(settings, patches).has_repeats());
    }
}

TEST(LandMesh, BytesBoundTheMeshAndSettingsOutOfRangeAreRefused) {
    const QuadtreeSettings settings = small_patches();
    const LandView view{{1.0, 2.0, 3.0}, 0.0};
    const auto patches = select(settings, view, {});
    const LandMesh mesh = make_land_mesh(settings, patches, view, sample_rough);
    EXPECT_GE(land_mesh_bytes(settings, patches),
              mesh.positions.capacity() * sizeof(Position) + mesh.triangles.capacity() * 12);
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    const auto refused = [&](auto number, double value) {
        QuadtreeSettings other = settings;
        other.*number = static_cast<std::remove_cvref_t<decltype(other.*number)>>(value);
        EXPECT_THROW(validate(other), Error) << value;
        EXPECT_THROW(make_land_mesh(other, patches, view, sample_rough), Error) << value;
    };
    for (const double bad : {0.0, kNan}) refused(&QuadtreeSettings::spacing, bad);
    for (const double bad : {6.0, 0.0}) refused(&QuadtreeSettings::patch, bad);
    for (const double bad : {0.0, 31.0}) refused(&QuadtreeSettings::levels, bad);
    for (const double bad : {kNan, 37.0}) refused(&QuadtreeSettings::range, bad);
    for (const double bad : {0.5, 0.95}) refused(&QuadtreeSettings::morph_start, bad);
    for (const double bad : {1e5, kNan}) refused(&QuadtreeSettings::farthest, bad);
    for (const LandEdge& edge : {LandEdge{{0.0, 0.0}, {0.0, 1.0}}, {{0.0, 0.0}, {1.0, kNan}}}) {
        QuadtreeSettings other = settings;
        other.edge = edge;
        EXPECT_THROW(validate(other), Error);
    }
    EXPECT_THROW(select(settings, {{kNan, 0.0, 0.0}, 0.0}, {}), Error);
    EXPECT_THROW(select(settings, {{0.0, 1e9, 0.0}, 0.0}, {}), Error);
    const std::array<std::array<double, 4>, 1> planes{{{1.0, 0.0, 0.0, 0.0}}};
    EXPECT_THROW(select(settings, {{}, 0.0, planes}, {}), Error);
}

}  // namespace
}  // namespace ocean
