// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Parts of something large, made when they are asked for and kept: which are there.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "ocean/thread_pool.hpp"

namespace ocean {

/// Read by any thread, changed by one at a time.
class Parts {
  public:
    explicit Parts(int count)
        : there_(std::make_unique<std::atomic<bool>[]>(static_cast<std::size_t>(count))),
          count_(count) {}

    int count() const { return count_; }
    bool has(int part) const {
        return there_[static_cast<std::size_t>(part)].load(std::memory_order_acquire);
    }
    void clear() {
        for (int part = 0; part < count_; ++part) {
            there_[static_cast<std::size_t>(part)].store(false, std::memory_order_relaxed);
        }
    }

    /// Calls body(part, thread) for those of `wanted` that are not there, on the threads of the
    /// pool if there is one.
    template <typename Body>
    void make(std::span<const int> wanted, ThreadPool* pool, const Body& body) {
        std::vector<int> missing;
        for (const int part : wanted) {
            if (!has(part)) missing.push_back(part);
        }
        const auto make_one = [&](int item, int thread) {
            const int part = missing[static_cast<std::size_t>(item)];
            body(part, thread);
            there_[static_cast<std::size_t>(part)].store(true, std::memory_order_release);
        };
        const int count = static_cast<int>(missing.size());
        if (pool != nullptr) {
            pool->for_each_item(count, make_one);
        } else {
            for (int item = 0; item < count; ++item) make_one(item, 0);
        }
    }

  private:
    std::unique_ptr<std::atomic<bool>[]> there_;
    int count_;
};

/// A set of parts, in order.
class PartSet {
  public:
    explicit PartSet(int count) : in_(static_cast<std::size_t>(count), 0) {}
    void add(int part) {
        char& in = in_[static_cast<std::size_t>(part)];
        if (in == 0) list_.push_back(part);
        in = 1;
    }
    std::span<const int> list() const { return list_; }

  private:
    std::vector<char> in_;
    std::vector<int> list_;
};

}  // namespace ocean
