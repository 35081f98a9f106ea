// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The queue between the boards' threads and the server's thread.
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <iterator>
#include <mutex>
#include <utility>
#include <variant>
#include <vector>

#include "ocean/internal/bridge/source.hpp"

namespace ocean::bridge {

/// A report or an event of a board; their order counts.
using BoardMessage = std::variant<Report, BoardEvent>;

/// All functions may be called from any thread.
class BoardQueue {
  public:
    static constexpr std::size_t kMaxMessages = 65536;

    /// Appends a message; a full queue drops it. Returns true if the reader must be woken, which is
    /// once until its take() has emptied the queue.
    bool enqueue(BoardMessage message) {
        const std::lock_guard lock(mutex_);
        if (messages_.size() < kMaxMessages) messages_.push_back(std::move(message));
        return !std::exchange(woken_, true);
    }

    struct Batch {
        std::vector<BoardMessage> messages;
        bool has_more;  // true if the reader must call take() again
    };
    /// Removes the oldest messages, at most `limit`.
    Batch take(std::size_t limit) {
        const std::lock_guard lock(mutex_);
        const auto end =
            messages_.begin() + static_cast<std::ptrdiff_t>(std::min(messages_.size(), limit));
        Batch batch{{std::move_iterator(messages_.begin()), std::move_iterator(end)}, false};
        messages_.erase(messages_.begin(), end);
        woken_ = !messages_.empty();
        batch.has_more = woken_;
        return batch;
    }

  private:
    std::mutex mutex_;
    std::deque<BoardMessage> messages_;
    bool woken_ = false;
};

}  // namespace ocean::bridge
