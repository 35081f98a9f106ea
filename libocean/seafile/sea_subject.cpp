// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea as a subject; see sea_subject.hpp. Everything here hands over to Sea, Ocean and the sea
// file: no formula of its own.
#include "ocean/sea_subject.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ocean/cascades.hpp"
#include "ocean/directional_spectrum.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/map_levels.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/seafile.hpp"
#include "ocean/world_heights.hpp"

namespace ocean {
namespace {

[[noreturn]] void refuse_kind(std::string_view kind) {
    throw Error(ErrorKind::unsupported, "this needs a sea; the subject is a " + std::string(kind));
}

OceanOptions ocean_options(const MapsOptions& options) {
    return {.threads = options.threads,
            .backend = options.backend,
            .foam_progress = options.foam_progress,
            .channels = options.channels};
}

class SeaMaps final : public SubjectMaps {
  public:
    SeaMaps(const Sea& sea, const MapsOptions& options) : ocean_(sea, ocean_options(options)) {
        ocean_.modes();
    }
    SeaMaps(const Ocean& built, const MapsOptions& options)
        : ocean_(built, ocean_options(options)) {}

    Ocean& ocean() { return ocean_; }

    std::unique_ptr<SubjectMaps> share(const MapsOptions& options) const override {
        return std::make_unique<SeaMaps>(ocean_, options);
    }
    std::vector<Surface> levels(double time, ChannelSet channels,
                                std::span<const int> resolutions) override {
        return map_levels(ocean_, time, channels, resolutions);
    }
    WorldHeights heights_by_place(double time, int resolution) override {
        return world_heights(ocean_, time, resolution);
    }
    void query(double time, std::span<const WorldPoint> points, std::span<QuerySample> samples,
               const QueryOptions& options) override {
        ocean_.query(time, points, samples, options);
    }
    ThreadPool& pool() override { return ocean_.pool(); }

  private:
    Ocean ocean_;
};

class SeaSubject final : public Subject {
  public:
    explicit SeaSubject(Sea sea) : sea_(std::move(sea)) {}

    const Sea& sea() const { return sea_; }

    std::string_view kind() const override { return kSeaKind; }
    std::string text() const override { return write_sea(sea_); }
    std::vector<std::string> named_files() const override { return ocean::named_files(sea_); }
    void set(std::string_view name, std::string_view value) override {
        set_parameter(sea_.parameters, name, value);
    }

    double time_of(double frame) const override { return sea_.time_of(frame); }
    int first_frame() const override { return sea_.parameters.time.first_frame; }
    double frame_rate() const override { return sea_.parameters.time.fps; }
    bool plays_take() const override { return !sea_.take.empty(); }
    std::vector<std::string> warnings(double time) const override {
        return full_development_warnings(sea_.at(time));
    }

    ChannelSet channels() const override {
        ChannelSet all;
        for (int c = 0; c < kChannelCount; ++c) all = all | static_cast<Channel>(c);
        return all;
    }
    int default_resolution() const override { return default_map_resolution(grid()); }
    Domain domain(int resolution) const override {
        return Domain::tile(grid().patch_size, resolution);
    }
    double shortest_wave(int resolution) const override {
        return std::max(sea_.parameters.surface.shortest_wavelength,
                        ocean::shortest_wave(grid(), resolution));
    }
    HeightRange height_range() const override {
        constexpr double kMinDepth = 4.0;  // [m]
        const Parameters& parameters = sea_.parameters;
        const double variance = make_directional_spectrum(parameters).variance(parameters.water);
        const double wave_height = 4.0 * std::sqrt(variance);
        return {-std::min(std::max(kMinDepth, 2.0 * wave_height), parameters.water.depth),
                2.0 * wave_height};
    }

    std::unique_ptr<SubjectMaps> open(const MapsOptions& options) const override {
        return std::make_unique<SeaMaps>(sea_, options);
    }
    std::uint64_t bytes(int sharing) const override {
        // With a take each of them is at a time of its own, and the first at another.
        const std::uint64_t seas = plays_take() ? 1 + static_cast<std::uint64_t>(sharing) : 1;
        return seas * modes_bytes(grid());
    }
    std::uint64_t work_bytes(const MapsOptions& options, ChannelSet channels,
                             int resolution) const override {
        return ocean::work_bytes(grid(), options.backend, channels, resolution, options.channels);
    }
    std::uint64_t by_place_bytes(int resolution) const override {
        return world_heights_bytes(sea_, resolution);
    }
    std::uint64_t query_bytes(const QueryOptions& options) const override {
        return SurfaceQuery::map_bytes(grid().resolution, options);
    }

  private:
    const Grid& grid() const { return sea_.parameters.grid; }

    Sea sea_;
};

}  // namespace

std::unique_ptr<Subject> make_subject(Sea sea) {
    return std::make_unique<SeaSubject>(std::move(sea));
}

std::unique_ptr<Subject> parse_sea_subject(std::string_view text, const std::string& name) {
    return make_subject(parse_sea(text, name, ""));
}

const Sea* find_sea(const Subject& subject) {
    const auto* sea = dynamic_cast<const SeaSubject*>(&subject);
    return sea == nullptr ? nullptr : &sea->sea();
}

const Sea& sea_of(const Subject& subject) {
    if (const Sea* sea = find_sea(subject)) return *sea;
    refuse_kind(subject.kind());
}

Ocean& ocean_of(SubjectMaps& maps) {
    if (auto* sea = dynamic_cast<SeaMaps*>(&maps)) return sea->ocean();
    throw Error(ErrorKind::unsupported, "this needs the maps of a sea");
}

}  // namespace ocean
