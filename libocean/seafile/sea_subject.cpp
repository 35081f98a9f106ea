// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A sea as a subject; see seafile.hpp. This file only calls Sea, Ocean and the sea file, and
// has no formula of its own.
#include "ocean/seafile.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "ocean/domain.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/cascades.hpp"
#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/internal/foam.hpp"
#include "ocean/internal/hull_rules.hpp"
#include "ocean/internal/map_levels.hpp"
#include "ocean/internal/sea_bytes.hpp"
#include "ocean/internal/surface_query.hpp"
#include "ocean/internal/world_heights.hpp"
#include "ocean/land_mask.hpp"
#include "ocean/ocean.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/sea_bed.hpp"

namespace ocean {
namespace {

[[noreturn]] void refuse_kind(std::string_view kind) {
    throw Error(ErrorKind::unsupported, "this needs a sea; the subject is a " + std::string(kind));
}

OceanOptions ocean_options(const MapsOptions& options) {
    return {.threads = options.threads,
            .backend = options.backend,
            .foam_progress = options.foam_progress,
            .channels = options.channels,
            .build_progress = options.build_progress};
}

/// The part of a sea that a subject shows: one period, or the whole or a part of its bed.
class SeaExtent {
  public:
    SeaExtent(const Sea& sea, std::optional<Domain> region) : region_(region) {
        if (!region_ && sea.parameters.water.bed) region_ = sea.parameters.water.bed->domain;
    }

    bool is_region() const { return region_.has_value(); }
    int default_resolution(const Grid& grid) const {
        return region_ ? std::max(region_->samples[0], region_->samples[1])
                       : default_map_resolution(grid);
    }
    /// Returns the domain of a map of `resolution` samples along the side of a period, or along the
    /// longer side of any other part.
    Domain domain(const Grid& grid, int resolution) const {
        if (!region_) return Domain::tile(grid.patch_size, resolution);
        if (resolution == default_resolution(grid)) return *region_;
        return with_cell(*region_, std::max(region_->size[0], region_->size[1]) / (resolution - 1));
    }

  private:
    std::optional<Domain> region_;
};

class SeaMaps final : public SubjectMaps {
  public:
    SeaMaps(const Sea& sea, const SeaExtent& extent, const MapsOptions& options)
        : ocean_(sea, ocean_options(options)), extent_(extent) {
        if (extent_.is_region()) {
            ocean_.prepare_coast();
        } else {
            ocean_.modes();
        }
    }
    SeaMaps(const SeaMaps& built, const MapsOptions& options)
        : ocean_(built.ocean_, ocean_options(options)), extent_(built.extent_) {}

    Ocean& ocean() { return ocean_; }

    std::unique_ptr<SubjectMaps> share(const MapsOptions& options) const override {
        return std::make_unique<SeaMaps>(*this, options);
    }
    std::vector<Surface> levels(double time, ChannelSet channels,
                                std::span<const int> resolutions) override {
        if (!extent_.is_region()) return map_levels(ocean_, time, channels, resolutions);
        std::vector<Surface> levels;
        for (const int resolution : resolutions) {
            levels.push_back(ocean_.region(time, domain(resolution), channels));
        }
        return levels;
    }
    WorldHeights eulerian_heights(double time, int resolution) override {
        if (extent_.is_region()) return region_heights(ocean_, time, domain(resolution));
        return world_heights(ocean_, time, resolution);
    }
    void query(double time, std::span<const WorldPoint> points, std::span<QuerySample> samples,
               const QueryOptions& options) override {
        ocean_.query(time, points, samples, options);
    }
    ThreadPool& pool() override { return ocean_.pool(); }

  private:
    Domain domain(int resolution) const {
        return extent_.domain(ocean_.parameters().grid, resolution);
    }

    Ocean ocean_;
    SeaExtent extent_;
};

class SeaSubject final : public Subject {
  public:
    SeaSubject(Sea sea, std::optional<Domain> region)
        : sea_(std::move(sea)), extent_(sea_, region) {
        if (!sea_.parameters.crests.empty()) Ocean{sea_};  // which refuses impossible crests
    }

    const Sea& sea() const { return sea_; }

    std::string_view kind() const override { return kSeaKind; }
    std::string text() const override { return write_sea(sea_); }
    std::vector<std::string> named_files() const override { return ocean::named_files(sea_); }
    void set(std::string_view name, std::string_view value) override {
        set_parameter(sea_.parameters, name, value);
    }

    Timeline timeline() const override { return timeline_of(sea_); }
    std::vector<std::string> warnings(double time) const override {
        const Parameters parameters = sea_.at(time);
        std::vector<std::string> all = full_development_warnings(parameters);
        for (std::string& warning : hull_warnings(parameters)) {
            if (!extent_.is_region()) all.push_back(std::move(warning));
        }
        if (parameters.water.bed) {
            const SeaBed& bed = *parameters.water.bed;
            std::ranges::move(bed_warnings(bed, parameters.water), std::back_inserter(all));
            std::ranges::move(coast_warnings(bed, incoming_waves(parameters)),
                              std::back_inserter(all));
            std::ranges::move(region_warnings(bed, domain(default_resolution())),
                              std::back_inserter(all));
        }
        return all;
    }

    ChannelSet channels() const override {
        ChannelSet all;
        for (int c = 0; c < kChannelCount; ++c) all = all | static_cast<Channel>(c);
        if (sea_.parameters.water.bed) all = all | kMasksOverBed;
        return sea_.parameters.hulls.empty() ? all : all | kHullMasks;
    }
    int default_resolution() const override { return extent_.default_resolution(grid()); }
    Domain domain(int resolution) const override { return extent_.domain(grid(), resolution); }
    std::optional<int> backend_resolution(const Backend& backend, int resolution) const override {
        if (!extent_.is_region()) return resolution;
        // The foam of the open sea is followed on separate maps.
        const bool sums_coasts = backend.start_coast != nullptr && sea_.parameters.water.bed;
        return backend == Backend::cpu || sums_coasts
                   ? std::optional(default_map_resolution(grid()))
                   : std::nullopt;
    }
    double shortest_wave(int resolution) const override {
        const double held = extent_.is_region() ? 2.0 * domain(resolution).step(0)
                                                : ocean::shortest_wave(grid(), resolution);
        return std::max(sea_.parameters.surface.shortest_wavelength, held);
    }
    HeightRange height_range(const MapsOptions&) const override {
        constexpr double kMinDepth = 4.0;  // [m]
        const Parameters& parameters = sea_.parameters;
        const double variance = make_directional_spectrum(parameters).variance(parameters.water);
        const double wave_height = 4.0 * std::sqrt(variance);
        return {-std::min(std::max(kMinDepth, 2.0 * wave_height), parameters.water.depth),
                2.0 * wave_height};
    }

    std::unique_ptr<SubjectMaps> open(const MapsOptions& options) const override {
        return std::make_unique<SeaMaps>(sea_, extent_, options);
    }
    Costs costs() const override {
        Costs costs{.shared = modes_bytes(grid())};
        // With a take, each SubjectMaps has its own time.
        if (timeline().plays_take) costs.each = modes_bytes(grid());
        if (extent_.is_region() && !sea_.parameters.water.bed) {
            costs.each += hull_sea_bytes(sea_.parameters);
            costs.map = [this](const MapsOptions&, ChannelSet channels, int) {
                const bool has_foam = channels.intersects({Channel::foam, Channel::cover});
                const int shown = default_map_resolution(grid());
                return has_foam ? maps_bytes(shown, kFoamMaps + 2) : 0;
            };
            costs.eulerian_heights = [this](int resolution) {
                return region_heights_bytes(domain(resolution));
            };
            return costs;
        }
        if (extent_.is_region()) {
            costs.shared += coast_bytes(sea_.parameters);
            // Foam is followed on separate maps, over one period and over the region.
            costs.map = [this](const MapsOptions&, ChannelSet channels, int resolution) {
                return region_work_bytes(sea_.parameters, domain(resolution), channels);
            };
            costs.eulerian_heights = [this](int resolution) {
                return region_heights_bytes(domain(resolution));
            };
            return costs;  // queries read the coast
        }
        costs.map = [this](const MapsOptions& options, ChannelSet channels, int resolution) {
            return work_bytes(grid(), options.backend, channels, resolution, options.channels);
        };
        costs.eulerian_heights = [this](int resolution) {
            return world_heights_bytes(sea_, resolution);
        };
        costs.query = [this](const QueryOptions& options) {
            return SurfaceQuery::map_bytes(grid().resolution, options);
        };
        return costs;
    }

  private:
    const Grid& grid() const { return sea_.parameters.grid; }

    Sea sea_;
    SeaExtent extent_;
};

}  // namespace

std::unique_ptr<Subject> make_subject(Sea sea) {
    return std::make_unique<SeaSubject>(std::move(sea), std::nullopt);
}

std::unique_ptr<Subject> make_region_subject(Sea sea, const Region& region) {
    if (repeats(sea.parameters)) {
        throw Error(ErrorKind::unsupported,
                    "--region: this sea has no bed (water.seabed), so that it repeats, and its "
                    "maps are those of one period");
    }
    const Domain domain = domain_of(region);
    return std::make_unique<SeaSubject>(std::move(sea), domain);
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
