// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean params`: lists the parameters of a sea or a terrain with units, ranges and meaning.
#include <memory>

#include "commands.hpp"
#include "console.hpp"
#include "ocean/channel.hpp"
#include "ocean/internal/nearest_name.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/terrain_table.hpp"
#include "parameters_text.hpp"

namespace ocean::app {
namespace {

std::vector<ListedParameter> rows_of(const std::string& kind) {
    if (kind.empty() || kind == kSeaKind) return listed(sea_table());
    if (kind == kTerrainKind) return listed(terrain_table());
    constexpr std::string_view kKinds[] = {kSeaKind, kTerrainKind};
    refuse("params " + kind + ": allowed are sea and terrain" + did_you_mean(kind, kKinds));
}

}  // namespace

Command params_command() {
    auto markdown = std::make_shared<bool>(false);
    auto kind = std::make_shared<std::string>();
    return {
        .name = "params",
        .summary = "List all parameters of a sea or a terrain with defaults, ranges and meaning",
        .options = {{"", {{"KIND", kind.get(), "", "sea or terrain; default sea"}}},
                    {"Output",
                     {{"--markdown", markdown.get(), "", "Print a Markdown table"},
                      {.names = "--json",
                       .target = &RunOptions::json,
                       .help = "Print a JSON array",
                       .excludes = "--markdown"}}}},
        .run =
            [markdown, kind](const Context& context) {
                const std::vector<ListedParameter> rows = rows_of(*kind);
                if (*markdown) return context.console.data(parameters_markdown(rows));
                context.console.data(context.options.json ? parameters_json(rows) + "\n"
                                                          : parameters_text(rows));
            },
    };
}

}  // namespace ocean::app
