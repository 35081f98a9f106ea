// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea as a subject, and the way back to it for what only a sea has.
#pragma once

#include <memory>

#include "ocean/ocean.hpp"
#include "ocean/sea.hpp"
#include "ocean/subject.hpp"
#include "ocean/subject_kind.hpp"

namespace ocean {

/// Takes a valid, resolved sea.
std::unique_ptr<Subject> make_subject(Sea sea);
/// Reads the text of such a subject. `name` stands for a path in messages. Throws Error as
/// parse_sea.
std::unique_ptr<Subject> parse_sea_subject(std::string_view text, const std::string& name);

/// Returns the sea that a subject is, or null.
const Sea* find_sea(const Subject& subject);
/// Returns it, or throws Error unsupported.
const Sea& sea_of(const Subject& subject);
/// Returns the ocean that makes a sea's maps. Throws Error unsupported for another subject's.
Ocean& ocean_of(SubjectMaps& maps);

}  // namespace ocean
