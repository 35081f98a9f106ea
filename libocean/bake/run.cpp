// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Baking the frames of a plan. A frame's time comes from the sea alone, so that frames may be baked
// in any order, on any machine, and baked again after a crash with the same bytes.
#include "ocean/bake/run.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <utility>

#include "complete_file.hpp"
#include "frame_baker.hpp"
#include "frame_workers.hpp"
#include "ocean/bake/frames_there.hpp"
#include "ocean/error.hpp"
#include "ocean/io/output_file.hpp"
#include "ocean/subject.hpp"
#include "ocean/text.hpp"

namespace ocean {
namespace {

using Clock = std::chrono::steady_clock;

/// What became of one frame.
struct Outcome {
    bool skipped = false;
    double seconds = 0.0;
    std::vector<std::string> files;
    std::optional<Error> error;
};

Outcome bake_frame(const BakePlan& plan, FrameBaker& baker, int frame) {
    Outcome outcome;
    const Clock::time_point started = Clock::now();
    try {
        const std::vector<BakeFile> files = plan.format->files(plan, frame);
        for (const BakeFile& file : files) outcome.files.push_back(file.path);
        outcome.skipped = plan.skip_existing && baker.keep(files);
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

/// Keeps the manifest on the disk not far behind the files, at a twentieth of the time at most.
class ManifestKeeper {
  public:
    explicit ManifestKeeper(const Bake& bake) : bake_(bake) {}

    void save(const std::function<void()>& before_it = {}) {
        const Clock::time_point started = Clock::now();
        bake_.host.whole([&] { bake_.manifest.save(before_it); });
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
    Report(const BakePlan& plan, BakeHost& host) : plan_(plan), host_(host) {}

    void frame(int number, const Outcome& outcome) {
        if (outcome.error) {
            host_.frame_failed(number, outcome.error->what(), goes_on());
            if (!first_error_) first_error_ = outcome.error;
            failed_.push_back(number);
            return;
        }
        ++whole_;
        if (outcome.skipped) {
            host_.frame_kept(number, outcome.files);
        } else {
            host_.note(
                format_text("frame %d is at %.9g s", number, plan_.subject->time_of(number)));
            host_.frame_baked(number, outcome.seconds, outcome.files);
        }
    }

    void end() {
        const std::size_t total = plan_.frames.size();
        if (failed_.empty() || goes_on()) host_.end();
        if (failed_.empty()) return;
        if (total == 1) throw *first_error_;
        if (goes_on()) {
            throw Error(ErrorKind::output,
                        format_text("%zu of %zu frames failed: ", failed_.size(), total) +
                            frames_text(failed_));
        }
        throw Error(first_error_->kind(),
                    std::string(first_error_->what()) +
                        format_text("; %d of %zu frames are whole", whole_, total));
    }

  private:
    /// A lone frame's error says all there is to say.
    bool goes_on() const { return plan_.keep_going && plan_.frames.size() > 1; }

    const BakePlan& plan_;
    BakeHost& host_;
    int whole_ = 0;
    std::vector<int> failed_;
    std::optional<Error> first_error_;
};

FramesThere frames_of_folder(const BakePlan& plan) {
    return find_frames(plan, [&plan](std::span<const BakeFile> files) {
        return plan.format->is_of_plan(plan, files.front());
    });
}

void put_shared(const Bake& bake, const BakePlan& plan, const BakeFile& file) {
    put_file_held({plan, bake.source, bake.manifest, bake.host}, file, plan.threads,
                  [&] { plan.format->write_shared(plan, file); });
}

/// The stage and the like, which are there before the first frame.
void bake_shared(const Bake& bake) {
    BakePlan plan = bake.plan;
    std::vector<BakeFile> files = plan.format->shared_files(plan);
    if (plan.format->frame_lists > 0) {
        const FramesThere there = frames_of_folder(plan);
        plan.all_frames = united(plan.all_frames, there.of_plan);
        files = plan.format->shared_files(plan);
        const std::string warning =
            foreign_frames_warning(there, plan.all_frames, files.front().path);
        if (!warning.empty()) bake.host.warning(warning);
    }
    for (const BakeFile& file : files) {
        auto there = plan.skip_existing ? find_complete(plan, file, bake.manifest, plan.threads)
                                        : std::nullopt;
        if (there) {
            bake.manifest.add(std::move(*there));
        } else {
            put_shared(bake, plan, file);
        }
    }
}

/// Of a format whose readers do not tell: the frames within the folder's that are not there, or
/// not of this sea.
void tell_gaps(const Bake& bake, const std::vector<int>& listed, const std::vector<int>& there) {
    std::vector<int> missing;
    const int step = common_step(listed);
    for (long long frame = listed.front(); frame <= listed.back(); frame += step) {
        const int number = static_cast<int>(frame);
        if (!std::ranges::binary_search(there, number)) missing.push_back(number);
    }
    bake.manifest.set_missing(missing);
    if (missing.empty()) return;
    bake.host.warning(
        "frames that are not there yet, which readers fill with a mean of their "
        "neighbours: " +
        frames_text(missing));
}

/// Gives the entry of a shared file the frame that a plan names: the file is the same for all
/// chunks, and each of them entered it with the first frame that it knew of.
void describe_anew(const Bake& bake, const BakePlan& plan, const BakeFile& file) {
    ManifestEntry entry;
    describe(plan, file, entry);
    const std::optional<ManifestEntry> known = bake.manifest.added(entry.name);
    if (!known) return;  // a device has no entry
    entry.bytes = known->bytes;
    entry.sha256 = known->sha256;
    entry.pixels_sha256 = known->pixels_sha256;
    bake.manifest.add(std::move(entry));
}

/// Lists the frames anew: another chunk may have made some meanwhile.
void update_frame_lists(const Bake& bake) {
    BakePlan plan = bake.plan;
    const FramesThere there = frames_of_folder(plan);
    plan.all_frames = united(plan.all_frames, there.of_plan);
    const std::vector<BakeFile> files = plan.format->shared_files(plan);
    for (std::size_t i = 0; i < files.size(); ++i) {
        const bool lists_frames = i < plan.format->frame_lists;
        lists_frames ? put_shared(bake, plan, files[i]) : describe_anew(bake, plan, files[i]);
    }
    if (plan.format->hides_gaps) tell_gaps(bake, plan.all_frames, there.of_plan);
}

/// Passes on what the subject warns of, in a take at the first frame that has some.
void warn_of_subject(const BakePlan& plan, BakeHost& host) {
    const bool plays = plan.subject->plays_take();
    for (const int frame : plan.frames) {
        const auto warnings = plan.subject->warnings(plan.subject->time_of(frame));
        for (const std::string& warning : warnings) {
            host.warning(plays ? "frame " + std::to_string(frame) + ": " + warning : warning);
        }
        if (!warnings.empty() || !plays) return;
    }
}

void bake_frames(const Bake& bake, const WorkShare& share, ManifestKeeper& keeper) {
    const BakePlan& plan = bake.plan;
    std::vector<std::unique_ptr<FrameBaker>> bakers;
    for (int worker = 0; worker < share.frames_at_a_time; ++worker) {
        bakers.push_back(std::make_unique<FrameBaker>(bake, share.threads_each));
    }
    std::vector<Outcome> outcomes(plan.frames.size());
    Report report(plan, bake.host);
    run_in_order(
        static_cast<int>(plan.frames.size()), share.frames_at_a_time,
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

/// While it lives an interrupt saves the manifest before the process ends.
class InterruptedManifest {
  public:
    InterruptedManifest(Manifest& manifest, BakeHost& host) : host_(host) {
        host.if_interrupted([&manifest, &host] {
            try {
                manifest.save();
            } catch (const std::exception& error) {
                host.warning(error.what());
            }
        });
    }
    ~InterruptedManifest() { host_.if_interrupted({}); }
    InterruptedManifest(const InterruptedManifest&) = delete;
    InterruptedManifest& operator=(const InterruptedManifest&) = delete;

  private:
    BakeHost& host_;
};

}  // namespace

void run_bake(const BakePlan& plan, BakeHost& host) {
    const WorkShare share = share_work(plan);
    if (plan.frames.empty()) {
        host.begin(plan, share);
        return host.end();
    }
    Manifest manifest(plan.pattern.manifest());
    if (!manifest.distrust().empty()) {
        host.warning(manifest.distrust() + "; it will be replaced");
    }
    require_own_files(plan, manifest);
    io::make_folder(plan.pattern.folder());
    io::remove_abandoned_temporaries(plan.pattern.folder());
    host.begin(plan, share);
    if (!plan.backend_note.empty()) host.note(plan.backend_note);
    host.note(format_text("%d frames at a time, %d threads each", share.frames_at_a_time,
                          share.threads_each));
    warn_of_subject(plan, host);
    const auto source = plan.subject->open({.threads = plan.threads});  // once, for all workers
    const Bake bake{plan, *source, manifest, host};
    ManifestKeeper keeper(bake);
    const InterruptedManifest last_act(manifest, host);
    try {
        if (plan.format->shared_files != nullptr) keeper.save([&] { bake_shared(bake); });
        bake_frames(bake, share, keeper);
        keeper.save([&] {
            if (plan.format->frame_lists > 0) update_frame_lists(bake);
        });
    } catch (...) {
        keeper.save_if_possible();
        throw;
    }
}

}  // namespace ocean
