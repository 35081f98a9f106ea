// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "patch_maker.hpp"

#include <algorithm>
#include <utility>

namespace ocean::preview {
namespace {

/// Writes the heights of (quads + 1)^2 vertices `spacing` apart from a corner on.
void write_heights(const PatchSource& source, double x, double y, double spacing, int quads,
                   std::vector<float>& heights, ThreadPool& pool) {
    const auto side = static_cast<std::size_t>(quads + 1);
    heights.resize(side * side);
    // Vertices with few of them in a period would show single points of it.
    constexpr double kMinVertices = 8.0;
    const Domain& land = source.function->domain();
    if (land.wraps && spacing * kMinVertices > std::min(land.size[0], land.size[1])) {
        std::ranges::fill(heights, static_cast<float>(source.mean));
        return;
    }
    const double length = quads * spacing;
    const Domain region{{x, y}, {length, length}, {quads + 1, quads + 1}, false};
    MapOutput output{heights.data(), 1, {}};
    output.component[0].quantity = Channel::height;
    source.function->write(region, {&output, 1}, pool);
}

}  // namespace

PatchKey node_of(const LandPatch& patch) {
    if (!patch.quarter) return {patch.level, patch.i, patch.j};
    return {patch.level, patch.i >> 1, patch.j >> 1};
}

PatchValues make_patch_heights(const PatchSource& source, const PatchKey& key, ThreadPool& pool) {
    const int quads = source.settings.patch;
    const double spacing = source.settings.spacing_of(key.level);
    const double x = static_cast<double>(key.i * quads) * spacing;
    const double y = static_cast<double>(key.j * quads) * spacing;
    std::vector<float> own, coarse;
    write_heights(source, x, y, spacing, quads, own, pool);
    write_heights(source, x, y, 2.0 * spacing, quads / 2, coarse, pool);
    const auto parent = [&](int i, int j) {
        return static_cast<double>(
            coarse[static_cast<std::size_t>(j / 2) * static_cast<std::size_t>(quads / 2 + 1) +
                   static_cast<std::size_t>(i / 2)]);
    };
    PatchValues heights;
    heights.reserve(2 * own.size());
    for (int j = 0; j <= quads; ++j) {
        for (int i = 0; i <= quads; ++i) {
            // The ends of the parent's edge that the vertex halves.
            const int di = i & 1, dj = j & 1;
            const double c = 0.5 * (parent(i - di, j - dj) + parent(i + di, j + dj));
            heights.push_back(own[heights.size() / 2]);
            heights.push_back(static_cast<float>(c));
        }
    }
    return heights;
}

PatchValues make_patch_slopes(const PatchSource& source, const PatchKey& key, ThreadPool& pool) {
    const QuadtreeSettings& settings = source.settings;
    int side = detail_side(settings);
    const double texel = settings.spacing_of(key.level) / kTexelsOfQuad;
    const double first = (0.5 - kBorder) * texel, length = (side - 1) * texel;
    const double node = settings.patch * settings.spacing_of(key.level);
    const Domain region{
        {static_cast<double>(key.i) * node + first, static_cast<double>(key.j) * node + first},
        {length, length},
        {side, side},
        false};
    constexpr int kComponents = 3;
    const auto texels = [](int n) {
        return static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
    };
    PatchValues values(kComponents * texels(side));
    MapOutput output{values.data(), kComponents, {}};
    output.component[0].quantity = Channel::slope_x;
    output.component[1].quantity = Channel::slope_y;
    source.function->write(region, {&output, 1}, pool);
    for (std::size_t i = 0; i < values.size(); i += kComponents) {
        values[i + 2] = values[i] * values[i] + values[i + 1] * values[i + 1];
    }
    std::size_t finer = 0;  // where that mipmap begins
    for (int mip = 1; mip < kDetailMips; ++mip, side /= 2) {
        const int half = side / 2;
        const std::size_t begin = values.size();
        values.resize(begin + kComponents * texels(half));
        for (int j = 0; j < half; ++j) {
            for (int i = 0; i < half; ++i) {
                for (int c = 0; c < kComponents; ++c) {
                    const auto of = [&](int column, int row) {
                        return values[finer + static_cast<std::size_t>(
                                                  kComponents * (row * side + column) + c)];
                    };
                    values[begin + static_cast<std::size_t>(kComponents * (j * half + i) + c)] =
                        0.25f * (of(2 * i, 2 * j) + of(2 * i + 1, 2 * j) + of(2 * i, 2 * j + 1) +
                                 of(2 * i + 1, 2 * j + 1));
                }
            }
        }
        finer = begin;
    }
    return values;
}

PatchMaker::PatchMaker(int threads, MakePatch make) : threads_(threads), make_(make) {}

PatchMaker::~PatchMaker() {
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    wake_.notify_all();
    for (std::thread& worker : workers_) worker.join();
}

void PatchMaker::begin(PatchSource source) {
    const std::lock_guard lock(mutex_);
    source_ = std::move(source);
    ++generation_;
    waiting_.clear();
    in_work_.clear();
    made_.clear();
    failure_ = nullptr;
}

void PatchMaker::request(const std::vector<PatchKey>& keys) {
    const std::lock_guard lock(mutex_);
    waiting_.clear();
    std::unordered_set<PatchKey, PatchHash> known = in_work_;
    for (const Made& made : made_) known.insert(made.key);
    for (const PatchKey& key : keys) {
        if (known.insert(key).second) waiting_.push_back(key);
    }
    if (waiting_.empty()) return;
    while (workers_.size() < static_cast<std::size_t>(threads_)) {
        workers_.emplace_back([this] { work(); });
    }
    wake_.notify_all();
}

std::vector<PatchMaker::Made> PatchMaker::take() {
    const std::lock_guard lock(mutex_);
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    return std::exchange(made_, {});
}

bool PatchMaker::wait(std::optional<std::chrono::steady_clock::time_point> until) {
    std::unique_lock lock(mutex_);
    const auto is_over = [&] { return !made_.empty() || failure_ || is_idle(); };
    if (until) return done_.wait_until(lock, *until, is_over);
    done_.wait(lock, is_over);
    return true;
}

std::size_t PatchMaker::unfinished() const {
    const std::lock_guard lock(mutex_);
    return waiting_.size() + in_work_.size();
}

bool PatchMaker::has_made() const {
    const std::lock_guard lock(mutex_);
    return !made_.empty();
}

bool PatchMaker::help() {
    std::unique_lock lock(mutex_);
    if (waiting_.empty()) return false;
    make_first(lock, helper_);
    return true;
}

void PatchMaker::work() {
    ThreadPool caller(1);
    std::unique_lock lock(mutex_);
    for (;;) {
        wake_.wait(lock, [this] { return ends_ || !waiting_.empty(); });
        if (ends_) return;
        make_first(lock, caller);
    }
}

/// Makes the first patch that waits, and unlocks the mutex meanwhile.
void PatchMaker::make_first(std::unique_lock<std::mutex>& lock, ThreadPool& caller) {
    const PatchKey key = waiting_.front();
    waiting_.pop_front();
    in_work_.insert(key);
    const PatchSource source = source_;
    const std::uint64_t generation = generation_;
    lock.unlock();
    PatchValues values;
    std::exception_ptr failure;
    try {
        values = make_(source, key, caller);
    } catch (...) {
        failure = std::current_exception();
    }
    lock.lock();
    if (generation != generation_) return;  // of a land before
    in_work_.erase(key);
    if (failure) {
        failure_ = failure;
    } else {
        made_.push_back({key, std::move(values)});
    }
    done_.notify_all();
}

}  // namespace ocean::preview
