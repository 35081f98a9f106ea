// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The numbers of patches, heights of vertices and slopes between them, made by threads of their own
// while pictures are drawn.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <unordered_set>
#include <vector>

#include "ocean/internal/land_quadtree.hpp"
#include "ocean/land_function.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean::preview {

/// A node of the quadtree: a square of QuadtreeSettings::patch quads of a level, its corner in its
/// sides from the world's origin.
struct PatchKey {
    int level = 0;
    std::int64_t i = 0, j = 0;

    bool operator==(const PatchKey&) const = default;
};
struct PatchHash {
    std::size_t operator()(const PatchKey& key) const {
        auto h = static_cast<std::uint64_t>(key.level);
        for (const std::int64_t value : {key.i, key.j}) {
            h = (h ^ static_cast<std::uint64_t>(value)) * 0x9e3779b97f4a7c15ull;
            h ^= h >> 29;
        }
        return static_cast<std::size_t>(h);
    }
};

/// Returns the node whose vertices a selected square has.
PatchKey node_of(const LandPatch& patch);

/// The land that patches are made of.
struct PatchSource {
    std::shared_ptr<const LandFunction> function;
    double mean = 0.0;  // of land that repeats [m]: what vertices show that lie a period apart
    QuadtreeSettings settings = {};
};

/// The numbers of a node.
using PatchValues = std::vector<float>;
using MakePatch = PatchValues (*)(const PatchSource& source, const PatchKey& key, ThreadPool& pool);

/// Returns the heights of a node: for each of its (patch + 1)^2 vertices, row by row, its own and
/// that of the next level's mesh at its label [m]. land_quadtree.hpp calls them h and c. A vertex
/// that several nodes have has the same bits in each.
PatchValues make_patch_heights(const PatchSource& source, const PatchKey& key, ThreadPool& pool);

/// The texels of the slopes of a node: kTexelsOfQuad along a quad, kBorder more around the node,
/// and kDetailMips mipmaps, the border of the last of which is half a texel.
inline constexpr int kTexelsOfQuad = 4;
inline constexpr int kBorder = 4;
inline constexpr int kDetailMips = 4;
/// Returns texels along a side of the finest one.
constexpr int detail_side(const QuadtreeSettings& settings) {
    return kTexelsOfQuad * settings.patch + 2 * kBorder;
}
/// Returns slope x, slope y and the square of the slope of each texel, mipmap after mipmap.
PatchValues make_patch_slopes(const PatchSource& source, const PatchKey& key, ThreadPool& pool);

class PatchMaker {
  public:
    struct Made {
        PatchKey key;
        PatchValues values;
    };

    PatchMaker(int threads, MakePatch make);
    ~PatchMaker();
    PatchMaker(const PatchMaker&) = delete;
    PatchMaker& operator=(const PatchMaker&) = delete;

    /// Makes patches of this land from now on, and forgets all others.
    void begin(PatchSource source);
    /// Replaces the patches that wait to be made, the most urgent one first.
    void request(const std::vector<PatchKey>& keys);
    /// Makes the most urgent patch that waits in the calling thread. Returns false if none waits.
    /// Only one thread may help.
    bool help();
    /// Returns the patches that were made since the last call. Rethrows an exception of their
    /// making.
    std::vector<Made> take();
    /// Waits until a patch is made that take() has not returned, or none is requested; or for some
    /// time. Returns false if time ran out.
    bool wait(std::optional<std::chrono::steady_clock::time_point> until);
    /// Returns the patches that wait or are in work.
    std::size_t unfinished() const;
    /// Returns true if take() would return a patch.
    bool has_made() const;

  private:
    void work();
    void make_first(std::unique_lock<std::mutex>& lock, ThreadPool& caller);
    bool is_idle() const { return waiting_.empty() && in_work_.empty(); }

    int threads_;
    MakePatch make_;
    ThreadPool helper_{1};
    mutable std::mutex mutex_;
    std::condition_variable wake_, done_;
    PatchSource source_;
    std::uint64_t generation_ = 0;  // of the land
    std::deque<PatchKey> waiting_;
    std::unordered_set<PatchKey, PatchHash> in_work_;
    std::vector<Made> made_;
    std::exception_ptr failure_;
    bool ends_ = false;
    std::vector<std::thread> workers_;
};

}  // namespace ocean::preview
