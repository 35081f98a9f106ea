// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Bakes one frame after the other: computes it, writes it and reads it back; several at a time, in
// order.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "manifest.hpp"
#include "ocean/bake/run.hpp"
#include "ocean/subject.hpp"

namespace ocean {

/// Calls job(worker, index) for the indices [0, count) on `workers` threads, then deliver(index) in
/// the order of the indices on the calling thread. At most two jobs for each worker are started
/// ahead of the last delivered job, so that a slow deliver() slows down the work. After a job that
/// returns false no further job is started; running jobs are finished and delivered. Jobs must not
/// throw; an exception of deliver() is thrown when the running jobs are finished.
void run_in_order(int count, int workers, const std::function<bool(int worker, int index)>& job,
                  const std::function<void(int index)>& deliver);

/// The objects that all frames of a bake share.
struct Bake {
    const BakePlan& plan;
    const SubjectMaps& source;  // with the data that its frames share
    Manifest& manifest;
    BakeHost& host;
};

/// Runs `write` with interrupts deferred, then reads the file back, verifies it and enters its
/// hashes into the manifest. Throws Error output if the file does not read back.
void write_and_verify(const Bake& bake, const BakeFile& file, int threads,
                      const std::function<void()>& write);

/// Does the same as write_and_verify() without deferring interrupts. For callers inside the host's
/// run_uninterrupted(), whose calls do not nest.
void write_and_verify_uninterrupted(const Bake& bake, const BakeFile& file, int threads,
                                    const std::function<void()>& write);

/// One worker of a bake. Several of them work in parallel.
class FrameBaker {
  public:
    FrameBaker(const Bake& bake, int threads);

    /// Enters the files into the manifest if all of them are complete. Returns true if they are.
    bool keep(const std::vector<BakeFile>& files);
    /// Computes the frame, writes its files, and reads them back for the manifest.
    void make(const std::vector<BakeFile>& files, int frame);
    /// Computes the maps of a frame at a time [s].
    std::vector<Surface> make_maps(double time);

  private:
    const Bake& bake_;
    int threads_;
    std::unique_ptr<SubjectMaps> source_;
};

}  // namespace ocean
