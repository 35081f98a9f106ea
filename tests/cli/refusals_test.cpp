// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: each command line of the folder `refusals` ends with its exit code and its one sentence,
// prints nothing else and changes no file. A table is of one program, a group of rows has its
// commands, files and steps that prepare them; the key of a row ends the command line, takes the
// place of {} in it, or is the content of the group's `file`, or of {} in its `text`.
// test_refusals.py runs the first row of each group end to end.
#include <cstdlib>
#include <iomanip>
#include <iostream>

#include "ocean_program.hpp"
#include "seafile/corpus.hpp"
#include "temporary_folder.hpp"
#if OCEAN_HAS_BRIDGE
#include "bridge_program.hpp"
#endif
#if OCEAN_HAS_PREVIEW
#include "preview_program.hpp"
#endif

namespace ocean::test {
namespace {

namespace fs = std::filesystem;

struct Outcome {
    int code;
    std::string output;
    std::string error;
};

using Main = int (*)(int argc, char** argv);

int run_whole_ocean(int argc, char** argv) {
    return app::run_ocean(argc, argv, app::ocean_catalogue());
}

const std::map<std::string, Main> kPrograms = {
    {"ocean", &run_whole_ocean},
#if OCEAN_HAS_BRIDGE
    {"ocean-bridge", &app::run_bridge},
#endif
#if OCEAN_HAS_PREVIEW
    {"ocean-preview", &app::run_preview},
#endif
};

/// Runs the words of a line, of which double quotes surround those with blanks and empty ones.
Outcome run(const std::string& program, const std::string& line) {
    std::vector<std::string> words = {program};
    std::istringstream stream(line);
    for (std::string word; stream >> std::quoted(word);) words.push_back(word);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = kPrograms.at(program)(static_cast<int>(arguments.size()), arguments.data());
    return {code, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
}

std::string with(std::string text, const std::string& key) {
    const std::size_t place = text.find("{}");
    return place == std::string::npos ? text : text.replace(place, 2, key);
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

void expect_refusal(const std::string& program, const std::string& line, int code,
                    const toml::node& sentence) {
    SCOPED_TRACE(line);
    const auto before = contents();
    const Outcome outcome = run(program, line);
    if (kPrints) std::cout << line << "\n    " << outcome.error;
    EXPECT_EQ(outcome.code, code);
    EXPECT_EQ(outcome.output, "");
    EXPECT_TRUE(contents() == before) << "a file is another than before";
    const std::size_t begin = program.size() + 2;
    ASSERT_TRUE(outcome.error.starts_with(program + ": ")) << outcome.error;
    EXPECT_EQ(std::ranges::count(outcome.error, '\n'), 1) << outcome.error;
    expect_sentence(outcome.error.substr(begin, outcome.error.size() - begin - 1), &sentence);
}

void expect_row(const std::string& program, const toml::table& group, const TomlEntry& row) {
    SCOPED_TRACE("line " + std::to_string(row.line));
    const std::string key = bytes_of(row.key);
    const auto file = group["file"].value<std::string>();
    if (file) write(*file, with(group["text"].value_or("{}"), key));
    for (const toml::node& command : *group["commands"].as_array()) {
        std::string line = text_of(command);
        if (!file && line.find("{}") == std::string::npos) line += " {}";
        expect_refusal(program, with(line, key), group["code"].value_or(2), *row.node);
    }
}

class Refusals : public testing::TestWithParam<fs::path> {};

TEST_P(Refusals, AreThoseOfTheTable) {
    const toml::table table = read_table(GetParam());
    const std::string program = table["program"].value_or("ocean");
    if (!kPrograms.contains(program)) GTEST_SKIP() << program << " was not built";
    for (const char* display : {"DISPLAY", "WAYLAND_DISPLAY"}) unsetenv(display);
    for (const toml::node& node : *table["group"].as_array()) {
        const toml::table& group = *node.as_table();
        const TemporaryFolder folder;
        fs::current_path(folder.path());
        fs::create_directory_symlink(data_dir(), "data");
        write_files(table.get("files"));
        write_files(group.get("files"));
        if (const toml::array* steps = group["prepare"].as_array()) {
            for (const toml::node& step : *steps) ASSERT_EQ(run(program, text_of(step)).code, 0);
        }
        for (const TomlEntry& row : in_file_order(*group["says"].as_table())) {
            expect_row(program, group, row);
        }
        fs::current_path(fs::temp_directory_path());
    }
}

INSTANTIATE_TEST_SUITE_P(Of, Refusals, testing::ValuesIn(tables_in("cli/refusals")), name_of_table);

}  // namespace
}  // namespace ocean::test
