// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: a program can bake with the library alone; its host gets the frames in order, each file
// is complete, and an exception of the host ends the bake without losing finished frames.
#include "ocean/bake/run.hpp"

#include <stdexcept>

#include "bakes.hpp"
#include "ocean/internal/bake/estimate.hpp"

namespace ocean {
namespace {

using test::TemporaryFolder;

BakeOptions small_bake(const TemporaryFolder& folder, const std::string& output) {
    BakeOptions options = test::sea_bake(folder.file(output), "3,1-2");
    options.threads = 2;
    return options;
}

BakePlan plan_of(const BakeOptions& options) {
    return make_bake_plan(options, standard_catalogue());
}

struct Diary : BakeHost {
    std::string events;
    const TemporaryFolder* folder = nullptr;  // of the files
    int uninterrupted_files = 0;              // written inside run_uninterrupted()
    bool has_interrupt_handler = false;
    bool foam = true;
    int leave_at = 0;  // a frame, or 0

    void begin(const BakePlan&, const WorkShare& share) override {
        EXPECT_TRUE(!foam || share.frames_at_a_time == 1)
            << "frames with foam depend on earlier ones";
        events += "begin ";
    }
    void frame_baked(int frame, double, const std::vector<std::string>& files) override {
        for (const std::string& file : files) EXPECT_TRUE(std::filesystem::exists(file)) << file;
        EXPECT_TRUE(has_interrupt_handler);
        events += "baked" + std::to_string(frame) + " ";
        if (frame == leave_at) throw std::runtime_error("the host left");
    }
    void frame_skipped(int frame, const std::vector<std::string>&) override {
        events += "kept" + std::to_string(frame) + " ";
    }
    void frame_failed(int frame, const std::string&, bool continues) override {
        events += "failed" + std::to_string(frame) + (continues ? "," : " ");
    }
    void end() override { events += "end"; }
    void run_uninterrupted(const std::function<void()>& write) override {
        const std::size_t before = folder != nullptr ? folder->entries() : 0;
        write();
        if (folder != nullptr && folder->entries() > before) ++uninterrupted_files;
    }
    void set_interrupt_handler(std::function<void()> act) override {
        has_interrupt_handler = act != nullptr;
    }
};

TEST(RunBake, ReportsEachFrameInTheRequestedOrder) {
    const TemporaryFolder folder;
    const BakePlan plan = plan_of(small_bake(folder, "sea.exr"));
    Diary diary;
    diary.folder = &folder;
    run_bake(plan, diary);
    EXPECT_EQ(diary.events, "begin baked3 baked1 baked2 end");
    EXPECT_EQ(diary.uninterrupted_files, 3 * 3 + 1)
        << "displacement, normal, foam, and the manifest";
    EXPECT_FALSE(diary.has_interrupt_handler);
    EXPECT_EQ(folder.entries(), 3u * 3u + 1u);
}

TEST(RunBake, RunsWithADefaultHost) {
    const TemporaryFolder folder;
    BakeHost host;
    run_bake(plan_of(small_bake(folder, "sea.####.df3")), host);
    EXPECT_EQ(folder.entries(), 2 * 3u + 1u) << "maps, their descriptions, and the manifest";
}

TEST(RunBake, EndsAtAnExceptionOfItsHostAndLosesNothing) {
    const TemporaryFolder folder;
    BakeOptions options = small_bake(folder, "sea.exr");
    Diary leaving;
    leaving.leave_at = 1;
    EXPECT_THROW(run_bake(plan_of(options), leaving), std::runtime_error);
    EXPECT_FALSE(leaving.has_interrupt_handler);
    options.skip_existing = true;
    Diary again;
    run_bake(plan_of(options), again);
    EXPECT_TRUE(again.events.starts_with("begin kept3 kept1 ")) << again.events;
    EXPECT_TRUE(again.events.ends_with("2 end")) << again.events;
}

TEST(RunBake, ReportsAndThrowsTheErrorOfAFrame) {
    const TemporaryFolder folder;
    BakeOptions options = small_bake(folder, "sea.exr");
    std::filesystem::create_directories(folder.file("sea.normal.0001.exr"));
    Diary diary;
    EXPECT_THROW(run_bake(plan_of(options), diary), Error);
    EXPECT_TRUE(diary.events.starts_with("begin baked3 failed1 ")) << diary.events;
    options.keep_going = true;
    Diary going_on;
    EXPECT_THROW(run_bake(plan_of(options), going_on), Error);
    EXPECT_EQ(going_on.events, "begin baked3 failed1,baked2 end");
}

TEST(RunBake, SkipsOnlyFilesThatItWouldWriteAgain) {
    const TemporaryFolder folder;
    BakeOptions options = small_bake(folder, "sea.####.inc");
    options.format_options = {{"eye", "0,0,6"}, {"mesh-columns", "20"}, {"mesh-rows", "20"}};
    options.skip_existing = true;
    const auto events = [&] {
        Diary diary;
        diary.foam = false;
        run_bake(plan_of(options), diary);
        return diary.events;
    };
    EXPECT_EQ(events(), "begin baked3 baked1 baked2 end");
    EXPECT_EQ(events(), "begin kept3 kept1 kept2 end");
    {
        std::fstream file(folder.file("sea.0001.inc"), std::ios::in | std::ios::out);
        file.seekp(200);
        file << "!";
    }
    EXPECT_EQ(events(), "begin kept3 baked1 kept2 end") << "a damaged file";
    options.format_options["heading"] = "10";
    EXPECT_EQ(events(), "begin baked3 baked1 baked2 end") << "another option of the format";
    options.frames = "1";
    options.fps = "12";
    EXPECT_THROW(events(), Error) << "another sea";
    options.overwrite = true;
    EXPECT_EQ(events(), "begin baked1 end") << "another sea";
}

TEST(RunBake, NeverReplacesFilesOfTheUser) {
    for (const char* const name : {"sea.0002.df3", "sea.height.0002.exr", "sea.0002.png",
                                   "sea.0002.png.inc", "sea.0002.inc", "sea.manifest.json"}) {
        const TemporaryFolder folder;
        folder.write(name, "not a frame of ours");
        std::string extension = std::filesystem::path(name).extension().string();
        if (std::string_view(name).ends_with(".png.inc")) extension = ".png";
        if (extension == ".json") extension = ".exr";
        BakeOptions height = small_bake(folder, "sea.####" + extension);
        if (extension == ".exr") height.format_options["products"] = "height";
        const BakePlan plan = plan_of(height);
        BakeHost host;
        EXPECT_THROW(forecast_bake(plan), Error) << name;
        EXPECT_THROW(run_bake(plan, host), Error) << name;
        EXPECT_EQ(folder.entries(), 1u) << name;
    }
}

TEST(RunBake, ReplacesItsOwnFilesWithoutAManifest) {
    for (const char* const output : {"sea.####.exr", "sea.####.df3", "sea.png", "sea.inc"}) {
        const TemporaryFolder folder;
        BakeOptions options = small_bake(folder, output);
        options.frames = "2";
        BakeHost host;
        run_bake(plan_of(options), host);
        const std::size_t files = folder.entries();
        std::filesystem::remove(plan_of(options).pattern.manifest());
        EXPECT_NO_THROW(run_bake(plan_of(options), host)) << output;
        EXPECT_EQ(folder.entries(), files);
    }
}

TEST(RunBake, ForecastsFilesAndBytesAndWritesNothing) {
    const TemporaryFolder folder;
    BakeOptions options = small_bake(folder, "sea.####.png");
    const BakeForecast before = forecast_bake(plan_of(options));
    ASSERT_EQ(before.files.size(), 9u);
    EXPECT_EQ(folder.entries(), 0u);
    BakeHost host;
    run_bake(plan_of(options), host);
    std::uint64_t bytes = 0;
    for (const BakeForecast::File& file : before.files) {
        EXPECT_FALSE(file.kept);
        bytes += std::filesystem::file_size(file.path);
    }
    EXPECT_LE(bytes, before.bytes);
    EXPECT_GE(2 * bytes + 9 * 4096, before.bytes);
    options.skip_existing = true;
    EXPECT_EQ(forecast_bake(plan_of(options)).bytes, 0u);
}

int query_count = 0;
BackendFitness small_maps_only(int resolution) {
    ++query_count;
    if (resolution <= 64) return {true, true, "a toy"};
    return {false, false, "maps of " + std::to_string(resolution) + " samples are too large"};
}
BackendFitness never_queried(int) {
    ADD_FAILURE() << "it is never fast";
    return {};
}

TEST(BakePlan, AutoChoosesTheFastBackendWithinItsLimitsAndQueriesItOnce) {
    const TemporaryFolder folder;
    Backend fast = Backend::cpu;
    fast.name = "toy";
    fast.fitness = small_maps_only;
    fast.may_be_fast = true;
    Backend slow = Backend::radix2;
    slow.name = "slow";
    slow.fitness = never_queried;
    const Backend backends[] = {Backend::cpu, fast, slow};
    Catalogue catalogue = standard_catalogue();
    catalogue.backends = backends;
    BakeOptions options = small_bake(folder, "sea.exr");
    options.backend = "auto";
    EXPECT_EQ(make_bake_plan(options, catalogue).backend.name, "toy");
    EXPECT_EQ(query_count, 1);
    options.resolution = "128";
    const BakePlan large = make_bake_plan(options, catalogue);
    EXPECT_EQ(large.backend.name, "cpu");
    EXPECT_EQ(large.backend_note, "backend cpu, not toy: maps of 128 samples are too large");
    EXPECT_EQ(query_count, 2);
    options.backend = "toy";
    EXPECT_THROW(make_bake_plan(options, catalogue), Error);
}

}  // namespace
}  // namespace ocean
