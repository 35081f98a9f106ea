// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A bake seen from a terminal: what it says goes to the console, and Ctrl-C waits for whole files.
#pragma once

#include <optional>

#include "command.hpp"
#include "interrupt.hpp"
#include "ocean/bake/run.hpp"

namespace ocean::app {

class ConsoleHost final : public BakeHost {
  public:
    explicit ConsoleHost(const Context& context) : context_(context) {}

    void begin(const BakePlan& plan, const WorkShare& share) override;
    void frame_baked(int frame, double seconds, const std::vector<std::string>& files) override;
    void frame_kept(int frame, const std::vector<std::string>& files) override;
    void frame_failed(int frame, const std::string& message, bool goes_on) override;
    void end() override;
    void note(const std::string& text) override;
    void warning(const std::string& text) override;
    std::function<void(std::int64_t done, std::int64_t total)> foam_progress() override;
    void whole(const std::function<void()>& write) override;
    void if_interrupted(std::function<void()> last_act) override;

  private:
    const Context& context_;
    std::optional<InterruptWatch::LastAct> last_act_;
};

/// Prints the files of a dry run and what they need; `beside` are files that are shown already.
void show_forecast(const BakeForecast& forecast, const BakeForecast& beside, Console& console);

}  // namespace ocean::app
