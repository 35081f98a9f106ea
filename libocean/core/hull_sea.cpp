// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "hull_sea.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "hulls/hull_marks.hpp"
#include "hulls/hull_summary.hpp"
#include "hulls/wake_motion.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/cascades.hpp"
#include "ocean/internal/directional_spectrum.hpp"
#include "ocean/internal/hull_rules.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/internal/sea_bytes.hpp"
#include "ocean/land_mask.hpp"
#include "ocean/thread_pool.hpp"
#include "wave/wave.hpp"
#include "waves/labels/label_search.hpp"
#include "waves/labels/region_rows.hpp"
#include "waves/query/query_points.hpp"

namespace ocean {
namespace {

/// The whitecaps and the foam of a surface with wakes. Foam is the open sea's, followed over time;
/// where the sum of both breaks now, its whitecap is foam too. That whitecap leaves no foam behind.
class SummedFoam {
  public:
    SummedFoam(const SurfaceSettings& settings, const Surface& open, float cover_power)
        : threshold_(static_cast<float>(settings.foam_threshold)),
          width_(static_cast<float>(settings.foam_width)),
          open_(open),
          cover_power_(cover_power) {}

    float whitecap(float jacobian) const {
        return wave::single_precision::surface_whitecap(jacobian, threshold_, width_);
    }
    float foam(WorldPoint label, const LabelPoint& point) const {
        return std::max(read_period(open_, Channel::foam, label), whitecap(label_jacobian(point)));
    }
    float cover(WorldPoint label, const LabelPoint& point) const {
        return std::max(read_period(open_, Channel::cover, label),
                        std::pow(whitecap(label_jacobian(point)), cover_power_));
    }

  private:
    float threshold_;
    float width_;
    const Surface& open_;
    float cover_power_;
};

/// Returns true if hulls are the same but for their tracks.
bool have_other_tracks(const std::vector<Hull>& before, const std::vector<Hull>& now) {
    return std::ranges::equal(before, now, [](Hull a, const Hull& b) {
        a.track = b.track;
        return a == b;
    });
}

/// Returns true for an output with all components of a normal, or none.
bool has_all_of_normal(const MapOutput& output) {
    const ChannelSet channels = channels_of({&output, 1});
    return !channels.intersects(kNormals) || channels.contains(kNormals);
}

/// The masks of all hulls together.
class AllMarks {
  public:
    AllMarks(const Parameters& sea, bool wanted, double time) {
        if (!wanted) return;
        for (const Hull& hull : sea.hulls) {
            hulls_.emplace_back(hull, sea.time.loop_period).move_to(time);
        }
    }

    float trail(WorldPoint label) const {
        float most = 0.0f;
        for (const HullMarks& hull : hulls_) most = std::max(most, hull.trail(label));
        return most;
    }
    float dry(WorldPoint label, const LabelPoint& point) const {
        const WorldPoint place{label.x + static_cast<double>(point.dx.value()),
                               label.y + static_cast<double>(point.dy.value())};
        float most = 0.0f;
        for (const HullMarks& hull : hulls_) most = std::max(most, hull.inside(place));
        return most;
    }

  private:
    std::vector<HullMarks> hulls_;
};

}  // namespace

void HullSea::drop(const OpenSea::Ended& ended) {
    if (ended.grid) surface_.reset();
}

void HullSea::prepare() {
    surface(parameters().time.start, false);
}

void HullSea::describe(SeaState& state) {
    const Parameters& sea = parameters();
    for (const Hull& hull : sea.hulls) {
        const std::string name = "hulls." + std::to_string(state.hulls.size());
        state.hulls.push_back(hull_summary(hull, sea.water, sea.time.loop_period, open().pool()));
        std::ranges::move(wake_warnings(state.hulls.back(), name),
                          std::back_inserter(state.warnings));
    }
}

HullSurface& HullSea::surface(double time, bool rates) {
    HullSurface& surface = still_surface(time);
    surface.move_to(open().modes(time), time, rates, open().pool());
    return surface;
}

HullSurface& HullSea::still_surface(double time) {
    const Parameters& now = open().parameters_at(time);
    const Modes& modes = open().modes(time);
    const auto height = [&] { return 4.0 * std::sqrt(open().spectrum(time).variance(now.water)); };
    const bool keeps_wakes =
        surface_ && water_ == now.water && choppiness_ == now.surface.choppiness &&
        loop_period_ == now.time.loop_period &&
        (hulls_ == now.hulls || (have_other_tracks(hulls_, now.hulls) && surface_->follow(now)));
    if (!keeps_wakes) {
        surface_.reset();
        require_memory(hull_sea_bytes(now), "the wakes of the hulls");
        surface_.emplace(now, shown(), height(), open().pool());
    } else if (modes_ != modes.revision) {
        surface_->renew_open_sea(height());
    }
    if (!keeps_wakes || modes_ != modes.revision || hulls_ != now.hulls) {
        modes_ = modes.revision;
        hulls_ = now.hulls;
        water_ = now.water;
        choppiness_ = now.surface.choppiness;
        loop_period_ = now.time.loop_period;
    }
    return *surface_;
}

PlacedSea::RegionMaps HullSea::region_maps(ChannelSet) const {
    return {};
}

void HullSea::write_region(double time, const Domain& domain, std::span<const MapOutput> outputs) {
    const ChannelSet channels = channels_of(outputs);
    ++open().stage_runs().surface;
    const bool has_foam = channels.intersects(kFoamChannels);
    const Surface foam_of_open =
        has_foam
            ? open_map(time, channels.without(kEveryMask | kEveryChannel.without(kFoamChannels)))
            : Surface();
    const auto power = channels.contains(Channel::cover)
                           ? static_cast<float>(open().cover_power(time, shown()))
                           : 1.0f;
    const SurfaceSettings settings = open().shown_settings(time, shown());
    const SummedFoam foam(settings, foam_of_open, power);
    const HullSurface& surface = this->surface(time, needs_rates(channels));
    surface.prepare(domain.origin[0], domain.origin[0] + domain.size[0], open().pool());
    const auto read = [&](std::span<const WorldPoint> labels, std::span<LabelPoint> points,
                          std::size_t) { surface.read(labels, points); };
    const AllMarks marks(parameters(), channels.intersects(kHullMasks), time);
    const auto own = [&](const RegionPiece<LabelPoint>& piece, const RegionTarget& target) {
        target.write(piece.count, [&](std::size_t i) {
            const WorldPoint label = piece.labels[i];
            const LabelPoint& point = piece.points[i];
            if (target.channel == Channel::whitecap) return foam.whitecap(piece.jacobians[i]);
            if (target.channel == Channel::foam) return foam.foam(label, point);
            if (target.channel == Channel::cover) return foam.cover(label, point);
            if (target.channel == channel_of(LandMask::trail)) return marks.trail(label);
            return marks.dry(label, point);  // region() has refused all others
        });
    };
    open().pool().for_each_item(domain.samples[1], [&](int j, int) {
        write_region_row<LabelPoint>(domain, j, {0, domain.samples[0]}, channels, outputs, read,
                                     own);
    });
}

Domain HullSea::wake_domain(std::size_t hull, double time) const {
    require_time(time);
    const Parameters& sea = parameters();
    const Hull& of = sea.hulls[hull];
    const WakeSize size = wake_size(of, fastest_leg(*of.track).speed, sea.water);
    const double step = size.side / size.resolution;
    const TrackPath path(of.track, sea.time.loop_period);
    const PathVector centre = wake_place(path, time, size.side, step).centre;
    return {{centre.x - 0.5 * size.side, centre.y - 0.5 * size.side},
            {size.side - step, size.side - step},
            {size.resolution, size.resolution},
            false};
}

void HullSea::wake_into(std::size_t hull, double time, const Domain& domain,
                        std::span<const MapOutput> outputs, bool adds) {
    require_time(time);
    require_region(domain);
    const ChannelSet channels = channels_of(outputs);
    constexpr Channel kTrail = channel_of(LandMask::trail);
    if (channels.intersects(kEveryMask.without(kTrail) | kFoamChannels |
                            ChannelSet(Channel::whitecap))) {
        throw Error(ErrorKind::unsupported,
                    "a wake alone has no foam and no mask but its trail; allowed: trail and the "
                    "channels of its waves");
    }
    if (adds && !std::ranges::all_of(outputs, has_all_of_normal)) {
        throw Error(ErrorKind::unsupported,
                    "a wake tilts whole normals; allowed: nx, ny and nz in one output");
    }
    HullSurface& surface = still_surface(time);
    surface.move_wakes_to(time, needs_rates(channels), open().pool());
    const Wake& wake = *surface.wakes()[hull];
    HullMarks marks(parameters().hulls[hull], parameters().time.loop_period);
    if (channels.contains(kTrail)) marks.move_to(time);
    wake.prepare(domain.origin[0], domain.origin[0] + domain.size[0], open().pool());
    const Wake::Rows rows(wake, domain);
    const auto trail = [&](const RegionPiece<LabelPoint>& piece, const RegionTarget& target) {
        target.write(piece.count, [&](std::size_t i) {
            const float mark = marks.trail(piece.labels[i]);
            if (mark == 0.0f) return 0.0f;
            return static_cast<float>(wake.trail_share_at(piece.labels[i])) * mark;
        });
    };
    // Nothing is added beyond its square.
    const auto [first, end] = adds ? wake.samples(domain, 0) : std::array{0, domain.samples[0]};
    const auto [low, high] = adds ? wake.samples(domain, 1) : std::array{0, domain.samples[1]};
    const RegionSpan span{first, end, adds};
    open().pool().for_each_item(high - low, [&, low = low](int j, int) {
        const auto read = [&](std::span<const WorldPoint>, std::span<LabelPoint> points,
                              std::size_t first) {
            surface.read_wake(rows, low + j, first, points);
        };
        write_region_row<LabelPoint>(domain, low + j, span, channels, outputs, read, trail);
    });
}

void HullSea::query(double time, std::span<const WorldPoint> points, std::span<QuerySample> samples,
                    const QueryOptions& options) {
    require_finite(points);
    if (options.resolution != 0 && options.resolution != shown()) {
        throw Error(ErrorKind::unsupported,
                    "resolution = " + std::to_string(options.resolution) +
                        ": with hulls a query reads all waves of the grid; allowed: 0 or " +
                        std::to_string(shown()));
    }
    spline_resolution(parameters().grid.resolution, {.refine = options.refine});
    if (points.empty()) return;
    HullSurface& surface = this->surface(time, true);
    if (options.exact) {
        require_memory(3 * WaveSum::bytes(open().modes(time), 1), "an exact query of this sea");
        surface.prepare_sums(open().modes(time), open().pool());
    } else {
        const auto [west, east] = std::ranges::minmax(points, {}, &WorldPoint::x);
        surface.prepare(west.x - surface.reach(), east.x + surface.reach(), open().pool());
    }
    std::vector<LabelPoint> found(points.size());
    const auto read = [&](std::span<const WorldPoint> labels, std::span<LabelPoint> at) {
        surface.read(labels, at, options.exact);
    };
    // A sum over all modes takes long enough to be a work item of its own.
    const std::size_t piece = options.exact ? 1 : kSearchBlock;
    search_labels(read, surface.reach(), piece, points, samples, std::span(found), open().pool());
    if (options.foam) add_foam(time, samples.first(points.size()), found);
}

void HullSea::add_foam(double time, std::span<QuerySample> samples,
                       std::span<const LabelPoint> found) {
    const Surface open_foam = open_map(time, Channel::foam);
    const SurfaceSettings settings = open().shown_settings(time, shown());
    const SummedFoam foam(settings, open_foam, 1.0f);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const WorldPoint label{samples[i].label[0], samples[i].label[1]};
        samples[i].foam = static_cast<double>(foam.foam(label, found[i]));
    }
}

double HullSea::height_error(double time) {
    return surface(time, false).height_error();
}

void HullSea::water_motion(double time, std::span<const WaterPoint> points,
                           std::span<WaterMotion> motions, const QueryOptions& options) {
    open().water_motion(time, points, motions, options);
    HullSurface& surface = still_surface(time);
    surface.move_wakes_to(time, false, open().pool());
    for (const auto& wake : surface.wakes()) {
        add_wake_motion(*wake, parameters().water, options.exact, points, motions, open().pool());
    }
}

const SprayFollower& HullSea::spray(double time, const SpraySettings& settings,
                                    const std::optional<Domain>& region) {
    if (!region) return open().spray(time, settings);
    constexpr Channel kDry = channel_of(LandMask::dry);
    const Domain domain = spray_domain(parameters(), region);
    const auto require_room = [&] { require_memory(spray_map_bytes(domain), "spray"); };
    return open().spray(time, settings, domain, require_room, [&](double t, Surface& map) {
        map = this->region(t, domain, kSprayChannels | ChannelSet(kDry));
        const std::span<float> whitecap = map.channel(Channel::whitecap);
        const std::span<const float> dry = map.channel(kDry);
        for (std::size_t i = 0; i < whitecap.size(); ++i) {
            if (dry[i] > 0.5f) whitecap[i] = 0.0f;
        }
    });
}

}  // namespace ocean
