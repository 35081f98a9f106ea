// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea as a Subject, and the way back from a Subject to its sea for code that only a sea has.
#pragma once

#include <memory>

#include "ocean/sea.hpp"
#include "ocean/subject.hpp"

namespace ocean {

class Ocean;
struct Region;

/// Returns a valid, resolved sea as a subject: one period of an open sea, or the whole bed of a sea
/// over a bed.
std::unique_ptr<Subject> make_subject(Sea sea);
/// Returns a region of a sea over a bed as a subject. Throws Error unsupported for a sea without a
/// bed, and as domain_of(region).
std::unique_ptr<Subject> make_region_subject(Sea sea, const Region& region);
/// Returns the sea or region that the text() of its subject describes. `name` stands for a path in
/// messages. Throws Error as parse_sea.
std::unique_ptr<Subject> parse_sea_subject(std::string_view text, const std::string& name);

/// Returns the sea of a subject, or null for a subject of another kind.
const Sea* find_sea(const Subject& subject);
/// Returns the sea of a subject. Throws Error unsupported for a subject of another kind.
const Sea& sea_of(const Subject& subject);
/// Returns the Ocean that makes a sea's maps. Throws Error unsupported for maps of another kind.
Ocean& ocean_of(SubjectMaps& maps);

}  // namespace ocean
