// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: a subject of a host, a tilted plane at one place of the world, is baked, labelled,
// resumed, listed and refused as a sea is, although no format and no product has code for it.

#include <cstdlib>

#include "bakes.hpp"
#include "ocean/internal/io/read_provenance.hpp"
#include "ocean/internal/text.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {
namespace {

using test::TemporaryFolder;

constexpr std::string_view kPlaneKind = "plane";

/// height = level + x / 10 - y / 20 over 300 m x 150 m from (100, -50) on.
class Plane final : public Subject {
  public:
    explicit Plane(double level) : level_(level) {}

    double height(double x, double y) const { return level_ + x / 10.0 - y / 20.0; }

    std::string_view kind() const override { return kPlaneKind; }
    std::string text() const override { return "level = " + shortest_text(level_); }
    std::vector<std::string> named_files() const override { return {}; }
    void set(std::string_view name, std::string_view) override {
        throw Error(ErrorKind::invalid_value,
                    {.what = "a plane has no such parameter", .parameter = std::string(name)});
    }
    Timeline timeline() const override { return {.moves = true, .start = 1.0 / 24.0}; }
    ChannelSet channels() const override {
        using enum Channel;
        return {Channel::height, nx, ny, nz, slope_x, slope_y};
    }
    int default_resolution() const override { return 64; }
    Domain domain(int resolution) const override {
        return {{100.0, -50.0}, {300.0, 150.0}, {resolution, resolution}, false};
    }
    double shortest_wave(int resolution) const override { return 2.0 * domain(resolution).step(0); }
    HeightRange height_range(const MapsOptions&) const override { return {-10.0, level_ + 45.0}; }
    std::unique_ptr<SubjectMaps> open(const MapsOptions& options) const override;
    Costs costs() const override { return {.shared = sizeof(Plane)}; }

  private:
    double level_;
};

class PlaneMaps final : public SubjectMaps {
  public:
    PlaneMaps(const Plane& plane, int threads) : plane_(plane), pool_(threads) {}

    std::unique_ptr<SubjectMaps> share(const MapsOptions& options) const override {
        return std::make_unique<PlaneMaps>(plane_, options.threads);
    }
    std::vector<Surface> levels(double time, ChannelSet channels,
                                std::span<const int> resolutions) override {
        std::vector<Surface> maps;
        for (const int resolution : resolutions) maps.push_back(map(time, channels, resolution));
        return maps;
    }
    WorldHeights eulerian_heights(double time, int resolution) override {
        return {map(time, {Channel::height}, resolution)};
    }
    void query(double, std::span<const WorldPoint> points, std::span<QuerySample> samples,
               const QueryOptions&) override {
        for (std::size_t i = 0; i < points.size(); ++i) {
            samples[i] = {};
            samples[i].height = plane_.height(points[i].x, points[i].y);
            samples[i].normal[2] = 1.0 / std::sqrt(1.0 + 0.01 + 0.0025);
        }
    }
    ThreadPool& pool() override { return pool_; }

  private:
    Surface map(double time, ChannelSet channels, int resolution) const {
        Surface surface(plane_.domain(resolution), time, channels);
        const double length = std::sqrt(1.0 + 0.01 + 0.0025);
        const std::pair<Channel, double> constant[] = {{Channel::nx, -0.1 / length},
                                                       {Channel::ny, 0.05 / length},
                                                       {Channel::nz, 1.0 / length},
                                                       {Channel::slope_x, 0.1},
                                                       {Channel::slope_y, -0.05}};
        for (const auto& [channel, value] : constant) {
            std::ranges::fill(surface.channel(channel), static_cast<float>(value));
        }
        const std::span<float> heights = surface.channel(Channel::height);
        for (std::size_t at = 0; at < heights.size(); ++at) {
            const auto n = static_cast<std::size_t>(resolution);
            const auto [x, y] =
                surface.domain().place(static_cast<int>(at % n), static_cast<int>(at / n));
            heights[at] = static_cast<float>(plane_.height(x, y));
        }
        return surface;
    }

    const Plane& plane_;
    ThreadPool pool_;
};

std::unique_ptr<SubjectMaps> Plane::open(const MapsOptions& options) const {
    return std::make_unique<PlaneMaps>(*this, options.threads);
}

std::unique_ptr<Subject> parse_plane(std::string_view text, const std::string& name) {
    constexpr std::string_view kKey = "level = ";
    if (!text.starts_with(kKey)) throw Error(ErrorKind::bad_file, name + ": is no plane");
    return std::make_unique<Plane>(std::stod(std::string(text.substr(kKey.size()))));
}

Catalogue catalogue_with_planes() {
    static constexpr SubjectReader kSubjects[] = {{kSeaKind, parse_sea_subject},
                                                  {kPlaneKind, parse_plane}};
    Catalogue catalogue = standard_catalogue();
    catalogue.subjects = kSubjects;
    return catalogue;
}

BakeOptions plane_bake(const std::string& output) {
    BakeOptions options = test::sea_bake(output, "1-2");
    options.source = "plane.toml";
    options.open_subject = [](const std::string&) { return std::make_unique<Plane>(2.5); };
    return options;
}

std::string bake(const BakeOptions& options) {
    return test::bake(options, catalogue_with_planes());
}

std::string refusal(const BakeOptions& options) {
    return test::refusal_of(options, catalogue_with_planes());
}

class EveryFormat : public testing::TestWithParam<const char*> {};

TEST_P(EveryFormat, HoldsAPlane) {
    const TemporaryFolder folder;
    const std::string extension = GetParam();
    if (standard_catalogue().find_format(extension) == nullptr) GTEST_SKIP() << "not built";
    BakeOptions options = plane_bake(folder.file("plane" + extension));
    ASSERT_EQ(bake(options), "bb");
    options.skip_existing = true;
    EXPECT_EQ(bake(options), "kk");  // resumed
    EXPECT_TRUE(std::filesystem::exists(folder.file("plane.manifest.json")));

    // Without a manifest its files are recognised as baked, and are replaced.
    std::filesystem::remove(folder.file("plane.manifest.json"));
    options.skip_existing = false;
    EXPECT_EQ(bake(options), "bb");

    if (extension == ".png" || extension == ".df3") return;  // files without a header
    const BakePlan plan = make_bake_plan(options, catalogue_with_planes());
    for (const BakeFile& file : plan.format->files(plan, 2)) {
        const auto provenance = io::read_provenance(file.path);
        ASSERT_TRUE(provenance) << file.path;
        EXPECT_EQ(provenance->kind, kPlaneKind) << file.path;
        EXPECT_EQ(provenance->text, "level = 2.5");
        EXPECT_EQ(provenance->frame, 2);
        ASSERT_TRUE(provenance->domain) << file.path;
        EXPECT_EQ(provenance->domain->origin, (std::array{100.0, -50.0}));
        EXPECT_FALSE(provenance->domain->wraps);
    }
}

INSTANTIATE_TEST_SUITE_P(OtherSubject, EveryFormat,
                         testing::Values(".exr", ".ply", ".obj", ".usda", ".vdb", ".png", ".df3"),
                         [](const auto& name) { return std::string(name.param).substr(1); });

TEST(OtherSubject, IsReadBackFromItsOwnFile) {
    const TemporaryFolder folder;
    BakeOptions options = plane_bake(folder.file("plane.exr"));
    options.format_options["products"] = "height";
    options.frames = "2";
    bake(options);
    BakeOptions again;
    again.from = folder.file("plane.exr");
    again.output = folder.file("again.exr");
    again.threads = 1;
    again.open_subject = [](const std::string&) { return std::make_unique<Plane>(2.5); };
    bake(again);
    const std::string bytes = test::read_bytes(folder.file("again.exr"));
    EXPECT_TRUE(bytes == test::read_bytes(folder.file("plane.exr")));
    EXPECT_FALSE(bytes.empty());
}

TEST(OtherSubject, LeavesFramesOfOtherPlanesOutOfItsStage) {
    const TemporaryFolder folder;
    struct Warnings : BakeHost {
        int count = 0;
        void warning(const std::string&) override { ++count; }
    };
    const auto warnings = [&](const std::string& frames, double level) {
        BakeOptions options = plane_bake(folder.file("plane.usda"));
        options.frames = frames;
        options.overwrite = true;
        options.open_subject = [level](const std::string&) {
            return std::make_unique<Plane>(level);
        };
        Warnings host;
        run_bake(make_bake_plan(options, catalogue_with_planes()), host);
        return host.count;
    };
    EXPECT_EQ(warnings("1-2", 2.5), 0);
    EXPECT_EQ(warnings("3-4", 2.5), 0);
    EXPECT_GT(warnings("5-6", 9.0), 0);
}

TEST(OtherSubject, IsRefusedProductsAndOptionsOfSeas) {
    const std::array<std::string, 3> requests[] = {
        {"x.ply", "spray", "--products spray: only a sea has it, and this is a plane"},
        {"x.vdb", "surface,vel", "--products vel: only a sea has it, and this is a plane"},
        {"x.exr", "caustics", "--products caustics: only a sea has it, and this is a plane"},
        {"x.exr", "height,foam", "a plane has no foam"}};
    for (const auto& [output, products, message] : requests) {
        if (standard_catalogue().find_format(output.substr(1)) == nullptr) continue;  // not built
        BakeOptions options = plane_bake(output);
        options.format_options["products"] = products;
        EXPECT_EQ(refusal(options), message);
    }
    BakeOptions fine = plane_bake("x.df3");
    fine.format_options["fine-map"] = "yes";
    EXPECT_EQ(refusal(fine), "--fine-map: only a sea has it, and this is a plane");
    BakeOptions rate = plane_bake("rate.exr");
    rate.fps = "25";
    EXPECT_EQ(refusal(rate), "time.fps: a plane has no such parameter");
}

}  // namespace
}  // namespace ocean
