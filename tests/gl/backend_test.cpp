// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The backend `gl` in an Ocean: foam, hosts' buffers and contexts, and the state it leaves behind.
#include <epoxy/gl.h>

#include <cstdlib>
#include <thread>

#include "gl/leftovers.hpp"
#include "ocean/error.hpp"
#include "ocean/gl/backend.hpp"
#include "ocean/internal/gl/context.hpp"
#include "ocean/ocean.hpp"
#include "paths.hpp"
#include "temporary_folder.hpp"
#include "unit/test_seas.hpp"

namespace ocean {
namespace {

using test::foaming_sea;
using test::relative_error;
using test::wind_sea;

double largest_difference(std::span<const float> a, std::span<const float> b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        // std::max would drop a NaN.
        const double difference = std::abs(static_cast<double>(a[i]) - b[i]);
        if (!(difference <= largest)) largest = difference;
    }
    return largest;
}

TEST(GlBackend, FoamIsThatOfTheCpuOverTwoHundredTicks) {
    Ocean cpu(foaming_sea());
    Ocean gpu(foaming_sea(), {.backend = gl::kBackend});
    for (const double time : {0.0, 2.51, 5.0, 10.0, 3.0}) {
        const Surface expected = cpu.evaluate(time, {Channel::foam});
        const Surface foam = gpu.evaluate(time, {Channel::foam});
        EXPECT_GT(test::variance(expected.channel(Channel::foam)), 1e-3);
        EXPECT_LE(largest_difference(foam.channel(Channel::foam), expected.channel(Channel::foam)),
                  2.0 / 512.0)
            << time;
    }
    EXPECT_GE(gpu.stage_runs().foam_ticks, 200);
    EXPECT_EQ(gpu.stage_runs().foam_ticks, cpu.stage_runs().foam_ticks);
}

TEST(GlBackend, FoamIsTheSameWhicheverFrameWasMadeBefore) {
    Parameters sea = foaming_sea();
    sea.grid.resolution = 64;
    sea.grid.patch_size = 100.0;
    sea.surface.foam_lifetime = 0.2;
    Ocean alone(sea, {.backend = gl::kBackend});
    Ocean later(sea, {.backend = gl::kBackend});
    for (const double time : {0.0, 2.0, 3.0}) later.evaluate(time, {Channel::foam});
    const Surface expected = alone.evaluate(3.22, {Channel::foam});
    const Surface foam = later.evaluate(3.22, {Channel::foam});
    EXPECT_GT(later.stage_runs().foam_ticks, 2 * alone.stage_runs().foam_ticks);
    EXPECT_EQ(largest_difference(foam.channel(Channel::foam), expected.channel(Channel::foam)),
              0.0);
}

TEST(GlBackend, WritesIntoTheBuffersOfHostsAndLeavesWhatIsNotAsked) {
    Ocean cpu(foaming_sea());
    Ocean gpu(foaming_sea(), {.backend = gl::kBackend});
    constexpr int kSize = 64;
    constexpr std::size_t kPitch = 4 * (kSize + 1) + 3;
    const auto make = [&](Ocean& ocean) {
        std::vector<float> image(kPitch * (kSize + 1), -7.0f);
        MapOutput output{image.data(), 4, {}, kPitch, true};
        output.component[0] = {Channel::dx, 2.0f};
        output.component[1] = {Channel::height, -0.5f};
        output.component[3] = {Channel::jacobian, 1.0f};
        ocean.evaluate_into(3.0, {&output, 1}, kSize);
        return image;
    };
    const std::vector<float> expected = make(cpu);
    const std::vector<float> image = make(gpu);
    EXPECT_LE(largest_difference(image, expected), 2e-6);
    EXPECT_EQ(image[2], -7.0f);
    EXPECT_EQ(image[kPitch - 1], -7.0f);
}

TEST(GlBackend, LiveParametersUploadAmplitudesAndAreThoseOfTheCpu) {
    Ocean cpu(wind_sea());
    Ocean gpu(wind_sea(), {.backend = gl::kBackend});
    for (const char* speed : {"10", "14", "6"}) {
        cpu.set("wind_speed", speed);
        gpu.set("wind_speed", speed);
        const Surface expected = cpu.evaluate(5.0, {Channel::height});
        const Surface heights = gpu.evaluate(5.0, {Channel::height});
        EXPECT_LE(
            relative_error(heights.channel(Channel::height), expected.channel(Channel::height)),
            1e-6);
    }
    gpu.set("water.depth", "12");
    cpu.set("water.depth", "12");
    EXPECT_LE(relative_error(gpu.evaluate(5.0, {Channel::dx}).channel(Channel::dx),
                             cpu.evaluate(5.0, {Channel::dx}).channel(Channel::dx)),
              1e-6);
}

TEST(GlBackend, SecondOrderIsThatOfTheCpu) {
    Parameters parameters = wind_sea(64);
    parameters.surface.second_order = true;
    Ocean cpu(parameters);
    Ocean gpu(parameters, {.backend = gl::kBackend});
    const ChannelSet channels = {Channel::height, Channel::vz};
    for (const double time : {5.0, 6.0}) {
        const Surface expected = cpu.evaluate(time, channels);
        const Surface made = gpu.evaluate(time, channels);
        for (const Channel channel : test::channels_of(made)) {
            EXPECT_LE(relative_error(made.channel(channel), expected.channel(channel)), 2e-6);
        }
    }
}

TEST(GlBackend, FlatWaterAndFlatChoppinessAreExact) {
    Parameters parameters = wind_sea(64);
    parameters.surface.choppiness = 0.0;
    Ocean cpu(parameters);
    Ocean gpu(parameters, {.backend = gl::kBackend});
    const Surface expected = cpu.evaluate(5.0, test::kAllChannels);
    const Surface surface = gpu.evaluate(5.0, test::kAllChannels);
    for (const Channel channel : {Channel::dx, Channel::jacobian, Channel::whitecap}) {
        EXPECT_EQ(largest_difference(surface.channel(channel), expected.channel(channel)), 0.0);
    }
    EXPECT_LE(relative_error(surface.channel(Channel::nx), expected.channel(Channel::nx)), 2e-6);

    // Flat maps use another program, and choppy ones after them again.
    for (const char* choppiness : {"0", "1.2", "0"}) {
        cpu.set("choppiness", choppiness);
        gpu.set("choppiness", choppiness);
        const Surface wanted = cpu.evaluate(5.0, {Channel::dx, Channel::jacobian});
        const Surface made = gpu.evaluate(5.0, {Channel::dx, Channel::jacobian});
        for (const Channel channel : {Channel::dx, Channel::jacobian}) {
            EXPECT_LE(largest_difference(made.channel(channel), wanted.channel(channel)), 5e-6)
                << channel_info(channel).name << " at choppiness " << choppiness;
        }
    }

    gpu.set("wind_speed", "0");
    const Surface still = gpu.evaluate(5.0, {Channel::height});
    for (const float height : still.channel(Channel::height)) ASSERT_EQ(height, 0.0f);
}

/// Counts the objects of the current context among the first names.
TEST(GlBackend, AThousandFramesInAHostsContextLeaveNothingBehindAndSayNothing) {
    const gl::HeadlessContext host({.debug = true});
    const gl::HeadlessContext::Current current(host);
    const int before = test::count_objects();
    {
        Ocean ocean(foaming_sea(), {.backend = gl::kBackend, .foam_start = FoamStart::empty});
        std::vector<float> image(4 * 64 * 64);
        MapOutput output{image.data(), 4, {}};
        output.component = {{{Channel::dx}, {Channel::height}, {Channel::nx}, {Channel::foam}}};
        const auto frame = [&](int number) {
            if (number % 100 == 50) ocean.set("wind_speed", number % 200 == 50 ? "14" : "15");
            ocean.evaluate_into(number / 60.0, {&output, 1}, 64);
        };
        for (int i = 0; i < 200; ++i) frame(i);
        const int objects = test::count_objects();
        const double memory = test::resident_megabytes();
        for (int i = 200; i < 1200; ++i) frame(i);
        EXPECT_EQ(test::count_objects(), objects);
        EXPECT_LT(test::resident_megabytes() - memory, 2.0);
    }
    EXPECT_EQ(test::count_objects(), before);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
    for (const std::string& message : host.messages()) ADD_FAILURE() << message;
}

/// Simulates a reset of the GPU by replacing the functions by which a driver reports it.
class PretendedReset {
  public:
    enum class Told { by_an_error, when_asked };

    explicit PretendedReset(Told told) {
        if (told == Told::by_an_error) epoxy_glGetError = [] { return GLenum{GL_CONTEXT_LOST}; };
        if (told == Told::when_asked) {
            epoxy_glGetGraphicsResetStatus = [] { return GLenum{GL_GUILTY_CONTEXT_RESET}; };
        }
    }
    ~PretendedReset() {
        epoxy_glGetError = error_;
        epoxy_glGetGraphicsResetStatus = status_;
    }
    PretendedReset(const PretendedReset&) = delete;
    PretendedReset& operator=(const PretendedReset&) = delete;

  private:
    PFNGLGETERRORPROC error_ = epoxy_glGetError;
    PFNGLGETGRAPHICSRESETSTATUSPROC status_ = epoxy_glGetGraphicsResetStatus;
};
constexpr PretendedReset::Told kTold[] = {PretendedReset::Told::by_an_error,
                                          PretendedReset::Told::when_asked};

void expect_reset(Ocean& ocean) {
    try {
        ocean.evaluate(1.0, {Channel::height, Channel::foam});
        ADD_FAILURE() << "a frame of a lost context";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::no_gpu);
        const std::string text = error.what();
        EXPECT_TRUE(text.starts_with("the GPU was reset or taken away while ")) << text;
        EXPECT_TRUE(text.ends_with("; finished outputs are complete")) << text;
    }
}

TEST(GlBackend, AResetIsToldAndTheNextFrameIsMadeInANewContext) {
    Parameters sea = foaming_sea();
    sea.surface.foam_lifetime = 0.5;
    Ocean ocean(sea, {.backend = gl::kBackend});
    Ocean never_lost(sea, {.backend = gl::kBackend});
    double time = 1.0;
    for (const PretendedReset::Told told : kTold) {
        {
            const PretendedReset reset(told);
            expect_reset(ocean);
            expect_reset(ocean);
        }
        const Surface expected = never_lost.evaluate(time, {Channel::height, Channel::foam});
        const Surface again = ocean.evaluate(time, {Channel::height, Channel::foam});
        for (const Channel channel : {Channel::height, Channel::foam}) {
            EXPECT_EQ(largest_difference(again.channel(channel), expected.channel(channel)), 0.0);
        }
        time += 2.0;
        EXPECT_FALSE(gl::has_current_context());
    }
}

TEST(GlBackend, WhatWasLostWithAHostsContextIsNotTouchedInTheNext) {
    for (const PretendedReset::Told told : kTold) {
        auto first = std::make_unique<gl::HeadlessContext>();
        auto current = std::make_unique<gl::HeadlessContext::Current>(*first);
        const int before = test::count_objects();
        Ocean ocean(foaming_sea(), {.backend = gl::kBackend});
        const Surface expected = ocean.evaluate(1.0, {Channel::height});
        EXPECT_GT(test::count_objects(), before);
        {
            const PretendedReset reset(told);
            expect_reset(ocean);
        }
        EXPECT_EQ(test::count_objects(), before);
        current.reset();
        first.reset();

        const gl::HeadlessContext second;
        const gl::HeadlessContext::Current now(second);
        std::array<GLuint, 32> own{};
        glGenBuffers(32, own.data());
        for (const GLuint name : own) glBindBuffer(GL_ARRAY_BUFFER, name);
        const int of_the_host = test::count_objects();
        const Surface again = ocean.evaluate(1.0, {Channel::height});
        EXPECT_EQ(
            largest_difference(again.channel(Channel::height), expected.channel(Channel::height)),
            0.0);
        EXPECT_GT(test::count_objects(), of_the_host);
        {
            const PretendedReset reset(told);
            expect_reset(ocean);
        }
        EXPECT_EQ(test::count_objects(), of_the_host);
    }
}

/// A lost context compiles nothing, which is no fault of the shader.
TEST(GlBackend, AResetWhileShadersAreCompiledIsToldAsOne) {
    const gl::HeadlessContext host;
    const gl::HeadlessContext::Current current(host);
    Ocean ocean(foaming_sea(), {.backend = gl::kBackend});
    const auto create = epoxy_glCreateShader;
    epoxy_glCreateShader = [](GLenum) { return GLuint{0}; };
    {
        const PretendedReset reset(PretendedReset::Told::by_an_error);
        expect_reset(ocean);
    }
    epoxy_glCreateShader = create;
    while (glGetError() != GL_NO_ERROR) {
    }
    EXPECT_EQ(ocean.evaluate(1.0, {Channel::height}).resolution(), 128);
}

TEST(GlBackend, CopiesHaveContextsOfTheirOwnAndRunInParallel) {
    Ocean first(foaming_sea(), {.backend = gl::kBackend});
    const Surface expected = first.evaluate(1.0, {Channel::height});
    Ocean second(first, {.threads = 1, .backend = gl::kBackend});
    std::vector<std::jthread> threads;
    std::array<Surface, 2> surfaces;
    threads.emplace_back([&] { surfaces[0] = first.evaluate(1.0, {Channel::height}); });
    threads.emplace_back([&] { surfaces[1] = second.evaluate(1.0, {Channel::height}); });
    threads.clear();
    for (const Surface& surface : surfaces) {
        EXPECT_EQ(
            largest_difference(surface.channel(Channel::height), expected.channel(Channel::height)),
            0.0);
    }
    EXPECT_FALSE(gl::has_current_context());
}

TEST(GlBackend, RunsOnTheDriverThatTheTestIsFor) {
    const char* wanted = std::getenv("OCEAN_GL_TEST_RENDERER");
    const gl::HeadlessContext context;
    EXPECT_NE(context.info().renderer.find(wanted == nullptr ? "" : wanted), std::string::npos)
        << context.info().text();
}

/// A driver that computes wrongly is played by a shader that does.
TEST(GlBackend, ADriverThatComputesWronglyIsRefused) {
    const test::TemporaryFolder folder;
    const std::filesystem::path shaders = folder.file("shaders");
    std::filesystem::copy(std::filesystem::path(test::source_dir()) / "shaders", shaders,
                          std::filesystem::copy_options::recursive);
    const auto spoil = [&](const char* file, const std::string& right, const std::string& wrong) {
        const std::filesystem::path path = shaders / file;
        std::string spoilt = test::read_bytes(path);
        const std::size_t at = spoilt.find(right);
        ASSERT_NE(at, std::string::npos) << right;
        std::ofstream(path) << spoilt.replace(at, right.size(), wrong);
    };
    const auto refusal = [&]() -> std::string {
        ::setenv("OCEAN_SHADER_DIR", shaders.c_str(), 1);
        const BackendFitness fitness = gl::kBackend.fitness(64);
        ::unsetenv("OCEAN_SHADER_DIR");
        return fitness.runs ? "" : fitness.reason;
    };
    EXPECT_EQ(refusal(), "");
    const std::string rest = "precise real rest = product_error(rate_high, tau_high, product);";
    spoil("wave/phase.glsl", rest, "precise real rest = 0.0;");
    EXPECT_NE(
        refusal().find("this GPU's driver does not compute as the shaders need it: its phases"),
        std::string::npos);
    spoil("wave/phase.glsl", "precise real rest = 0.0;", rest);
    EXPECT_EQ(refusal(), "");
    spoil("wave/noise.glsl", "round < 10", "round < 9");
    EXPECT_NE(refusal().find("its noise by"), std::string::npos);
}

TEST(GlBackend, SaysWhatItRunsOnAndWhatIsTooMuch) {
    const BackendFitness fitness = gl::kBackend.fitness(512);
    EXPECT_TRUE(fitness.runs) << fitness.reason;
    const gl::HeadlessContext context;
    EXPECT_EQ(fitness.fast, !context.info().software);
    EXPECT_NE(fitness.reason.find(context.info().renderer), std::string::npos);
    if (context.info().storage_block_bytes < 8LL * 8192 * 8192) {
        const BackendFitness large = gl::kBackend.fitness(8192);
        EXPECT_FALSE(large.runs);
        EXPECT_NE(large.reason.find("536870912 bytes"), std::string::npos) << large.reason;
    }
    EXPECT_THROW(gl::HeadlessContext({.device = 63}), Error);
}

}  // namespace
}  // namespace ocean
