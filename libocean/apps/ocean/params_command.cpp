// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// `ocean params`: what there is to set in a sea, with units, ranges and meaning.
#include <memory>

#include "commands.hpp"
#include "console.hpp"
#include "ocean/parameter_table.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

constexpr std::size_t kLineWidth = 100;

std::string parameters_text() {
    const Parameters defaults;
    std::string text;
    std::string_view section;
    for (const ParameterInfo& info : parameter_table()) {
        if (info.section != section) {
            section = info.section;
            const bool many = info.in_list();
            text += (text.empty() ? "" : "\n") + std::string(many ? "[[" : "[") +
                    std::string(section) + (many ? "]]  (one table per wave system)" : "]") + "\n";
        }
        const std::string value = to_text(value_of(defaults, {&info, 0}));
        const std::string assignment =
            std::string(info.key) + " = " + (value.empty() ? "(none)" : value);
        text += format_text("  %-38s  %s\n", assignment.c_str(), allowed_values(info).c_str());
        text += wrapped(info.help, 6, kLineWidth);
    }
    return text;
}

}  // namespace

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
                                                          : parameters_text());
            },
    };
}

}  // namespace ocean::app
