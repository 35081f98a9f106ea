// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Any allowed set of parameters gives a finite surface: no NaN, no infinity, no crash.

#include <bit>

#include "ocean/enum_words.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/sea_state.hpp"
#include "refusal.hpp"
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
            if (skipped(info) || info.member.items(parameters) == 0) continue;
            if (!info.choices().empty()) {
                const auto words = info.choices();
                const std::string word(words[random_() % words.size()]);
                if (word != "measured") assign(parameters, {&info, 0}, word);
            } else if (info.type() == "bool") {
                assign(parameters, {&info, 0}, random_() % 4 == 0);
            } else {
                assign(parameters, {&info, 0}, number(info));
            }
        }
        parameters.grid.resolution = 32;
        if (parameters.surface.second_order) parameters.water.depth = Water{}.depth;
        return parameters;
    }

  private:
    static bool skipped(const ParameterInfo& info) {
        return info.type() == "text" || info.type() == "list" || info.type() == "numbers" ||
               info.section == "time" || info.key == "resolution" ||
               info.key == "shortest_wavelength" || info.key == "longest_wavelength";
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
            if (info.rule == NumberRule::even) whole = whole / 2 * 2;
            if (info.rule == NumberRule::power_of_two) {
                whole =
                    static_cast<std::int64_t>(std::bit_floor(static_cast<std::uint64_t>(whole)));
                if (whole < static_cast<std::int64_t>(info.min_nonzero)) whole = 0;
            }
            return whole;
        }
        return value;
    }

    std::mt19937 random_;
};

/// Both ends of a range, and where it begins at 0 the smallest numbers beside it.
std::vector<ParameterValue> ends_of(const ParameterInfo& info) {
    if (info.type() == "int") {
        return {static_cast<std::int64_t>(info.min), static_cast<std::int64_t>(info.max)};
    }
    std::vector<ParameterValue> ends = {info.min, info.max};
    if (std::isinf(info.max)) ends.emplace_back(std::numeric_limits<double>::max());
    if (info.min_nonzero > 0.0) {
        ends.emplace_back(info.min_nonzero);
    } else if (info.min <= 0.0) {
        ends.emplace_back(std::numeric_limits<double>::denorm_min());
        ends.emplace_back(1e-100);
        ends.emplace_back(1e-9);
    }
    return ends;
}

/// A sea of one word, with water shallow enough for all that depends on it.
Parameters sea_of(SpectrumKind kind) {
    Parameters parameters = test::wind_sea(32, 100.0, {.spectrum = kind, .depth = 20.0});
    parameters.surface.foam_step = 1.0;  // the longest lifetime is thousands of the default's ticks
    if (kind == SpectrumKind::measured) {
        SpectrumRecord record;
        record.frequency = {0.05, 0.1, 0.2, 0.4};
        record.density = {0.0, 6.0, 2.0, 0.1};
        parameters.waves.front().measured = std::make_shared<const SpectrumRecord>(record);
    }
    return parameters;
}

/// One of several parts of the table of parameters.
class ParameterEnds : public testing::TestWithParam<int> {};
constexpr int kParts = 6;

TEST_P(ParameterEnds, GiveAFiniteSeaThatEnds) {
    const Parameters defaults;
    int next = 0;
    for (const ParameterInfo& info : parameter_table()) {
        const bool number = info.type() == "float" || info.type() == "int";
        if (!number || info.key == "resolution") continue;  // all tests use its lower end
        if (info.member.items(defaults) == 0) continue;
        if (next++ % kParts != GetParam()) continue;
        for (std::size_t kind = 0; kind < enum_count<SpectrumKind>(); ++kind) {
            for (const ParameterValue& end : ends_of(info)) {
                SCOPED_TRACE(info.path() + " = " + to_text(end) + ", " +
                             std::string(kEnumWords<SpectrumKind>[kind]));
                Parameters parameters = sea_of(static_cast<SpectrumKind>(kind));
                // The cost of foam does not depend on the spectrum.
                const bool foam = kind == 0;
                assign(parameters, {&info, 0}, end);
                Ocean sea(parameters, {.threads = 1});
                const ChannelSet channels =
                    foam ? test::kAllChannels | Channel::foam : test::kAllChannels;
                const Surface surface = sea.evaluate(parameters.time.start, channels, 32);
                ASSERT_TRUE(test::is_finite(surface));
                EXPECT_NO_THROW(sea_state_json(sea.state())) << "a number that JSON lacks";
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Part, ParameterEnds, testing::Range(0, kParts));

TEST(Robustness, ALoopIsNoneOrAHundredthOfASecondAtLeast) {
    Parameters parameters;
    EXPECT_NO_THROW(set_parameter(parameters, "loop_period", "0"));
    EXPECT_NO_THROW(set_parameter(parameters, "loop_period", "0.01"));
    for (const char* tiny : {"0.0099", "1e-100", "5e-324"}) {
        const auto set = [&] { set_parameter(parameters, "loop_period", tiny); };
        EXPECT_TRUE(test::says(test::message_of(set), "allowed: 0 or 0.01 .. 1000000 s")) << tiny;
    }
}

TEST(Robustness, AllowedParametersGiveFiniteSurfaces) {
    RandomParameters seas(11);
    for (int i = 0; i < 300; ++i) {
        const Parameters parameters = seas.next();
        SCOPED_TRACE(testing::Message()
                     << "sea " << i << ": depth " << parameters.water.depth << " patch "
                     << parameters.grid.patch_size << " wind " << parameters.waves[0].wind()
                     << " spectrum " << static_cast<int>(parameters.waves[0].spectrum));
        Ocean sea(parameters, {.threads = 1});
        ASSERT_TRUE(test::is_finite(sea.evaluate(12.0, test::kAllChannels)));
        // Also where the surface has folded many times over.
        const std::vector<WorldPoint> points = {{0.0, 0.0}, {1e7, -3.3}, {12.345, 67.89}};
        for (const QuerySample& sample : test::query(sea, 12.0, points, {.foam = false})) {
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
