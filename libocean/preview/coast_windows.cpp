// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "coast_windows.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "ocean/internal/surf_traces.hpp"
#include "ocean/land_mask.hpp"

namespace ocean::preview {
namespace {

constexpr double kWindowRatio = 4.0;  // of the cells of neighbouring windows
/// An eye sees a cell of the finest window under less than 1 in so many.
constexpr double kFinestAngle = 128.0;

/// Ticks before a first picture whose foam is settled, and the ticks of wet ground before them [s].
constexpr double kFoamTick = 0.25;
constexpr double kWetTick = 1.0;
/// Lifetimes after which 5 % of the foam are left.
constexpr double kSettledLifetimes = 3.0;

constexpr Channel kDepth = channel_of(LandMask::depth);
constexpr Channel kBreaking = channel_of(LandMask::breaking);
constexpr ChannelSet kTraceChannels = {kDepth, kBreaking};
constexpr Channel kTrail = channel_of(LandMask::trail);
constexpr ChannelSet kHullChannels = {kTrail, Channel::whitecap};
/// A coarser window would make a patch of its cell of each whitecap that one of its samples meets
/// [m].
constexpr double kWhitecapCell = 4.0;
constexpr ChannelSet kShapeChannels = {Channel::dx,      Channel::dy,      Channel::height,
                                       Channel::slope_x, Channel::slope_y, Channel::dx_x,
                                       Channel::dy_y,    Channel::dx_y};
constexpr float kDeep = 1e3f;  // depth of water without a bed, as the shaders have it [m]

std::size_t sample_count(const CoastWindow& window) {
    return static_cast<std::size_t>(window.samples) * static_cast<std::size_t>(window.samples);
}

/// Returns the index of the sample next to a place, or nothing outside the window.
std::optional<std::size_t> nearest_sample(const CoastWindow& window, double x, double y) {
    const auto index = [&](std::size_t axis, double at) {
        return std::llround(at / window.cell) - window.corner[axis];
    };
    const std::int64_t i = index(0, x), j = index(1, y);
    if (i < 0 || j < 0 || i >= window.samples || j >= window.samples) return std::nullopt;
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(window.samples) +
           static_cast<std::size_t>(i);
}

/// Returns the part of a window in an area: beside it the open sea is shown.
CoastPart part_in(const CoastWindow& window, const Domain& area, Domain& domain) {
    CoastPart part;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto corner = static_cast<double>(window.corner[axis]);
        const double low = area.origin[axis] / window.cell - corner;
        const double high = (area.origin[axis] + area.size[axis]) / window.cell - corner;
        const double last = window.samples - 1;
        const int first = static_cast<int>(std::clamp(std::floor(low), 0.0, last));
        const int end = static_cast<int>(std::clamp(std::ceil(high), 0.0, last));
        part.first[axis] = first;
        domain.samples[axis] = end - first + 1;
        domain.origin[axis] = (corner + first) * window.cell;
        domain.size[axis] = (end - first) * window.cell;
    }
    return part;
}

/// Calls visit(index in the window, index in the part) for each sample of a part.
template <typename Visit>
void visit_part(const CoastPart& part, int window_samples, Visit&& visit) {
    const std::array<int, 2> samples = part.surface.domain().samples;
    std::size_t from = 0;
    for (int j = 0; j < samples[1]; ++j) {
        std::size_t to =
            static_cast<std::size_t>(part.first[1] + j) * static_cast<std::size_t>(window_samples) +
            static_cast<std::size_t>(part.first[0]);
        for (int i = 0; i < samples[0]; ++i) visit(to++, from++);
    }
}

/// Returns the index in the window of a sample of a part.
std::size_t index_in_window(const CoastPart& part, const CoastWindow& window, std::uint32_t at) {
    const auto width = static_cast<std::uint32_t>(part.surface.domain().samples[0]);
    const auto row = static_cast<std::uint32_t>(part.first[1]) + at / width;
    return std::size_t{row} * static_cast<std::size_t>(window.samples) +
           static_cast<std::size_t>(part.first[0]) + at % width;
}

/// Returns how wet the ground about a sample of a part is. Where the depth changes much from sample
/// to sample it is the share of its cell that water covers: what covers a sample or does not would
/// end in stairs of the cell.
float wet_about(std::span<const float> depth, const std::array<int, 2>& samples, std::size_t at) {
    constexpr float kFine = 0.05f;  // change of the depth over a cell [m]
    const int width = samples[0];
    const int i = static_cast<int>(at) % width, j = static_cast<int>(at) / width;
    const auto change = [&](int index, int count, int step) {
        const int back = index > 0 ? step : 0, on = index + 1 < count ? step : 0;
        const float low = depth[at - static_cast<std::size_t>(back)];
        const float high = depth[at + static_cast<std::size_t>(on)];
        return std::abs(high - low) * static_cast<float>(step) / static_cast<float>(back + on);
    };
    const float over_cell = change(i, width, 1) + change(j, samples[1], width);
    if (over_cell <= kFine) return covered_by(depth[at]);
    return std::clamp(0.5f + depth[at] / over_cell, 0.0f, 1.0f);
}

/// The bounds of CoastTraces::reach, so that deep water and high land do not count more in means
/// [m].
constexpr float kReach = 2.0f;

/// Wets the ground about a sample of a part, whose traces are those of `to`. left: the share of its
/// wetness that is left.
void wet_ground(CoastTraces& traces, std::size_t to, std::span<const float> depth,
                const std::array<int, 2>& samples, std::size_t at, float left) {
    constexpr float kFall =
        0.15f;  // while sand dries to 1/e the edge of wet sand falls by this [m]
    const float now = std::clamp(depth[at], -kReach, kReach);
    traces.reach[to] = std::max(now, traces.reach[to] - kFall * (1.0f - left));
    traces.wet[to] = std::max(wet_about(depth, samples, at), left * traces.wet[to]);
}

/// The part of a window that changes with the waves: the surf and the swash.
struct SurfEdge {
    RegionSurf labels;
    std::vector<float> depth;         // of all samples of the part [m]
    std::vector<std::uint32_t> edge;  // samples that may get wet or dry

    /// The part has its depth at that time.
    SurfEdge(const CoastPart& part, Ocean& sea, double time) : labels(part.surface.domain()) {
        const auto now = part.surface.channel(kDepth);
        depth.assign(now.begin(), now.end());
        std::vector<char> is_edge(depth.size());
        const auto width = static_cast<std::size_t>(part.surface.domain().samples[0]);
        labels.read(sea, time, [&](std::size_t at, float, float) {
            for (const std::size_t near : {at - width, at - 1, at, at + 1, at + width}) {
                if (near < is_edge.size()) is_edge[near] = 1;
            }
        });
        for (std::uint32_t at = 0; at < is_edge.size(); ++at) {
            if (is_edge[at] != 0) edge.push_back(at);
        }
    }
};

/// Returns the bed of a sea, or the box of all wakes.
Domain placed_area(const Ocean& sea, double time) {
    if (const auto& bed = sea.parameters().water.bed) return bed->domain;
    Domain area = sea.wake_domain(0, time);
    for (std::size_t hull = 1; hull < sea.parameters().hulls.size(); ++hull) {
        const Domain wake = sea.wake_domain(hull, time);
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const double low = std::min(area.origin[axis], wake.origin[axis]);
            const double high =
                std::max(area.origin[axis] + area.size[axis], wake.origin[axis] + wake.size[axis]);
            area.origin[axis] = low;
            area.size[axis] = high - low;
        }
    }
    return area;
}

void write_image(CoastImage& image, const CoastPart& part, const CoastTraces& traces,
                 double choppiness, double cover_power) {
    const std::size_t count = sample_count(image.window);
    for (auto* values : {&image.shape, &image.gradients, &image.moments, &image.traces}) {
        values->assign(kWindowComponents * count, 0.0f);
    }
    // Maps of the open sea have displacements at choppiness 1, which points away.
    const auto scale = static_cast<float>(choppiness > 0.0 ? -1.0 / choppiness : 0.0);
    const auto read = [&](Channel channel) { return part.surface.channel(channel); };
    const auto dx = read(Channel::dx), dy = read(Channel::dy), height = read(Channel::height);
    const auto slope_x = read(Channel::slope_x), slope_y = read(Channel::slope_y);
    const auto dx_x = read(Channel::dx_x), dy_y = read(Channel::dy_y), dx_y = read(Channel::dx_y);
    const bool has_bed = part.surface.channels().contains(kDepth);
    const auto depth = has_bed ? read(kDepth) : std::span<const float>();
    const bool has_whitecaps =
        part.surface.channels().contains(Channel::whitecap) && image.window.cell <= kWhitecapCell;
    const auto whitecap = has_whitecaps ? read(Channel::whitecap) : std::span<const float>();
    const auto power = static_cast<float>(cover_power);
    visit_part(part, image.window.samples, [&](std::size_t to, std::size_t n) {
        const auto set = [&](std::vector<float>& of, float a, float b, float c, float d) {
            float* const texel = &of[kWindowComponents * to];
            texel[0] = a;
            texel[1] = b;
            texel[2] = c;
            texel[3] = d;
        };
        const float foam = traces.foam[to];
        set(image.shape, scale * dx[n], scale * dy[n], height[n], has_bed ? depth[n] : kDeep);
        set(image.gradients, slope_x[n], slope_y[n], scale * dx_x[n], scale * dy_y[n]);
        set(image.moments, slope_x[n] * slope_x[n], slope_y[n] * slope_y[n],
            slope_x[n] * slope_y[n], scale * dx_y[n]);
        // A trail is a share of the water, as cover is.
        const float cover = has_bed ? std::pow(foam, kSurfCoverPower) : foam;
        set(image.traces, cover, foam * foam * foam, traces.wet[to],
            has_bed         ? traces.reach[to]
            : has_whitecaps ? std::pow(whitecap[n], power)
                            : 0.0f);
    });
}

}  // namespace

Domain CoastWindow::domain() const {
    const double side = (samples - 1) * cell;
    return {{static_cast<double>(corner[0]) * cell, static_cast<double>(corner[1]) * cell},
            {side, side},
            {samples, samples},
            false};
}

std::vector<CoastWindow> coast_windows(const std::array<double, 3>& eye,
                                       const CoastMapsOptions& options) {
    const double seen = std::abs(eye[2]) / (kFinestAngle * options.finest);
    double cell = options.finest * std::exp2(std::max(0.0, std::ceil(std::log2(seen))));
    std::vector<CoastWindow> windows(options.windows);
    for (CoastWindow& window : windows) {
        const auto corner = [&](double at) {
            return std::llround(at / cell) - options.samples / 2;
        };
        window = {{corner(eye[0]), corner(eye[1])}, cell, options.samples};
        cell *= kWindowRatio;
    }
    return windows;
}

std::optional<double> read_windows(const std::vector<CoastImage>& windows,
                                   std::vector<float> CoastImage::*image, std::size_t component,
                                   double x, double y) {
    for (const CoastImage& values : windows) {
        const CoastWindow& window = values.window;
        const double u = x / window.cell - static_cast<double>(window.corner[0]);
        const double v = y / window.cell - static_cast<double>(window.corner[1]);
        const double last = window.samples - 1;
        if (!(u >= 0.0 && v >= 0.0 && u < last && v < last)) continue;
        const auto i = static_cast<std::size_t>(u), j = static_cast<std::size_t>(v);
        const auto at = [&](std::size_t column, std::size_t row) {
            const std::size_t n = row * static_cast<std::size_t>(window.samples) + column;
            return static_cast<double>((values.*image)[kWindowComponents * n + component]);
        };
        const double s = u - std::floor(u), t = v - std::floor(v);
        return std::lerp(std::lerp(at(i, j), at(i + 1, j), s),
                         std::lerp(at(i, j + 1), at(i + 1, j + 1), s), t);
    }
    return std::nullopt;
}

std::vector<CoastImage>& CoastSurface::at(Ocean& sea, double time, const std::array<double, 3>& eye,
                                          double cover_power) {
    const std::vector<CoastWindow> windows = coast_windows(eye, options_);
    const bool over_bed = sea.parameters().water.bed != nullptr;
    const double lifetime = sea.parameters().water.shore.surf_foam_lifetime;
    const bool is_new = !followed_ || revision_ != sea.revision() || time < *followed_ ||
                        time > *followed_ + kSettledLifetimes * lifetime;
    revision_ = sea.revision();
    if (is_new) {
        traces_.clear();
        followed_.reset();
    }
    move_traces(windows);
    if (is_new && over_bed && options_.foam_start == FoamStart::settled) settle(sea, time);
    const std::vector<CoastPart> parts =
        follow(sea, time, kShapeChannels | (over_bed ? kTraceChannels : kHullChannels));
    images_.resize(windows.size());
    const double choppiness = sea.parameters().surface.choppiness;
    for (std::size_t w = 0; w < windows.size(); ++w) {
        images_[w].window = windows[w];
        write_image(images_[w], parts[w], traces_[w], choppiness, cover_power);
    }
    return images_;
}

void CoastSurface::settle(Ocean& sea, double time) {
    const double lifetime = sea.parameters().water.shore.surf_foam_lifetime;
    const double foam = kSettledLifetimes * lifetime;
    double ago = std::max(kDryingTime, foam + kWetTick);
    const std::vector<CoastPart> parts = follow(sea, time - ago, kTraceChannels);
    std::vector<std::optional<SurfEdge>> surf;
    for (const CoastPart& part : parts) {
        auto& edge = surf.emplace_back();
        if (part.surface.channels().contains(kDepth)) edge.emplace(part, sea, time - ago);
    }
    for (ago -= kWetTick; ago > 0.0; ago -= ago > foam ? kWetTick : kFoamTick) {
        const Left left = left_until(time - ago, lifetime);
        for (std::size_t w = 0; w < parts.size(); ++w) {
            if (!surf[w]) continue;
            CoastTraces& traces = traces_[w];
            const auto in_window = [&](std::uint32_t at) {
                return index_in_window(parts[w], traces.window, at);
            };
            surf[w]->labels.read(sea, time - ago,
                                 [&](std::uint32_t at, float breaking, float depth) {
                                     surf[w]->depth[at] = depth;
                                     float& was = traces.foam[in_window(at)];
                                     was = std::max(breaking, left.foam * was);
                                 });
            const std::array<int, 2> samples = parts[w].surface.domain().samples;
            for (const std::uint32_t at : surf[w]->edge) {
                wet_ground(traces, in_window(at), surf[w]->depth, samples, at, left.wet);
            }
        }
        followed_ = time - ago;
    }
}

CoastSurface::Left CoastSurface::left_until(double time, double lifetime) const {
    const double passed = followed_ ? time - *followed_ : 0.0;
    const auto left = [&](double of) { return static_cast<float>(std::exp(-passed / of)); };
    return {lifetime > 0.0 ? left(lifetime) : 0.0f, left(kDryingTime)};
}

std::vector<CoastPart> CoastSurface::follow(Ocean& sea, double time, ChannelSet channels) {
    const double lifetime = sea.parameters().water.shore.surf_foam_lifetime;
    const Left left = left_until(time, lifetime);
    area_ = placed_area(sea, time);
    std::vector<CoastPart> parts;
    for (CoastTraces& traces : traces_) {
        Domain domain{.origin = {}, .size = {}, .samples = {}, .wraps = false};
        CoastPart& part = parts.emplace_back(part_in(traces.window, area_, domain));
        if (channels.contains(kTrail)) std::ranges::fill(traces.foam, 0.0f);
        if (domain.samples[0] < 2 || domain.samples[1] < 2) continue;
        part.surface = sea.region(time, domain, channels);
        if (channels.contains(kTrail)) {  // which has no past
            const auto trail = part.surface.channel(kTrail);
            visit_part(part, traces.window.samples,
                       [&](std::size_t to, std::size_t from) { traces.foam[to] = trail[from]; });
            continue;
        }
        const auto breaking = part.surface.channel(kBreaking);
        const auto depth = part.surface.channel(kDepth);
        visit_part(part, traces.window.samples, [&](std::size_t to, std::size_t from) {
            traces.foam[to] = std::max(breaking[from], left.foam * traces.foam[to]);
            wet_ground(traces, to, depth, domain.samples, from, left.wet);
        });
    }
    followed_ = time;
    return parts;
}

void CoastSurface::move_traces(const std::vector<CoastWindow>& windows) {
    const bool same = std::ranges::equal(windows, traces_, {}, {}, &CoastTraces::window);
    if (same) return;
    std::vector<CoastTraces> moved;
    for (const CoastWindow& window : windows) {
        CoastTraces& to = moved.emplace_back();
        to.window = window;
        to.foam.resize(sample_count(window));
        to.wet.resize(sample_count(window));
        to.reach.resize(sample_count(window), -kReach);
        if (traces_.empty()) continue;
        const Domain domain = window.domain();
        std::size_t n = 0;
        for (int j = 0; j < window.samples; ++j) {
            for (int i = 0; i < window.samples; ++i, ++n) {
                const auto [x, y] = domain.place(i, j);
                // Its own samples first: a finer window has other means.
                const auto holds = [&, x = x, y = y](const CoastTraces& from) {
                    return from.window.cell >= window.cell && nearest_sample(from.window, x, y);
                };
                auto from = std::ranges::find_if(traces_, holds);
                if (from == traces_.end()) {
                    from = std::ranges::find_if(traces_, [&, x = x, y = y](const auto& any) {
                        return nearest_sample(any.window, x, y).has_value();
                    });
                }
                if (from == traces_.end()) continue;
                const std::size_t at = *nearest_sample(from->window, x, y);
                to.foam[n] = from->foam[at];
                to.wet[n] = from->wet[at];
                to.reach[n] = from->reach[at];
            }
        }
    }
    traces_ = std::move(moved);
}

}  // namespace ocean::preview
