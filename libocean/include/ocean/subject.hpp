// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A subject is the content of a bake, a mesh or a view: a sea, a terrain or a coast. Code that
// needs only its maps, its text and its times uses these two interfaces; code for one kind of
// subject (spray, slope tiles) requests that kind: find_sea, find_terrain.
//
//     const auto subject = make_subject(read_sea("storm.toml"));  // of seafile.hpp
//     const auto maps = subject->open({.threads = 8});
//     const int sizes[] = {subject->default_resolution()};
//     for (int frame = 1; frame <= 48; ++frame) {
//         const double time = subject->timeline().time_of(frame);
//         write(maps->levels(time, {Channel::height}, sizes).front());
//     }
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/backend.hpp"
#include "ocean/domain.hpp"
#include "ocean/query.hpp"
#include "ocean/surface.hpp"

namespace ocean {

/// The settings with which maps of a subject are made.
struct MapsOptions {
    int threads = 0;  // 0 = the cores this process may use
    Backend backend = Backend::cpu;
    /// Called while foam is followed from its beginning; may throw to stop the call.
    std::function<void(std::int64_t done, std::int64_t total)> foam_progress = {};
    std::span<const ChannelInfo> channels = {};  // channels beside the table's
    /// Called while a subject that takes long is built, with what is being computed and the share
    /// of it that is done; may throw to stop the call.
    std::function<void(std::string_view work, double share)> build_progress = {};
};

/// A map of heights by world position instead of by label.
struct WorldHeights {
    Surface surface;         // with the channel height alone; sample (i, j) is its own position
    std::size_t folded = 0;  // samples where several labels are displayed
};

/// Makes the maps of one subject and keeps intermediate results for the next call. One thread at a
/// time per object; several objects run in parallel.
class SubjectMaps {
  public:
    virtual ~SubjectMaps() = default;

    /// Returns maps for another thread. They share what these maps have computed.
    virtual std::unique_ptr<SubjectMaps> share(const MapsOptions& options) const = 0;
    /// Returns a map of each resolution, ordered from the finest. With foam or cover, each
    /// resolution must be half the previous one. Throws Error for channels that the subject does
    /// not have.
    virtual std::vector<Surface> levels(double time, ChannelSet channels,
                                        std::span<const int> resolutions) = 0;
    /// Returns the heights on resolution^2 world positions of the domain.
    virtual WorldHeights eulerian_heights(double time, int resolution) = 0;
    /// Writes height, normal and fold of the surface at each point.
    virtual void query(double time, std::span<const WorldPoint> points,
                       std::span<QuerySample> samples, const QueryOptions& options) = 0;
    /// Returns the pool, for other work of the caller; not during a call of this object.
    virtual ThreadPool& pool() = 0;
};

/// The range of heights that a volume of the subject covers by default [m].
struct HeightRange {
    double bottom = 0.0;
    double top = 0.0;  // above any crest to be expected
};

/// The cost of something that needs no memory.
struct NoCost {
    template <typename... Arguments>
    std::uint64_t operator()(const Arguments&...) const {
        return 0;
    }
};

/// The memory that maps of a subject need [bytes]. The functions may refer to the subject.
struct Costs {
    std::uint64_t shared = 0;  // for all SubjectMaps together
    std::uint64_t each = 0;    // for each SubjectMaps, its maps not included
    /// Returns the bytes that making a map of these channels needs beside the map.
    std::function<std::uint64_t(const MapsOptions& options, ChannelSet channels, int resolution)>
        map = NoCost{};
    /// Returns the bytes that eulerian_heights needs beside their map.
    std::function<std::uint64_t(int resolution)> eulerian_heights = NoCost{};
    /// Returns the bytes of a query of these options.
    std::function<std::uint64_t(const QueryOptions& options)> query = NoCost{};
};

class Subject {
  public:
    virtual ~Subject() = default;

    /// Returns the subject's kind, such as "sea". Image headers store text() under the key
    /// ocean:KIND.
    virtual std::string_view kind() const = 0;
    /// Returns the subject's own file, resolved: it reads back to the same subject and needs no
    /// other file.
    virtual std::string text() const = 0;
    /// Returns the files that the subject's own file names, spelled as there.
    virtual std::vector<std::string> named_files() const = 0;
    /// Sets a parameter, before maps are made. Throws Error invalid_value.
    virtual void set(std::string_view name, std::string_view value) = 0;

    /// Returns the times of the subject's frames; without an override the subject does not move.
    virtual Timeline timeline() const { return {}; }
    /// Returns warnings about the subject at a time, a sentence each.
    virtual std::vector<std::string> warnings(double /*time*/) const { return {}; }

    /// Returns the channels of the table that the subject has.
    virtual ChannelSet channels() const = 0;
    /// Returns the samples along a side of the map that shows all waves of the subject.
    virtual int default_resolution() const = 0;
    /// Returns the domain of a map of `resolution` samples along its side.
    virtual Domain domain(int resolution) const = 0;
    /// Returns the shortest wave that a map of `resolution` samples holds [m].
    virtual double shortest_wave(int resolution) const = 0;
    /// Returns the heights of the subject's volumes. If this computes the subject, the maps of a
    /// later open() reuse the result.
    virtual HeightRange height_range(const MapsOptions& options) const = 0;

    /// Returns the samples along a side of the maps that a backend makes for a map of `resolution`
    /// samples; nothing if the backend makes none, because the subject is a function of the place.
    virtual std::optional<int> backend_resolution(const Backend&, int resolution) const {
        return resolution;
    }

    /// Returns maps that have already computed what all their copies share. Several threads may
    /// call it.
    virtual std::unique_ptr<SubjectMaps> open(const MapsOptions& options) const = 0;
    /// Returns the memory that the subject's maps need. The result is valid as long as the subject.
    virtual Costs costs() const = 0;
};

}  // namespace ocean
