// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The blocking pool: threads sleep on a condition variable between calls.
#include "ocean/thread_pool.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "base/thread_throttle.hpp"
#include "ocean/internal/platform.hpp"

namespace ocean {

namespace {

/// The items first .. last - 1 that no thread has begun.
class ItemRange {
  public:
    void set(int first, int last) { range_.store(pack(first, last), std::memory_order_relaxed); }

    /// Claims an item from the front or the back; -1 if none is left.
    int claim(bool front) {
        std::uint64_t range = range_.load(std::memory_order_relaxed);
        for (;;) {
            const auto first = static_cast<int>(range >> 32);
            const auto last = static_cast<int>(range & 0xFFFFFFFFu);
            if (first >= last) return -1;
            const std::uint64_t left = front ? pack(first + 1, last) : pack(first, last - 1);
            if (range_.compare_exchange_weak(range, left, std::memory_order_relaxed)) {
                return front ? first : last - 1;
            }
        }
    }

  private:
    static std::uint64_t pack(int first, int last) {
        return static_cast<std::uint64_t>(first) << 32 | static_cast<std::uint32_t>(last);
    }

    alignas(64) std::atomic<std::uint64_t> range_{};
};

/// A call can be stopped between this many shares of a range: each takes at most a few hundredths
/// of a second.
constexpr int kSharesToStopBetween = 128;

/// Returns the beginning of share i of `shares`.
int share_edge(int count, int i, int shares) {
    return static_cast<int>(static_cast<long long>(count) * i / shares);
}

}  // namespace

struct ThreadPool::Impl {
    using Time = std::chrono::steady_clock::time_point;
    static constexpr std::chrono::milliseconds kBetweenLooks{10};

    int size = 1;
    RunJobs run_jobs;
    std::uint64_t process = process_number();  // process that owns the threads
    std::vector<std::thread> workers;
    std::vector<ItemRange> ranges;  // one for each thread
    // State of the calling thread:
    ThreadThrottle throttle{1};
    std::function<void()> interrupt;
    std::atomic_flag looking;
    Time next_look{};
    std::mutex mutex;
    std::condition_variable start;
    std::condition_variable done;
    // State guarded by the mutex:
    const std::function<void(int, int)>* body = nullptr;  // of the current call, if any
    std::uint64_t call = 0;                               // its number
    int crew = 1;                                         // threads that may take part
    bool measured = false;                                // the threads' usage is measured
    ThreadUsage used;                                     // usage of all threads in this call
    int taking_part = 0;                                  // workers in the current call
    bool stopping = false;
    std::exception_ptr failure;

    Impl(int threads, RunJobs jobs)
        : size(threads), run_jobs(std::move(jobs)), ranges(static_cast<std::size_t>(threads)) {
        if (run_jobs) return;
        workers.reserve(static_cast<std::size_t>(size - 1));
        for (int thread = 1; thread < size; ++thread) {
            try {
                workers.emplace_back([this, thread] { work(thread); });
            } catch (const std::exception&) {
                // If the system refuses another thread, the present threads do the same work with
                // the same bits.
                size = thread;
                break;
            }
        }
        throttle = ThreadThrottle(size);
    }
    ~Impl() {
        {
            const std::lock_guard lock(mutex);
            stopping = true;
        }
        start.notify_all();
        for (std::thread& worker : workers) worker.join();
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    /// Runs the items of the thread's own range, which are neighbours, then items of other threads
    /// from the far end of their ranges. Returns the usage of the thread.
    ThreadUsage run_items(const std::function<void(int, int)>& run, int thread) {
        const ThreadUsage before = measured ? usage_of_this_thread() : ThreadUsage{};
        for (int other = 0; other < crew; ++other) {
            ItemRange& range = ranges[static_cast<std::size_t>((thread + other) % crew)];
            for (int item; (item = range.claim(other == 0)) >= 0;) {
                run_item(run, item, thread);
                if (thread == 0 || run_jobs) look_for_interrupt();
            }
        }
        const ThreadUsage after = measured ? usage_of_this_thread() : ThreadUsage{};
        return {after.preemptions - before.preemptions, after.seconds - before.seconds};
    }

    /// Distributes the items to the first `threads` ranges. Requires the mutex.
    void share_out(int count, int threads) {
        crew = threads;
        for (int thread = 0; thread < crew; ++thread) {
            ranges[static_cast<std::size_t>(thread)].set(share_edge(count, thread, crew),
                                                         share_edge(count, thread + 1, crew));
        }
    }

    void run_as_jobs(int count, const std::function<void(int, int)>& run) {
        {
            const std::lock_guard lock(mutex);
            share_out(count, std::min(size, count));
        }
        run_jobs(crew, [&](int job) { run_items(run, job); });
        run_items(run, 0);  // items of jobs that the host has left out
    }

    /// Adds the usage of a thread. Requires the mutex.
    void add(ThreadUsage usage) {
        used.preemptions += usage.preemptions;
        used.seconds += usage.seconds;
    }

    void run_item(const std::function<void(int, int)>& run, int item, int thread) {
        try {
            run(item, thread);
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!failure) failure = std::current_exception();
        }
    }

    void throw_failure() {
        if (failure) std::rethrow_exception(std::exchange(failure, nullptr));
    }

    /// Checks for an interrupt. The calling thread calls it; with a host's jobs one job at a time
    /// does, and the host may leave out any job.
    void look_for_interrupt() {
        if (!interrupt || looking.test_and_set(std::memory_order_acquire)) return;
        look();
        looking.clear(std::memory_order_release);
    }

    void look() {
        if (std::chrono::steady_clock::now() < next_look) return;
        try {
            interrupt();
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!failure) failure = std::current_exception();
            for (ItemRange& range : ranges) range.set(0, 0);
        }
        next_look = std::chrono::steady_clock::now() + kBetweenLooks;
    }

    /// Blocks until no thread takes part in the call.
    void wait_for_workers(std::unique_lock<std::mutex>& lock) {
        const auto alone = [this] { return taking_part == 0; };
        while (interrupt && !done.wait_for(lock, kBetweenLooks, alone)) {
            lock.unlock();
            look_for_interrupt();
            lock.lock();
        }
        done.wait(lock, alone);
    }

    void work(int thread) {
        const PlainFloats plain;  // replaces modes inherited from the host's thread
        std::uint64_t seen = 0;
        std::unique_lock lock(mutex);
        for (;;) {
            start.wait(lock, [&] {
                return stopping || (body != nullptr && call != seen && thread < crew);
            });
            if (stopping) return;
            seen = call;
            const std::function<void(int, int)>& run = *body;
            ++taking_part;
            lock.unlock();
            const ThreadUsage usage = run_items(run, thread);
            lock.lock();
            add(usage);
            if (--taking_part == 0) done.notify_one();
        }
    }
};

ThreadPool::ThreadPool(int threads, RunJobs run_jobs)
    : impl_(
          std::make_unique<Impl>(threads > 0 ? threads : available_cores(), std::move(run_jobs))) {}

ThreadPool::~ThreadPool() {
    leave_to_the_parent();
}

/// Abandons the state in a child after fork(): its threads exist only in the parent, so it cannot
/// be destroyed.
void ThreadPool::leave_to_the_parent() {
    if (impl_->process != process_number()) static_cast<void>(impl_.release());
}

void ThreadPool::set_interrupt(std::function<void()> interrupt) {
    impl_->interrupt = std::move(interrupt);
}

int ThreadPool::size() const {
    return impl_->size;
}

void ThreadPool::for_each_item(int count, const std::function<void(int item, int thread)>& body) {
    if (count <= 0) return;
    if (impl_->process != process_number()) {
        auto anew = std::make_unique<Impl>(impl_->size, impl_->run_jobs);
        anew->interrupt = impl_->interrupt;
        leave_to_the_parent();
        impl_ = std::move(anew);
    }
    Impl& state = *impl_;
    if (state.run_jobs) {
        state.run_as_jobs(count, body);
        state.throw_failure();
        return;
    }
    const ThreadThrottle::Clock::time_point began = ThreadThrottle::Clock::now();
    const int chosen = state.throttle.choose(began);
    const int crew = std::min(chosen, count);
    {
        const std::lock_guard lock(state.mutex);
        state.share_out(count, crew);
        // Threads without an item would seem to have waited for a core.
        state.measured = crew == chosen && state.throttle.wants_usage();
        state.used = {};
        state.body = &body;
        ++state.call;
    }
    if (crew > 1) state.start.notify_all();
    const ThreadUsage usage = state.run_items(body, 0);
    std::unique_lock lock(state.mutex);
    // No item is left: threads that wake up now find no call, and this thread awaits the active
    // ones.
    state.body = nullptr;
    state.wait_for_workers(lock);
    state.add(usage);
    state.throttle.ended(began, ThreadThrottle::Clock::now(), state.used);
    state.throw_failure();
}

void ThreadPool::for_each_range(int count, const std::function<void(int first, int last)>& body) {
    const struct {
        int count;
        int shares;
        const std::function<void(int, int)>& body;
    } work{count, std::min(count, impl_->interrupt ? kSharesToStopBetween : impl_->size), body};
    for_each_item(work.shares, [&work](int share, int) {
        work.body(share_edge(work.count, share, work.shares),
                  share_edge(work.count, share + 1, work.shares));
    });
}

}  // namespace ocean
