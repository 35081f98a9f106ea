// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The energy of waves over a bed, against bulk models of a surf zone, the geometry of shadows and
// its own symmetries.
#include "coast/statics/energy_march.hpp"

#include "coast/statics/breaking.hpp"
#include "coast/statics/march_land.hpp"
#include "field/bilinear.hpp"
#include "ocean/internal/dispersion.hpp"
#include "ocean/thread_pool.hpp"
#include "refusal.hpp"
#include "test_beds.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

constexpr double kDegree = kTwoPi / 360.0;
constexpr double kPeakOmega = 0.85;
constexpr double kHeight = 2.96 / 1.4142135623730951;  // Hrms of the open sea [m]

/// One system of waves: Hs 2.96 m, peak period 7.4 s, spread as cos^2s of half the angle.
struct System {
    double direction = 0.0;  // [rad]
    double spread = 1000.0;  // s: 1000 is 2.6 degrees wide
    double share = 1.0;      // of the variance
};

DirectionalSpectrum make_sea(const std::vector<System>& systems) {
    constexpr int directions = 720;
    std::vector<double> rows, sums, spreading(directions, 0.0);
    for (const System& system : systems) {
        std::vector<double> shape(directions);
        for (int j = 0; j < directions; ++j) {
            const double half = 0.5 * (kTwoPi * j / directions - system.direction);
            shape[static_cast<std::size_t>(j)] =
                std::pow(std::abs(std::cos(half)), 2.0 * system.spread);
        }
        const double sum = std::accumulate(shape.begin(), shape.end(), 0.0) * kTwoPi / directions;
        for (std::size_t j = 0; j < directions; ++j) {
            spreading[j] += system.share * shape[j] / sum;
        }
    }
    double variance = 0.0;
    for (double omega = 0.45; omega <= 4.0; omega += 0.01) {  // JONSWAP's shape
        const double width = omega <= kPeakOmega ? 0.07 : 0.09;
        const double x = (omega - kPeakOmega) / (width * kPeakOmega);
        rows.push_back(omega);
        sums.push_back(std::pow(omega, -5.0) * std::exp(-1.25 * std::pow(kPeakOmega / omega, 4.0)) *
                       std::pow(3.3, std::exp(-0.5 * x * x)));
        variance += 0.01 * sums.back();
    }
    const std::size_t row_size = DirectionalSpectrum::row_size(directions);
    const std::shared_ptr<double[]> table(new double[rows.size() * row_size]);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        sums[i] *= kHeight * kHeight / 8.0 / variance;
        std::vector<double> row;
        for (std::size_t j = 0; j < directions; ++j) row.push_back(sums[i] * spreading[j]);
        DirectionalSpectrum::store_row(row, table.get() + i * row_size);
    }
    return DirectionalSpectrum(rows, directions, table, sums);
}

ShoreBands bands_of(const DirectionalSpectrum& sea, const Water& water) {
    Parameters parameters;
    parameters.water = water;
    return choose_bands(sea, parameters);
}

EnergyMaps march(const BedGrid& bed, const DirectionalSpectrum& sea, const Water& water = {},
                 const MarchSettings& settings = {}, int threads = 1,
                 const ShoreProgress& progress = {}) {
    ThreadPool pool(threads);
    return march_energy(bed, bands_of(sea, water), sea, water, settings, pool, progress);
}

/// Returns a map at a place, bilinear.
double read(const EnergyMaps& maps, const std::vector<float>& map, double x, double y) {
    const double u = (x - maps.domain.origin[0]) / maps.domain.step(0);
    const double v = (y - maps.domain.origin[1]) / maps.domain.step(1);
    const int i = std::min(static_cast<int>(u), maps.domain.samples[0] - 2);
    const int j = std::min(static_cast<int>(v), maps.domain.samples[1] - 2);
    const auto at = [&](int di, int dj) {
        return double{map[static_cast<std::size_t>((j + dj) * maps.domain.samples[0] + i + di)]};
    };
    return bilinear(at(0, 0), at(1, 0), at(0, 1), at(1, 1), u - i, v - j);
}

// ---- a surf zone along x

/// A bed of depth d(x) [m], uniform along y.
struct Profile {
    std::string name;
    double length;
    std::function<double(double)> depth;
};

Profile slope_of(double rise) {
    return {"slope " + std::to_string(rise), (14.0 + 3.0) / rise,
            [rise](double x) { return 14.0 - rise * x; }};
}

Profile barred_beach() {
    return {"bar", 900.0, [](double x) {
                return 12.0 - x / 60.0 - 1.7 * std::exp(-std::pow((x - 520.0) / 35.0, 2.0)) +
                       0.35 * std::exp(-std::pow((x - 590.0) / 30.0, 2.0));
            }};
}

EnergyMaps surf(const Profile& profile, const MarchSettings& settings = {}) {
    const double cell = 4.0;
    const int columns = static_cast<int>(profile.length / cell) + 1;
    const BedGrid bed =
        test::grid_of(columns, 21, cell, [&](double x, double) { return -profile.depth(x); });
    return march(bed, make_sea({{}}), {}, settings);
}

/// Returns Hrms at places 0.5 m apart by Thornton and Guza's equation for one frequency,
/// d (H^2 c_g / 8) / dx = -dissipation, from the open sea on.
std::vector<double> bulk_model(const Profile& profile) {
    std::vector<double> heights;
    double flux = 0.0;
    for (double x = 0.0; x < profile.length; x += 0.5) {
        const Dispersion water(Water{.depth = std::max(profile.depth(x), 0.6)});
        const double speed = water.group_velocity(water.wavenumber(kPeakOmega));
        if (x == 0.0) flux = kHeight * kHeight / 8.0 * 0.5 * 9.81 / kPeakOmega;
        heights.push_back(std::sqrt(8.0 * flux / speed));
        flux -= 0.5 * breaking_dissipation(heights.back(), std::max(profile.depth(x), 0.6),
                                           kPeakOmega / kTwoPi);
        flux = std::max(flux, 1e-9);
    }
    return heights;
}

double place_of_depth(const Profile& profile, double depth) {
    double x = 0.0;
    while (profile.depth(x) > depth) x += 0.1;
    return x;
}

TEST(EnergyMarch, HeightsFollowThorntonAndGuzaAndAreMeasuredOnesThatRiseWithTheSlope) {
    // Measured: 3 to 4 %. The equation has one frequency, the march all; 12 % would be good enough.
    // Hrms / d of saturated surf lies between 0.29 and 0.55 in nature and rises with the slope
    // [Sallenger and Holman 1985]. Thornton and Guza's equation itself gives 0.602 at 1 m on 1:15,
    // the march 0.61: there the bound is the equation, elsewhere 0.58.
    std::vector<double> previous(3, 0.0);
    for (const Profile& profile :
         {slope_of(1.0 / 100.0), slope_of(1.0 / 30.0), slope_of(1.0 / 15.0), barred_beach()}) {
        SCOPED_TRACE(profile.name);
        const EnergyMaps maps = surf(profile);
        const std::vector<double> bulk = bulk_model(profile);
        double worst = 0.0;
        for (std::size_t n = 0; n < bulk.size(); n += 4) {
            const double x = 0.5 * static_cast<double>(n);
            if (profile.depth(x) < 1.0 || x > profile.length - 16.0) continue;
            worst = std::max(worst, std::abs(read(maps, maps.rms_height, x, 40.0) / bulk[n] - 1.0));
        }
        EXPECT_LE(worst, 0.06);
        if (profile.name == "bar") continue;
        std::size_t n = 0;
        for (const double depth : {2.0, 1.5, 1.0}) {
            const double x = place_of_depth(profile, depth);
            const double ratio = read(maps, maps.rms_height, x, 40.0) / depth;
            const double exact = bulk[static_cast<std::size_t>(2.0 * x)] / depth;
            EXPECT_GE(ratio, 0.29) << depth;
            EXPECT_LE(ratio, std::max(0.58, exact + 0.015)) << depth;
            EXPECT_GT(ratio, previous[n] + 0.03) << depth;
            previous[n++] = ratio;
        }
    }
}

TEST(EnergyMarch, IslandsCastTheShadowThatTheSpreadAllows) {
    // Deep water behind a round island: the energy is the share of the waves that can be seen.
    const double radius = 100.0, centre_x = 400.0, centre_y = 800.0;
    const BedGrid bed = test::grid_of(201, 201, 8.0, [&](double x, double y) {
        return std::hypot(x - centre_x, y - centre_y) < radius ? 3.0 : -300.0;
    });
    for (const double spread : {10.0, 2.0}) {
        const System system{.direction = 0.0, .spread = spread};
        for (const double cell : {8.0, 16.0}) {
            const EnergyMaps maps = march(bed, make_sea({system}), {}, {.cell = cell});
            double worst = 0.0;
            for (const double dx : {150.0, 300.0, 600.0, 1000.0}) {
                for (const double dy : {0.0, 100.0, 200.0}) {
                    const double hidden = std::asin(std::min(radius / std::hypot(dx, dy), 1.0));
                    double visible = 0.0, all = 0.0;
                    for (double t = -kPi; t < kPi; t += 0.005) {
                        const double e = std::pow(std::abs(std::cos(0.5 * t)), 2.0 * spread);
                        all += e;
                        if (std::abs(t - std::atan2(dy, dx)) > hidden) visible += e;
                    }
                    const double k = read(maps, maps.arrival, centre_x + dx, centre_y + dy);
                    worst = std::max(worst, std::abs(k - visible / all));
                }
            }
            EXPECT_LE(worst, 0.1) << spread << " " << cell;  // 0.06 and 0.09
        }
    }
}

TEST(EnergyMarch, OverADeepFlatBedAllStaysAsInTheOpenSea) {
    for (const double depth : {1e4, 20.0, 0.5}) {
        const Water water{.depth = depth};
        const BedGrid bed =
            test::grid_of(60, 40, 10.0, [&](double x, double) { return -depth - x; });
        const DirectionalSpectrum sea =
            make_sea({{.direction = 0.7, .spread = 4.0, .share = 0.6},
                      {.direction = -2.6, .spread = 30.0, .share = 0.4}});
        const EnergyMaps maps = march(bed, sea, water);
        EXPECT_GT(maps.amplitude.size(), 16u);
        for (const std::vector<float>& amplitude : maps.amplitude) {
            for (const float a : amplitude) ASSERT_NEAR(a, 1.0f, 1e-6f);
        }
        for (const float k : maps.arrival) ASSERT_NEAR(k, 1.0f, 1e-6f);
        double variance = 0.0;  // pairs of band and sector with little of the sea are left out
        for (const ShoreWaves& waves : bands_of(sea, water).waves) variance += waves.variance;
        EXPECT_NEAR(maps.rms_height.front(), std::sqrt(8.0 * variance), 1e-3 * kHeight);
        EXPECT_NEAR(maps.rms_height.front(), kHeight, 0.02 * kHeight);
    }
}

TEST(EnergyMarch, MapsOfATurnedCoastAreTurned) {
    // A coast turned by 90 degrees with its waves: the same numbers, read along y. Sectors stay
    // where they are and cut the sea elsewhere, which is worth less than 1 %.
    const auto beach = [](double along) { return -14.0 + along / 30.0; };
    const BedGrid east = test::grid_of(121, 21, 4.0, [&](double x, double) { return beach(x); });
    const BedGrid north = test::grid_of(21, 121, 4.0, [&](double, double y) { return beach(y); });
    const EnergyMaps a = march(east, make_sea({{.direction = 0.3, .spread = 8.0}}));
    const EnergyMaps b =
        march(north, make_sea({{.direction = 0.3 + 0.25 * kTwoPi, .spread = 8.0}}));
    for (double s = 100.0; s < 400.0; s += 20.0) {
        EXPECT_NEAR(read(a, a.rms_height, s, 40.0), read(b, b.rms_height, 40.0, s), 0.015);
    }
}

TEST(EnergyMarch, MarchesThatMeetBreakLikeOne) {
    // Two narrow systems 70 degrees to either side of the normal of a beach march apart; in the
    // surf they are together as high as one of the same energy.
    const BedGrid bed =
        test::grid_of(241, 121, 8.0, [](double x, double) { return -60.0 + x / 30.0; });
    const double side = 70.0 * kDegree;
    const EnergyMaps two = march(
        bed, make_sea({{.direction = side, .share = 0.5}, {.direction = -side, .share = 0.5}}));
    const EnergyMaps one = march(bed, make_sea({{.direction = side, .share = 1.0}}));
    for (const double depth : {6.0, 3.0, 2.0, 1.0}) {
        const double x = 30.0 * (60.0 - depth);
        EXPECT_NEAR(read(two, two.rms_height, x, 480.0) / read(one, one.rms_height, x, 480.0), 1.0,
                    0.02)
            << depth;
    }
}

TEST(EnergyMarch, LandSwallowsAndBreakingIsBounded) {
    const BedGrid bed =
        test::grid_of(200, 60, 4.0, [](double x, double) { return -8.0 + x / 40.0; });
    const EnergyMaps maps = march(bed, make_sea({{.spread = 10.0}}));
    for (std::size_t n = 0; n < maps.domain.count(); ++n) {
        ASSERT_GE(maps.breaking_share[n], 0.0f);
        ASSERT_LE(maps.breaking_share[n], 1.0f);
        ASSERT_LE(maps.group_width[n], 1.00001f);
    }
    EXPECT_GT(read(maps, maps.rms_height, 300.0, 100.0), 0.2);  // 0.5 m deep
    EXPECT_EQ(read(maps, maps.rms_height, 400.0, 100.0), 0.0);
    EXPECT_EQ(read(maps, maps.arrival, 400.0, 100.0), 0.0);
    EXPECT_GT(read(maps, maps.breaking_share, 240.0, 100.0), 0.3);
    EXPECT_LT(read(maps, maps.breaking_share, 20.0, 100.0), 0.3);
}

// ---- walls

const Water kEightMetres{.depth = 8.0};

/// A wall of samples in water 8 m deep: those within half the width of a line from a to b, and
/// those that the line passes nearest to, so that a wall of width 0 is one sample wide and closed
/// by corners alone.
struct Wall {
    double ax, ay, bx, by, width;

    bool has(double x, double y, double cell) const {
        const double dx = bx - ax, dy = by - ay, length = std::hypot(dx, dy);
        const double along = ((x - ax) * dx + (y - ay) * dy) / length;
        const double across = ((y - ay) * dx - (x - ax) * dy) / length;
        if (along < -0.5 * cell || along > length + 0.5 * cell) return false;
        const double one = 0.5 * cell * std::max(std::abs(dx), std::abs(dy)) / length;
        return std::abs(across) <= std::max(one, 0.5 * width);
    }
};

BedGrid walled_bed(int columns, int rows, double cell, const std::vector<Wall>& walls) {
    return test::grid_of(columns, rows, cell, [&](double x, double y) {
        const auto stands = [&](const Wall& wall) { return wall.has(x, y, cell); };
        return std::ranges::any_of(walls, stands) ? 4.0 : -8.0;
    });
}

TEST(EnergyMarch, AThinWallShadowsAsAThickOneDoesFromAnyDirection) {
    // One cell wide and 16 m, 200 m long, in a broad sea; the mean height 40 to 100 m behind the
    // middle. A march of 16 m cells that reads its bed every 4 m steps over the thin one.
    struct Case {
        double cell, turn;
    };
    for (const Case& wall_case :
         {Case{4.0, 0.0}, {4.0, 20.0}, {4.0, 70.0}, {2.0, 45.0}, {8.0, 20.0}}) {
        // Lambdas of clang 14 capture no structured bindings.
        const double cell = wall_case.cell, turn = wall_case.turn;
        const double c = std::cos(turn * kDegree), s = std::sin(turn * kDegree);
        const int samples = static_cast<int>(640.0 / cell) + 1;
        const DirectionalSpectrum sea = make_sea({{.direction = turn * kDegree, .spread = 5.0}});
        const auto height = [&](double width) {
            const Wall wall{320.0 + 100.0 * s, 320.0 - 100.0 * c, 320.0 - 100.0 * s,
                            320.0 + 100.0 * c, width};
            const EnergyMaps maps =
                march(walled_bed(samples, samples, cell, {wall}), sea, kEightMetres);
            double sum = 0.0;
            for (double behind = 40.0; behind <= 100.0; behind += 15.0) {
                sum += read(maps, maps.rms_height, 320.0 + behind * c, 320.0 + behind * s);
            }
            return sum / 5.0;
        };
        const double thin = height(0.0);
        EXPECT_LT(thin, 1.25 * height(16.0)) << cell << " " << turn;
        EXPECT_LT(thin, 0.4 * kHeight) << cell << " " << turn;
    }
}

/// A mole of 200 m about the middle of a bed of 640 m, its direction turned from y by `turn`.
/// Places are counted from its middle: across, away from the sea, and along.
struct Mole {
    double cell, turn;
    int width;  // [samples]

    BedGrid bed(bool is_thick) const {
        const int samples = static_cast<int>(640.0 / cell) + 1;
        return test::grid_of(samples, samples, cell, [&](double x, double y) {
            const double c = std::cos(turn), s = std::sin(turn);
            const double across = (x - 320.0) * c + (y - 320.0) * s;
            const double along = (y - 320.0) * c - (x - 320.0) * s;
            // The thick mole has the samples of the thin one and those in 72 m towards the sea, so
            // that the faces to their lees are the same.
            const bool stands = across <= face() && across >= (is_thick ? -72.0 : -face());
            return stands && std::abs(along) <= 100.0 ? 4.0 : -8.0;
        });
    }
    /// Returns half the width of the thin mole, which is closed by corners [m].
    double face() const {
        return 0.5 * cell * width * std::max(std::abs(std::cos(turn)), std::abs(std::sin(turn))) +
               1e-9;
    }
    std::array<double, 2> behind(double across, double along) const {
        const double u = face() + across, c = std::cos(turn), s = std::sin(turn);
        return {320.0 + u * c - along * s, 320.0 + u * s + along * c};
    }
};

TEST(EnergyMarch, WavesBehindAMoleFeelNoDepthsOfLandThatTheyDidNotCross) {
    // At each place from 25 m behind, with one and two samples against five cells of the march; the
    // waves behind both are those that a straight view of the open sea lets in. Waves that feel the
    // thick mole's land break on it and turn to it, and waves do not see the thin one's.
    struct Case {
        double cell, turn, oblique;  // of the waves to the mole [degrees]
        int width;
    };
    for (const auto& [cell, turn, oblique, width] : {Case{4.0, 22.5, 30.0, 1},
                                                     {2.0, 22.5, 30.0, 2},
                                                     {5.0, 22.5, 30.0, 1},
                                                     {4.0, 75.0, -30.0, 1},
                                                     {5.0, 60.0, -45.0, 1}}) {
        const Mole mole{cell, turn * kDegree, width};
        const double main = (turn + oblique) * kDegree, spread = 5.0;
        const DirectionalSpectrum sea = make_sea({{.direction = main, .spread = spread}});
        const BedGrid thin_bed = mole.bed(false), thick_bed = mole.bed(true);
        const EnergyMaps thin = march(thin_bed, sea, kEightMetres),
                         thick = march(thick_bed, sea, kEightMetres);
        const MarchLand land(thick_bed, {});
        const auto seen = [&](const std::array<double, 2>& place) {
            double sum = 0.0, all = 0.0;
            for (double off = -170.0; off <= 170.0; off += 1.0) {
                const double angle = main + off * kDegree;
                const double energy = std::pow(std::cos(0.5 * off * kDegree), 2.0 * spread);
                all += energy;
                sum += energy * double{land.through(place, {place[0] - 500.0 * std::cos(angle),
                                                            place[1] - 500.0 * std::sin(angle)})};
            }
            return std::sqrt(sum / all);
        };
        for (double across = 25.0; across <= 150.0; across += 25.0) {
            for (double along = -95.0; along <= 95.0; along += 10.0) {
                const std::array<double, 2> place = mole.behind(across, along);
                const double of_thin = read(thin, thin.rms_height, place[0], place[1]);
                const double of_thick = read(thick, thick.rms_height, place[0], place[1]);
                EXPECT_LT(of_thin, 1.25 * of_thick) << cell << " " << turn << " " << oblique << " "
                                                    << width << " at " << across << " " << along;
                EXPECT_NEAR(of_thick / kHeight, seen(place), 0.1)
                    << cell << " " << turn << " " << oblique << " at " << across << " " << along;
            }
        }
    }
}

TEST(EnergyMarch, AWallAlongTheMarchPartsTheWaterOnItsSides) {
    // A mole of two cells along the mean direction, closed to the sea by a second one: within the
    // corner are only waves that come round its open end.
    for (const double turn : {0.0, 30.0, 80.0}) {
        const double angle = turn * kDegree, c = std::cos(angle), s = std::sin(angle);
        const auto place = [&](double along, double across) {
            return std::array{400.0 + along * c - across * s, 400.0 + along * s + across * c};
        };
        const auto wall = [&](std::array<double, 2> a, std::array<double, 2> b) {
            return Wall{a[0], a[1], b[0], b[1], 8.0};
        };
        const BedGrid bed = walled_bed(
            201, 201, 4.0,
            {wall(place(-200, 0), place(200, 0)), wall(place(-200, 0), place(-200, 160))});
        const EnergyMaps maps =
            march(bed, make_sea({{.direction = angle, .spread = 20.0}}), kEightMetres);
        const auto at = [&](double along, double across) {
            const auto [x, y] = place(along, across);
            return read(maps, maps.rms_height, x, y);
        };
        EXPECT_LT(at(-100.0, 40.0), 0.25 * at(-100.0, -60.0)) << turn;
        EXPECT_LT(at(-120.0, 30.0), 0.25 * at(-100.0, -60.0)) << turn;
    }
}

TEST(EnergyMarch, NothingComesRoundLandFromBorderToBorderUnlessASystemOrAStraitDoes) {
    const auto barrier = [](double x, double) { return x >= 480.0 && x < 512.0 ? 4.0 : -8.0; };
    const BedGrid bed = test::grid_of(121, 101, 8.0, barrier);
    for (const double direction : {0.0, -25.0, 15.0, 180.0}) {
        for (const double spread : {2.0, 20.0}) {
            const EnergyMaps maps =
                march(bed, make_sea({{.direction = direction * kDegree, .spread = spread}}),
                      kEightMetres);
            const double before = direction == 180.0 ? 800.0 : 200.0;
            for (const double y : {100.0, 400.0, 700.0}) {
                EXPECT_GT(read(maps, maps.rms_height, before, y), 0.5 * kHeight);
                EXPECT_EQ(read(maps, maps.rms_height, 1000.0 - before, y), 0.0) << direction;
                EXPECT_EQ(read(maps, maps.arrival, 1000.0 - before, y), 0.0) << direction;
            }
        }
    }
    // A tenth of the energy is a swell from the other side.
    const EnergyMaps two =
        march(bed, make_sea({{.share = 0.9}, {.direction = kPi, .share = 0.1}}), kEightMetres);
    EXPECT_NEAR(read(two, two.rms_height, 800.0, 400.0) / kHeight, std::sqrt(0.1), 0.03);
    // A strait of two samples joins the water, so that none is still.
    const auto strait = [&](double x, double y) {
        return y > 390.0 && y < 410.0 ? -8.0 : barrier(x, y);
    };
    const EnergyMaps joined =
        march(test::grid_of(121, 101, 8.0, strait), make_sea({{.spread = 10.0}}), kEightMetres);
    EXPECT_TRUE(joined.still.still.empty());
}

TEST(EnergyMarch, PondsLagoonsAndAtollsAreStill) {
    struct Case {
        const char* name;
        std::function<double(double, double)> height;
        std::vector<std::array<double, 2>> still, moved;
    };
    const std::vector<Case> cases = {
        // A ring of one sample, closed by corners.
        {"atoll",
         [](double x, double y) {
             return std::abs(std::hypot(x - 400.0, y - 400.0) - 150.0) < 2.9 ? 1.5 : -8.0;
         },
         {{400.0, 400.0}, {350.0, 420.0}},
         {{100.0, 400.0}}},
        {"lagoon behind a dune",
         [](double x, double) {
             return x < 400.0 ? -8.0 : x < 420.0 ? 3.0 : x < 500.0 ? -2.0 : 2.0;
         },
         {{460.0, 100.0}, {450.0, 400.0}, {470.0, 700.0}},
         {{200.0, 400.0}}},
        {"polder with a dike along the border",
         [](double x, double y) {
             if (x < 500.0) return -8.0;
             return x < 530.0 || x > 790.0 || y < 40.0 || y > 760.0 ? 5.0 : -3.0;
         },
         {{560.0, 100.0}, {700.0, 400.0}, {770.0, 700.0}},
         {{200.0, 400.0}}}};
    for (const Case& of : cases) {
        const BedGrid bed = test::grid_of(201, 201, 4.0, of.height);
        const EnergyMaps maps =
            march(bed, make_sea({{.direction = 0.2, .spread = 3.0}}), kEightMetres);
        for (const auto& [x, y] : of.still) {
            EXPECT_EQ(read(maps, maps.rms_height, x, y), 0.0) << of.name;
        }
        for (const auto& [x, y] : of.moved) {
            EXPECT_GT(read(maps, maps.rms_height, x, y), 0.5 * kHeight) << of.name;
        }
    }
}

TEST(EnergyMarch, ReportsItsProgressAndStopsWhenTold) {
    const BedGrid bed =
        test::grid_of(60, 60, 8.0, [](double x, double) { return -9.0 + x / 60.0; });
    const DirectionalSpectrum sea = make_sea({{}});
    double last = 0.0;
    march(bed, sea, {}, {}, 2, [&](double share) {
        EXPECT_GT(share, last);
        last = share;
    });
    EXPECT_EQ(last, 1.0);
    int calls = 0;
    const auto stop = [&](double) {
        if (++calls == 3) throw Error(ErrorKind::interrupted, "stopped");
    };
    EXPECT_THROW(march(bed, sea, {}, {}, 2, stop), Error);
    EXPECT_EQ(calls, 3);
}

TEST(EnergyMarch, RefusesSettingsOutOfRangeAndLeavesFlatSeasFlat) {
    const BedGrid bed = test::grid_of(10, 10, 8.0, [](double, double) { return -9.0; });
    for (const MarchSettings& settings :
         {MarchSettings{.cell = 0.0}, {.direction_bin = 0.5}, {.min_depth = 0.0}}) {
        EXPECT_THROW(march(bed, make_sea({{}}), {}, settings), Error);
    }
    const EnergyMaps maps = march_energy(bed, {}, {}, {}, {}, test::pool());
    EXPECT_TRUE(maps.amplitude.empty());
    EXPECT_EQ(maps.rms_height, std::vector<float>(maps.domain.count(), 0.0f));
}

}  // namespace
}  // namespace ocean
