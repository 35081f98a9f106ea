// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A parameter of any table as a row of the panel: a slider, a field, a list of words or a checkbox,
// as the table says.
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
    bool is_used;  // else the row is dimmed
};

struct ParameterChange {
    std::string path;
    std::string value;
    std::string before;  // what it was, before the drag that this is a part of
    bool is_drag;
};

/// Draws the row between ImGui::NewFrame and ImGui::Render. Calls `set` with what a hand changed.
void draw_parameter(const ShownParameter& shown,
                    const std::function<void(const ParameterChange&)>& set);

/// Whether a search finds the parameter by its label or its path; the empty one finds all.
bool is_found(const ParameterSpec& spec, std::size_t item, const std::string& search);

}  // namespace ocean::app
