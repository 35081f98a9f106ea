// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Tracks of hulls: what a CSV file and the rows of a sea file mean, and that a saved sea carries
// them.
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "helpers.hpp"
#include "ocean/internal/hull_rules.hpp"
#include "temporary_folder.hpp"
#include "track_file.hpp"

namespace ocean::test {
namespace {

TEST(HullTrackFile, ColumnsStandInAnyOrderWithUnits) {
    const HullTrack track = parse_track("y [m],time [s],x\n1,0,2\n3,1.5,4\n", "boat.csv");
    EXPECT_EQ(track.rows, (std::vector<TrackRow>{{0.0, 2.0, 1.0}, {1.5, 4.0, 3.0}}));
    EXPECT_TRUE(track.courses.empty());
    const HullTrack sailed =
        parse_track("time;x;y;heading;speed\n0;1;2;90;3,5\n1;1;5;91;3\n", "boat.csv");
    EXPECT_EQ(sailed.courses, (std::vector<TrackCourse>{{90.0, 3.5}, {91.0, 3.0}}));
}

TEST(HullTrackFile, WayPointsAreReachedAtTheirSpeeds) {
    const HullTrack track = parse_track("x,y,speed\n0,0,4\n60,80,6\n60,80.0,6\n60,20,0\n", "b.csv");
    const double times[] = {0.0, 20.0, 20.0, 40.0};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_DOUBLE_EQ(track.rows[i].time, times[i]);
}

TEST(HullTrackFile, ASavedSeaCarriesTheRowsOfItsFile) {
    const TemporaryFolder folder;
    std::ofstream(folder.file("boat.csv")) << "time,x,y\n0,0.1,0\n10,50,3\n20,99,9\n";
    const std::string text = "libocean = 1\n[[hulls]]\nlength = 12.0\ntrack_file = \"boat.csv\"\n";
    const Sea sea = parse_sea(text, "sea.toml", folder.path());
    ASSERT_EQ(sea.parameters.hulls.size(), 1u);
    EXPECT_EQ(sea.parameters.hulls[0].track->rows.size(), 3u);
    EXPECT_EQ(named_files(sea), std::vector<std::string>{"boat.csv"});
    const Sea again = parse_sea(write_sea(sea), "saved.toml", "/nowhere");
    EXPECT_EQ(difference(again, sea), "");
    EXPECT_EQ(write_sea(again), write_sea(sea));
}

TEST(HullTrackFile, TheValuesOfASeaHaveItsTracks) {
    const Sea sea = parse(
        "[[hulls]]\ntrack = [[0, 0, 0], [10, 50, 0]]\n"
        "[[hulls]]\nfactor = 0.5\ntrack = [[0, 9, 0, 0, 5], [10, 59, 0, 0, 5]]\n");
    std::vector<NamedText> texts = sea_values(sea);
    std::vector<NamedValue> values;
    for (const NamedText& text : texts) values.push_back({text.name, text.value});
    EXPECT_EQ(difference(parse_sea(text_of_values(values), "values", ""), sea), "");
}

TEST(HullTrackFile, AnotherFileIsAnotherTrack) {
    const TemporaryFolder folder;
    std::ofstream(folder.file("a.csv")) << "time,x,y\n0,0,0\n10,50,0\n";
    std::ofstream(folder.file("b.csv")) << "time,x,y\n0,0,0\n10,0,50\n";
    Sea sea = parse_sea("libocean = 1\n[[hulls]]\ntrack_file = \"a.csv\"\n", "s", folder.path());
    set_parameter(sea.parameters, "hulls.0.track_file", "b.csv");
    EXPECT_EQ(sea.parameters.hulls[0].track, nullptr);
    resolve_files(sea, folder.path());
    EXPECT_EQ(sea.parameters.hulls[0].track->rows[1].y, 50.0);
}

TEST(HullTrackFile, AMillionRowsAreRefusedInBoundedTime) {
    std::string text = "time,x,y\n";
    for (int i = 0; i < 1'000'000; ++i) text += std::to_string(i) + ",0,0\n";
    const Refusal refusal = refusal_of([&] { parse_track(text, "log.csv"); });
    EXPECT_EQ(refusal.message,
              "log.csv:50002: more than the 50000 rows allowed; a row for each second is plenty");
}

}  // namespace
}  // namespace ocean::test
