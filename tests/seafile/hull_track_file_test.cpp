// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Tracks of hulls: what a CSV file and the rows of a sea file mean, and that a saved sea carries
// them.
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

/// A file with two segments and what receivers write beside the points.
std::string gpx_text() {
    return "\xEF\xBB\xBF<?xml version='1.0'?>\n<!-- a <trkpt> in a comment -->\n"
           "<g:gpx xmlns:g=\"http://www.topografix.com/GPX/1/1\" creator=\"a > b\">\n"
           "<metadata><time>2020-01-01T00:00:00Z</time></metadata>\n"
           "<wpt lat=\"1\" lon=\"1\"/>\n"
           "<g:trk><name>Tom &amp; Ida</name><trkseg>\n"
           "<g:trkpt lat='0.0' lon='10.0'><ele>3</ele><time> 2026-05-01T10:00:00Z "
           "</time></g:trkpt>\n"
           "<trkpt lon=\"10.001\" lat=\"0\"><time>2026-05-01T12:00:40.5+02:00</time></trkpt>\n"
           "</trkseg><trkseg>\n"
           "<trkpt lat=\"0.001\" lon=\"10.001\"><time>2026-05-01T10:01:30</time>\n"
           "<extensions><time>noon</time></extensions></trkpt>\n"
           "</trkseg></g:trk></g:gpx>\n";
}

TEST(HullTrackFile, GpxPointsLieInTheTangentPlaneOfTheOrigin) {
    Hull hull;
    hull.origin = {0.0, 10.0};
    const auto points = parse_gpx(gpx_text(), "boat.gpx");
    const HullTrack track = placed_track(points, hull, "boat.gpx");
    require_track(track, "boat.gpx");
    ASSERT_EQ(track.rows.size(), 3u);
    const double times[] = {0.0, 40.5, 90.0};
    for (std::size_t i = 0; i < 3; ++i) EXPECT_DOUBLE_EQ(track.rows[i].time, times[i]);
    // A thousandth of a degree: a = 6378137 m along the equator, a (1 - e^2) along a meridian.
    EXPECT_NEAR(track.rows[0].x, 0.0, 1e-9);
    EXPECT_NEAR(track.rows[1].x, 111.3195, 1e-4);
    EXPECT_NEAR(track.rows[1].y, 0.0, 1e-6);
    EXPECT_NEAR(track.rows[2].y, 110.5743, 1e-4);
    hull.origin_time = "2026-05-01T09:59:00Z";
    EXPECT_DOUBLE_EQ(placed_track(points, hull, "boat.gpx").rows[0].time, 60.0);
    // In the north the parallels are shorter, and north stays north.
    hull.origin = {60.0, 10.0};
    const HullTrack north = placed_track({{60.0, 10.01, 0.0}, {60.01, 10.0, 60.0}}, hull, "b.gpx");
    EXPECT_NEAR(north.rows[0].x, 558.0, 0.1);
    EXPECT_NEAR(north.rows[0].y, 0.042, 0.001);  // the parallel bends to the north
    EXPECT_NEAR(north.rows[1].x, 0.0, 1e-6);
    EXPECT_NEAR(north.rows[1].y, 1114.1, 0.1);
}

TEST(HullTrackFile, ASeaReadsGpxByItsOriginAndCarriesTheRows) {
    const TemporaryFolder folder;
    std::ofstream(folder.file("boat.gpx")) << gpx_text();
    std::ofstream(folder.file("boat.csv")) << "time,x,y\n0,0,0\n10,50,0\n";
    const auto read = [&](const std::string& keys) {
        return parse_sea("libocean = 1\n[[hulls]]\n" + keys, "sea.toml", folder.path());
    };
    Sea sea = read("track_file = \"boat.gpx\"\norigin = [0, 10]\n");
    EXPECT_NEAR(sea.parameters.hulls[0].track->rows[1].x, 111.3195, 1e-4);
    const Sea again = parse_sea(write_sea(sea), "saved.toml", "/nowhere");
    EXPECT_EQ(difference(again, sea), "");
    set_parameter(sea.parameters, "hulls.0.origin", "[0, 10.001]");
    resolve_files(sea, folder.path());
    EXPECT_NEAR(sea.parameters.hulls[0].track->rows[1].x, 0.0, 1e-9);
    const auto sentence = [&](const std::string& keys) {
        return refusal_of([&] { read(keys); }).message;
    };
    EXPECT_NE(sentence("track_file = \"boat.gpx\"\n")
                  .find("a GPX track needs origin = [latitude, longitude], the place of (0, 0) in "
                        "degrees; its first point is at [0.0, 10.0]"),
              std::string::npos);
    EXPECT_NE(sentence("track_file = \"boat.gpx\"\norigin = [95, 10]\n").find("needs origin"),
              std::string::npos);
    EXPECT_NE(sentence("track_file = \"boat.gpx\"\norigin = [0, 10]\norigin_time = \"noon\"\n")
                  .find("origin_time = 'noon'; allowed is such as 2026-05-01T10:00:03Z"),
              std::string::npos);
    EXPECT_NE(sentence("track_file = \"boat.csv\"\norigin = [0, 10]\n")
                  .find("origin and origin_time belong to a GPX track"),
              std::string::npos);
}

TEST(HullTrackFile, APartOfAGpxFileIsRefused) {
    const std::string text = gpx_text();
    for (std::size_t size = 0; size + 2 < text.size(); ++size) {
        EXPECT_TRUE(refusal_of([&] { parse_gpx(text.substr(0, size), "boat.gpx"); }).refused)
            << size;
    }
}

TEST(HullTrackFile, TooManyPointsAreRefusedInBoundedTime) {
    std::string text = "<gpx>";
    for (int i = 0; i < 60'000; ++i) {
        text += "<trkpt lat=\"0\" lon=\"0\"><time>2026-05-01T10:00:00Z</time></trkpt>";
    }
    const Refusal refusal = refusal_of([&] { parse_gpx(text, "log.gpx"); });
    EXPECT_EQ(refusal.message,
              "log.gpx:1: more than the 50000 points allowed; a point for each second is plenty");
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
