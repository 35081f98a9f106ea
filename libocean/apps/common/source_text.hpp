// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The text of a subject from the argument that names it: a file of parameters, a pipe, standard
// input, or the header of a baked file.
#pragma once

#include <string>
#include <string_view>

namespace ocean::app {

inline constexpr std::string_view kPresetPrefix = "preset:";
/// The end of each refusal of a terrain in the place of a sea.
inline constexpr char kTerrainHint[] = "; `ocean terrain` bakes one";

/// The text of a file of parameters, and where it comes from.
struct SourceText {
    std::string text;
    std::string name;      // for messages
    std::string base_dir;  // to which files that it names are relative; empty: they are inlined
};

/// Returns the text that a source names; not a preset. A baked file must show a subject of that
/// kind. Throws Error.
SourceText read_source_text(const std::string& source, std::string_view kind);

}  // namespace ocean::app
