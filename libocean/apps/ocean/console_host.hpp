// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The host of bakes from a terminal: reports go to the console, and Ctrl-C waits until the current
// files are complete.
#pragma once

#include <optional>

#include "command.hpp"
#include "interrupt.hpp"
#include "ocean/bake/run.hpp"
#include "ocean/internal/bake/estimate.hpp"

namespace ocean::app {

class ConsoleHost final : public BakeHost {
  public:
    explicit ConsoleHost(const Context& context) : context_(context) {}

    void begin(const BakePlan& plan, const WorkShare& share) override;
    void frame_baked(int frame, double seconds, const std::vector<std::string>& files) override;
    void frame_skipped(int frame, const std::vector<std::string>& files) override;
    void frame_failed(int frame, const std::string& message, bool continues) override;
    void end() override;
    void note(const std::string& text) override;
    void warning(const std::string& text) override;
    std::function<void(std::int64_t done, std::int64_t total)> foam_progress() override;
    std::function<void(std::string_view work, double share)> build_progress() override;
    void run_uninterrupted(const std::function<void()>& write) override;
    void set_interrupt_handler(std::function<void()> handler) override;

  private:
    const Context& context_;
    std::optional<InterruptWatch::LastAct> last_act_;
};

/// Reports how many files a run writes, their sizes and its memory, and warns where there is no
/// room. `beside` are files of the same run that are not baked.
void report_forecast(const BakeForecast& forecast, const BakeForecast& beside, Console& console);
/// Does so for a dry run, and prints the files.
void show_forecast(const BakeForecast& forecast, const BakeForecast& beside, Console& console);

}  // namespace ocean::app
