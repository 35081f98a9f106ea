// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: each command line of the folder `refusals` ends with its exit code and its one sentence,
// prints nothing else and changes no file. A group of rows has its commands, files and steps that
// prepare them; the key of a row ends the command line, takes the place of {} in it, or is the
// content of the group's `file`. test_refusals.py runs the first row of each group end to end.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "ocean_program.hpp"
#include "seafile/corpus.hpp"
#include "temporary_folder.hpp"

namespace ocean::test {
namespace {

namespace fs = std::filesystem;

struct Outcome {
    int code;
    std::string output;
    std::string error;
};

/// Runs the words of a line, of which double quotes surround those with blanks and empty ones.
Outcome run(const std::string& line) {
    std::vector<std::string> words = {"ocean"};
    std::istringstream stream(line);
    for (std::string word; stream >> std::quoted(word);) words.push_back(word);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = app::run_ocean(static_cast<int>(arguments.size()), arguments.data(),
                                    app::ocean_catalogue());
    return {code, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
}

/// A name that ends with a slash is a folder.
void write(const fs::path& path, const std::string& bytes) {
    if (path.has_parent_path()) fs::create_directories(path.parent_path());
    if (path.has_filename()) std::ofstream(path, std::ios::binary) << bytes;
}
void write_files(const toml::node* files) {
    if (files == nullptr) return;
    for (const auto& [name, text] : *files->as_table()) write(name.str(), text_of(text));
}

std::map<fs::path, std::string> contents() {
    std::map<fs::path, std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(".")) {
        found[entry.path()] = entry.is_regular_file() ? read_bytes(entry.path().string()) : "";
    }
    return found;
}

void expect_refusal(const std::string& line, int code, const toml::node& sentence) {
    SCOPED_TRACE(line);
    const auto before = contents();
    const Outcome outcome = run(line);
    if (kPrints) std::cout << line << "\n    " << outcome.error;
    EXPECT_EQ(outcome.code, code);
    EXPECT_EQ(outcome.output, "");
    EXPECT_TRUE(contents() == before) << "a file is another than before";
    ASSERT_TRUE(outcome.error.starts_with("ocean: ")) << outcome.error;
    EXPECT_EQ(std::ranges::count(outcome.error, '\n'), 1) << outcome.error;
    expect_sentence(outcome.error.substr(7, outcome.error.size() - 8), &sentence);
}

void expect_row(const toml::table& group, const TomlEntry& row) {
    SCOPED_TRACE("line " + std::to_string(row.line));
    const std::string key = bytes_of(row.key);
    const auto file = group["file"].value<std::string>();
    if (file) write(*file, key);
    for (const toml::node& command : *group["commands"].as_array()) {
        std::string line = text_of(command);
        const std::size_t place = line.find("{}");
        if (place != std::string::npos) {
            line.replace(place, 2, key);
        } else if (!file) {
            line += " " + key;
        }
        expect_refusal(line, group["code"].value_or(2), *row.node);
    }
}

class Refusals : public testing::TestWithParam<fs::path> {};

TEST_P(Refusals, AreThoseOfTheTable) {
    const toml::table table = read_table(GetParam());
    for (const toml::node& node : *table["group"].as_array()) {
        const toml::table& group = *node.as_table();
        const TemporaryFolder folder;
        fs::current_path(folder.path());
        fs::create_directory_symlink(data_dir(), "data");
        write_files(table.get("files"));
        write_files(group.get("files"));
        if (const toml::array* steps = group["prepare"].as_array()) {
            for (const toml::node& step : *steps) ASSERT_EQ(run(text_of(step)).code, 0);
        }
        for (const TomlEntry& row : in_file_order(*group["says"].as_table())) {
            expect_row(group, row);
        }
        fs::current_path(fs::temp_directory_path());
    }
}

INSTANTIATE_TEST_SUITE_P(Of, Refusals, testing::ValuesIn(tables_in("cli/refusals")), name_of_table);

}  // namespace
}  // namespace ocean::test
