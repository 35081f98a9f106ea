// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "view_table.hpp"

#include "ocean/error.hpp"

namespace ocean::preview {

const ViewRow& row_of(View view) {
    const auto number = static_cast<std::size_t>(view);
    if (number < kViews.size()) return kViews[number];
    throw Error(ErrorKind::invalid_value, "there is no view " + std::to_string(number));
}

std::string view_defines(SceneKind kind) {
    std::string text = "#define VIEW_CASES";
    for (const ViewRow& row : kViews) {
        const std::string_view glsl = row.glsl_of(kind);
        if (glsl.empty()) continue;
        text += " case " + std::to_string(static_cast<int>(row.view)) + ": return " +
                std::string(glsl) + ";";
    }
    return text + "\n";
}

}  // namespace ocean::preview
