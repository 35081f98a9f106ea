// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean params`: lists the parameters of a sea with units, ranges and meaning.
#include <memory>

#include "commands.hpp"
#include "console.hpp"
#include "ocean/parameter_table.hpp"
#include "parameters_text.hpp"

namespace ocean::app {
Command params_command() {
    auto markdown = std::make_shared<bool>(false);
    return {
        .name = "params",
        .summary = "List all parameters with defaults, ranges and meaning",
        .options = {{"Output",
                     {{"--markdown", markdown.get(), "", "Print a Markdown table"},
                      {.names = "--json",
                       .target = &RunOptions::json,
                       .help = "Print a JSON array",
                       .excludes = "--markdown"}}}},
        .run =
            [markdown](const Context& context) {
                if (*markdown) return context.console.data(parameters_markdown());
                context.console.data(context.options.json ? parameters_json() + "\n"
                                                          : parameters_text(listed(sea_table())));
            },
    };
}

}  // namespace ocean::app
