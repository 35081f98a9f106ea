// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The blocking pool: threads sleep on a condition variable between calls.
#include "ocean/thread_pool.hpp"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "ocean/platform.hpp"

namespace ocean {

struct ThreadPool::State {
    /// One call of for_each_item.
    struct Call {
        const std::function<void(int, int)>* body = nullptr;
        int count = 0;
        std::uint32_t number = 0;
    };

    int size = 1;
    std::vector<std::thread> workers;
    std::mutex mutex;
    std::condition_variable start;
    std::condition_variable done;
    Call call;                          // guarded by mutex
    bool stopping = false;              // guarded by mutex
    std::exception_ptr failure;         // guarded by mutex
    std::atomic<std::uint64_t> next{};  // call number << 32 | its next item
    std::atomic<int> unfinished{};      // items of the call

    /// Takes items until there are none left. A thread that comes late finds the number of a later
    /// call, or no item: it never touches the body of a call that has returned.
    void take_items(const Call& mine, int thread) {
        std::uint64_t ticket = next.load(std::memory_order_acquire);
        for (;;) {
            if (static_cast<std::uint32_t>(ticket >> 32) != mine.number) return;
            const auto item = static_cast<int>(ticket & 0xFFFFFFFFu);
            if (item >= mine.count) return;
            if (!next.compare_exchange_weak(ticket, ticket + 1, std::memory_order_acq_rel))
                continue;
            run_item(mine, item, thread);
            ticket = next.load(std::memory_order_acquire);
        }
    }

    void run_item(const Call& mine, int item, int thread) {
        try {
            (*mine.body)(item, thread);
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!failure) failure = std::current_exception();
        }
        if (unfinished.fetch_sub(1, std::memory_order_acq_rel) == 1) {
            const std::lock_guard lock(mutex);
            done.notify_one();
        }
    }

    void work(int thread) {
        std::uint32_t seen = 0;
        for (;;) {
            Call mine;
            {
                std::unique_lock lock(mutex);
                start.wait(lock, [&] { return stopping || call.number != seen; });
                if (stopping) return;
                mine = call;
            }
            seen = mine.number;
            take_items(mine, thread);
        }
    }
};

ThreadPool::ThreadPool(int threads) : state_(std::make_unique<State>()) {
    state_->size = threads > 0 ? threads : available_cores();
    state_->workers.reserve(static_cast<std::size_t>(state_->size - 1));
    for (int thread = 1; thread < state_->size; ++thread) {
        try {
            state_->workers.emplace_back([state = state_.get(), thread] { state->work(thread); });
        } catch (const std::exception&) {
            // The system gives no more threads: those there are do the same work to the same bits.
            state_->size = thread;
            break;
        }
    }
}

ThreadPool::~ThreadPool() {
    {
        const std::lock_guard lock(state_->mutex);
        state_->stopping = true;
    }
    state_->start.notify_all();
    for (std::thread& worker : state_->workers) worker.join();
}

int ThreadPool::size() const {
    return state_->size;
}

void ThreadPool::for_each_item(int count, const std::function<void(int item, int thread)>& body) {
    if (count <= 0) return;
    State::Call mine;
    {
        const std::lock_guard lock(state_->mutex);
        mine = {&body, count, state_->call.number + 1};
        state_->call = mine;
        state_->failure = nullptr;
        state_->unfinished.store(count, std::memory_order_relaxed);
        state_->next.store(std::uint64_t{mine.number} << 32, std::memory_order_release);
    }
    if (count > 1) state_->start.notify_all();
    state_->take_items(mine, 0);
    std::unique_lock lock(state_->mutex);
    state_->done.wait(lock, [this] { return state_->unfinished.load() == 0; });
    if (state_->failure) std::rethrow_exception(std::exchange(state_->failure, nullptr));
}

void ThreadPool::for_each_range(int count, const std::function<void(int first, int last)>& body) {
    const struct {
        int count;
        int shares;
        const std::function<void(int, int)>& body;
        int edge(int i) const {
            return static_cast<int>(static_cast<long long>(count) * i / shares);
        }
    } work{count, state_->size, body};
    for_each_item(work.shares, [&work](int share, int) {
        const int first = work.edge(share);
        const int last = work.edge(share + 1);
        if (first < last) work.body(first, last);
    });
}

}  // namespace ocean
