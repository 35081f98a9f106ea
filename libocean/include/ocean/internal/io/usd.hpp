// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A subject as a USD mesh over time: a text stage that names value clips, a crate file with the
// points of each frame, and one with the faces and uv that all frames share. Lengths are in [m],
// velocities in [m/s].
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ocean/internal/io/provenance.hpp"
#include "ocean/internal/io/subject_words.hpp"
#include "ocean/io/mesh.hpp"

namespace ocean::io {

/// The clips of a stage. The names are files in the stage's folder.
struct UsdSequence {
    std::string topology;      // "sea.topology.usdc"
    std::string manifest;      // "sea.clips.usda"
    std::string frames;        // "sea.####.usdc"
    std::vector<int> numbers;  // frame numbers, ascending, at least one
    double rate = 24.0;        // [frames/s]
    bool y_up = false;
    /// The attributes of the frames beside the points, with normals as "normal"; values are
    /// ignored.
    std::vector<Attribute> attributes;
    bool own_faces = false;  // each frame has its triangles, in place of the shared faces
    SubjectWords words = subject_words("");
};

/// Returns the step of frames FIRST-LASTxSTEP, 1 for one frame; nothing if the steps differ.
std::optional<int> even_step(std::span<const int> frames);

/// Returns the text of the stage, with `strings` as customLayerData.
std::string usd_stage(const UsdSequence& sequence, std::span<const HeaderString> strings);
/// Returns the text of the clip manifest: the attributes of the clips, so that readers need not
/// open all of them.
std::string usd_clip_manifest(const UsdSequence& sequence);

/// Writes the points of a mesh, their extent, its normals and attributes, and its triangles if it
/// has some, at a time code. Throws Error output.
void write_usd_frame(const Mesh& mesh, std::span<const HeaderString> strings, double time_code,
                     const std::string& path);
/// Writes the quads of a patch mesh and its uv as primvars:st. Throws Error output.
void write_usd_topology(const Domain& domain, const SubjectWords& words, const std::string& path);
/// Writes the triangles of any mesh and its uv, if it has one. Throws Error output.
void write_usd_topology(const Mesh& mesh, const SubjectWords& words, const std::string& path);
/// Returns the header strings of a frame; a topology has its resolution only. Throws Error
/// bad_file.
std::vector<HeaderString> read_usd_header(const std::string& path);

}  // namespace ocean::io
