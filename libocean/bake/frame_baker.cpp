// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See frame_baker.hpp. A file is read back as soon as it is written, so that the hashes are of the
// disk's content and a faulty disk is detected.
#include "frame_baker.hpp"

#include <array>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include "complete_file.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/text.hpp"

namespace ocean {
namespace {

class Workers {
  public:
    Workers(int count, int workers, const std::function<bool(int, int)>& job)
        : count_(count),
          max_ahead_(2 * workers),
          finished_(static_cast<std::size_t>(count), false) {
        for (int worker = 0; worker < workers; ++worker) {
            threads_.emplace_back([this, worker, &job] { work(worker, job); });
        }
    }
    ~Workers() {
        stop();
        for (std::thread& thread : threads_) thread.join();
    }
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    /// Blocks until the job `index` is finished; returns false if it will never be started.
    bool wait_for(int index) {
        std::unique_lock lock(mutex_);
        const auto done = [&] { return finished_[static_cast<std::size_t>(index)]; };
        changed_.wait(lock, [&] { return done() || (stopped_ && index >= next_); });
        return done();
    }

    void delivered(int index) {
        const std::lock_guard lock(mutex_);
        delivered_ = index + 1;
        changed_.notify_all();
    }

  private:
    void stop() {
        const std::lock_guard lock(mutex_);
        stopped_ = true;
        changed_.notify_all();
    }

    void work(int worker, const std::function<bool(int, int)>& job) {
        for (;;) {
            int index = 0;
            {
                std::unique_lock lock(mutex_);
                changed_.wait(lock, [this] {
                    return stopped_ || next_ == count_ || next_ - delivered_ < max_ahead_;
                });
                if (stopped_ || next_ == count_) return;
                index = next_++;
            }
            const bool go_on = job(worker, index);
            const std::lock_guard lock(mutex_);
            finished_[static_cast<std::size_t>(index)] = true;
            stopped_ = stopped_ || !go_on;
            changed_.notify_all();
        }
    }

    const int count_;
    const int max_ahead_;
    std::mutex mutex_;
    std::condition_variable changed_;
    int next_ = 0;
    int delivered_ = 0;
    bool stopped_ = false;
    std::vector<bool> finished_;
    std::vector<std::thread> threads_;
};

}  // namespace

void run_in_order(int count, int workers, const std::function<bool(int worker, int index)>& job,
                  const std::function<void(int index)>& deliver) {
    Workers all(count, workers, job);
    for (int index = 0; index < count && all.wait_for(index); ++index) {
        deliver(index);
        all.delivered(index);
    }
}

FrameBaker::FrameBaker(const Bake& bake, int threads)
    : bake_(bake),
      threads_(threads),
      source_(bake.source.share({.threads = threads,
                                 .backend = bake.plan.backend,
                                 .foam_progress = bake.host.foam_progress(),
                                 .channels = bake.plan.channels})) {}

bool FrameBaker::keep(const std::vector<BakeFile>& files) {
    std::vector<ManifestEntry> entries;
    for (const BakeFile& file : files) {
        auto entry = find_complete(bake_.plan, file, bake_.manifest, threads_);
        if (!entry) return false;
        entries.push_back(std::move(*entry));
    }
    for (ManifestEntry& entry : entries) bake_.manifest.add(std::move(entry));
    return true;
}

void FrameBaker::make(const std::vector<BakeFile>& files, int frame) {
    const std::vector<Surface> maps = make_maps(bake_.plan.subject->timeline().time_of(frame));
    bake_.plan.format->write({bake_.plan, frame, maps, *source_, threads_,
                              [this](const BakeFile& file, const std::function<void()>& write) {
                                  write_and_verify(bake_, file, threads_, write);
                              },
                              [this](const std::string& message) { bake_.host.warning(message); }},
                             files);
}

std::vector<Surface> FrameBaker::make_maps(double time) {
    const FrameMaps& maps = bake_.plan.maps;
    if (maps.channels.empty()) return {};
    if (!maps.eulerian) {
        std::vector<Surface> levels = source_->levels(time, maps.channels, maps.resolutions);
        if (maps.finer > 0) {
            auto finer = source_->levels(time, maps.finer_channels, std::array{maps.finer});
            levels.push_back(std::move(finer.front()));
        }
        return levels;
    }
    WorldHeights heights = source_->eulerian_heights(time, maps.resolutions.front());
    if (heights.folded > 0) {
        bake_.host.warning(format_text(
            "at %g s %zu of %zu points lie where the crests have folded over: they take the top "
            "sheet",
            time, heights.folded, heights.surface.channel(Channel::height).size()));
    }
    std::vector<Surface> surfaces;
    surfaces.push_back(std::move(heights.surface));
    return surfaces;
}

/// Removes a symbolic link at a frame's path that points to a file of the same folder, which may be
/// another frame. Links to other folders are written through, as for every output.
static void remove_link_to_frame(const BakeFile& file) {
    std::error_code code;
    const std::filesystem::path path = utf8_path(file.path);
    if (!std::filesystem::is_symlink(path, code) || !is_regular(file)) return;
    const auto folder = std::filesystem::canonical(path.parent_path() / ".", code);
    if (std::filesystem::canonical(path, code).parent_path() != folder) return;
    std::filesystem::remove(path, code);
}

void write_and_verify_uninterrupted(const Bake& bake, const BakeFile& file, int threads,
                                    const std::function<void()>& write) {
    remove_link_to_frame(file);
    write();
    if (!is_regular(file)) return;
    try {
        bake.manifest.add(inspect(bake.plan, file, threads));
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::bad_file) throw;
        throw Error(ErrorKind::output,
                    "'" + file.path + "' does not read back as it was written: " + error.what());
    }
}

void write_and_verify(const Bake& bake, const BakeFile& file, int threads,
                      const std::function<void()>& write) {
    bake.host.run_uninterrupted(
        [&] { write_and_verify_uninterrupted(bake, file, threads, write); });
}

}  // namespace ocean
