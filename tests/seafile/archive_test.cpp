// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Archives of spectra: files of one format are read as one, and skipped files are reported.
#include "archive.hpp"

#include "helpers.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::test {
namespace {

struct File {
    std::string name;
    std::string content;
    char type = '0';
};

/// Returns an archive as `tar` writes it, with two empty blocks at its end.
std::string tar(const std::vector<File>& files) {
    std::string archive;
    for (const File& file : files) {
        std::array<char, 512> header{};
        const auto put = [&](std::size_t at, const std::string& text) {
            std::copy(text.begin(), text.end(), header.begin() + static_cast<std::ptrdiff_t>(at));
        };
        put(0, file.name.substr(0, 100));
        put(124, format_text("%011o", static_cast<unsigned>(file.content.size())));
        put(148, "        ");
        header[156] = file.type;
        put(257, "ustar");
        const unsigned sum = std::accumulate(
            header.begin(), header.end(), 0u,
            [](unsigned total, char c) { return total + static_cast<unsigned char>(c); });
        put(148, format_text("%06o", sum));
        header[154] = '\0';
        archive.append(header.data(), header.size()).append(file.content);
        archive.resize((archive.size() + 511) / 512 * 512);
    }
    return archive + std::string(1024, '\0');
}

const std::string kCsvA = "station,frequency,density\nA,.1,1\nA,.2,2\n";
const std::string kCsvB = "station,frequency,density\nB,.1,3\nB,.2,4\n";

std::vector<SpectrumRecord> read_tar(const std::string& content) {
    return read_spectra_from({content, "s.tar", {}});
}

TEST(Archive, TheFilesOfOneFormatAreReadAndTheOthersNamed) {
    const std::string swan = "SWAN 1\nTIME\n";
    const std::vector<SpectrumRecord> records = read_tar(tar({{"x/", "", '5'},
                                                              {"readme", "hello\n"},
                                                              {"x/a.csv", kCsvA},
                                                              {"b.spec", swan},
                                                              {"x/b.csv", kCsvB}}));
    ASSERT_EQ(records.size(), 2u);
    EXPECT_EQ(records[0].station, "A");
    EXPECT_EQ(records[1].density[1], 4.0);
    EXPECT_EQ(records[1].warnings,
              (std::vector<std::string>{
                  "2 of 4 files of the archive are left out, the first of them readme"}));
    EXPECT_TRUE(read_tar(tar({{"a.csv", kCsvA}})).front().warnings.empty());
}

TEST(Archive, AFileThatCannotBeReadCostsNoOther) {
    const std::vector<SpectrumRecord> records =
        read_tar(tar({{"a.csv", kCsvA}, {"b.csv", "frequency,density\n.1,x\n"}}));
    ASSERT_EQ(records.size(), 2u);
    EXPECT_EQ(records[1].fault, "s.tar/b.csv:2: the density 'x' is not a number");
    EXPECT_EQ(refusal_of([] {
                  read_tar(tar({{"b.csv", "frequency,density\n.1,x\n"}}));
              }).message,
              "s.tar/b.csv:2: the density 'x' is not a number");
    EXPECT_TRUE(refusal_of([] {
                    read_tar(tar({{"readme", "hello\n"}}));
                }).says("s.tar: is an archive without a spectrum file of a known format"));
}

TEST(Archive, TablesThatBelongTogetherAreReadTogether) {
    std::vector<File> files;
    for (const char* suffix : {".swdir", ".swdir2", ".swr1", ".swr2", ".data_spec"}) {
        files.push_back({std::string("n/41010") + suffix,
                         text::read_file(kData + "/spectra/ndbc_41010" + suffix, 1 << 20)});
    }
    const std::vector<SpectrumRecord> records = read_tar(tar(files));
    const std::vector<SpectrumRecord> apart = read_spectra(kBuoy);
    ASSERT_EQ(records.size(), apart.size());
    EXPECT_TRUE(same_record(records[0], apart[0]));
    EXPECT_TRUE(records[0].has_moments());
}

TEST(Archive, LongNamesAndCutsAndDamage) {
    const std::string name = std::string(150, 'n') + "/a.csv";
    std::string cut_off;
    const std::string gnu =
        tar({{"././@LongLink", name + std::string(1, '\0'), 'L'}, {"n", kCsvA}});
    EXPECT_EQ(tar_members(gnu, "s.tar", cut_off).front().name, name);
    const std::string pax =
        tar({{"x", std::to_string(name.size() + 10) + " path=" + name + "\n", 'x'}, {"n", kCsvA}});
    EXPECT_EQ(tar_members(pax, "s.tar", cut_off).front().name, name);
    EXPECT_EQ(cut_off, "");

    const std::string two = tar({{"a.csv", kCsvA}, {"b.csv", kCsvB + std::string(600, ' ')}});
    const std::vector<SpectrumRecord> records = read_tar(two.substr(0, 512 + 512 + 512 + 20));
    ASSERT_EQ(records.size(), 1u);
    EXPECT_EQ(records[0].warnings,
              (std::vector<std::string>{
                  "1 of 2 files of the archive are left out, the first of them b.csv (cut off)"}));
    EXPECT_TRUE(
        says(message_of([&] { read_tar(two.substr(0, 520)); }), "tar: the file is cut off"));
    std::string damaged = two;
    damaged[1024 + 3] = '!';
    EXPECT_EQ(message_of([&] { read_tar(damaged); }),
              "s.tar: tar: the header of a file is damaged");
    EXPECT_FALSE(is_tar(kCsvA));
    EXPECT_FALSE(is_tar(std::string(2000, '\0')));
    EXPECT_TRUE(says(message_of([] { read_tar("PK\x03\x04 etc."); }), "is a zip archive"));
}

}  // namespace
}  // namespace ocean::test
