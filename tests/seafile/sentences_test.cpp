// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Broken texts of sea files, takes, tracks, rings and grids of heights: the folder `sentences` has
// a table for each reader, whose rows are a text and the one sentence that refuses it.

#include <iostream>

#include "corpus.hpp"
#include "helpers.hpp"
#include "ocean/internal/elevation_file.hpp"
#include "ocean/internal/measured_rings.hpp"
#include "track_file.hpp"

namespace ocean::test {
namespace {

using Read = void (*)(const std::string& text);
const std::map<std::string, Read> kReaders = {
    {"grid",
     [](const std::string& text) {
         std::istringstream stream(text);
         parse_ascii_grid(stream, text.size(), "bed.asc", "", {});
     }},
    {"gpx",
     [](const std::string& text) {
         Hull hull;
         hull.origin = {59.9, 10.7};
         require_track(placed_track(parse_gpx(text, "boat.gpx"), hull, "boat.gpx"), "boat.gpx");
     }},
    {"rings", [](const std::string& text) { parse_rings(text, "r.csv"); }},
    {"sea", [](const std::string& text) { parse(text); }},
    {"take", [](const std::string& text) { parse_take(text, "storm.take", Parameters{}); }},
    {"track",
     [](const std::string& text) { require_track(parse_track(text, "boat.csv"), "boat.csv"); }}};

class Sentences : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(Sentences, AreThoseOfTheTable) {
    const Read read = kReaders.at(std::filesystem::path(GetParam()).stem().string());
    const toml::table table = read_table(GetParam());
    for (const toml::node& node : *table["row"].as_array()) {
        const toml::table& row = *node.as_table();
        SCOPED_TRACE("line " + std::to_string(line_of(node)));
        Refusal refusal = refusal_of([&] { read(text_of(*row.get("text"))); });
        const std::size_t path = refusal.message.find(kData);
        if (path != std::string::npos) refusal.message.erase(path, kData.size() + 1);
        if (kPrints) std::cout << "[[row]]\nsays = \"" << refusal.message << "\"\n";
        expect_sentence(refusal.message, row.get("says"));
        const auto kind = row["kind"].value_or(table["kind"].value_or(std::string()));
        if (!refusal.refused) continue;
        EXPECT_EQ(refusal.kind, kind == "bad_file"      ? ErrorKind::bad_file
                                : kind == "not_found"   ? ErrorKind::not_found
                                : kind == "unsupported" ? ErrorKind::unsupported
                                                        : ErrorKind::invalid_value);
    }
}

INSTANTIATE_TEST_SUITE_P(Of, Sentences, testing::ValuesIn(tables_in("seafile/sentences")),
                         name_of_table);

}  // namespace
}  // namespace ocean::test
