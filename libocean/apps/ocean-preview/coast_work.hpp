// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The coast of a changed sea, computed in another thread while the sea before is shown.
#pragma once

#include <atomic>
#include <future>
#include <memory>
#include <mutex>
#include <string>

#include "ocean/ocean.hpp"

namespace ocean::app {

class CoastWork {
  public:
    /// Begins. before: shares what it has computed, and may be used meanwhile.
    CoastWork(Ocean& before, Sea sea);
    /// Stops a computation that is in work.
    ~CoastWork();
    CoastWork(const CoastWork&) = delete;
    CoastWork& operator=(const CoastWork&) = delete;

    bool done() const;
    void wait() const { made_.wait(); }
    /// Returns what is computed and the share of it that is done, for a person: "delays 40 %".
    std::string progress() const;
    /// Returns the sea with its coast; blocks until it is done. Throws Error.
    const Ocean& result();

  private:
    struct Stopped {};

    std::atomic<bool> stopped_ = false;
    mutable std::mutex mutex_;
    std::string work_ = "waves";
    double share_ = 0.0;
    std::unique_ptr<Ocean> sea_;
    std::future<void> made_;
};

}  // namespace ocean::app
