// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See frame_workers.hpp.
#include "frame_workers.hpp"

#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

namespace ocean {
namespace {

class Workers {
  public:
    Workers(int count, int workers, const std::function<bool(int, int)>& job)
        : count_(count),
          max_ahead_(2 * workers),
          finished_(static_cast<std::size_t>(count), false) {
        for (int worker = 0; worker < workers; ++worker) {
            threads_.emplace_back([this, worker, &job] { work(worker, job); });
        }
    }
    ~Workers() {
        stop();
        for (std::thread& thread : threads_) thread.join();
    }
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    /// Blocks until the job `index` is finished; returns false if it will never be started.
    bool wait_for(int index) {
        std::unique_lock lock(mutex_);
        const auto done = [&] { return finished_[static_cast<std::size_t>(index)]; };
        changed_.wait(lock, [&] { return done() || (stopped_ && index >= next_); });
        return done();
    }

    void delivered(int index) {
        const std::lock_guard lock(mutex_);
        delivered_ = index + 1;
        changed_.notify_all();
    }

  private:
    void stop() {
        const std::lock_guard lock(mutex_);
        stopped_ = true;
        changed_.notify_all();
    }

    void work(int worker, const std::function<bool(int, int)>& job) {
        for (;;) {
            int index = 0;
            {
                std::unique_lock lock(mutex_);
                changed_.wait(lock, [this] {
                    return stopped_ || next_ == count_ || next_ - delivered_ < max_ahead_;
                });
                if (stopped_ || next_ == count_) return;
                index = next_++;
            }
            const bool go_on = job(worker, index);
            const std::lock_guard lock(mutex_);
            finished_[static_cast<std::size_t>(index)] = true;
            stopped_ = stopped_ || !go_on;
            changed_.notify_all();
        }
    }

    const int count_;
    const int max_ahead_;
    std::mutex mutex_;
    std::condition_variable changed_;
    int next_ = 0;
    int delivered_ = 0;
    bool stopped_ = false;
    std::vector<bool> finished_;
    std::vector<std::thread> threads_;
};

}  // namespace

void run_in_order(int count, int workers, const std::function<bool(int worker, int index)>& job,
                  const std::function<void(int index)>& deliver) {
    Workers all(count, workers, job);
    for (int index = 0; index < count && all.wait_for(index); ++index) {
        deliver(index);
        all.delivered(index);
    }
}

}  // namespace ocean
