// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: of ten names of each table that messages suggest from (commands, options, keys, formats,
// products, presets, words of the wire) every typo of one letter suggests the name, and nothing is
// suggested that is more than two edits away. The tables of the folders `refusals`
// and `mistakes` have the places that suggest.
#include "commands.hpp"
#include "ocean/backend.hpp"
#include "ocean/bake/catalogue.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/internal/water_types.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/seafile.hpp"
#include "ocean_program.hpp"
#if __has_include("ocean/internal/bridge/line_protocol.hpp")
#include "ocean/internal/bridge/line_protocol.hpp"
#include "ocean/internal/bridge/value_table.hpp"
#include "testing.hpp"
#endif

namespace ocean::app {
namespace {

/// Returns the words that one insertion, deletion, replacement or exchange makes of a name.
std::vector<std::string> typos_of(const std::string& name) {
    std::vector<std::string> typos;
    for (std::size_t i = 0; i <= name.size(); ++i) {
        typos.push_back(name.substr(0, i) + "q" + name.substr(i));
        if (i == name.size()) break;
        typos.push_back(name.substr(0, i) + name.substr(i + 1));
        typos.push_back(name.substr(0, i) + "q" + name.substr(i + 1));
        std::string exchanged = name;
        if (i + 1 < name.size()) std::swap(exchanged[i], exchanged[i + 1]);
        typos.push_back(exchanged);
    }
    return typos;
}

/// Counts the edits between two words, as a check of the library's own count.
std::size_t edits_between(const std::string& a, const std::string& b) {
    std::vector<std::vector<std::size_t>> edits(a.size() + 1,
                                                std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                edits[i][j] = i + j;
                continue;
            }
            edits[i][j] = std::min({edits[i - 1][j] + 1, edits[i][j - 1] + 1,
                                    edits[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                edits[i][j] = std::min(edits[i][j], edits[i - 2][j - 2] + 1);
            }
        }
    }
    return edits.back().back();
}

/// The first ten names of at least three letters are mistyped.
void expect_right_suggestions(const char* table, const std::vector<std::string>& names) {
    const std::vector<std::string_view> views(names.begin(), names.end());
    std::vector<KnownName> known;
    for (const std::string_view name : views) known.push_back({name, name});
    int mistyped = 0;
    for (const std::string& name : names) {
        if (name.size() < 3 || mistyped == 10) continue;
        ++mistyped;
        for (const std::string& typo : typos_of(name)) {
            if (std::ranges::find(names, typo) != names.end()) continue;
            const auto nearest = nearest_names(typo, known);
            EXPECT_NE(std::ranges::find(nearest, name), nearest.end())
                << table << ": " << typo << " of " << name;
            for (const std::string_view suggested : nearest) {
                EXPECT_LE(edits_between(typo, std::string(suggested)), 2u) << table << ": " << typo;
            }
        }
        // Three letters more are another word.
        for (const std::string_view suggested : nearest_names(name + "xyz", known)) {
            EXPECT_LE(edits_between(name + "xyz", std::string(suggested)), 2u) << table;
        }
    }
    // Units and switches, such as m, ft, on and up, are too short to be mistyped.
    const auto longer =
        std::ranges::count_if(names, [](const std::string& name) { return name.size() >= 3; });
    EXPECT_GE(mistyped, std::min<int>(3, static_cast<int>(longer))) << table;
    EXPECT_GT(mistyped, 0) << table;
}

template <typename Rows, typename Name>
std::vector<std::string> names_of(const Rows& rows, Name name) {
    std::vector<std::string> names;
    for (const auto& row : rows) names.emplace_back(std::invoke(name, row));
    return names;
}

TEST(Suggestions, OfCommandsAndOptions) {
    const std::vector<Command> commands = {info_command(),     bake_command(ocean_catalogue()),
                                           povray_command(),   query_command(),
                                           gauge_command(),    foam_texture_command(),
                                           spectrum_command(), records_command(),
                                           params_command(),   presets_command()};
    expect_right_suggestions("commands", names_of(commands, &Command::name));
    for (const Command& command : commands) {
        std::vector<std::string> options = {"--help"};
        for (const OptionGroup& group : command.options) {
            for (const Option& option : group.options) {
                const std::size_t dashes = option.names.find("--");
                if (dashes != std::string::npos) options.push_back(option.names.substr(dashes));
            }
        }
        expect_right_suggestions(command.name.c_str(), options);
    }
}

TEST(Suggestions, OfParameters) {
    expect_right_suggestions("keys", names_of(parameter_table(), &ParameterInfo::key));
    expect_right_suggestions("paths", names_of(parameter_table(), [](const ParameterInfo& info) {
                                 return info.path();
                             }));
    for (const ParameterInfo& info : parameter_table()) {
        const auto words = info.choices();
        if (!words.empty()) {
            expect_right_suggestions("words", std::vector<std::string>(words.begin(), words.end()));
        }
    }
}

TEST(Suggestions, OfFormatsProductsBackendsAndPresets) {
    const Catalogue& catalogue = ocean_catalogue();
    expect_right_suggestions("formats", names_of(catalogue.formats, [](const BakeFormat* format) {
                                 return format->name;
                             }));
    expect_right_suggestions("extensions",
                             names_of(catalogue.formats, [](const BakeFormat* format) {
                                 return format->extension.substr(1);
                             }));
    expect_right_suggestions("products", names_of(catalogue.products, &Product::name));
    expect_right_suggestions("backends", names_of(catalogue.backends, &Backend::name));
    expect_right_suggestions("presets", names_of(presets(), &Preset::name));
    expect_right_suggestions("water", names_of(water_types(), &WaterType::name));
}

#if __has_include("ocean/internal/bridge/line_protocol.hpp")
TEST(Suggestions, OfTheWire) {
    expect_right_suggestions("wire", names_of(bridge::command_forms(), &bridge::CommandForm::word));
    expect_right_suggestions("app", names_of(bridge::app_values(), &bridge::AppValue::name));
    const bridge::ValueTable values;
    expect_right_suggestions("values", names_of(values.entries(), &bridge::ValueEntry::name));
}
#endif

}  // namespace
}  // namespace ocean::app
