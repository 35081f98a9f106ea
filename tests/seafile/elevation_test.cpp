// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: .asc and .flt + .hdr are read as GIS programs write them, with rows from the south, the
// origin at the centre of the south-west cell, metres and NaN for holes; each assumption is a note;
// whatever is not such a file is refused by one sentence, before its memory is allocated.
#include "ocean/internal/elevation_file.hpp"

#include "helpers.hpp"
#include "temporary_folder.hpp"

namespace ocean {
namespace {

using test::Refusal;
using test::refusal_of;
using test::TemporaryFolder;

const std::string kHeader = "ncols 3\nnrows 2\nxllcorner 1000\nyllcorner 2000\ncellsize 10\n";
const std::string kHeights = "1 2 3\n4 5 6\n";

ElevationModel parse(const std::string& text, const ElevationOptions& options = {},
                     const std::string& crs = "") {
    std::istringstream stream(text);
    return parse_ascii_grid(stream, text.size(), "bed.asc", crs, options);
}

Refusal refusal(const std::string& text, const ElevationOptions& options = {}) {
    return refusal_of([&] { parse(text, options); });
}

std::vector<float> values(const ElevationModel& model) {
    return {model.heights.begin(), model.heights.end()};
}

std::string floats(std::initializer_list<float> heights, bool swapped = false) {
    std::string bytes;
    for (const float height : heights) {
        char four[4];
        std::memcpy(four, &height, 4);
        if (swapped) std::reverse(four, four + 4);
        bytes.append(four, 4);
    }
    return bytes;
}

TEST(ElevationFile, AnAsciiGridIsReadFromTheNorthAndKeptFromTheSouth) {
    const ElevationModel model = parse(kHeader + kHeights);
    EXPECT_EQ(model.domain.samples, (std::array{3, 2}));
    EXPECT_FALSE(model.domain.wraps);
    EXPECT_EQ(model.domain.origin, (std::array{1005.0, 2005.0}));
    EXPECT_EQ(model.domain.step(0), 10.0);
    EXPECT_EQ(model.domain.step(1), 10.0);
    EXPECT_EQ(values(model), (std::vector<float>{4, 5, 6, 1, 2, 3}));
    EXPECT_TRUE(model.notes.empty());
    EXPECT_EQ(model.crs, "");
}

TEST(ElevationFile, TheHeadersOfOtherProgramsMeanTheSame) {
    const std::vector<float> expected = values(parse(kHeader + kHeights));
    const char* const headers[] = {
        "NCOLS 3\r\nNROWS 2\r\nXLLCENTER 1005\r\nYLLCENTER 2005\r\nCELLSIZE 10\r\n",
        "# by hand\n// twice\nnrows 2\nncols 3\nxllcorner 1000.0\nyllcorner 2000.0\n"
        "dx 10\ndy 10\nNODATA_value -32768\n",
        "\xEF\xBB\xBFncols\t3\nnrows   2\nxllcorner 1,0e3\nyllcorner 2000,0\ncellsize 10,0\n"
        "nodata_value nan\n",
        "ncols 3 nrows 2 xllcorner 1000 yllcorner 2000 cellsize 1e1 NODATA_value -1.#IND ",
    };
    for (const char* header : headers) {
        const ElevationModel model = parse(header + kHeights);
        EXPECT_EQ(values(model), expected) << header;
        EXPECT_EQ(model.domain.origin, (std::array{1005.0, 2005.0})) << header;
        EXPECT_EQ(model.domain.step(1), 10.0) << header;
    }
    // Heights may break their lines anywhere, and have decimal commas.
    EXPECT_EQ(values(parse(kHeader + "1\n2 3,0 4\t5\n\n6")), expected);
}

TEST(ElevationFile, HolesAreRefusedFilledOrKept) {
    const std::string text = kHeader + "NODATA_value -999\n1 2 3\n1 -999 3\n";
    const Refusal refused = refusal(text);
    EXPECT_EQ(refused.kind, ErrorKind::bad_file);
    EXPECT_EQ(refused.message,
              "bed.asc: 1 of 6 heights (17 %) are missing; they can be filled with the smooth "
              "surface around them (holes: fill)");
    const ElevationModel kept = parse(text, {.holes = HolePolicy::keep});
    EXPECT_TRUE(std::isnan(kept.heights[1]));
    const ElevationModel filled = parse(text, {.holes = HolePolicy::fill});
    EXPECT_NEAR(filled.heights[1], 2.0f, 1e-3f);
    ASSERT_EQ(filled.notes.size(), 1u);
    EXPECT_TRUE(refusal(kHeader + "-9999 2 3 4 5 6").refused);  // ESRI's default value
    // A common mark that the header does not declare is no hole, and a note.
    EXPECT_EQ(parse(kHeader + "-32768 2 3 4 5 6").notes.size(), 1u);
    // No file means such a height.
    EXPECT_TRUE(std::isnan(
        parse(kHeader + "-3.40282e38 2 3 nan 5 6", {.holes = HolePolicy::keep}).heights[3]));
}

TEST(ElevationFile, ADeclaredMarkIsAHoleAtThePrecisionOfItsCells) {
    // The mark, a cell, and whether the cell is the mark.
    struct Case {
        const char* mark;
        const char* cell;
        bool is_hole;
    };
    for (const Case& one : {
             Case{"-9999.9", "-9999.900390625", true},  // a float's digits
             Case{"-9999.9", "-9999.9", true},
             Case{"-9999,9", "-9999.90039", true},
             Case{"-9999.98765", "-9999.99", true},  // %g
             Case{"-32767.1234", "-3.27671e+04", true},
             Case{"-99999.99", "-100000", true},
             Case{"-9999.90", "-9999.904", true},  // the header's word is the rounded one
             Case{"1.70141e4", "17014.1183", true},
             Case{"-9999", "-9999.00001", true},
             Case{"-9999", "-9999.01", false},
             Case{"-9999.00", "-9999.004", false},  // a whole number is exact
             Case{"-9999", "-10000", false},
             Case{"-9999.9", "-10000", false},  // five digits: a height
             Case{"-9999.98765", "-9999.98", false},
             Case{"0", "0.0000001", false},
             Case{"0.4", "0", false},
         }) {
        const std::string text = kHeader + "NODATA_value " + one.mark + "\n1 2 3 4 5 " + one.cell;
        const float height = parse(text, {.holes = HolePolicy::keep}).heights[2];
        EXPECT_EQ(std::isnan(height), one.is_hole) << one.mark << " and " << one.cell;
    }
}

TEST(ElevationFile, AnotherMarkThanTheDeclaredOneIsAHeightAndANote) {
    const auto notes = [](const std::string& heights) {
        return parse(kHeader + "NODATA_value -9999\n" + heights, {.holes = HolePolicy::keep}).notes;
    };
    EXPECT_EQ(notes("-32768 -32768 -9999 4 5 6")[0],
              "2 heights are -32768, a common mark for missing heights, which the file does not "
              "declare; they are kept");
    EXPECT_EQ(notes("32767 2 3 4 5 6")[0],
              "1 height is 32767, a common mark for missing heights, which the file does not "
              "declare; it is kept");
    EXPECT_EQ(notes("32767 -32768 -99999 -32767 5 6").size(), 4u);
    EXPECT_TRUE(notes("1 2 3 4 5 6").empty());
}

TEST(ElevationFile, UnitsAndSignsBecomeMetresUpwards) {
    const auto first = [](const ElevationOptions& options) {
        return parse(kHeader + kHeights, options).heights[0];
    };
    EXPECT_FLOAT_EQ(first({.unit = HeightUnit::ft}), 4.0f * 0.3048f);
    EXPECT_FLOAT_EQ(first({.unit = HeightUnit::us_ft}), 4.0f * 1200.0f / 3937.0f);
    EXPECT_EQ(first({.sign = HeightSign::down}), -4.0f);
}

TEST(ElevationFile, DegreesAreToldByTheFileByTheNumbersOrByTheUser) {
    const std::string geographic =
        "ncols 3\nnrows 2\nxllcorner -119.5\nyllcorner 34\ncellsize 0.001\n" + kHeights;
    const ElevationModel guessed = parse(geographic);
    EXPECT_TRUE(guessed.was_degrees);
    EXPECT_NEAR(guessed.domain.step(1), 110.92, 0.01);
    EXPECT_NEAR(guessed.domain.step(0), 92.38, 0.01);
    EXPECT_NEAR(guessed.geographic_origin[0], -119.4995, 1e-9);
    ASSERT_EQ(guessed.notes.size(), 1u);
    EXPECT_TRUE(test::says(guessed.notes[0], "guessed"));
    EXPECT_FALSE(parse(geographic, {.degrees = CellsInDegrees::no}).was_degrees);
    // A pond in metres with an origin of its own.
    EXPECT_FALSE(
        parse("ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 0.5\n" + kHeights).was_degrees);
    EXPECT_FALSE(parse(geographic, {}, "PROJCS[\"local\",UNIT[\"metre\",1]]").was_degrees);
    const std::string wgs = "GEOGCS[\"WGS 84\",UNIT[\"degree\",0.0174532925199433]]";
    EXPECT_TRUE(parse(geographic, {}, wgs).was_degrees);
    const ElevationModel forced =
        parse("ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 2\n" + kHeights,
              {.degrees = CellsInDegrees::yes});
    EXPECT_NEAR(forced.domain.step(0), 222500.0, 300.0);
}

TEST(ElevationFile, AProjectionInFeetIsScaled) {
    const std::string crs =
        "PROJCS[\"NAD83 / California zone 5 (ftUS)\",GEOGCS[\"NAD83\",PRIMEM[\"Greenwich\",0],"
        "UNIT[\"degree\",0.0174532925199433]],PROJECTION[\"Lambert\"],"
        "PARAMETER[\"false_easting\",6561666.667],UNIT[\"US survey foot\",0.3048006096012192]]";
    const ElevationModel model = parse(kHeader + kHeights, {}, crs);
    EXPECT_FALSE(model.was_degrees);
    EXPECT_NEAR(model.domain.step(0), 3.048006096, 1e-9);
    EXPECT_NEAR(model.domain.origin[1], 2005.0 * 0.3048006096, 1e-6);
    ASSERT_EQ(model.notes.size(), 1u);
    EXPECT_EQ(parse(kHeader + kHeights, {}, "Projection UTM Zone 11 Units METERS").domain.step(0),
              10.0);
}

TEST(ElevationFile, AMapOfMercatorIsToldToStretchTheGround) {
    for (const char* crs : {"PROJCS[\"WGS 84 / Pseudo-Mercator\",PROJECTION[\"Mercator_1SP\"]]",
                            "PROJCS[\"a\",PROJECTION[\"Mercator_Auxiliary_Sphere\"]]",
                            "PROJCRS[\"a\",METHOD[\"Popular Visualisation Pseudo Mercator\"]]"}) {
        const auto notes = parse(kHeader + kHeights, {}, crs).notes;
        ASSERT_EQ(notes.size(), 1u) << crs;
        EXPECT_TRUE(test::says(notes[0], "is Mercator's, which stretches the ground"));
    }
    const char* const utm = "PROJCS[\"UTM\",PROJECTION[\"Transverse_Mercator\"],UNIT[\"m\",1]]";
    EXPECT_TRUE(parse(kHeader + kHeights, {}, utm).notes.empty());
}

TEST(ElevationFile, RawFloatsHaveEitherByteOrderAndEitherHeader) {
    const TemporaryFolder folder;
    const std::string path = folder.file("bed.flt");
    const std::string old_header = kHeader + "NODATA_value -9999\nbyteorder LSBFIRST\n";
    const std::string raster_header =
        "BYTEORDER M\nLAYOUT BIL\nNROWS 2\nNCOLS 3\nNBANDS 1\nNBITS 32\nBANDROWBYTES 12\n"
        "TOTALROWBYTES 12\nPIXELTYPE FLOAT\nULXMAP 1005\nULYMAP 2015\nXDIM 10\nYDIM 10\n";
    const std::vector<float> expected = values(parse(kHeader + kHeights));
    folder.write("bed.flt", floats({1, 2, 3, 4, 5, 6}));
    folder.write("bed.hdr", old_header);
    EXPECT_EQ(values(read_elevation(path)), expected);
    EXPECT_EQ(values(read_elevation(folder.file("bed.hdr"))), expected);
    folder.write("bed.flt", floats({1, 2, 3, 4, 5, 6}, true));
    folder.write("bed.hdr", raster_header);
    const ElevationModel model = read_elevation(path);
    EXPECT_EQ(values(model), expected);
    EXPECT_EQ(model.domain, parse(kHeader + kHeights).domain);
    folder.write("bed.hdr", kHeader);
    folder.write("bed.flt", floats({1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(read_elevation(path).notes.size(), 1u);  // the byte order is assumed
    folder.write("bed.prj", "PROJCS[\"UTM 11\",\r\nUNIT[\"metre\",1]]\r\n");
    EXPECT_EQ(read_elevation(path).crs, "PROJCS[\"UTM 11\",  UNIT[\"metre\",1]]");
}

TEST(ElevationFile, ProgressIsToldWhileRowsAreRead) {
    std::string text = "ncols 2\nnrows 200\nxllcorner 0\nyllcorner 0\ncellsize 10\n";
    for (int row = 0; row < 200; ++row) text += "1 2\n";
    int calls = 0;
    parse(text, {.progress = [&](int row, int rows) {
              ++calls;
              EXPECT_LT(row, rows);
          }});
    EXPECT_GE(calls, 3);
    EXPECT_TRUE(refusal_of([&] {
                    parse(text, {.progress = [](int, int) {
                              throw Error(ErrorKind::interrupted, "stopped");
                          }});
                }).says("stopped"));
}

TEST(ElevationFile, CellsOfDegreesEndAtThePoles) {
    EXPECT_EQ(refusal("ncols 3\nnrows 2\nxllcorner 0\nyllcorner 89\ncellsize 1\n" + kHeights,
                      {.degrees = CellsInDegrees::yes})
                  .message,
              "bed.asc: cells of degrees reach beyond a pole: the latitudes must lie within -90 .. "
              "90");
}

TEST(ElevationFile, EachBadFileGetsItsSentence) {
    const TemporaryFolder folder;
    const auto message = [&](const std::string& name) {
        std::string text = refusal_of([&] { read_elevation(folder.file(name)); }).message;
        for (std::size_t at = 0; (at = text.find(folder.path() + "/")) != text.npos;) {
            text.erase(at, folder.path().size() + 1);
        }
        return text;
    };
    EXPECT_EQ(message("missing.asc"), "missing.asc: no such file");
    std::filesystem::create_directory(folder.file("dir.asc"));
    EXPECT_EQ(message("dir.asc"), "dir.asc: is a directory, not a file");
    folder.write("alone.flt", floats({1, 2}));
    EXPECT_EQ(message("alone.flt"),
              "alone.flt: has no header beside it: a .flt file needs a .hdr file of its name");
    folder.write("only.hdr", kHeader);
    EXPECT_EQ(message("only.hdr"), "only.hdr: has no .flt file of its name beside it");
    const auto message_of = [&](const std::string& heights, const std::string& header) {
        folder.write("a.flt", heights);
        folder.write("a.hdr", kHeader + header);
        return message("a.flt");
    };
    EXPECT_EQ(message_of(floats({1, 2, 3, 4, 5}), ""),
              "a.flt: has 20 bytes, its header says 3 x 2 floats, which are 24");
    EXPECT_EQ(message_of(floats({1, 2, 3, 4, 5, 6, 7}), ""),
              "a.flt: has 28 bytes, its header says 3 x 2 floats, which are 24");
    EXPECT_EQ(message_of(floats({1, 2, 3}), "nbits 16\npixeltype SIGNEDINT\n"),
              "a.hdr:6: nbits = 16; allowed: 32, the bits of a float");
    EXPECT_EQ(message_of(floats({1, 2, 3, 4, 5, 6}, true), "byteorder VMS\n"),
              "a.hdr:6: byteorder = 'vms'; allowed: LSBFIRST, MSBFIRST");
    EXPECT_TRUE(
        test::says(message_of(floats({1000, 2, 3, 4, 5, 300000}, true), "byteorder MSBFIRST\n"),
                   "; or the byteorder of the header is wrong"));
    folder.write("photo.jpg", "\xFF\xD8\xFF");
    EXPECT_EQ(message("photo.jpg"),
              "photo.jpg: is no elevation model: .asc, or .flt with .hdr, are read, and `ocean "
              "terrain import` converts GeoTIFF, .hgt, PNG, EXR and others");
    // A grid is recognised by its content, too.
    folder.write("grid.txt", "# a comment\n" + kHeader + kHeights);
    EXPECT_EQ(message("grid.txt"), "");
}

TEST(ElevationFile, ForeignFormatsAreToldTheirCommand) {
    const TemporaryFolder folder;
    const auto check = [&](const std::string& name, const std::string& bytes,
                           const std::string& words) {
        folder.write(name, bytes);
        const Refusal refused = refusal_of([&] { read_elevation(folder.file(name)); });
        EXPECT_EQ(refused.kind, ErrorKind::unsupported) << name;
        EXPECT_TRUE(refused.says(words));
    };
    for (const char* name : {"a.tif", "a.TIFF", "N34W119.hgt", "a.png", "a.exr"}) {
        check(name, "", "`ocean terrain import " + folder.file(name) + " -o bed.flt`");
    }
    check("tiff.dat", std::string("II*\0 rest", 9), "format TIFF: convert it by `ocean terrain");
    check("a.nc", "CDF\1", "`gdal_translate -ot Float32 ");
    check("a.nc", "CDF\1", "`ocean terrain import bed.tif -o bed.flt`");
}

}  // namespace
}  // namespace ocean
