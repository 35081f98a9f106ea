// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Collects the reports and events of a source, for a test that waits for them.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "helpers.hpp"
#include "ocean/internal/bridge/source.hpp"

namespace ocean::bridge::test {

/// Outlives the source.
class Ear {
  public:
    Source::Listener listener() {
        return {[this](const Report& report) { hear(reports_, report); },
                [this](const BoardEvent& event) { hear(events_, event_text(event)); }};
    }

    /// False if it does not come to that.
    bool hears(const std::function<bool(const std::vector<Report>&)>& reports) {
        return wait([&] { return reports(reports_); });
    }
    bool hears_event(const std::string& event) {
        return wait([&] { return std::ranges::find(events_, event) != events_.end(); });
    }
    bool hears_events(std::size_t count) {
        return wait([&] { return events_.size() >= count; });
    }
    /// "a/cc1 = 5" of each report so far.
    std::vector<std::string> values() {
        const std::lock_guard lock(mutex_);
        std::vector<std::string> values;
        for (const Report& report : reports_) {
            values.push_back(report.channel + " = " +
                             std::to_string(static_cast<int>(report.value)));
        }
        return values;
    }
    std::vector<std::string> events() {
        const std::lock_guard lock(mutex_);
        return events_;
    }
    void forget() {
        const std::lock_guard lock(mutex_);
        reports_.clear();
        events_.clear();
    }

  private:
    template <typename Word>
    void hear(std::vector<Word>& words, const Word& word) {
        {
            const std::lock_guard lock(mutex_);
            words.push_back(word);
        }
        heard_.notify_all();
    }
    template <typename Condition>
    bool wait(const Condition& condition) {
        std::unique_lock lock(mutex_);
        return heard_.wait_for(lock, std::chrono::milliseconds(kPatience), condition);
    }

    std::mutex mutex_;
    std::condition_variable heard_;
    std::vector<Report> reports_;
    std::vector<std::string> events_;
};

}  // namespace ocean::bridge::test
