// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The blocking pool: threads sleep on a condition variable between calls.
#include "ocean/thread_pool.hpp"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "ocean/platform.hpp"

namespace ocean {

struct ThreadPool::State {
    int size = 1;
    std::vector<std::thread> workers;
    std::mutex mutex;
    std::condition_variable start;
    std::condition_variable done;
    const std::function<void(int, int)>* body = nullptr;
    int count = 0;
    int running = 0;
    unsigned generation = 0;
    bool stopping = false;
    std::exception_ptr failure;

    void run_share(int share) {
        const auto edge = [this](int i) {
            return static_cast<int>(static_cast<long long>(count) * i / size);
        };
        const int first = edge(share);
        const int last = edge(share + 1);
        if (first == last) return;
        try {
            (*body)(first, last);
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!failure) failure = std::current_exception();
        }
    }

    void work(int share) {
        unsigned seen = 0;
        for (;;) {
            {
                std::unique_lock lock(mutex);
                start.wait(lock, [&] { return stopping || generation != seen; });
                if (stopping) return;
                seen = generation;
            }
            run_share(share);
            const std::lock_guard lock(mutex);
            if (--running == 0) done.notify_one();
        }
    }
};

ThreadPool::ThreadPool(int threads) : state_(std::make_unique<State>()) {
    state_->size = threads > 0 ? threads : available_cores();
    state_->workers.reserve(static_cast<std::size_t>(state_->size - 1));
    for (int share = 1; share < state_->size; ++share) {
        try {
            state_->workers.emplace_back([state = state_.get(), share] { state->work(share); });
        } catch (const std::exception&) {
            // The system gives no more threads: those there are do the same work to the same bits.
            state_->size = share;
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

void ThreadPool::for_each_range(int count, const std::function<void(int first, int last)>& body) {
    {
        const std::lock_guard lock(state_->mutex);
        state_->body = &body;
        state_->count = count;
        state_->running = state_->size - 1;
        state_->failure = nullptr;
        ++state_->generation;
    }
    state_->start.notify_all();
    state_->run_share(0);
    std::unique_lock lock(state_->mutex);
    state_->done.wait(lock, [this] { return state_->running == 0; });
    if (state_->failure) std::rethrow_exception(state_->failure);
}

}  // namespace ocean
