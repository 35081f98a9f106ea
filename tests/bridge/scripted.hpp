// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests that are steps in a file of the folder `scripts`, with what each step gives behind "->".
#pragma once

#include "seafile/corpus.hpp"

namespace ocean::bridge::test {

struct Step {
    std::string line;
    std::vector<std::string> words;
    std::optional<std::string> gives;  // with a blank before it, or ""
};

struct Script {
    std::string name;
    std::string map;  // "" if it needs none
    std::vector<Step> steps;

    friend void PrintTo(const Script& script, std::ostream* stream) { *stream << script.name; }
};

inline std::vector<Step> steps_of(const std::string& text) {
    std::vector<Step> steps;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        line.erase(std::min(line.find("  #"), line.size()));
        if (line.empty() || line.front() == '#') continue;
        Step step{line, {}, std::nullopt};
        if (const std::size_t arrow = line.find(" ->"); arrow != std::string::npos) {
            step.gives = line.substr(arrow + 3);
            line.erase(arrow);
        }
        std::istringstream words(line);
        for (std::string word; words >> word;) step.words.push_back(word);
        steps.push_back(std::move(step));
    }
    return steps;
}

inline std::vector<Script> scripts_of(const std::string& file) {
    const toml::table table =
        ocean::test::read_table(ocean::test::source_dir() + "/tests/bridge/scripts/" + file);
    std::vector<Script> scripts;
    for (const toml::node& node : *table["script"].as_array()) {
        const toml::table& script = *node.as_table();
        scripts.push_back({script["name"].value_or(""), script["map"].value_or(""),
                           steps_of(script["steps"].value_or(""))});
    }
    return scripts;
}

inline std::string name_of_script(const testing::TestParamInfo<Script>& info) {
    return info.param.name;
}

}  // namespace ocean::bridge::test
