// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See run.hpp. The time of a frame depends on the subject alone, so that frames may be baked in any
// order, on any machine, and baked again after a crash with the same bytes.
#include "ocean/bake/run.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <new>
#include <optional>
#include <utility>

#include "complete_file.hpp"
#include "frame_baker.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/bake/estimate.hpp"
#include "ocean/internal/bake/existing_frames.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/text.hpp"

namespace ocean {
namespace {

using Clock = std::chrono::steady_clock;

/// The result of one frame.
struct FrameOutcome {
    bool skipped = false;
    double seconds = 0.0;
    std::vector<std::string> files;
    std::optional<Error> error;
};

FrameOutcome bake_frame(const BakePlan& plan, FrameBaker& baker, int frame) {
    FrameOutcome outcome;
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

/// Saves the manifest every few seconds while files are written, and spends at most a twentieth of
/// the time on it.
class ManifestSaver {
  public:
    explicit ManifestSaver(const Bake& bake) : bake_(bake) {}

    void save(const std::function<void()>& before_merge = {}) {
        const Clock::time_point started = Clock::now();
        bake_.host.run_uninterrupted([&] { bake_.manifest.save(before_merge); });
        saved_ = Clock::now();
        pause_ = std::max<Clock::duration>(std::chrono::seconds(5), 20 * (saved_ - started));
    }
    void save_if_due() {
        if (Clock::now() - saved_ > pause_) save();
    }
    /// Saves while another error is on its way to the user; an error of saving must not hide that
    /// error.
    void try_save() noexcept {
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

/// Reports the frames to the host in order. end() throws the error that ends the run.
class FrameReporter {
  public:
    FrameReporter(const BakePlan& plan, BakeHost& host) : plan_(plan), host_(host) {}

    void frame(int number, const FrameOutcome& outcome) {
        if (outcome.error) {
            host_.frame_failed(number, outcome.error->what(), continues());
            if (!first_error_) first_error_ = outcome.error;
            failed_.push_back(number);
            return;
        }
        ++complete_;
        if (outcome.skipped) {
            host_.frame_skipped(number, outcome.files);
        } else {
            host_.note(format_text("frame %d is at %.9g s", number,
                                   plan_.subject->timeline().time_of(number)));
            host_.frame_baked(number, outcome.seconds, outcome.files);
        }
    }

    void end() {
        const std::size_t total = plan_.frames.size();
        if (failed_.empty() || continues()) host_.end();
        if (failed_.empty()) return;
        if (total == 1) throw *first_error_;
        if (continues()) {
            throw Error(ErrorKind::output,
                        format_text("%zu of %zu frames failed: ", failed_.size(), total) +
                            frames_text(failed_));
        }
        throw Error(first_error_->kind(),
                    std::string(first_error_->what()) +
                        format_text("; %d of %zu frames are complete", complete_, total));
    }

  private:
    /// With one frame, an error ends the bake and needs no count of frames.
    bool continues() const { return plan_.keep_going && plan_.frames.size() > 1; }

    const BakePlan& plan_;
    BakeHost& host_;
    int complete_ = 0;
    std::vector<int> failed_;
    std::optional<Error> first_error_;
};

ExistingFrames existing_frames(const BakePlan& plan) {
    return find_frames(plan, [&plan](std::span<const BakeFile> files) {
        return plan.format->matches_plan(plan, files.front());
    });
}

void write_shared(const Bake& bake, const BakePlan& plan, const BakeFile& file) {
    write_and_verify_uninterrupted({plan, bake.source, bake.manifest, bake.host}, file,
                                   plan.threads, [&] { plan.format->write_shared(plan, file); });
}

/// Writes the shared files, such as a USD stage, before the first frame.
void bake_shared(const Bake& bake) {
    BakePlan plan = bake.plan;
    std::vector<BakeFile> files = plan.format->shared_files(plan);
    if (plan.format->frame_lists > 0) {
        const ExistingFrames existing = existing_frames(plan);
        plan.all_frames = united(plan.all_frames, existing.of_plan);
        files = plan.format->shared_files(plan);
        const std::string warning =
            foreign_frames_warning(existing, plan.all_frames, files.front().path);
        if (!warning.empty()) bake.host.warning(warning);
    }
    for (const BakeFile& file : files) {
        auto complete = plan.skip_existing ? find_complete(plan, file, bake.manifest, plan.threads)
                                           : std::nullopt;
        if (complete) {
            bake.manifest.add(std::move(*complete));
        } else {
            write_shared(bake, plan, file);
        }
    }
}

/// For a format whose readers silently interpolate missing frames, warns of the frames between the
/// first and the last listed frame that are missing or show another subject.
void warn_of_gaps(const Bake& bake, const std::vector<int>& listed,
                  const std::vector<int>& existing) {
    std::vector<int> missing;
    const int step = common_step(listed);
    for (long long frame = listed.front(); frame <= listed.back(); frame += step) {
        const int number = static_cast<int>(frame);
        if (!std::ranges::binary_search(existing, number)) missing.push_back(number);
    }
    bake.manifest.set_missing(missing);
    if (missing.empty()) return;
    bake.host.warning(
        "frames that do not exist yet, which readers interpolate from their neighbours: " +
        frames_text(missing));
}

/// Updates the frame in the entry of a shared file: the file is the same for all chunks, but each
/// chunk entered it with the first frame that it knew.
void update_entry(const Bake& bake, const BakePlan& plan, const BakeFile& file) {
    ManifestEntry entry;
    describe(plan, file, entry);
    const std::optional<ManifestEntry> known = bake.manifest.added(entry.name);
    if (!known) return;  // devices have no entries
    entry.bytes = known->bytes;
    entry.sha256 = known->sha256;
    entry.pixels_sha256 = known->pixels_sha256;
    bake.manifest.add(std::move(entry));
}

/// Writes the lists of frames again, because another chunk may have baked some frames meanwhile.
void update_frame_lists(const Bake& bake) {
    BakePlan plan = bake.plan;
    const ExistingFrames existing = existing_frames(plan);
    plan.all_frames = united(plan.all_frames, existing.of_plan);
    const std::vector<BakeFile> files = plan.format->shared_files(plan);
    for (std::size_t i = 0; i < files.size(); ++i) {
        const bool lists_frames = i < plan.format->frame_lists;
        lists_frames ? write_shared(bake, plan, files[i]) : update_entry(bake, plan, files[i]);
    }
    if (plan.format->interpolates_missing_frames)
        warn_of_gaps(bake, plan.all_frames, existing.of_plan);
}

void bake_frames(const Bake& bake, const WorkShare& share, ManifestSaver& saver) {
    const BakePlan& plan = bake.plan;
    std::vector<std::unique_ptr<FrameBaker>> bakers;
    for (int worker = 0; worker < share.frames_at_a_time; ++worker) {
        bakers.push_back(std::make_unique<FrameBaker>(bake, share.threads_each));
    }
    std::vector<FrameOutcome> outcomes(plan.frames.size());
    FrameReporter report(plan, bake.host);
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
            saver.save_if_due();
        });
    report.end();
}

/// A shard cleans up after itself alone: on a network disk the lock of a file that another machine
/// is writing may not be seen here.
void remove_abandoned_temporaries(const BakePlan& plan) {
    std::optional<std::vector<std::string>> own;
    if (plan.shard) {
        own = {plan.pattern.manifest(plan.shard)};
        for (const int frame : plan.frames) {
            for (BakeFile& file : plan.format->files(plan, frame)) own->push_back(file.path);
        }
    }
    io::remove_abandoned_temporaries(plan.pattern.folder(), own);
}

/// While this object lives, an interrupt saves the manifest before the process ends.
class ManifestOnInterrupt {
  public:
    ManifestOnInterrupt(Manifest& manifest, BakeHost& host) : host_(host) {
        host.set_interrupt_handler([&manifest, &host] {
            try {
                manifest.save();
            } catch (const std::exception& error) {
                host.warning(error.what());
            }
        });
    }
    ~ManifestOnInterrupt() { host_.set_interrupt_handler({}); }
    ManifestOnInterrupt(const ManifestOnInterrupt&) = delete;
    ManifestOnInterrupt& operator=(const ManifestOnInterrupt&) = delete;

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
    Manifest manifest(plan.pattern, plan.shard);
    for (const std::string& warning : manifest.warnings()) host.warning(warning);
    refuse_to_overwrite_others(plan, manifest);
    io::make_folder(plan.pattern.folder());
    remove_abandoned_temporaries(plan);
    host.begin(plan, share);
    if (!plan.backend_note.empty()) host.note(plan.backend_note);
    host.note(format_text("%d frames at a time, %d threads each", share.frames_at_a_time,
                          share.threads_each));
    for (const std::string& warning : bake_warnings(plan, plan.frames.size())) {
        host.warning(warning);
    }
    // All workers share one source.
    const auto source =
        plan.subject->open({.threads = plan.threads, .build_progress = host.build_progress()});
    const Bake bake{plan, *source, manifest, host};
    ManifestSaver saver(bake);
    const ManifestOnInterrupt on_interrupt(manifest, host);
    try {
        if (plan.format->has_shared_files) saver.save([&] { bake_shared(bake); });
        bake_frames(bake, share, saver);
        saver.save([&] {
            if (plan.format->frame_lists > 0) update_frame_lists(bake);
        });
    } catch (...) {
        saver.try_save();
        throw;
    }
}

}  // namespace ocean
