// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A parameter of any table as a row of the panel: a slider, a field, a list of words or a checkbox,
// by the type in the table.
#pragma once

#include <functional>
#include <string>

#include "ocean/table.hpp"

namespace ocean::app {

struct ShownParameter {
    const ParameterSpec& spec;
    std::size_t item;
    ParameterValue value;  // as it is now
    ParameterValue default_value;
    bool is_used;                // false: the row is dimmed
    std::string_view note = "";  // last line of the tooltip
};

struct ParameterChange {
    std::string path;
    std::string value;
    std::string before;  // the value before it, or before the drag that it is a part of
    bool is_drag;
};

/// Draws the row between ImGui::NewFrame and ImGui::Render. Calls `set` with the user's change.
void draw_parameter(const ShownParameter& shown,
                    const std::function<void(const ParameterChange&)>& set);

/// Returns whether a search finds the parameter by its label or its path; "" finds all.
bool is_found(const ParameterSpec& spec, std::size_t item, const std::string& search);

}  // namespace ocean::app
