// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A subject as a USD mesh over time: a stage of text that names value clips, a crate file with the
// points of each frame, and one with the faces and uv that all share. Metres; velocities are m/s.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ocean/io/mesh.hpp"
#include "ocean/io/provenance.hpp"
#include "ocean/io/subject_words.hpp"

namespace ocean::io {

/// What a stage says of its clips. Names are those of files beside it.
struct UsdSequence {
    std::string topology;      // "sea.topology.usdc"
    std::string manifest;      // "sea.clips.usda"
    std::string frames;        // "sea.####.usdc"
    std::vector<int> numbers;  // of the frames, ascending, at least one
    double rate = 24.0;        // frames a second
    bool y_up = false;
    /// What frames have beside points, normals among it as "normal"; values play no part.
    std::vector<Attribute> attributes;
    SubjectWords words = subject_words("");
};

/// The step of frames FIRST-LASTxSTEP, 1 for one frame; nothing where the steps differ.
std::optional<int> even_step(std::span<const int> frames);

/// The text of the stage, with `strings` as customLayerData.
std::string usd_stage(const UsdSequence& sequence, std::span<const HeaderString> strings);
/// The text that says which attributes clips have, so that a reader need not open them all.
std::string usd_clip_manifest(const UsdSequence& sequence);

/// Writes points, their extent, and normals and attributes where the mesh has them, at a time code.
/// Throws Error output.
void write_usd_frame(const Mesh& mesh, std::span<const HeaderString> strings, double time_code,
                     const std::string& path);
/// Writes the quads of a patch mesh and its uv as primvars:st. Throws Error output.
void write_usd_topology(const Domain& domain, const SubjectWords& words, const std::string& path);
/// The strings of a frame; of a topology its resolution. Throws Error bad_file.
std::vector<HeaderString> read_usd_header(const std::string& path);

}  // namespace ocean::io
