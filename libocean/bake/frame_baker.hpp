// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One frame of a bake after another: computed, written, read back.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "manifest.hpp"
#include "ocean/bake/run.hpp"
#include "ocean/subject.hpp"

namespace ocean {

/// What all frames of a bake share.
struct Bake {
    const BakePlan& plan;
    const SubjectMaps& source;  // with what its frames share
    Manifest& manifest;
    BakeHost& host;
};

/// Writes a file, undisturbed by an interrupt, and reads it back for the manifest.
void put_file(const Bake& bake, const BakeFile& file, int threads,
              const std::function<void()>& write);

/// Writes a file within a `whole` of the host that the caller has begun: they do not nest.
void put_file_held(const Bake& bake, const BakeFile& file, int threads,
                   const std::function<void()>& write);

/// Several of them bake side by side.
class FrameBaker {
  public:
    FrameBaker(const Bake& bake, int threads);

    /// Enters the files into the manifest and returns true if all of them are complete.
    bool keep(const std::vector<BakeFile>& files);
    /// Computes the frame, writes its files, and reads them back for the manifest.
    void make(const std::vector<BakeFile>& files, int frame);

  private:
    std::vector<Surface> make_maps(double time);

    const Bake& bake_;
    int threads_;
    std::unique_ptr<SubjectMaps> source_;
};

}  // namespace ocean
