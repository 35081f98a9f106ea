// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Frames side by side: computed in any order, reported in theirs.
#pragma once

#include <functional>

namespace ocean {

/// Calls job(worker, index) for the indices [0, count) on `workers` threads, then deliver(index) in
/// the order of the indices on the calling thread. No job is begun more than two for each worker
/// ahead of what was delivered: who does not read holds the work up. After a job that returned
/// false no other is begun; those in hand are finished and delivered. Jobs must not throw; what
/// deliver throws comes out here when the jobs in hand are done.
void run_in_order(int count, int workers, const std::function<bool(int worker, int index)>& job,
                  const std::function<void(int index)>& deliver);

}  // namespace ocean
