// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "hulls/wake.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/prefault_pages.hpp"
#include "base/simd/simd_level.hpp"
#include "field/ease.hpp"
#include "ocean/internal/hull_rules.hpp"
#include "ocean/internal/surface_query.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {
namespace {

// The wake fades to 0 between these shares of its square, from the centre. The window has ended
// nearly all of it before.
constexpr double kRimBegin = 0.46;
constexpr double kRimEnd = 0.495;
constexpr double kTrailEnds = 0.38;  // share of the square from which on a trail fades

/// The hull goes at most this share of its square in a span of the windows: within it W stays 1
/// around the hull, which lies at most 0.26 from the middle.
constexpr double kWayOfSpan = 0.035;

double longest_span(const WakeSize& size, const Hull& hull) {
    return kWayOfSpan * size.side / std::max(fastest_leg(*hull.track).speed, 1e-9);
}

/// Returns the factor of one axis, with its slope as the first of the jet's derivatives.
RimFactor rim_factor(double offset, double side) {
    const double share = std::abs(offset) / side;
    const double u = (share - kRimBegin) / (kRimEnd - kRimBegin);
    if (u <= 0.0) return {1.0, 0.0};
    if (u >= 1.0) return {0.0, 0.0};
    const double rise = 30.0 * u * u * (1.0 - u) * (1.0 - u) / (kRimEnd - kRimBegin) / side;
    return {1.0 - ease_quintic(u), offset < 0.0 ? rise : -rise};
}

LinearWaves<Jet> within_rim(const LinearWaves<Jet>& waves, RimFactor along, RimFactor across) {
    if (along.value == 1.0 && across.value == 1.0) return waves;
    const Jet factor(static_cast<float>(along.value * across.value),
                     static_cast<float>(along.slope * across.value),
                     static_cast<float>(along.value * across.slope));
    return {factor * waves.height, factor * waves.displacement_x, factor * waves.displacement_y};
}

}  // namespace

Wake::Wake(const Hull& hull, const Water& water, double loop_period, ThreadPool& pool)
    : size_(wake_size(hull, fastest_leg(*hull.track).speed, water)),
      path_(hull.track, loop_period),
      clock_(path_, longest_span(size_, hull)),
      lattice_(hull, size_, water),
      still_(lattice_.still_modes()),
      map_(still_, size_.resolution, pool),
      factors_(lattice_.factors(map_.factor(still_))),
      places_(lattice_.places(map_.packed())),
      amplitudes_(2 * lattice_.count()),
      sums_(4 * lattice_.count()),
      ticks_(2 * lattice_.count()),
      turns_(size_.resolution, size_.side, 0.5 * hull.length) {
    prefault_pages(amplitudes_, pool);
    prefault_pages(sums_, pool);
}

bool Wake::follow(const Hull& hull, const Water& water) {
    const WakeSize size = wake_size(hull, fastest_leg(*hull.track).speed, water);
    if (size != size_) return false;
    TrackPath path(hull.track, path_.period());
    const WakeClock clock(path, longest_span(size, hull));
    const double shared = path_.same_until(path);
    path_ = std::move(path);
    const bool keeps = span_ && clock == clock_ &&
                       clock.tick_begin(*span_, ticks_added_) <= shared &&
                       place_at(clock.begin(*span_ + 1)).middle == ends_;
    if (!keeps) span_.reset();
    clock_ = clock;
    return true;
}

void Wake::settle(std::int64_t span, ThreadPool& pool) {
    span_.reset();
    const double begin = clock_.begin(span), end = clock_.begin(span + 1);
    const WakePlace place = place_at(begin);
    ends_ = place_at(end).middle;
    const WakePast past = wake_past(path_, clock_.settled(path_, span, size_.age), begin, place);
    const WindowNodes first(past, 0.0, place.middle, size_.age);
    const WindowNodes second(past, end - begin, ends_, size_.age);
    const std::size_t count = lattice_.count();
    const WakeLoops loops = wake_loops(simd_level());
    std::ranges::fill(sums_, 0.0f);
    std::ranges::fill(ticks_, 0.0f);
    ticks_added_ = 0;
    for (int node = 0; node + 1 < static_cast<int>(past.nodes.size());
         node += WakeTurns::kSegments) {
        const WakeRuns runs = turns_.fill(past, node);
        constexpr std::size_t kRound = kWakeBlock - 1;
        const std::size_t nodes = (runs.tables.nodes + kRound) / kWakeBlock * kWakeBlock;
        pool.for_each_range(static_cast<int>(count / kWakeBlock), [&](int from, int to) {
            PageVector<std::int32_t> choices(nodes);
            float* const at = sums_.data() + static_cast<std::size_t>(from) * kWakeBlock;
            loops.sum({.waves = lattice_.waves(from, to),
                       .past = runs,
                       .windows = {first.window(node), second.window(node)},
                       .size = static_cast<float>(size_.side),
                       .node_count = nodes,
                       .choices = choices.data(),
                       .re = {at, at + 2 * count},
                       .im = {at + count, at + 3 * count}});
        });
    }
    settled_ = place;
    span_ = span;
}

void Wake::add_ticks(int ticks, ThreadPool& pool) {
    if (ticks < ticks_added_) {
        std::ranges::fill(ticks_, 0.0f);
        ticks_added_ = 0;
    }
    const float* const re = ticks_.data();
    const float* const im = re + lattice_.count();
    const std::int64_t span = *span_;
    span_.reset();  // an interrupt leaves ticks that are added in part
    for (; ticks_added_ < ticks; ++ticks_added_) {
        const double begin = clock_.begin(span);
        WakePast past = wake_past(path_, clock_.tick(path_, span, ticks_added_), begin, settled_);
        past.insert_before({0.0, 0.0, 0.0});
        run_frame({.re = {re, re}, .im = {im, im}, .share = 0.0f, .moves = false}, past, ticks_,
                  pool);
    }
    span_ = span;
}

void Wake::run_frame(WakeFrame frame, const WakePast& past, PageVector<float>& to,
                     ThreadPool& pool) {
    frame.past = turns_.fill(past, 0);
    const WakeLoops loops = wake_loops(simd_level());
    pool.for_each_range(static_cast<int>(lattice_.count() / kWakeBlock), [&](int from, int end) {
        const std::size_t at = static_cast<std::size_t>(from) * kWakeBlock;
        WakeFrame part = frame;
        part.waves = lattice_.waves(from, end);
        for (const float** const values :
             {&part.re[0], &part.re[1], &part.im[0], &part.im[1], &part.ticks_re, &part.ticks_im}) {
            if (*values != nullptr) *values += at;
        }
        part.to_re = to.data() + at;
        part.to_im = part.to_re + lattice_.count();
        loops.frame(part);
    });
}

void Wake::move_to(double time, bool rates, ThreadPool& pool) {
    const std::int64_t span = clock_.span_of(time);
    if (span_ != span) settle(span, pool);
    const WakeNewest newest = clock_.newest(path_, time);
    add_ticks(newest.ticks, pool);
    const double begin = clock_.begin(span), end = clock_.begin(span + 1);
    past_ = wake_past(path_, newest.times, time, place_at(time));
    sum_.reset();
    past_.insert_before({begin - time, settled_.centre.x - past_.place.centre.x,
                         settled_.centre.y - past_.place.centre.y});
    const std::size_t count = lattice_.count();
    const float* const sums = sums_.data();
    run_frame({.re = {sums, sums + 2 * count},
               .im = {sums + count, sums + 3 * count},
               .ticks_re = newest.ticks > 0 ? ticks_.data() : nullptr,
               .ticks_im = newest.ticks > 0 ? ticks_.data() + count : nullptr,
               .share = static_cast<float>((time - begin) / (end - begin)),
               .moves = past_.moves()},
              past_, amplitudes_, pool);
    const float* const re = amplitudes_.data();
    farthest_ = lattice_.farthest(re, re + count);
    lattice_.pack(re, re + count, factors_.data(), places_, map_.packed(), pool);
    map_.forget();
    map_.move_to(still_, 0.0, rates, pool);
}

void Wake::prepare(double first, double last, ThreadPool& pool) const {
    const double half = kRimEnd * size_.side;
    const double from = std::max(first - past_.place.centre.x, -half);
    const double to = std::min(last - past_.place.centre.x, half);
    if (from > to) return;
    map_.prepare(from, to, pool);
}

bool Wake::holds(double x, double y) const {
    const double half = kRimEnd * size_.side;
    return std::abs(x - past_.place.centre.x) < half && std::abs(y - past_.place.centre.y) < half;
}

std::array<int, 2> Wake::samples(const Domain& domain, std::size_t axis) const {
    const double half = kRimEnd * size_.side;
    const double centre = axis == 0 ? past_.place.centre.x : past_.place.centre.y;
    const auto number = [&](double place) {
        const double at = std::floor((place - domain.origin[axis]) / domain.step(axis));
        return static_cast<int>(std::clamp(at + 1.0, 0.0, double(domain.samples[axis])));
    };
    return {number(centre - half), number(centre + half)};
}

double Wake::share_at(double x, double y) const {
    return rim_factor(x - past_.place.centre.x, size_.side).value *
           rim_factor(y - past_.place.centre.y, size_.side).value;
}

double Wake::trail_share_at(WorldPoint label) const {
    const auto share = [&](double offset) {
        return ease(kRimEnd, kTrailEnds, std::abs(offset) / size_.side);
    };
    return share(label.x - past_.place.centre.x) * share(label.y - past_.place.centre.y);
}

LinearWaves<Jet> Wake::read(double x, double y) const {
    const double u = x - past_.place.centre.x;
    const double v = y - past_.place.centre.y;
    return within_rim(map_.read<Jet>(u, v), rim_factor(u, size_.side), rim_factor(v, size_.side));
}

std::vector<double> Wake::Rows::columns(const Wake& wake, const Domain& domain) {
    const auto [begin, end] = wake.samples(domain, 0);
    std::vector<double> x;
    for (int i = begin; i < end; ++i)
        x.push_back(domain.place(i, 0)[0] - wake.past_.place.centre.x);
    return x;
}

Wake::Rows::Rows(const Wake& wake, const Domain& domain)
    : Rows(wake, domain, columns(wake, domain)) {}

Wake::Rows::Rows(const Wake& wake, const Domain& domain, std::span<const double> x)
    : wake_(wake),
      domain_(domain),
      begin_(static_cast<std::size_t>(wake.samples(domain, 0)[0])),
      lines_(wake.map_, x) {
    for (const double place : x) rims_.push_back(rim_factor(place, wake.size_.side));
}

void Wake::Rows::read(int j, std::size_t first, std::span<LinearWaves<Jet>> waves) const {
    const double y = domain_.place(0, j)[1] - wake_.past_.place.centre.y;
    const double side = wake_.size_.side;
    const std::size_t end = std::abs(y) < kRimEnd * side ? begin_ + rims_.size() : begin_;
    const std::size_t from = std::clamp(begin_, first, first + waves.size());
    const std::size_t to = std::clamp(end, from, first + waves.size());
    std::ranges::fill(waves.first(from - first), LinearWaves<Jet>{});
    std::ranges::fill(waves.subspan(to - first), LinearWaves<Jet>{});
    const RimFactor across = rim_factor(y, side);
    const auto found = waves.subspan(from - first, to - from);
    lines_.read(y, from - begin_, found);
    for (std::size_t i = 0; i < found.size(); ++i) {
        const RimFactor along = rims_[from - begin_ + i];
        if (along.value < 1.0 || across.value < 1.0) {
            found[i] = within_rim(found[i], along, across);
        }
    }
}

Modes Wake::modes() const {
    Modes modes = still_;
    const float* const re = amplitudes_.data();
    lattice_.set_amplitudes(re, re + lattice_.count(), modes);
    return modes;
}

void Wake::prepare_sums(const Water& water) {
    if (!sum_) sum_.emplace(modes(), water);
}

LinearWaves<Jet> Wake::read_exactly(double x, double y) const {
    const double u = x - past_.place.centre.x;
    const double v = y - past_.place.centre.y;
    return within_rim(waves_of<Jet>(sum_->at_label(u, v)), rim_factor(u, size_.side),
                      rim_factor(v, size_.side));
}

std::uint64_t Wake::bytes(int resolution) {
    return WakeLattice::bytes(resolution) + WakeTurns::bytes(resolution) +
           SurfaceQuery::map_bytes(resolution, {.refine = 1});
}

}  // namespace ocean
