// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Times of records: accepted texts, and minutes since 1970 there and back.
#include "ocean/internal/utc_time.hpp"

#include "testing.hpp"

namespace ocean::test {
namespace {

TEST(UtcTime, SecondsAndTheirFractionsAreDropped) {
    for (const char* text : {"2018-02-14T00:27", "2018-02-14 00:27Z", "2018-02-14T00:27:59",
                             "2018-02-14T00:27:59.9Z", "2018-02-14T00:27:19.000000Z"}) {
        const std::optional<UtcTime> time = parse_utc_time(text);
        ASSERT_TRUE(time) << text;
        EXPECT_EQ(time->text(), "2018-02-14T00:27") << text;
    }
    for (const char* text :
         {"2018-02-14T00:27:", "2018-02-14T00:27:1", "2018-02-14T00:27:19.",
          "2018-02-14T00:27:19.Z", "2018-02-14T00:27:190", "2018-02-14T00:27.5",
          "2018-02-14T00:27:19.0+25:00", "2018-02-14T00:27+1:00", "2018-02-14T00:27+01:60",
          "2018-02-14T00:27+", "2018-02-14T00:27 CET"}) {
        EXPECT_FALSE(parse_utc_time(text)) << text;
    }
}

TEST(UtcTime, OtherZonesAreConverted) {
    for (const auto& [text, utc] : {std::pair{"2024-03-01 12:00:00+00:00", "2024-03-01T12:00"},
                                    {"2024-03-01T00:30+01:00", "2024-02-29T23:30"},
                                    {"2024-12-31 22:00:00.5-0530", "2025-01-01T03:30"},
                                    {"2024-03-01T12:00 +13", "2024-02-29T23:00"},
                                    {"2024-03-01 12:00 UTC", "2024-03-01T12:00"},
                                    {"2024-03-01T12:00:00 GMT", "2024-03-01T12:00"}}) {
        const std::optional<UtcTime> time = parse_utc_time(text);
        ASSERT_TRUE(time) << text;
        EXPECT_EQ(time->text(), utc) << text;
    }
}

TEST(UtcTime, MinutesGoThereAndBack) {
    EXPECT_EQ(utc_time_at(0)->text(), "1970-01-01T00:00");
    EXPECT_EQ(utc_time_at(-1)->text(), "1969-12-31T23:59");
    for (const char* text : {"1800-01-01T00:00", "2000-02-29T12:34", "2999-12-31T23:59"}) {
        EXPECT_EQ(utc_time_at(parse_utc_time(text)->minutes())->text(), text);
    }
    const std::int64_t first = parse_utc_time("1800-01-01T00:00")->minutes();
    EXPECT_FALSE(utc_time_at(first - 1)) << "years before are none of valid()";
    for (const std::int64_t far :
         {std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::min()}) {
        EXPECT_FALSE(utc_time_at(far)) << far;
    }
}

}  // namespace
}  // namespace ocean::test
