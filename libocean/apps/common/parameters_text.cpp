// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "parameters_text.hpp"

#include "ocean/internal/text.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

constexpr std::size_t kLineWidth = 100;

std::string heading(const ParameterSpec& spec) {
    const std::string name(spec.section);
    if (!spec.in_list()) return "[" + name + "]\n";
    return "[[" + name + "]]  (one table per " + std::string(spec.item) + ")\n";
}

}  // namespace

std::string parameters_text(std::span<const ListedParameter> parameters) {
    std::string text;
    std::string_view section;
    for (const auto& [spec, default_value] : parameters) {
        if (spec->section != section) {
            section = spec->section;
            text += (text.empty() ? "" : "\n") + heading(*spec);
        }
        const std::string value = to_text(default_value);
        const std::string assignment =
            std::string(spec->key) + " = " + (value.empty() ? "(none)" : value);
        text += format_text("  %-38s  %s\n", assignment.c_str(), allowed_values(*spec).c_str());
        text += wrapped(spec->help, 6, kLineWidth);
    }
    return text;
}

}  // namespace ocean::app
