// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The kernel of the cpu backend: its codelets, every size and instruction set against transforms in
// double, and bits that do not depend on how a frame is requested.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <random>
#include <utility>

#include "base/simd/simd.hpp"
#include "direct_dft.hpp"
#include "ocean/internal/map_request.hpp"
#include "simd_levels.hpp"
#include "test_seas.hpp"
#include "waves/kernel/frame_parts.hpp"
#include "waves/kernel/frame_task.hpp"
#include "waves/kernel/map_kernel.hpp"
#include "waves/kernel/packed_modes.hpp"
#include "waves/synthesis/mode_grid.hpp"

namespace ocean {
namespace {

using test::kAllChannels;
using test::levels;

TEST(FrameParts, ShareNoFieldAndAreJoinedUpToASize) {
    using enum Linear;
    FrameParts parts;
    parts.add({height});
    parts.add({slope_x, slope_y});
    parts.add({});  // nothing
    parts.add({displacement_x});
    parts.add({gradient_xx, height});
    parts.join(0);
    EXPECT_EQ(parts.count(), 3);
    EXPECT_EQ(parts.of({height}), parts.of({gradient_xx, height}));
    EXPECT_NE(parts.of({height}), parts.of({slope_x}));
    EXPECT_EQ(parts.of({}), 0);
    parts.join(3);  // slopes and the displacement; the others would be five
    EXPECT_EQ(parts.count(), 2);
    EXPECT_EQ(parts.of({slope_y}), parts.of({displacement_x}));
    parts.join(5);
    EXPECT_EQ(parts.count(), 1);
}

TEST(Kernel, EveryCodeletIsTheDirectSumInEveryLane) {
    for (const SimdLevel level : levels()) {
        const KernelCode& code = kernel_code(level);
        const auto lanes = static_cast<std::size_t>(code.lanes);
        for (const int points : {2, 4, 8, 16, 32, 64, 128}) {
            const auto n = static_cast<std::size_t>(points);
            PageVector<float> in(2 * lanes * n);
            PageVector<float> out(in.size());
            std::mt19937 random(7);
            for (float& x : in) x = std::uniform_real_distribution<float>(-1.0f, 1.0f)(random);
            code.codelet(points, in.data(), out.data());
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                std::vector<std::complex<double>> line;
                for (std::size_t j = 0; j < n; ++j) {
                    line.emplace_back(in[2 * j * lanes + lane], in[(2 * j + 1) * lanes + lane]);
                }
                const auto expected = test::direct_dft(line, FftDirection::inverse);
                for (std::size_t k = 0; k < n; ++k) {
                    EXPECT_NEAR(out[2 * k * lanes + lane], expected[k].real(), 3e-7 * points);
                    EXPECT_NEAR(out[(2 * k + 1) * lanes + lane], expected[k].imag(), 3e-7 * points);
                }
            }
        }
    }
}

std::vector<Linear> all_fields() {
    std::vector<Linear> fields;
    for (int f = 0; f < kLinearCount; ++f) fields.push_back(static_cast<Linear>(f));
    return fields;
}

/// The linear fields of a map by a full transform in double.
std::vector<float> exact_plane(const MapModes& modes, Linear field) {
    auto grid = coefficient_grid<double>(modes, field);
    Radix2Fft<double>(modes.resolution).transform_2d(grid, FftDirection::inverse);
    std::vector<float> plane;
    for (const auto& value : grid) plane.push_back(static_cast<float>(value.real()));
    return plane;
}

struct Planes {
    std::vector<PageVector<float>> plane;
    std::vector<MapOutput> outputs;

    Planes(int resolution, std::span<const Linear> fields) {
        for (const Linear field : fields) {
            plane.emplace_back(Lattice{resolution, 1.0}.size(), -1.0f);
            outputs.push_back({plane.back().data(), 1, {{{field, 1.0f}}}});
        }
    }
};

void expect_exact(const MapModes& modes, const std::string& what) {
    const std::vector<Linear> fields = all_fields();
    std::vector<std::vector<float>> exact;
    for (const Linear field : fields) exact.push_back(exact_plane(modes, field));
    for (const SimdLevel level : levels()) {
        Planes planes(modes.resolution, fields);
        MapKernel(pack_modes(modes, test::pool(), level))
            .run({modes.tau, {}, planes.outputs, {}}, test::pool());
        for (std::size_t f = 0; f < fields.size(); ++f) {
            EXPECT_LT(test::relative_error(planes.plane[f], exact[f]), 5e-7)
                << what << ", " << simd_name(level) << ", N = " << modes.resolution << ", field "
                << f;
        }
    }
}

TEST(Kernel, EverySizeOnEveryInstructionSetIsTheTransformInDouble) {
    for (const int size : {32, 64, 128, 256, 512, 1024}) {
        Parameters parameters = test::wind_sea(size, 400.0, {.depth = 30.0});
        const Modes modes = test::modes_of(parameters);
        expect_exact(map_modes(modes, 1e6, size), "own map");
    }
}

TEST(Kernel, LargeSizesAreTheTransformInDouble) {
    // Few modes, so that the judge stays quick: the sizes beyond are zero padding to the kernel.
    const Parameters parameters = test::wind_sea(64, 100.0);
    const Modes modes = test::modes_of(parameters);
    const std::vector<Linear> fields = {Linear::height, Linear::gradient_xy};
    for (const int size : {2048, 4096}) {
        const MapModes request = map_modes(modes, 12.0, size);
        for (const SimdLevel level : levels()) {
            Planes planes(size, fields);
            MapKernel(pack_modes(request, test::pool(), level))
                .run({request.tau, {}, planes.outputs, {}}, test::pool());
            // The coarse map is every so manieth sample of the fine one.
            const MapModes coarse = map_modes(modes, 12.0, 64);
            for (std::size_t f = 0; f < fields.size(); ++f) {
                std::vector<float> picked;
                for (const auto [i, j] : test::pairs(64, 64)) {
                    picked.push_back(
                        planes.plane[f][static_cast<std::size_t>((j * size + i) * (size / 64))]);
                }
                EXPECT_LT(test::relative_error(picked, exact_plane(coarse, fields[f])), 5e-7)
                    << size << ' ' << simd_name(level);
            }
        }
    }
}

TEST(PackedModes, OtherAmplitudesOfALatticeArePackedAsIfFromNothing) {
    for (const int cascades : {1, 2}) {
        Ocean sea(test::wind_sea(64, 200.0, {.wind = 12.0, .cascades = cascades}), {.threads = 1});
        const Modes before = sea.modes();
        sea.set("waves.0.wind_speed", "7");
        const Modes& after = sea.modes();
        ASSERT_EQ(before.lattice_revision, after.lattice_revision);
        for (const SimdLevel level : levels()) {
            for (const int resolution : {32, 64, 128}) {  // cuts, holds and pads the modes
                const MapModes modes = map_modes(after, 2.0, resolution);
                const auto packed = std::make_shared<PackedModes>(
                    map_modes(before, 2.0, resolution), test::pool(), level);
                ASSERT_TRUE(packed->refill(modes, test::pool()));
                const auto heights = [&](std::shared_ptr<const PackedModes> of) {
                    PageVector<float> map(Lattice{resolution, 1.0}.size());
                    const MapOutput output{map.data(), 1, {{{Channel::height, 1.0f}}}};
                    MapKernel(std::move(of)).run({modes.tau, {}, {&output, 1}, {}}, test::pool());
                    return map;
                };
                const auto fresh = std::make_shared<PackedModes>(modes, test::pool(), level);
                EXPECT_EQ(heights(packed), heights(fresh))
                    << simd_name(level) << ", " << resolution << ", " << cascades;
            }
        }
    }
}

TEST(PackedModes, AnotherPatchOfTheSameSizeHasWavenumbersOfItsOwn) {
    Ocean sea(test::wind_sea(64, 200.0), {.threads = 1});
    const Surface before = sea.evaluate(1.0, {Channel::height, Channel::nx});
    sea.set("grid.patch_size", "300");
    Ocean fresh(test::wind_sea(64, 300.0), {.threads = 1});
    const Surface expected = fresh.evaluate(1.0, {Channel::height, Channel::nx});
    EXPECT_TRUE(test::same_bits(sea.evaluate(1.0, {Channel::height, Channel::nx}), expected));
    EXPECT_FALSE(test::same_bits(before, expected));
}

TEST(Kernel, MapsThatCutOrPadTheModesAndMapsOfCascadesAreExactToo) {
    Parameters parameters = test::wind_sea(64, 400.0);
    const Modes one = test::modes_of(parameters);
    expect_exact(map_modes(one, 3.0, 32), "cut");
    expect_exact(map_modes(one, 3.0, 256), "padded");
    parameters.grid.cascades = 3;
    const Modes three = test::modes_of(parameters);
    expect_exact(map_modes(three, 3.0, 512), "three cascades");
    expect_exact(cascade_modes(three, 2, 3.0, 64), "small map");
}

/// A sea with every kind of output, and one frame of it.
class KernelFrames : public testing::Test {
  protected:
    static constexpr int kSize = 128;
    ThreadPool pool_{2};
    Parameters parameters_ = test::wind_sea(kSize, 150.0);
    Modes modes_ = test::modes_of(parameters_);
    MapModes request_ = map_modes(modes_, 77.7, kSize);

    /// Every channel that has no past, planar, one after the other.
    std::vector<PageVector<float>> channels(SimdLevel level, int threads,
                                            const CacheSizes& caches = cache_sizes()) {
        ThreadPool pool(threads);
        std::vector<PageVector<float>> maps;
        std::vector<MapOutput> outputs;
        for (int c = 0; c < kChannelCount; ++c) {
            maps.emplace_back(modes_.lattice.size(), -7.0f);
            const auto channel = static_cast<Channel>(c);
            if (channel == Channel::foam) continue;
            outputs.push_back({maps.back().data(), 1, {{{channel, 1.0f}}}});
        }
        run(level, outputs, pool, {}, caches);
        return maps;
    }

    void run(SimdLevel level, std::span<const MapOutput> outputs, ThreadPool& pool,
             FoamLayer foam = {}, const CacheSizes& caches = cache_sizes()) {
        SurfaceSettings settings = parameters_.surface;
        settings.foam_threshold = 0.7;
        MapKernel(pack_modes(request_, pool, level), caches)
            .run({request_.tau, settings, outputs, foam}, pool);
    }
};

constexpr std::size_t kEndless = std::size_t{1} << 40;
/// Outputs are stored past the one and through the other.
constexpr CacheSizes kNoCaches{0, 0}, kLargeCaches{kEndless, kEndless};

TEST_F(KernelFrames, HaveTheSameBitsForAnySizesOfCaches) {
    for (const SimdLevel level : levels()) {
        const auto whole = channels(level, 1, kLargeCaches);
        EXPECT_EQ(channels(level, 1, kNoCaches), whole);
        EXPECT_EQ(channels(level, 2, {0, kEndless}), whole);
        EXPECT_EQ(channels(level, 2, {std::size_t{96} << 10, 0}), whole);
    }
}

TEST_F(KernelFrames, HaveTheSameBitsIfTheirStripsAreSweptAFewAtATime) {
    constexpr float kUnwritten = -7.0f;
    const auto output_to = [](PageVector<float>& map) {
        using enum Channel;
        return MapOutput{map.data(), 4, {{{dx}, {dy}, {height}, {vz}}}};
    };
    PageVector<float> whole(4 * modes_.lattice.size());
    PageVector<float> map(whole.size());
    const MapOutput to_whole = output_to(whole), to_map = output_to(map);
    for (const SimdLevel level : levels()) {
        for (const CacheSizes& caches : {kNoCaches, kLargeCaches}) {
            run(level, {&to_whole, 1}, pool_, {}, caches);
            std::ranges::fill(map, kUnwritten);
            MapKernel kernel(pack_modes(request_, pool_, level), caches);
            kernel.begin({request_.tau, parameters_.surface, {&to_map, 1}, {}}, pool_);
            PageVector<float> scratch(kernel.scratch_floats());
            using Strips = std::array<std::uint8_t, kSize / 32>;
            ASSERT_EQ(kernel.strip_width(), 32);
            Strips written{};
            for (const Strips& sweep :
                 {Strips{0, 0, 1, 0}, Strips{1, 0, 0, 0}, Strips{0, 1, 0, 1}}) {
                kernel.sweep(sweep, sweep[0] != 0 ? nullptr : &pool_);
                for (std::size_t strip = 0; strip < sweep.size(); ++strip) {
                    if (sweep[strip] == 0) continue;
                    kernel.write_strip(static_cast<int>(strip), scratch.data());
                    written[strip] = 1;
                }
                for (std::size_t i = 0; i < map.size(); ++i) {
                    const bool is_written = written[i / 4 % kSize / 32] != 0;
                    ASSERT_EQ(map[i], is_written ? whole[i] : kUnwritten)
                        << simd_name(level) << ", " << i;
                }
            }
        }
    }
}

TEST_F(KernelFrames, HaveTheSameBitsForAnyNumberOfThreads) {
    for (const SimdLevel level : levels()) {
        const auto one = channels(level, 1);
        for (const int threads : {2, 3, 7}) EXPECT_EQ(channels(level, threads), one);
    }
}

TEST(Kernel, MachinesWithoutFusedProductsRoundThemOnceToo) {
    // Any bits, and products whose sum lies next to the middle of two floats.
    std::mt19937 random(5);
    const auto any_float = [&] {
        return std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    };
    for (int i = 0; i < 300000; ++i) {
        float a = any_float(), b = any_float(), c = any_float();
        if (i % 2 == 0) {
            a = 1.0f + std::ldexp(static_cast<float>(random() % 64), -23);
            b = 1.0f + std::ldexp(static_cast<float>(random() % 64), -23);
            c = std::ldexp(static_cast<float>(random() % 3) - 1.0f,
                           -static_cast<int>(random() % 90));
        } else if (i % 3 == 0) {
            a = std::ldexp(a, -60);  // often subnormal
        }
        const float sum = OCEAN_KERNEL::fma(a, b, c).v[0], expected = std::fma(a, b, c);
        if (std::isnan(expected)) {
            EXPECT_TRUE(std::isnan(sum));
        } else {
            ASSERT_EQ(std::bit_cast<std::uint32_t>(sum), std::bit_cast<std::uint32_t>(expected))
                << a << " " << b << " " << c;
        }
    }
}

TEST(Kernel, PowersAreThoseOfDouble) {
    for (int i = 1; i <= 4000; ++i) {
        const float x = static_cast<float>(i) / 4000.0f;
        for (const float y : {0.01f, 0.5f, 1.0f, 3.7f, 8.0f}) {
            const double expected = std::pow(static_cast<double>(x), static_cast<double>(y));
            if (expected < 1e-30) continue;
            const float power = OCEAN_KERNEL::pow(x, y).v[0];
            ASSERT_NEAR(static_cast<double>(power) / expected, 1.0, 2.5e-6) << x << "^" << y;
        }
    }
}

TEST_F(KernelFrames, HaveTheSameBitsOnAllMachines) {
    const auto plain = channels(SimdLevel::portable, 1);
    for (const SimdLevel level : levels()) {
        SCOPED_TRACE(simd_name(level));
        EXPECT_EQ(channels(level, 1), plain);
    }
}

TEST_F(KernelFrames, HaveTheSameBitsInAnySubsetAndAnyLayout) {
    using enum Channel;
    const std::vector<std::vector<Quantity>> requests = {
        {height},
        {nx, ny, nz},
        {dx, dy, height},
        {whitecap},
        {vx, vy, vz},
        {slope_y, slope_x},
        {jacobian, height},
        {dx, dy, height, whitecap},
        {nz, nz, height, dx},
        {height, {}, jacobian},
        {{}, ny},
    };
    // Where a buffer begins within a line of the cache, and gaps between its rows.
    const std::vector<std::pair<std::size_t, std::size_t>> layouts = {
        {0, 0}, {1, 0}, {4, 0}, {8, 0}, {15, 0}, {0, 16}, {4, 12}, {3, 5}};
    for (const SimdLevel level : levels()) {
        const auto planar = channels(level, 1);
        for (const auto& quantities : requests) {
            const auto expected = [&](std::size_t sample, std::size_t c) {
                if (quantities[c] == Quantity{}) return -7.0f;
                return planar[static_cast<std::size_t>(quantities[c].id)][sample];
            };
            for (const auto& [offset, gap] : layouts) {
                const std::size_t n = quantities.size(), pitch = n * kSize + gap;
                PageVector<float> whole(kSize * pitch + 64, -7.0f);
                for (std::size_t i = 0; i < modes_.lattice.size(); ++i) {
                    float* const sample = &whole[offset + i / kSize * pitch + i % kSize * n];
                    for (std::size_t c = 0; c < n; ++c) sample[c] = expected(i, c);
                }
                for (const CacheSizes& caches : {kNoCaches, kLargeCaches}) {
                    PageVector<float> buffer(whole.size(), -7.0f);
                    MapOutput output{buffer.data() + offset, static_cast<int>(n), {}, pitch};
                    for (std::size_t c = 0; c < n; ++c) output.component[c] = {quantities[c], 1.0f};
                    run(level, {&output, 1}, pool_, {}, caches);
                    ASSERT_EQ(buffer, whole) << simd_name(level) << ", " << n << " components "
                                             << offset << " floats behind a line, " << gap
                                             << " between rows, caches of " << caches.shared;
                }
            }
        }
    }
}

TEST_F(KernelFrames, OfManyOutputsAreWhole) {
    std::vector<PageVector<float>> maps;
    std::vector<MapOutput> outputs;
    for (int i = 0; i < 3 * kMaxOutputs / 2; ++i) {
        maps.emplace_back(modes_.lattice.size(), -7.0f);
        outputs.push_back({maps.back().data(), 1, {{{Channel::height, 1.0f}}}});
    }
    run(simd_level(), outputs, pool_);
    for (const auto& map : maps) EXPECT_EQ(map, maps.front());
    EXPECT_EQ(maps.front(), channels(simd_level(), 1)[static_cast<std::size_t>(Channel::height)]);
}

TEST_F(KernelFrames, FollowFoamFromTheMapBefore) {
    for (const SimdLevel level : levels()) {
        const auto planar = channels(level, 1);
        const auto& whitecap = planar[static_cast<int>(Channel::whitecap)];
        PageVector<float> before(whitecap.size());
        for (std::size_t i = 0; i < before.size(); ++i) {
            before[i] = static_cast<float>(i % 17) / 16.0f;
        }
        for (const CacheSizes& caches : {kNoCaches, kLargeCaches}) {
            PageVector<float> foam = before;
            const MapOutput output{foam.data(), 1, {{{Channel::foam, 1.0f}}}};
            run(level, {&output, 1}, pool_, {foam.data(), 0.5f, 0.1f}, caches);
            for (std::size_t i = 0; i < foam.size(); ++i) {
                const float value = std::max(whitecap[i], 0.5f * before[i]);
                ASSERT_EQ(foam[i], value < 0.1f ? 0.0f : value) << simd_name(level) << " at " << i;
            }
        }
    }
}

TEST_F(KernelFrames, CoverIsFoamToItsPower) {
    for (const SimdLevel level : levels()) {
        for (const float power : {0.5f, 1.0f, 2.8f, 3.35f, 8.0f}) {
            PageVector<float> foam(modes_.lattice.size());
            PageVector<float> cover(foam.size());
            for (std::size_t i = 0; i < foam.size(); ++i) {
                foam[i] = static_cast<float>(i % 1025) / 1024.0f;
            }
            const PageVector<float> before = foam;
            const MapOutput outputs[] = {{foam.data(), 1, {{{Channel::foam, 1.0f}}}},
                                         {cover.data(), 1, {{{Channel::cover, 1.0f}}}}};
            run(level, outputs, pool_, {before.data(), 1.0f, 0.002f, power});
            bool none = false, whole = false;
            for (std::size_t i = 0; i < foam.size(); ++i) {
                const double exact = std::pow(static_cast<double>(foam[i]), double{power});
                ASSERT_NEAR(cover[i], exact, 2e-6 * exact) << simd_name(level) << ' ' << foam[i];
                none |= foam[i] == 0.0f;
                whole |= foam[i] == 1.0f;
            }
            EXPECT_TRUE(none && whole);
        }
    }
}

TEST_F(KernelFrames, WithoutChoppinessNeedNoGradients) {
    parameters_.surface.choppiness = 0.0;
    const auto with_jacobian = channels(simd_level(), 1);
    for (std::size_t i = 0; i < modes_.lattice.size(); ++i) {
        const float hx = with_jacobian[static_cast<int>(Channel::slope_x)][i];
        const float hy = with_jacobian[static_cast<int>(Channel::slope_y)][i];
        const float nz = with_jacobian[static_cast<int>(Channel::nz)][i];
        ASSERT_NEAR(nz, 1.0f / std::sqrt(1.0f + hx * hx + hy * hy), 1e-6);
        ASSERT_EQ(with_jacobian[static_cast<int>(Channel::jacobian)][i], 1.0f);
    }
}

TEST_F(KernelFrames, AreMadeOfPlanesByTheSameFormulas) {
    for (const SimdLevel level : levels()) {
        const std::vector<Linear> fields = all_fields();
        Planes planes(kSize, fields);
        run(level, planes.outputs, pool_);
        PlanarFields rows{{}, kSize};
        for (std::size_t f = 0; f < fields.size(); ++f) rows.plane[f] = planes.plane[f].data();
        PageVector<float> normal(3 * modes_.lattice.size());
        PageVector<float> expected(normal.size());
        const auto output = [](PageVector<float>& to) {
            return MapOutput{
                to.data(), 3, {{{Channel::nx, 1.0f}, {Channel::ny, -1.0f}, {Channel::nz, 1.0f}}}};
        };
        const MapOutput from_rows = output(normal);
        const MapOutput from_modes = output(expected);
        run(level, {&from_modes, 1}, pool_);
        write_rows(rows, kSize, 0, kSize, {0.0, parameters_.surface, {&from_rows, 1}, {}}, level);
        EXPECT_EQ(normal, expected) << simd_name(level);
    }
}

}  // namespace
}  // namespace ocean
