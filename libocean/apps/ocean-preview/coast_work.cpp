// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "coast_work.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string_view>
#include <utility>

namespace ocean::app {
namespace {

/// Returns "delays" of "coast: delays".
std::string_view without_subject(std::string_view work) {
    const std::size_t colon = work.find(": ");
    return colon == std::string_view::npos ? work : work.substr(colon + 2);
}

}  // namespace

CoastWork::CoastWork(Ocean& before, Sea sea) {
    OceanOptions options;
    // A thread is left for the pictures.
    options.threads = std::max(1, before.pool().size() - 1);
    options.interrupt = [this] {
        if (stopped_) throw Stopped();
    };
    options.build_progress = [this](std::string_view work, double share) {
        if (stopped_) throw Stopped();
        const std::lock_guard lock(mutex_);
        work_ = without_subject(work);
        share_ = share;
    };
    sea_ = std::make_unique<Ocean>(before, std::move(options));
    sea_->change(std::move(sea));
    made_ = std::async(std::launch::async, [this] {
        try {
            sea_->prepare_coast();
        } catch (const Stopped&) {
        }
    });
}

CoastWork::~CoastWork() {
    stopped_ = true;
    if (made_.valid()) made_.wait();
}

bool CoastWork::done() const {
    return made_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

std::string CoastWork::progress() const {
    const std::lock_guard lock(mutex_);
    return work_ + " " + std::to_string(std::lround(100.0 * share_)) + " %";
}

const Ocean& CoastWork::result() {
    made_.get();
    return *sea_;
}

}  // namespace ocean::app
