// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The tiles of a large map, made only when needed, and then kept.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "ocean/thread_pool.hpp"

namespace ocean {

/// Records which tiles are ready. Any thread may read the record; only one thread at a time may
/// change it.
class LazyTiles {
  public:
    explicit LazyTiles(int count)
        : ready_(std::make_unique<std::atomic<bool>[]>(static_cast<std::size_t>(count))),
          count_(count) {}

    int count() const { return count_; }
    bool has(int tile) const {
        return ready_[static_cast<std::size_t>(tile)].load(std::memory_order_acquire);
    }
    void clear() {
        for (const int tile : made_) {
            ready_[static_cast<std::size_t>(tile)].store(false, std::memory_order_relaxed);
        }
        made_.clear();
    }

    /// Calls body(tile, thread) for each of the `wanted` tiles that is not ready, on the threads of
    /// the pool or, if it is null, on the calling thread.
    template <typename Body>
    void make(std::span<const int> wanted, ThreadPool* pool, const Body& body) {
        std::vector<int> missing;
        for (const int tile : wanted) {
            if (!has(tile)) missing.push_back(tile);
        }
        const auto make_one = [&](int item, int thread) {
            const int tile = missing[static_cast<std::size_t>(item)];
            body(tile, thread);
            ready_[static_cast<std::size_t>(tile)].store(true, std::memory_order_release);
        };
        made_.insert(made_.end(), missing.begin(), missing.end());
        const int count = static_cast<int>(missing.size());
        if (pool != nullptr) {
            pool->for_each_item(count, make_one);
        } else {
            for (int item = 0; item < count; ++item) make_one(item, 0);
        }
    }

  private:
    std::unique_ptr<std::atomic<bool>[]> ready_;
    int count_;
    std::vector<int> made_;  // all that may be ready
};

/// A set of tiles, in the order in which they were added.
class TileSet {
  public:
    explicit TileSet(int count) : in_(static_cast<std::size_t>(count), 0) {}
    void add(int tile) {
        char& in = in_[static_cast<std::size_t>(tile)];
        if (in == 0) list_.push_back(tile);
        in = 1;
    }
    std::span<const int> list() const { return list_; }

  private:
    std::vector<char> in_;
    std::vector<int> list_;
};

}  // namespace ocean
