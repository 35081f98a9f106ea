// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How files name their subject, to people and to hosts: one row a kind, for all formats.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "ocean/io/provenance.hpp"

namespace ocean::io {

struct SubjectWords {
    std::string kind;  // "sea", as Provenance has it: the object of an OBJ file
    std::string noun;  // "a sea"
    std::string prim;  // "Ocean": of a USD stage

    /// Returns what names in POV-Ray begin with, "Ocean_".
    std::string prefix() const { return prim + "_"; }
    /// Returns "The surface of a sea".
    std::string phrase() const { return "The surface of " + noun; }
};

/// Returns the words of a kind; a sea's for none. A kind without a row, "plane", has "a plane" and
/// "Plane".
SubjectWords subject_words(std::string_view kind);
/// Returns the words of the subject that a header names; a sea's where it names none.
SubjectWords subject_words(std::span<const HeaderString> strings);

}  // namespace ocean::io
