// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: headers hold the provenance of a file, and it is read back from them.
#include "ocean/internal/io/provenance.hpp"

#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/io/png.hpp"
#include "ocean/internal/io/read_provenance.hpp"
#include "ocean/internal/io/subject_words.hpp"
#include "ocean/io/exr.hpp"
#include "refusal.hpp"
#include "temporary_folder.hpp"

namespace ocean {
namespace {

using io::HeaderString;
using io::Provenance;
using test::Refusal;
using test::refusal_of;
using test::TemporaryFolder;

std::map<std::string, std::string> as_map(const std::vector<HeaderString>& strings) {
    std::map<std::string, std::string> map;
    for (const auto& [name, text] : strings) map[name] = text;
    return map;
}

const Provenance kSea{.kind = "sea",
                      .text = "libocean = 1\n",
                      .id = "1a2b",
                      .frame = -7,
                      .time = 0.1,
                      .domain = Domain::tile(250.0),
                      .backend = "cpu"};
const Provenance kPlane{.kind = "plane",
                        .text = "tilt = 3\n",
                        .domain = Domain{{100.5, -20.0}, {64.0, 32.0}, {65, 33}, false}};

// The names are an interface: files of all versions have them.
TEST(Provenance, OfASeaHasThePromisedStrings) {
    std::map<std::string, std::string> header = as_map(io::provenance_strings(kSea));
    EXPECT_TRUE(header.erase("ocean:version"));
    const std::map<std::string, std::string> expected{{"ocean:sea", "libocean = 1\n"},
                                                      {"ocean:frame", "-7"},
                                                      {"ocean:time", "0.1"},
                                                      {"ocean:period", "250"},
                                                      {"ocean:backend", "cpu"}};
    EXPECT_EQ(header, expected);
}

TEST(SubjectWords, HaveOneRowForEachKind) {
    const auto texts = [](const io::SubjectWords& words) {
        return words.kind + ", " + words.prim + ", " + words.prefix() + ", " + words.phrase();
    };
    EXPECT_EQ(texts(io::subject_words("sea")), "sea, Ocean, Ocean_, The surface of a sea");
    EXPECT_EQ(texts(io::subject_words("terrain")),
              "terrain, Terrain, Terrain_, The surface of a terrain");
    EXPECT_EQ(texts(io::subject_words("")), texts(io::subject_words("sea")));
    EXPECT_EQ(texts(io::subject_words("ice floe")),
              "ice floe, Ice_floe, Ice_floe_, The surface of an ice floe");
    EXPECT_EQ(io::subject_words(io::provenance_strings(kPlane)).prim, "Plane");
    EXPECT_EQ(io::subject_words(io::provenance_strings(kSea)).prim, "Ocean");
    EXPECT_EQ(io::subject_words(std::vector<HeaderString>{}).prim, "Ocean");
    Provenance terrain = kPlane;
    terrain.kind = kTerrainKind;
    EXPECT_EQ(io::provenance_strings(terrain).front().name, "ocean:terrain");
    EXPECT_EQ(io::find_provenance(io::provenance_strings(terrain), "f")->kind, "terrain");
}

TEST(Provenance, IsReadBackForDomainsThatWrapAndThatDoNot) {
    for (const Provenance& one : {kSea, kPlane}) {
        const auto back = io::find_provenance(io::provenance_strings(one), "f");
        ASSERT_TRUE(back) << one.kind;
        EXPECT_EQ(back->kind, one.kind);
        EXPECT_EQ(back->text, one.text);
        EXPECT_EQ(back->frame, one.frame);
        EXPECT_EQ(back->time, one.time);
        EXPECT_EQ(back->domain, one.domain);
        EXPECT_EQ(back->backend, one.backend);
    }
}

TEST(Provenance, IsAbsentWithoutASubjectAndRefusesBadNumbers) {
    EXPECT_FALSE(io::find_provenance({}, "f"));
    const std::vector<HeaderString> other = {{"ocean:field", "height"}, {"sea", "x"}};
    EXPECT_FALSE(io::find_provenance(other, "f"));
    const std::vector<HeaderString> lost = {{"ocean:subject", "plane"}};
    EXPECT_FALSE(io::find_provenance(lost, "f")) << "its text is missing";
    for (const auto& [name, text] : std::map<std::string, std::string>{
             {"frame", "1.5"}, {"time", ""}, {"period", "wide"}, {"size", "3"}, {"size", "3,"}}) {
        const std::vector<HeaderString> strings = {{"ocean:sea", "x"}, {"ocean:" + name, text}};
        const Refusal refusal = refusal_of([&] { io::find_provenance(strings, "f.exr"); });
        EXPECT_EQ(refusal.kind, ErrorKind::bad_file);
        EXPECT_EQ(refusal.message, "f.exr: its ocean:" + name + " is not a number");
    }
}

TEST(Provenance, IsReadFromImagesByTheirContent) {
    const TemporaryFolder folder;
    const std::vector<std::uint16_t> grey(64 * 64, 7);
    const std::string png = io::grey_png(64, 64, grey);
    const auto strings = io::provenance_strings(kPlane);
    io::write_file_atomically(folder.file("a.dat"), io::with_png_strings(png, strings));
    const std::vector<float> samples(4, 1.0f);
    io::write_exr({.width = 2,
                   .height = 2,
                   .planes = {{.name = "Y", .samples = samples}},
                   .provenance = kPlane},
                  folder.file("b.dat"), io::ExrCompression::none);
    for (const char* name : {"a.dat", "b.dat"}) {
        const auto back = io::read_provenance(folder.file(name));
        ASSERT_TRUE(back) << name;
        EXPECT_EQ(back->kind, "plane");
        EXPECT_EQ(back->text, kPlane.text);
        EXPECT_EQ(back->domain, kPlane.domain);
    }
    io::write_file_atomically(folder.file("c.toml"), "libocean = 1\n");
    EXPECT_FALSE(io::read_provenance(folder.file("c.toml")));
}

TEST(Provenance, IsRefusedForForeignAndTruncatedImages) {
    const TemporaryFolder folder;
    const std::vector<std::uint16_t> grey(64 * 64, 7);
    const std::string png = io::grey_png(64, 64, grey);
    const std::string labelled = io::with_png_strings(png, io::provenance_strings(kSea));
    std::string huge = labelled;
    huge[33] = '\x7f';  // the length of the first text
    for (const std::string& bytes : {png, labelled.substr(0, 60), huge}) {
        io::write_file_atomically(folder.file("a.png"), bytes);
        const Refusal refusal = refusal_of([&] { io::read_provenance(folder.file("a.png")); });
        EXPECT_EQ(refusal.kind, ErrorKind::bad_file) << refusal.message;
    }
}

TEST(ForeignFile, IsNotReplacedAndOwnOrEmptyOnesAre) {
    const TemporaryFolder folder;
    const std::string path = folder.file("a.png");
    const auto guard = [&](bool ours) {
        io::refuse_to_replace_foreign_file(path, "a test", [ours] { return ours; });
    };
    EXPECT_NO_THROW(guard(false)) << "there is none";
    io::write_file_atomically(path, "");
    EXPECT_NO_THROW(guard(false)) << "it is empty";
    io::write_file_atomically(path, "mine");
    EXPECT_NO_THROW(guard(true));
    const Refusal refusal = refusal_of([&] { guard(false); });
    EXPECT_EQ(refusal.kind, ErrorKind::invalid_value);
    EXPECT_EQ(refusal.message, "'" + path +
                                   "' exists and was not written by a test: it is not replaced; "
                                   "move it or choose another name");
    EXPECT_EQ(test::read_bytes(path), "mine");
}

}  // namespace
}  // namespace ocean
