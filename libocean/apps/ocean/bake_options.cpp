// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See bake_options.hpp.
#include "bake_options.hpp"

#include <algorithm>
#include <span>
#include <utility>
#include <variant>

#include "console.hpp"
#include "console_host.hpp"
#include "format_help.hpp"
#include "ocean/internal/bake/estimate.hpp"
#include "ocean/internal/json.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

/// Returns true if another format has the option already.
bool has_option(const std::vector<OptionGroup>& groups, const std::string& name) {
    return std::ranges::any_of(groups, [&](const OptionGroup& group) {
        return std::ranges::find(group.options, name, &Option::names) != group.options.end();
    });
}

/// Adds the options of formats that this program was built without; the plan refuses them.
void add_absent_options(BakeOptions& bake, const Catalogue& catalogue,
                        std::vector<OptionGroup>& groups) {
    for (const FormatLibrary& one : catalogue.libraries) {
        if (!catalogue.lacks(one) || one.options.empty()) continue;
        OptionGroup group{std::string(one.family), {}};
        for (const char* const name : one.options) {
            group.options.push_back(
                {"--" + std::string(name), &bake.format_options[name], "VALUE",
                 "Not in this program, which was built without " + std::string(one.library)});
        }
        groups.push_back(std::move(group));
    }
}

}  // namespace

void add_format_options(FormatFlags& flags, BakeOptions& bake, const Catalogue& catalogue,
                        std::string_view kind, std::vector<OptionGroup>& groups) {
    for (const BakeFormat* format : catalogue.formats) {
        OptionGroup group{std::string(format->family), {}};
        for (const FormatOption& option : format->options(catalogue)) {
            const std::string name = "--" + option.name;
            const bool foreign = !option.subject.empty() && option.subject != kind;
            if (foreign || has_option(groups, name)) continue;
            const std::string help = option_overview(option.name, catalogue);
            if (option.value.empty()) {
                group.options.push_back({name, &flags[option.name], "", help});
            } else {
                std::string& value = bake.format_options[option.name];
                group.options.push_back({name, &value, option.value, help});
            }
        }
        if (!group.options.empty()) groups.push_back(std::move(group));
    }
    add_absent_options(bake, catalogue, groups);
    for (OptionGroup& group : std::span(groups).subspan(1)) {
        for (Option& option : group.options) {
            if (std::holds_alternative<std::string*>(option.target)) option.rule = NotEmpty{};
        }
    }
}

void add_given(const FormatFlags& flags, BakeOptions& options) {
    for (const auto& [name, given] : flags) {
        if (given) options.format_options[name] = "yes";
    }
}

void run_or_forecast(const BakePlan& plan, bool dry_run, const Context& context) {
    if (!plan.format_note.empty()) {
        context.console.report("mesh", plan.format_note, {});
    }
    if (dry_run) return show_forecast(forecast_bake(plan), {}, context.console);
    bake_on_console(plan, context);
}

void show_summary(const BakePlan& plan, const Context& context) {
    const BakeForecast forecast = forecast_bake(plan);
    const double seconds = measure_bake_pace(plan).seconds(static_cast<int>(plan.frames.size()));
    const long files = forecast.all(), kept = forecast.kept();
    if (context.options.json) {
        context.console.data(JsonObject()
                                 .add("frames", plan.frames.size())
                                 .add("files", files)
                                 .add("kept", kept)
                                 .add("bytes", forecast.bytes)
                                 .add("free_bytes", forecast.free_bytes)
                                 .add("memory_bytes", forecast.memory_bytes)
                                 .add("seconds", seconds)
                                 .text() +
                             "\n");
    } else {
        context.console.data(format_text("frames   %zu\nfiles    %ld, %ld of them kept\n",
                                         plan.frames.size(), files, kept) +
                             "bytes    " + bytes_text(forecast.bytes) + " at most, " +
                             bytes_text(forecast.free_bytes) + " are free\nmemory   " +
                             bytes_text(forecast.memory_bytes) +
                             format_text("\nseconds  about %.2g, and those of writing\n", seconds));
    }
    for (const std::string& warning : forecast.warnings) context.console.warning(warning);
}

}  // namespace ocean::app
