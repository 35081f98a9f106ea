// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Any allowed set of parameters gives a finite surface: no NaN, no infinity, no crash.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "ocean/parameter_table.hpp"
#include "test_seas.hpp"

namespace ocean {
namespace {

/// Random values over the hard ranges: ends, soft range and everything between.
class RandomParameters {
  public:
    explicit RandomParameters(unsigned seed) : random_(seed) {}

    Parameters next() {
        Parameters parameters;
        for (const ParameterInfo& info : parameter_table()) {
            if (skipped(info)) continue;
            if (!info.choices().empty()) {
                const auto words = info.choices();
                const std::string word(words[random_() % words.size()]);
                if (word != "measured") assign(parameters, {&info, 0}, word);
            } else {
                assign(parameters, {&info, 0}, number(info));
            }
        }
        parameters.grid.resolution = 32;
        return parameters;
    }

  private:
    static bool skipped(const ParameterInfo& info) {
        return info.type() == "text" || info.type() == "list" || info.section == "time" ||
               info.key == "resolution" || info.key == "shortest_wavelength" ||
               info.key == "longest_wavelength";
    }

    ParameterValue number(const ParameterInfo& info) {
        const double share = static_cast<double>(random_() % 1001) / 1000.0;
        double value = info.soft_min + share * (info.soft_max - info.soft_min);
        const auto pick = random_() % 8;
        if (pick == 0) value = info.min;
        if (pick == 1 && std::isfinite(info.max)) value = info.max;
        if (pick == 1 && !std::isfinite(info.max)) value = info.max;
        if (pick == 2 && info.min > 0.0 && std::isfinite(info.max)) {
            value = info.min * std::pow(info.max / info.min, share);
        }
        if (info.type() == "int") {
            auto whole = static_cast<std::int64_t>(value);
            if (info.key == "alignment") whole = whole / 2 * 2;
            return whole;
        }
        return value;
    }

    std::mt19937 random_;
};

TEST(Robustness, AllowedParametersGiveFiniteSurfaces) {
    RandomParameters seas(11);
    for (int i = 0; i < 300; ++i) {
        const Parameters parameters = seas.next();
        SCOPED_TRACE(testing::Message()
                     << "sea " << i << ": depth " << parameters.water.depth << " patch "
                     << parameters.grid.patch_size << " wind " << parameters.waves[0].wind()
                     << " spectrum " << static_cast<int>(parameters.waves[0].spectrum));
        Ocean sea(parameters, {.threads = 1});
        const Surface surface = sea.evaluate(12.0, test::kAllChannels);
        for (int c = 0; c < kChannelCount; ++c) {
            for (const float value : surface.channel(static_cast<Channel>(c))) {
                ASSERT_TRUE(std::isfinite(value)) << "channel " << c;
            }
        }
        // Also where the surface has folded many times over.
        QueryOptions without_foam;
        without_foam.foam = false;
        const WorldPoint points[] = {{0.0, 0.0}, {1e7, -3.3}, {12.345, 67.89}};
        QuerySample samples[3];
        sea.query(12.0, points, samples, without_foam);
        for (const QuerySample& sample : samples) {
            ASSERT_TRUE(std::isfinite(sample.height + sample.velocity[0] + sample.velocity[2]));
            ASSERT_NEAR(std::hypot(sample.normal[0], sample.normal[1], sample.normal[2]), 1.0,
                        1e-6);
        }
        const SeaState state = sea.state();
        ASSERT_TRUE(std::isfinite(state.significant_wave_height.asked));
        ASSERT_TRUE(std::isfinite(state.mean_square_slope.resolved));
    }
}

}  // namespace
}  // namespace ocean
