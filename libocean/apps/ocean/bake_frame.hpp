// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One frame of a bake: which files it has, whether they are there already, and how they are made.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bake_plan.hpp"
#include "interrupt.hpp"
#include "manifest.hpp"
#include "ocean/ocean.hpp"

namespace ocean::app {

class Console;

struct BakeFile {
    std::string path;
    std::string product;                 // several in comma lists
    std::vector<const Product*> fields;  // of an EXR
    std::string header;                  // of an EXR, byte for byte
    std::string recipe;                  // SHA-256 of all that decides the content
    int resolution = 0;                  // of the map of a DF3 file
};

/// In the order in which they are written.
std::vector<BakeFile> files_of_frame(const BakePlan& plan, int frame);

/// What is to be said of a file that is whole and what this plan would write; nothing for any
/// other. An EXR shows it by itself, and must agree with the manifest if that lists it; other files
/// need the manifest.
std::optional<ManifestEntry> find_complete(const BakePlan& plan, const BakeFile& file, int frame,
                                           const Manifest& manifest, int threads);

/// What all frames of a bake share.
struct Bake {
    const BakePlan& plan;
    const Ocean& ocean;  // with its modes
    Manifest& manifest;
    InterruptWatch& interrupts;
    Console& console;
};

/// Bakes one frame after another; several of them run side by side.
class FrameBaker {
  public:
    FrameBaker(const Bake& bake, int threads);

    /// Enters the files into the manifest and returns true if all of them are complete.
    bool keep(const std::vector<BakeFile>& files, int frame);
    /// Computes the frame, writes its files, and reads them back for the manifest.
    void make(const std::vector<BakeFile>& files, int frame);

  private:
    std::vector<Surface> make_levels(double time);
    /// The heights at places of the world, as a format without overhangs shows them: the
    /// displacement inverted, of folds the top sheet.
    Surface shown_heights(double time);
    void write_maps(const std::vector<BakeFile>& files, int frame, std::span<const Surface> levels);
    void write_images(const std::vector<BakeFile>& files, const io::Frame& frame);
    void write_mesh(const BakeFile& file, const io::Frame& frame, std::span<const Surface> levels);
    void record(const BakeFile& file, int frame);

    const Bake& bake_;
    int threads_;
    io::ExrOptions exr_;
    Ocean ocean_;
};

}  // namespace ocean::app
