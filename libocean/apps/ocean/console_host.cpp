// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See console_host.hpp.
#include "console_host.hpp"

#include <optional>
#include <utility>

#include "interrupt.hpp"
#include "ocean/bake/run.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

class ConsoleHost final : public BakeHost {
  public:
    explicit ConsoleHost(const Context& context) : context_(context) {}

    void begin(const BakePlan& plan, const WorkShare& share) override {
        const int frames = static_cast<int>(plan.frames.size());
        if (frames == 0) {
            return context_.console.begin(
                0,
                format_text("--shard %d/%d is empty: the bake has fewer frames", plan.shard->number,
                            plan.shard->count),
                {});
        }
        const Domain domain = plan.domain();
        const double period = domain.size[0];
        const double shortest = plan.shortest_wave();
        const int columns = domain.wraps ? plan.finest() : domain.samples[0];
        const int rows = domain.wraps ? plan.finest() : domain.samples[1];
        const std::string size = domain.wraps
                                     ? format_text("period %g m", period)
                                     : format_text("%g x %g m", domain.size[0], domain.size[1]);
        const std::uint64_t memory = bake_memory_bytes(plan, share.frames_at_a_time);
        context_.console.begin(frames,
                               format_text("%d frame%s of %d x %d samples, ", frames,
                                           frames == 1 ? "" : "s", columns, rows) +
                                   size + format_text(", shortest wave %.3g m, ", shortest) +
                                   bytes_text(memory) + " of memory",
                               {{"resolution", plan.finest()},
                                {"period", Json(period, significant<9>)},
                                {"shortest_wave", Json(shortest, significant<9>)},
                                {"memory_bytes", memory},
                                {"frames_at_a_time", share.frames_at_a_time}});
    }
    void frame_baked(int frame, double seconds, const std::vector<std::string>& files) override {
        context_.console.step(frame, seconds, files);
    }
    void frame_skipped(int frame, const std::vector<std::string>& files) override {
        context_.console.skip(frame, files);
    }
    void frame_failed(int frame, const std::string& message, bool continues) override {
        context_.console.fail(frame, message, continues);
    }
    void end() override { context_.console.finish(); }
    void note(const std::string& text) override { context_.console.note(text); }
    void warning(const std::string& text) override { context_.console.warning(text); }
    std::function<void(std::int64_t, std::int64_t)> foam_progress() override {
        return foam_progress_on(context_.console);
    }
    std::function<void(std::string_view, double)> build_progress() override {
        return build_progress_on(context_.console);
    }
    void run_uninterrupted(const std::function<void()>& write) override {
        const InterruptWatch::Hold hold = context_.interrupts.hold();
        write();
    }
    void set_interrupt_handler(std::function<void()> handler) override {
        last_act_.reset();
        if (handler) last_act_.emplace(context_.interrupts, std::move(handler));
    }

  private:
    const Context& context_;
    std::optional<InterruptWatch::LastAct> last_act_;
};

}  // namespace

void bake_on_console(const BakePlan& plan, const Context& context) {
    ConsoleHost host(context);
    run_bake(plan, host);
}

void show_forecast(const BakeForecast& forecast, const BakeForecast& beside, Console& console) {
    for (const BakeForecast* part : {&beside, &forecast}) {
        for (const BakeForecast::File& file : part->files) {
            const std::string state =
                file.count > 1  ? format_text("\t%ld files, %ld kept", file.count, file.kept)
                : file.kept > 0 ? "\tkept"
                                : "";
            console.data(file.path + state + "\n");
        }
    }
    report_forecast(forecast, beside, console);
    for (const std::string& warning : forecast.warnings) console.warning(warning);
}

void report_forecast(const BakeForecast& forecast, const BakeForecast& beside, Console& console) {
    const long all = beside.all() + forecast.all();
    const long complete = beside.kept() + forecast.kept();
    const std::uint64_t bytes = beside.bytes + forecast.bytes;
    const std::uint64_t room = forecast.free_bytes;
    console.report("plan",
                   format_text("%ld files, %ld of them kept, the others at most ", all, complete) +
                       bytes_text(bytes) + "; " + bytes_text(room) + " are free; " +
                       bytes_text(forecast.memory_bytes) + " of memory",
                   {{"files", all},
                    {"kept", complete},
                    {"bytes", bytes},
                    {"free_bytes", room},
                    {"memory_bytes", forecast.memory_bytes}});
    if (bytes > room) {
        console.warning("the files may need " + bytes_text(bytes) + ", " + bytes_text(room) +
                        " are free: they may not fit");
    }
}

}  // namespace ocean::app
