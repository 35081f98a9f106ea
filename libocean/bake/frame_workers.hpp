// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Runs jobs in parallel and delivers their results in order.
#pragma once

#include <functional>

namespace ocean {

/// Calls job(worker, index) for the indices [0, count) on `workers` threads, then deliver(index) in
/// the order of the indices on the calling thread. At most two jobs for each worker are started
/// ahead of the last delivered job, so that a slow deliver() slows down the work. After a job that
/// returns false no further job is started; running jobs are finished and delivered. Jobs must not
/// throw; an exception of deliver() is thrown when the running jobs are finished.
void run_in_order(int count, int workers, const std::function<bool(int worker, int index)>& job,
                  const std::function<void(int index)>& deliver);

}  // namespace ocean
