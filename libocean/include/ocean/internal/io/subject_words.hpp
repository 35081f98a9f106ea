// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The names of subjects in files of all formats, one row for each kind.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "ocean/internal/io/provenance.hpp"

namespace ocean::io {

struct SubjectWords {
    std::string kind;  // "sea", the kind of Provenance and the object of an OBJ file
    std::string noun;  // "a sea"
    std::string prim;  // "Ocean", the prim of a USD stage

    /// Returns the prefix of names in POV-Ray, "Ocean_".
    std::string prefix() const { return prim + "_"; }
    /// Returns "The surface of a sea".
    std::string phrase() const { return "The surface of " + noun; }
};

/// Returns the words of a kind; "" stands for a sea. A kind without a row, such as "plane", gets "a
/// plane" and "Plane".
SubjectWords subject_words(std::string_view kind);
/// Returns the words of the subject that a header names; without one, the words of a sea.
SubjectWords subject_words(std::span<const HeaderString> strings);

}  // namespace ocean::io
