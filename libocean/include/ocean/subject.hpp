// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A subject is what a bake, a mesh or a view shows: a sea, later a terrain or a coast. Whoever
// needs maps of it, its text and its times alone knows it by these two interfaces; what is true of
// one kind of subject only (spray, slope tiles) asks for that kind (sea_subject.hpp).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/backend.hpp"
#include "ocean/domain.hpp"
#include "ocean/query.hpp"
#include "ocean/surface.hpp"

namespace ocean {

/// How maps of a subject are made.
struct MapsOptions {
    int threads = 0;  // 0 = the cores this process may use
    Backend backend = Backend::cpu;
    /// Called while foam is followed from its beginning; may throw to stop that.
    std::function<void(std::int64_t done, std::int64_t total)> foam_progress = {};
    std::span<const ChannelInfo> channels = {};  // beside those of the table
};

/// A map of heights by place instead of by label.
struct WorldHeights {
    Surface surface;         // the channel height alone; sample (i, j) is the place itself
    std::size_t folded = 0;  // samples where several labels are shown
};

/// Makes the maps of one subject, and keeps what the next call may use again. One thread at a time
/// per object; several objects run in parallel.
class SubjectMaps {
  public:
    virtual ~SubjectMaps() = default;

    /// Returns the maps for another thread. What these have made is shared, not made again.
    virtual std::unique_ptr<SubjectMaps> share(const MapsOptions& options) const = 0;
    /// Returns a map of each resolution, the finest first. With foam or cover each must be half the
    /// one before. Throws Error for channels that the subject does not have.
    virtual std::vector<Surface> levels(double time, ChannelSet channels,
                                        std::span<const int> resolutions) = 0;
    virtual WorldHeights heights_by_place(double time, int resolution) = 0;
    /// Writes height, normal and fold of the surface at as many places as there are samples.
    virtual void query(double time, std::span<const WorldPoint> points,
                       std::span<QuerySample> samples, const QueryOptions& options) = 0;
    /// For work beside the maps' own; not during a call of them.
    virtual ThreadPool& pool() = 0;
};

/// The heights that a volume of the subject holds unless its user says otherwise [m].
struct HeightRange {
    double bottom = 0.0;
    double top = 0.0;  // higher than any crest that comes
};

class Subject {
  public:
    virtual ~Subject() = default;

    /// Returns its kind, "sea". Headers of files have its text as ocean:KIND.
    virtual std::string_view kind() const = 0;
    /// Returns its own file, resolved: it reads back to the same subject and needs no other file.
    virtual std::string text() const = 0;
    /// Returns the files that its own file names, as they are spelled there.
    virtual std::vector<std::string> named_files() const = 0;
    /// Sets a parameter before maps are made. Throws Error invalid_value.
    virtual void set(std::string_view name, std::string_view value) = 0;

    /// Returns the time of a frame [s]; of what does not move too.
    virtual double time_of(double frame) const = 0;
    virtual int first_frame() const = 0;
    virtual double frame_rate() const = 0;  // [1/s]
    /// True if its parameters change with time, so that each time has maps of its own kind.
    virtual bool plays_take() const = 0;
    /// Returns what a user should know of the subject at a time, a sentence each.
    virtual std::vector<std::string> warnings(double time) const = 0;

    /// Returns the channels that it has of the table.
    virtual ChannelSet channels() const = 0;
    /// Returns the samples along a side of the map that shows all of it.
    virtual int default_resolution() const = 0;
    /// Returns where a map of `resolution` samples along its side lies.
    virtual Domain domain(int resolution) const = 0;
    /// Returns the shortest wave of such a map [m].
    virtual double shortest_wave(int resolution) const = 0;
    virtual HeightRange height_range() const = 0;

    /// Returns maps with what they share made already.
    virtual std::unique_ptr<SubjectMaps> open(const MapsOptions& options) const = 0;
    /// Returns the bytes of so many SubjectMaps that share, without what a map needs.
    virtual std::uint64_t bytes(int sharing) const = 0;
    /// Returns the bytes that making a map of these channels takes beside the map.
    virtual std::uint64_t work_bytes(const MapsOptions& options, ChannelSet channels,
                                     int resolution) const = 0;
    virtual std::uint64_t by_place_bytes(int resolution) const = 0;
    virtual std::uint64_t query_bytes(const QueryOptions& options) const = 0;
};

}  // namespace ocean
