// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: a particle of spray keeps its id, its end and its size from frame to frame, across the
// seam of a loop too; a frame alone has the bits of the sequence; there are as many particles as
// turn white; drops fly as drops do.
#include "ocean/spray.hpp"

#include <bit>
#include <set>

#include "ocean/internal/foam.hpp"
#include "refusal.hpp"
#include "test_beds.hpp"
#include "test_seas.hpp"
#include "waves/spray/spray_birth.hpp"
#include "waves/spray/spray_flight.hpp"

namespace ocean {
namespace {

using Particles = std::vector<SprayParticle>;

Parameters windy_sea(double wind = 20.0, int resolution = 128, double patch = 160.0) {
    return test::wind_sea(resolution, patch, {.wind = wind, .choppiness = 1.2});
}

Particles spray_of(Ocean& sea, double frame, const SpraySettings& settings = {}) {
    return sea.spray(sea.sea().time_of(frame), settings);
}

std::map<std::uint64_t, SprayParticle> by_id(const Particles& particles) {
    std::map<std::uint64_t, SprayParticle> found;
    for (const SprayParticle& particle : particles) {
        EXPECT_TRUE(found.emplace(particle.id, particle).second) << "an id is there twice";
    }
    return found;
}

/// All bits: a particle has no padding.
bool equal(const Particles& a, const Particles& b) {
    static_assert(sizeof(SprayParticle) == 10 * sizeof(double));
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(a.front())) == 0);
}

/// Checks two frames dt apart: particles that have not ended are present, new ones were just born.
void expect_to_go_on(const Particles& first, const Particles& second, double dt) {
    const auto before = by_id(first);
    const auto after = by_id(second);
    EXPECT_GT(before.size(), 50u) << "there is spray to compare";
    constexpr double kRounding = 1e-9;
    for (const auto& [id, particle] : before) {
        EXPECT_GE(particle.age, 0.0);
        const auto found = after.find(id);
        if (found == after.end()) {
            EXPECT_GE(particle.age + dt, particle.life - kRounding) << "it has not ended";
            continue;
        }
        EXPECT_LT(particle.age + dt, particle.life + kRounding) << "it has ended";
        EXPECT_NEAR(found->second.age, particle.age + dt, kRounding);
        EXPECT_EQ(found->second.life, particle.life);
        EXPECT_EQ(found->second.radius, particle.radius);
        const double way = std::hypot(found->second.x - particle.x, found->second.y - particle.y,
                                      found->second.z - particle.z);
        EXPECT_LT(way, 60.0 * dt) << "no wind is that fast";
    }
    for (const auto& [id, particle] : after) {
        EXPECT_TRUE(before.contains(id) || particle.age <= dt + kRounding) << "born unseen";
    }
}

TEST(Spray, LivesOnFromFrameToFrameUntilItsEnd) {
    for (const double fps : {24.0, 60.0}) {
        Parameters parameters = windy_sea();
        parameters.time.fps = fps;
        Ocean sea(parameters, {.threads = 1});
        for (int frame = 100; frame < 124; ++frame) {
            expect_to_go_on(spray_of(sea, frame), spray_of(sea, frame + 1), 1.0 / fps);
        }
    }
}

TEST(Spray, ALoopsLastFrameRunsIntoItsFirst) {
    Parameters parameters = windy_sea();
    parameters.time.loop_period = 3.0;
    Ocean sea(parameters, {.threads = 1});
    const int frames = 72;
    for (const int frame : {frames - 1, frames, frames + 1}) {
        expect_to_go_on(spray_of(sea, frame), spray_of(sea, frame % frames + 1), 1.0 / 24.0);
        expect_to_go_on(spray_of(sea, frame), spray_of(sea, frame + 1), 1.0 / 24.0);
    }
    const auto now = by_id(spray_of(sea, 5));
    const auto next_time = by_id(spray_of(sea, 5 + frames));
    ASSERT_EQ(now.size(), next_time.size());
    for (const auto& [id, particle] : now) {
        ASSERT_TRUE(next_time.contains(id));
        EXPECT_NEAR(next_time.at(id).x, particle.x, 1e-9);
        EXPECT_NEAR(next_time.at(id).vz, particle.vz, 1e-9);
    }
    // A loop that is shorter than a particle may live.
    parameters.time.loop_period = 1.0;
    Ocean brief(parameters, {.threads = 1});
    for (const int frame : {1, 23, 24}) {
        expect_to_go_on(spray_of(brief, frame), spray_of(brief, frame + 1), 1.0 / 24.0);
    }
    for (const SprayParticle& particle : spray_of(brief, 7)) EXPECT_LE(particle.life, 0.5);
}

TEST(Spray, AFrameAloneHasTheBitsOfTheSequence) {
    const Parameters parameters = windy_sea();
    Ocean alone(parameters, {.threads = 1});
    const Particles expected = spray_of(alone, 200);
    ASSERT_GT(expected.size(), 50u);

    const auto from = [&](int first, int threads, int step) {
        Ocean sea(parameters, {.threads = threads});
        Particles spray;
        for (int frame = first; frame != 200 + step; frame += step) spray = spray_of(sea, frame);
        return spray;
    };
    EXPECT_TRUE(equal(from(180, 1, 1), expected));
    EXPECT_TRUE(equal(from(190, 2, 1), expected));
    EXPECT_TRUE(equal(from(100, 2, 50), expected)) << "with gaps";
    EXPECT_TRUE(equal(from(230, 2, -1), expected)) << "backwards";

    Ocean busy(parameters, {.threads = 2});
    busy.evaluate(7.0, {Channel::foam, Channel::height}, 64);
    spray_of(busy, 199, {.density = 1.0});
    EXPECT_TRUE(equal(spray_of(busy, 200), expected)) << "beside other work and settings";
    Parameters slower = parameters;
    slower.time.fps = 12.0;
    Ocean other(slower, {.threads = 1});
    EXPECT_TRUE(equal(other.spray(parameters.time.start + 199.0 / 24.0), expected));
}

/// A beach that rises to the east, 1:24 from 8 m of water to 2 m of land, in a wind that makes few
/// whitecaps.
Parameters windy_beach() {
    Parameters parameters = windy_sea(9.5, 64, 240.0);
    parameters.surface.choppiness = 1.0;
    parameters.surface.foam_step = 0.1;
    parameters.water.depth = 8.0;
    return test::over(parameters,
                      test::bed_of(121, 41, 2.0, [](double x, double) { return x / 24.0 - 8.0; }));
}

TEST(Spray, OverABedTheFrontsOfBreakingWavesHaveIt) {
    const Parameters parameters = windy_beach();
    const SpraySettings settings{.lifetime = 0.5, .density = 200.0};
    Ocean sea(parameters, {.threads = 1});
    const Particles alone = spray_of(sea, 60, settings);
    std::size_t offshore = 0, surf = 0;
    for (const SprayParticle& particle : alone) {
        // Near where it was born: gusts carry it some metres, and to both sides.
        const float bed = bed_height(*parameters.water.bed, particle.x - particle.vx * particle.age,
                                     particle.y - particle.vy * particle.age);
        EXPECT_LT(bed, 0.0f) << "swash has no spray";
        offshore += bed < -4.0f ? 1u : 0u;
        surf += bed > -2.5f ? 1u : 0u;
    }
    // The surf is 1.3 to 2.5 m deep: 29 m wide, and the sea offshore 96 m.
    EXPECT_GT(surf, 100u);
    EXPECT_GT(static_cast<double>(surf) / 29.0, 3.0 * static_cast<double>(offshore) / 96.0)
        << surf << " in the surf, " << offshore << " offshore";

    Ocean busy(parameters, {.threads = 2});
    for (int frame = 57; frame < 60; ++frame) spray_of(busy, frame, settings);
    busy.region(1.0, {{100.0, 10.0}, {60.0, 40.0}, {31, 21}, false}, Channel::height);
    EXPECT_TRUE(equal(spray_of(busy, 60, settings), alone)) << "in a sequence, on two threads";
}

TEST(Spray, ASequencePaysForNewTicksAlone) {
    Ocean sea(windy_sea(), {.threads = 1});
    spray_of(sea, 100);
    const int first = sea.stage_runs().spray_ticks;
    EXPECT_EQ(first, 40 + 2 + 1) << "2 s of 0.05 s, and the tick before them";
    for (int frame = 101; frame <= 124; ++frame) spray_of(sea, frame);
    EXPECT_EQ(sea.stage_runs().spray_ticks - first, 20);
    spray_of(sea, 123);
    EXPECT_EQ(sea.stage_runs().spray_ticks - first, 20) << "a step back is free";
    sea.set("wind_speed", "12");
    spray_of(sea, 124);
    EXPECT_EQ(sea.stage_runs().spray_ticks - first, 20 + 43) << "another sea has its own";
}

TEST(Spray, ItsVelocityIsTheDerivativeOfItsPlace) {
    Ocean sea(windy_sea(), {.threads = 1});
    constexpr double kStep = 1e-4;
    const auto before = by_id(sea.spray(9.0 - kStep));
    const auto after = by_id(sea.spray(9.0 + kStep));
    int compared = 0;
    for (const SprayParticle& now : sea.spray(9.0)) {
        if (!before.contains(now.id) || !after.contains(now.id)) continue;
        const SprayParticle& a = before.at(now.id);
        const SprayParticle& b = after.at(now.id);
        // The drag of the smallest drops acts within 5 ms.
        EXPECT_NEAR((b.x - a.x) / (2 * kStep), now.vx, 2e-2);
        EXPECT_NEAR((b.y - a.y) / (2 * kStep), now.vy, 2e-2);
        EXPECT_NEAR((b.z - a.z) / (2 * kStep), now.vz, 2e-2);
        ++compared;
    }
    EXPECT_GT(compared, 50);
}

/// Square metres of the lattice that turn white at a tick.
double new_white(Ocean& sea, std::int64_t tick) {
    const Lattice lattice = spray_lattice(sea.parameters().grid);
    const FoamClock clock = foam_clock(sea.parameters().surface, 0.0);
    const auto map = [&](std::int64_t n) {
        return sea.evaluate(clock.time_of(n), {Channel::whitecap}, lattice.resolution);
    };
    const Surface before = map(tick - 1), now = map(tick);
    int count = 0;
    for (std::size_t i = 0; i < lattice.size(); ++i) {
        count += now.channel(Channel::whitecap)[i] > 0.5f &&
                 before.channel(Channel::whitecap)[i] <= 0.5f;
    }
    return count * std::pow(lattice.period / lattice.resolution, 2);
}

TEST(Spray, ThereIsAsMuchAsTurnsWhite) {
    for (const double wind : {9.0, 12.0, 20.0, 30.0}) {
        Ocean sea(windy_sea(wind), {.threads = 2});
        const SpraySettings settings{.lifetime = 0.5, .density = 3.0};
        double expected = 0.0, born = 0.0, dense = 0.0;
        for (std::int64_t tick = 200; tick < 220; ++tick) {
            expected += settings.density * spume_onset(wind) * new_white(sea, tick);
            const double end = 0.05 * static_cast<double>(tick + 1) - 1e-6;  // all of it are born
            const auto young = [&](const SpraySettings& asked) {
                const Particles all = sea.spray(end, asked);
                EXPECT_LE(all.size(), max_spray_particles(sea.sea(), asked)) << wind;
                return static_cast<double>(
                    std::ranges::count_if(all, [](const auto& p) { return p.age < 0.05 - 1e-6; }));
            };
            born += young(settings);
            dense += young({.lifetime = 0.5, .density = 6.0});
        }
        ASSERT_GT(expected, 100.0) << wind;
        EXPECT_LT(born, expected + 4.0 * std::sqrt(expected)) << wind;
        EXPECT_GT(born, 0.8 * expected) << wind << ": some fall at once";
        EXPECT_NEAR(dense, 2.0 * born, 8.0 * std::sqrt(expected)) << "twice the density";
    }
}

TEST(Spray, ACalmSeaHasNone) {
    for (const double wind : {0.0, 6.9}) {
        Parameters parameters = windy_sea(wind);
        parameters.surface.foam_coverage = FoamCoverage::threshold;  // white crests even so
        Ocean sea(parameters, {.threads = 1});
        EXPECT_TRUE(sea.spray(5.0).empty()) << wind;
        EXPECT_EQ(max_spray_particles(sea.sea(), {}), 0u);
    }
    EXPECT_EQ(spume_onset(7.0), 0.0);
    EXPECT_EQ(spume_onset(9.0), 0.5);
    EXPECT_EQ(spume_onset(11.0), 1.0);
    EXPECT_EQ(spume_onset(40.0), 1.0);
    Ocean sea(windy_sea(), {.threads = 1});
    EXPECT_TRUE(sea.spray(5.0, {.density = 0.0}).empty());
}

TEST(Spray, NoMoreThanAskedForAndEverywhereAlike) {
    Ocean sea(windy_sea(25.0), {.threads = 1});
    const SpraySettings settings{.density = 20.0};
    const Particles all = sea.spray(9.0, settings);
    ASSERT_GT(all.size(), 4000u);
    SpraySettings few = settings;
    few.most = 1000;
    const Particles thinned = sea.spray(9.0, few);
    EXPECT_LT(thinned.size(), 1100u);
    EXPECT_GT(thinned.size(), 400u);
    const auto share = [](const Particles& particles) {
        const auto south = std::ranges::count_if(particles, [](const auto& p) { return p.y < 80; });
        return static_cast<double>(south) / static_cast<double>(particles.size());
    };
    EXPECT_NEAR(share(thinned), share(all), 0.1);
    EXPECT_EQ(max_spray_particles(sea.sea(), few), 1000u);
    for (const SpraySettings& wrong : {SpraySettings{.lifetime = 0.0},
                                       {.lifetime = 11.0},
                                       {.density = -1.0},
                                       {.density = std::nan("")},
                                       {.most = 0}}) {
        EXPECT_THROW(sea.spray(9.0, wrong), Error);
    }
}

TEST(Spray, ItsLatticeIsTheSeasOwn) {
    const auto lattice = [](double patch, int resolution, int cascades = 1) {
        return spray_lattice({resolution, patch, cascades, {}}).resolution;
    };
    EXPECT_EQ(lattice(500.0, 512), 256);
    EXPECT_EQ(lattice(1200.0, 512), 512);
    EXPECT_EQ(lattice(1900.0, 512), 512);
    EXPECT_EQ(lattice(4000.0, 512, 3), 1024);
    EXPECT_EQ(lattice(20.0, 512), 64);
    EXPECT_EQ(lattice(4000.0, 256), 256) << "the map holds no shorter waves";
}

TEST(Spray, IdsTellEverythingApart) {
    std::set<std::uint64_t> ids;
    for (const std::uint32_t seed : {0u, 1u, 4294967295u}) {
        for (const std::int64_t tick : {-2, -1, 0, 1, 77}) {
            for (std::uint32_t cell = 0; cell < 50; ++cell) {
                for (std::uint32_t k = 0; k < 4; ++k) ids.insert(spray_id(seed, tick, cell, k));
            }
        }
    }
    EXPECT_EQ(ids.size(), 3u * 5u * 50u * 4u);
    // Each half of them by itself is spread evenly.
    int low = 0, high = 0;
    for (const std::uint64_t id : ids) {
        low += static_cast<int>(id >> 31 & 1);
        high += static_cast<int>(id >> 63);
    }
    EXPECT_NEAR(low, 1500, 150);
    EXPECT_NEAR(high, 1500, 150);
    // The finaliser of the reference: splitmix64 from the state 0.
    EXPECT_EQ(scramble(0x9E3779B97F4A7C15u), 0xE220A8397B1DCDAFu);
}

/// A lattice at rest that has turned white all over.
Surface white_map(int resolution, double period) {
    Surface map(Lattice{resolution, period}, 0.0, kSprayChannels);
    for (int c = 0; c < kChannelCount; ++c) std::ranges::fill(map.channel(Channel(c)), 0.0f);
    std::ranges::fill(map.channel(Channel::whitecap), 1.0f);
    return map;
}

TEST(Spray, IsTornOffAlongTheWindAndUpwards) {
    constexpr int kSide = 128;
    const Surface map = white_map(kSide, 128.0);
    const std::vector<std::uint8_t> dark(map.channel(Channel::dx).size(), 0);
    const SprayAir air{20.0, kPi / 3.0, 9.81};
    const SprayTick tick{7, 3, 0.05, 2.0, 1.0, 1e9, air};
    const std::vector<SprayBirth> births = births_of(tick, map, dark);
    ASSERT_EQ(births.size(), static_cast<std::size_t>(kSide * kSide)) << "one a square metre";
    EXPECT_TRUE(births_of(tick, map, white_cells(map)).empty()) << "what was white bears none";

    test::SampleMean along, across, up, wind, early, x, y, square;
    for (std::size_t i = 0; i < births.size(); ++i) {
        const SprayBirth& birth = births[i];
        const auto turned = [&](const Vector3& v) {
            return std::pair(v[0] * 0.5 + v[1] * std::sqrt(0.75),
                             v[1] * 0.5 - v[0] * std::sqrt(0.75));
        };
        const auto [forward, sideways] = turned(birth.velocity);
        EXPECT_GE(forward, 0.0);
        EXPECT_GE(birth.velocity[2], 0.0);
        along.add(forward);
        across.add(sideways);
        up.add(birth.velocity[2]);
        wind.add(turned(birth.drift).first - forward);
        early.add(birth.since);
        x.add(birth.place[0] - static_cast<double>(i % kSide));
        square.add(std::pow(birth.place[0] - static_cast<double>(i % kSide), 2));
        y.add(birth.place[1] - static_cast<double>(i / kSide));
        EXPECT_LT(birth.since, 0.05);
    }
    // u* = 20 sqrt(1.79e-3), half a Gaussian has the mean sqrt(2/pi) sd.
    const double friction = 20.0 * std::sqrt(1.79e-3);
    EXPECT_NEAR(friction_velocity(20.0), friction, 1e-12);
    const double half = std::sqrt(2.0 / kPi);
    EXPECT_NEAR(along.mean(), half * 2.39 * friction, 0.03);
    EXPECT_NEAR(across.mean(), 0.0, 0.05);
    EXPECT_NEAR(up.mean(), half * 1.25 * friction, 0.02);
    EXPECT_NEAR(wind.mean(), 20.0 - friction / 0.4 * std::log(10.0), 1e-9);
    // Anywhere in its cell, any time in its step.
    EXPECT_NEAR(early.mean(), 0.025, 0.0005);
    EXPECT_NEAR(x.mean(), 0.0, 0.01);
    EXPECT_NEAR(square.mean(), 1.0 / 12.0, 0.002);
    EXPECT_NEAR(y.mean(), 0.0, 0.01);
}

TEST(Spray, IsBornOnTheMovingSurface) {
    Surface map = white_map(64, 64.0);
    const auto fill = [&](Channel channel, double of_x, double of_y) {
        for (std::size_t i = 0; i < 64 * 64; ++i) {
            map.channel(channel)[i] = static_cast<float>(of_x * static_cast<double>(i % 64) +
                                                         of_y * static_cast<double>(i / 64));
        }
    };
    fill(Channel::height, 0.5, 0.25);
    fill(Channel::dx, 0.125, 0.0);
    std::ranges::fill(map.channel(Channel::vz), 4.0f);
    std::ranges::fill(map.channel(Channel::vx), -2.0f);
    const std::vector<std::uint8_t> dark(64 * 64, 0);
    const SprayTick tick{7, 3, 0.05, 2.0, 1.0, 1e9, {20.0, 0.0, 9.81}};
    const std::vector<SprayBirth> births = births_of(tick, map, dark);
    ASSERT_EQ(births.size(), 64u * 64u);
    for (std::size_t i = 0; i < births.size(); ++i) {
        const SprayBirth& birth = births[i];
        const auto at_the_seam = [](std::size_t k) { return k == 0 || k == 63; };
        if (at_the_seam(i % 64) || at_the_seam(i / 64)) continue;
        const double label_x = (birth.place[0] + 2.0 * birth.since) / 1.125;
        const double label_y = birth.place[1];
        EXPECT_NEAR(birth.place[2], 0.5 * label_x + 0.25 * label_y + 4.0 * birth.since, 1e-4);
        EXPECT_GE(birth.velocity[2], 4.0);
        EXPECT_GE(birth.velocity[0], -2.0);
    }
    // The same in a whole sea, on its query.
    Ocean sea(windy_sea(20.0, 64, 150.0), {.threads = 1});
    std::vector<WorldPoint> places;
    std::vector<double> heights;
    for (const SprayParticle& p : sea.spray(9.0, {.lifetime = 0.5, .density = 5.0})) {
        if (p.age > 0.01) continue;
        places.push_back({p.x, p.y});
        heights.push_back(p.z);
    }
    ASSERT_GT(places.size(), 20u);
    const auto samples = test::query(sea, 9.0, places);
    for (std::size_t i = 0; i < places.size(); ++i) heights[i] -= samples[i].height;
    EXPECT_LT(test::rms(heights), 0.2) << "of waves of 3.5 m";
}

TEST(Spray, TheSizesOfDropsAreThoseOfAndreas) {
    const auto flux = [](double r80) {
        if (r80 < 37.5) return 1.0 / r80;
        if (r80 < 100.0) return std::pow(37.5, 1.8) * std::pow(r80, -2.8);
        return std::pow(37.5, 1.8) * std::pow(100.0, 5.2) * std::pow(r80, -8.0);
    };
    double total = 0.0;
    constexpr double kStep = 0.01;
    for (double r = 10.0; r < 250.0; r += kStep) total += flux(r) * r * r * r * kStep;
    double below = 0.0, r80 = 10.0;
    for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) {
        for (; below < share * total; r80 += kStep) below += flux(r80) * r80 * r80 * r80 * kStep;
        const double radius = 1e-6 * std::pow(r80 / 0.518, 1.0 / 0.976);
        EXPECT_NEAR(spume_radius(share), radius, 2e-3 * radius) << share;
    }
    EXPECT_NEAR(spume_radius(0.0), 20.8e-6, 0.1e-6);
    EXPECT_NEAR(spume_radius(1.0 - 0x1p-53), 563e-6, 2e-6);
}

TEST(Spray, DropsFallAsFastAsMeasured) {
    // [Gunn and Kinzer 1949], table 2: diameter in mm and m/s.
    const std::pair<double, double> kMeasured[] = {{0.1, 0.27}, {0.2, 0.72}, {0.3, 1.17},
                                                   {0.5, 2.06}, {0.8, 3.27}, {1.0, 4.03}};
    for (const auto& [diameter, speed] : kMeasured) {
        const double fall = 9.81 * response_time(0.5e-3 * diameter, 9.81);
        EXPECT_NEAR(fall, speed, 0.08 * speed) << diameter << " mm";
    }
    // Stokes' law is the limit of small drops.
    const double small = 1e-6;
    EXPECT_NEAR(response_time(small, 9.81), 2000.0 * small * small / (9.0 * 1.81e-5), 1e-8);
}

TEST(Spray, FliesAsLinearDragHasItAndEndsWhereItSays) {
    SprayBirth birth{};
    birth.place = {1.0, 2.0, 3.0};
    birth.velocity = {0.0, 4.0, 5.0};
    birth.drift = {12.0, 0.0, -2.0};
    birth.response = 0.2;
    birth.life = 5.0;
    EXPECT_EQ(particle_at(birth, 0.0).z, 3.0);
    EXPECT_EQ(particle_at(birth, 0.0).vz, 5.0);
    EXPECT_NEAR(particle_at(birth, 0.2).vx, 12.0 * (1.0 - std::exp(-1.0)), 1e-12);
    EXPECT_NEAR(particle_at(birth, 4.0).vz, -2.0, 1e-7);
    EXPECT_NEAR(particle_at(birth, 4.0).x, 1.0 + 12.0 * (4.0 - 0.2), 1e-6);
    // Falls through the still water.
    const double life = life_of(birth, 10.0);
    EXPECT_NEAR(particle_at(birth, life).z, 0.0, 1e-9);
    EXPECT_GT(life, 2.0);
    EXPECT_EQ(life_of(birth, 1.0), 1.0) << "its age comes first";
    // Born below it, through the height of its birth.
    birth.place[2] = -1.0;
    EXPECT_NEAR(particle_at(birth, life_of(birth, 10.0)).z, -1.0, 1e-9);
    EXPECT_GT(life_of(birth, 10.0), 0.5);
    birth.velocity[2] = -3.0;
    EXPECT_LT(life_of(birth, 10.0), 1e-6);
    // A gust that would lift it does not save a particle that has been under water.
    birth.place[2] = 0.1;
    birth.drift[2] = 1.0;
    EXPECT_NEAR(particle_at(birth, life_of(birth, 10.0)).z, 0.0, 1e-9);
    EXPECT_LT(life_of(birth, 10.0), 0.1);
    birth.place[2] = 2.0;
    EXPECT_EQ(life_of(birth, 10.0), 10.0);
}

TEST(Mist, DriftsWithItsGustAndSpreadsAndFades) {
    SprayBirth birth{};
    birth.place = {1.0, 2.0, 3.0};
    birth.gust = {12.0, -1.0, 0.5};
    birth.mixing = 0.8;
    const MistPuff young = puff_at(birth, 0.0, 4.0);
    EXPECT_EQ(young.z, 3.0);
    EXPECT_EQ(young.share, 1.0);
    const MistPuff puff = puff_at(birth, 2.0, 4.0);
    EXPECT_EQ(puff.x, 25.0);
    EXPECT_EQ(puff.y, 0.0);
    EXPECT_EQ(puff.z, 4.0);
    EXPECT_LT(puff_at(birth, 4.0 - 1e-9, 4.0).share, 1e-9) << "none breaks off";
    // At first as fast as the air mixes, in the end as diffusion does.
    const auto spread = [&](double age) {
        return std::sqrt(std::pow(puff_at(birth, age, 100.0).deviation, 2) -
                         std::pow(young.deviation, 2));
    };
    EXPECT_NEAR(spread(0.01), 0.8 * 0.01, 1e-4 * 0.8);
    const double memory = 0.4 * 2.5 / 0.8;  // s
    EXPECT_NEAR(std::pow(spread(90.0) / spread(40.0), 2), (90.0 - memory) / (40.0 - memory), 1e-9);
    birth.mixing = 0.0;
    EXPECT_EQ(puff_at(birth, 3.0, 4.0).deviation, young.deviation);
}

TEST(Mist, IsThatOfTheSprayFrameByFrame) {
    const Parameters parameters = windy_sea();
    Ocean alone(parameters, {.threads = 1});
    Ocean sequence(parameters, {.threads = 2});
    for (int frame = 195; frame < 200; ++frame) spray_of(sequence, frame);
    const double time = alone.sea().time_of(200);
    const std::vector<MistPuff> mist = alone.mist(time);
    const std::vector<MistPuff> again = sequence.mist(time);
    ASSERT_EQ(mist.size(), again.size());
    EXPECT_EQ(std::memcmp(mist.data(), again.data(), mist.size() * sizeof(MistPuff)), 0);
    // Fallen drops have left their mist.
    EXPECT_GT(mist.size(), spray_of(alone, 200).size());
    EXPECT_TRUE(Ocean(windy_sea(5.0), {.threads = 1}).mist(time).empty());
}

TEST(Spray, FollowsATakeAndWhatIsPerformed) {
    Ocean live(windy_sea(14.0), {.threads = 1});
    spray_of(live, 60);  // beyond the performed time
    live.perform(1.5, "wind_speed", "24");
    live.perform(1.5, "wind_direction", "120");
    const Particles shown = spray_of(live, 60);
    Ocean again(live.sea(), {.threads = 2});
    EXPECT_TRUE(equal(spray_of(again, 60), shown));
    expect_to_go_on(spray_of(live, 60), spray_of(live, 61), 1.0 / 24.0);
    Ocean calm(windy_sea(14.0), {.threads = 1});
    EXPECT_TRUE(equal(spray_of(calm, 30), spray_of(again, 30))) << "before the change";
    EXPECT_GT(spray_of(live, 240).size(), spray_of(calm, 240).size());
    EXPECT_GE(max_spray_particles(live.sea(), {}), spray_of(live, 240).size());
    double x = 0.0;
    for (const SprayParticle& particle : spray_of(live, 240)) x += particle.vx;
    EXPECT_LT(x, 0.0) << "the wind has turned";
}

TEST(Spray, GoesWithTheStrongestWind) {
    Parameters parameters = windy_sea(12.0);
    parameters.waves.push_back(parameters.waves.front());
    parameters.waves.back().wind_speed = 15.0;
    parameters.waves.back().wind_direction = 90.0;
    parameters.water.gravity = 3.7;
    const SprayAir air = spray_air(parameters);
    EXPECT_EQ(air.wind_speed, 15.0);
    EXPECT_NEAR(air.direction, kPi / 2.0, 1e-12);
    EXPECT_EQ(air.gravity, 3.7);
}

}  // namespace
}  // namespace ocean
