// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "frame_budget.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>

#include "ocean/internal/text.hpp"

namespace ocean::app {
namespace {

double now() {
    const auto since = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double, std::milli>(since).count();
}

std::string row(const std::string& stage, std::vector<double> times) {
    if (times.empty()) return "";
    std::ranges::sort(times);
    return format_text("%s,%.3f,%.3f\n", stage.c_str(), times[times.size() / 2], times.back());
}

}  // namespace

gl::AfterStage FrameBudget::after_stage() {
    return [this](std::string_view stage) {
        glFinish();
        const double time = now();
        add(stage, time - before_);
        before_ = time;
    };
}

void FrameBudget::begin() {
    glFinish();
    before_ = now();
}

void FrameBudget::add(std::string_view stage, double milliseconds) {
    auto known = stages_.find(stage);
    if (known == stages_.end()) {
        order_.emplace_back(stage);
        known = stages_.emplace(order_.back(), std::vector<double>()).first;
    }
    known->second.resize(frames_ + 1);
    known->second.back() += milliseconds;
}

std::string FrameBudget::table() const {
    std::string text = "stage,median,worst\n";
    std::vector<double> all(frames_);
    for (const std::string& stage : order_) {
        const std::vector<double>& times = stages_.find(stage)->second;
        text += row(stage, times);
        for (std::size_t frame = 0; frame < std::min(frames_, times.size()); ++frame) {
            all[frame] += times[frame];
        }
    }
    return text + row("frame", all);
}

}  // namespace ocean::app
