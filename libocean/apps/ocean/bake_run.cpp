// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Baking the frames of a plan. A frame's time comes from the sea alone, so that frames may be baked
// in any order, on any machine, and baked again after a crash with the same bytes.
#include "bake_run.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>

#include "bake_estimate.hpp"
#include "bake_frame.hpp"
#include "command.hpp"
#include "console.hpp"
#include "frame_workers.hpp"
#include "ocean/error.hpp"
#include "ocean/ocean.hpp"
#include "text.hpp"
#include "write_output.hpp"

namespace ocean::app {
namespace {

using Clock = std::chrono::steady_clock;

/// What became of one frame.
struct Outcome {
    bool skipped = false;
    double seconds = 0.0;
    std::vector<std::string> files;
    std::optional<Error> error;
};

/// Light also meets the waves that are too short for the map.
void settle_slope_variance(BakePlan& plan, const Context& context) {
    if (!plan.view || plan.slope_variance_given) return;
    const auto slope_of = [&](const Parameters& parameters) {
        return Ocean(parameters, {.threads = context.options.threads}).state().mean_square_slope;
    };
    Parameters held = plan.sea.parameters;
    if (held.grid.cascades == 1) {
        held.grid.resolution = std::min(plan.resolution, held.grid.resolution);
    } else {
        held.surface.shortest_wavelength =
            std::max(held.surface.shortest_wavelength, plan.shortest_wave());
    }
    plan.view->unresolved_slope_variance =
        std::max(0.0, slope_of(plan.sea.parameters).asked - slope_of(held).resolved);
}

void announce(const BakePlan& plan, const Crew& crew, Console& console) {
    const int frames = static_cast<int>(plan.frames.size());
    const Grid& grid = plan.sea.parameters.grid;
    const double shortest = plan.shortest_wave();
    const std::uint64_t memory = memory_bytes(plan, crew.workers);
    console.begin(frames,
                  format_text("%d frame%s of %d x %d samples, period %g m, shortest wave %.3g m, ",
                              frames, frames == 1 ? "" : "s", plan.resolution, plan.resolution,
                              grid.patch_size, shortest) +
                      bytes_text(memory) + " of memory",
                  format_text("\"resolution\": %d, \"period\": %.9g, \"shortest_wave\": %.9g, "
                              "\"memory_bytes\": %llu, \"frames_at_a_time\": %d",
                              plan.resolution, grid.patch_size, shortest,
                              static_cast<unsigned long long>(memory), crew.workers));
    console.note(format_text("%d frames at a time, %d threads each", crew.workers, crew.threads));
}

Outcome bake_frame(const BakePlan& plan, FrameBaker& baker, int frame) {
    Outcome outcome;
    const Clock::time_point started = Clock::now();
    try {
        const std::vector<BakeFile> files = files_of_frame(plan, frame);
        for (const BakeFile& file : files) outcome.files.push_back(file.path);
        outcome.skipped = plan.skip_existing && baker.keep(files, frame);
        if (!outcome.skipped) baker.make(files, frame);
    } catch (const Error& error) {
        outcome.error = error;
    } catch (const std::bad_alloc&) {
        outcome.error = Error(ErrorKind::out_of_memory, "there is not enough memory");
    } catch (const std::exception& error) {
        outcome.error = Error(ErrorKind::output, error.what());
    }
    outcome.seconds = std::chrono::duration<double>(Clock::now() - started).count();
    return outcome;
}

/// "7, 9-11".
std::string ranges_text(const std::vector<int>& frames) {
    std::string text;
    for (std::size_t i = 0; i < frames.size();) {
        std::size_t last = i;
        while (last + 1 < frames.size() && frames[last + 1] == frames[last] + 1) ++last;
        text += (text.empty() ? "" : ", ") + std::to_string(frames[i]);
        if (last > i) text += "-" + std::to_string(frames[last]);
        i = last + 1;
    }
    return text;
}

/// Keeps the manifest on the disk not far behind the files, at a twentieth of the time at most.
class ManifestKeeper {
  public:
    explicit ManifestKeeper(const Bake& bake) : bake_(bake) {}

    void save() {
        const InterruptWatch::Hold whole = bake_.interrupts.hold();
        const Clock::time_point started = Clock::now();
        bake_.manifest.save();
        saved_ = Clock::now();
        pause_ = std::max<Clock::duration>(std::chrono::seconds(5), 20 * (saved_ - started));
    }
    void save_now_and_then() {
        if (Clock::now() - saved_ > pause_) save();
    }
    /// When something else went wrong, which is what the user must hear.
    void save_if_possible() noexcept {
        try {
            save();
        } catch (const std::exception&) {
        }
    }

  private:
    const Bake& bake_;
    Clock::time_point saved_ = Clock::now();
    Clock::duration pause_ = std::chrono::seconds(5);
};

/// Reports each frame as it is delivered; throws what ends the run.
class Report {
  public:
    Report(const BakePlan& plan, Console& console) : plan_(plan), console_(console) {}

    void frame(int number, const Outcome& outcome) {
        if (outcome.error) {
            console_.fail(number, outcome.error->what(), goes_on());
            if (!first_error_) first_error_ = outcome.error;
            failed_.push_back(number);
            return;
        }
        ++whole_;
        if (outcome.skipped) {
            console_.skip(number, outcome.files);
        } else {
            console_.note(format_text("frame %d is at %.9g s", number, plan_.sea.time_of(number)));
            console_.step(number, outcome.seconds, outcome.files);
        }
    }

    void end() {
        const std::size_t total = plan_.frames.size();
        if (failed_.empty() || goes_on()) console_.finish();
        if (failed_.empty()) return;
        if (total == 1) throw *first_error_;
        if (goes_on()) {
            throw Error(ErrorKind::output,
                        format_text("%zu of %zu frames failed: ", failed_.size(), total) +
                            ranges_text(failed_));
        }
        throw Error(first_error_->kind(),
                    std::string(first_error_->what()) +
                        format_text("; %d of %zu frames are whole", whole_, total));
    }

  private:
    /// A lone frame's error says all there is to say.
    bool goes_on() const { return plan_.keep_going && plan_.frames.size() > 1; }

    const BakePlan& plan_;
    Console& console_;
    int whole_ = 0;
    std::vector<int> failed_;
    std::optional<Error> first_error_;
};

void bake_frames(const Bake& bake, const Crew& crew, Console& console, ManifestKeeper& keeper) {
    const BakePlan& plan = bake.plan;
    std::vector<std::unique_ptr<FrameBaker>> bakers;
    for (int worker = 0; worker < crew.workers; ++worker) {
        bakers.push_back(std::make_unique<FrameBaker>(bake, crew.threads));
    }
    std::vector<Outcome> outcomes(plan.frames.size());
    Report report(plan, console);
    run_in_order(
        static_cast<int>(plan.frames.size()), crew.workers,
        [&](int worker, int index) {
            const auto i = static_cast<std::size_t>(index);
            outcomes[i] =
                bake_frame(plan, *bakers[static_cast<std::size_t>(worker)], plan.frames[i]);
            return !outcomes[i].error || plan.keep_going;
        },
        [&](int index) {
            const auto i = static_cast<std::size_t>(index);
            report.frame(plan.frames[i], std::exchange(outcomes[i], {}));
            keeper.save_now_and_then();
        });
    report.end();
}

void bake_all(const BakePlan& plan, const Crew& crew, const Context& context) {
    make_folder(plan.pattern.folder());
    io::remove_abandoned_temporaries(plan.pattern.folder());
    Manifest manifest(plan.pattern.manifest());
    if (!manifest.distrust().empty()) {
        context.console.warning(manifest.distrust() + "; it will be replaced");
    }
    announce(plan, crew, context.console);
    Ocean ocean(plan.sea, {.threads = context.options.threads});
    ocean.modes();  // once, for all workers
    const Bake bake{plan, ocean, manifest, context.interrupts, context.console};
    ManifestKeeper keeper(bake);
    const InterruptWatch::LastAct last_act(context.interrupts, [&] {
        try {
            manifest.save();
        } catch (const std::exception& error) {
            context.console.warning(error.what());
        }
    });
    try {
        bake_frames(bake, crew, context.console, keeper);
    } catch (...) {
        keeper.save_if_possible();
        throw;
    }
    keeper.save();
}

}  // namespace

void run_bake(BakePlan& plan, bool dry_run, const Context& context) {
    const Crew crew = choose_crew(plan, context.options.threads);
    settle_slope_variance(plan, context);
    if (dry_run) return show_plan(plan, crew, context.console);
    if (plan.frames.empty()) {
        context.console.begin(0, "--shard " + plan.shard + " is empty: there are fewer frames", "");
        return context.console.finish();
    }
    bake_all(plan, crew, context);
}

}  // namespace ocean::app
