// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Samples of the displayed surface; see query.hpp. Newton's method on the spline map solves a point
// that displays one label; near a fold it starts from every label that the index of folds lists.
// Only the strips near the requested points are made.
#include "ocean/query.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <utility>

#include "ocean/internal/surface_query.hpp"
#include "ocean/internal/wave_sum.hpp"
#include "ocean/thread_pool.hpp"
#include "wave/wave.hpp"
#include "waves/query/bound_splines.hpp"
#include "waves/query/inversion.hpp"
#include "waves/query/query_bounds.hpp"
#include "waves/query/query_folds.hpp"
#include "waves/query/query_points.hpp"
#include "waves/query/spline_map.hpp"
#include "waves/query/spline_strips.hpp"
#include "waves/query/top_sheet.hpp"

namespace ocean {
namespace {

// The fourth quantity of each is not read.
constexpr std::array<Quantity, 4> kPosition = {Channel::dx, Channel::dy, Channel::height,
                                               Channel::height};
constexpr std::array<Quantity, 4> kVelocity = {Channel::vx, Channel::vy, Channel::vz, Channel::vz};

/// Prefetches a sample that is written soon: points follow the map, and samples lie anywhere.
void prefetch_for_writing(QuerySample& sample) {
    const char* const bytes = reinterpret_cast<const char*>(&sample);
    __builtin_prefetch(bytes, 1);
    __builtin_prefetch(bytes + sizeof(sample) - 1, 1);
}

/// Sets the normal on the side seen from above: on the upper sheet of a fold the label's own normal
/// points down.
void set_normal(QuerySample& sample, double choppiness, const DisplacementSample& displacement,
                double slope_x, double slope_y) {
    const auto n = wave::double_precision::surface_normal(
        choppiness, displacement.gradient_xx, displacement.gradient_yy, displacement.gradient_xy,
        slope_x, slope_y);
    const double up = n.z < 0.0 ? -1.0 : 1.0;
    const double normal[3] = {up * n.x, up * n.y, up * n.z};
    const bool cusp = !std::isfinite(normal[0] + normal[1] + normal[2]);
    for (int i = 0; i < 3; ++i) sample.normal[i] = cusp ? (i == 2 ? 1.0 : 0.0) : normal[i];
}

}  // namespace

struct SurfaceQuery::Impl {
    Impl(const Modes& modes, const QueryOptions& asked, ThreadPool& pool)
        : options(asked),
          shown(shown_resolution(modes.lattice.resolution, asked)),
          fine(spline_resolution(modes.lattice.resolution, asked)),
          strips(modes, fine, spline_factor(modes, shown, fine), pool),
          position({fine, modes.lattice.period}, pool),
          velocity(position.lattice(), pool),
          folds(modes.lattice.period, std::min(2 * shown, fine), pool),
          bounds(query_bounds(modes, shown, fine, asked.exact, pool)),
          revision(modes.revision) {}

    /// Switches to other modes of the same lattice. Returns false if their lattice differs; the
    /// object is then unusable.
    bool use(const Modes& modes, ThreadPool& pool);
    void begin(const Modes& modes, const SurfaceSettings& settings, const Water& water,
               double new_time, ThreadPool& pool, FoamMap new_foam);

    /// Labels to start from, kept between the points of one thread.
    using Starts = std::vector<WorldPoint>;

    double period() const { return position.lattice().period; }
    double spacing() const { return period() / shown; }
    double reach() const { return choppiness * bounds.farthest; }
    InversionTarget target(WorldPoint place) const {
        return InversionTarget::at(place.x, place.y, choppiness, reach());
    }
    /// Returns the block of the folds' index that each point lies in.
    std::vector<int> blocks_of(std::span<const WorldPoint> points) const;
    /// Makes the strips and the blocks that samples of points in these blocks read.
    void prepare(std::span<const int> blocks, ThreadPool* pool) const;
    struct Numbered {
        WorldPoint point;
        std::size_t number;
    };
    std::vector<Numbered> in_order(std::span<const WorldPoint> points,
                                   std::span<const int> blocks) const;
    int block_of(WorldPoint point) const {
        const WorldPoint place = wrapped_place(point);
        return folds.block_of(place.x, place.y);
    }
    WorldPoint wrapped_place(WorldPoint point) const {
        return {wrapped(point.x, period()), wrapped(point.y, period())};
    }
    /// Makes the strip of one position, for a search that leaves the prepared strips.
    void need(double x) const {
        for (const int column : position.columns(x)) strips.need(strips.strip_of(column));
    }
    Solution solve(const InversionTarget& target, WorldPoint start) const;
    Solution top_solution(WorldPoint place, WorldPoint guess, Starts& starts,
                          QuerySample& sample) const;
    /// Returns the sample of a point. `place` is the point within the period, `guess` a label near
    /// the label of `place`.
    QuerySample sample(WorldPoint point, WorldPoint place, WorldPoint guess, Starts& starts) const;
    void sample_in_order(std::span<const Numbered> points, std::span<QuerySample> samples) const;
    void fill(QuerySample& sample, const Solution& solution) const;
    void fill_exactly(QuerySample& sample, WorldPoint place, ShownLabel label) const;
    double foam_at(double x, double y) const;

    QueryOptions options;
    int shown;  // samples of the map whose waves count
    int fine;   // samples of the splines
    SplineStrips strips;
    SplineMap position;  // dx, dy, height at choppiness 1
    SplineMap velocity;
    mutable FoldIndex folds;
    mutable std::mutex preparing;
    QueryBounds bounds;
    Revision revision;  // of the modes
    double choppiness = 0.0;
    double time = 0.0;
    std::optional<WaveSum> exact;
    BoundSplines bound;
    FoamMap foam;
};

bool SurfaceQuery::Impl::use(const Modes& modes, ThreadPool& pool) {
    if (revision == modes.revision) return true;
    if (position.lattice().period != modes.lattice.period ||
        shown != shown_resolution(modes.lattice.resolution, options)) {
        return false;
    }
    revision = {};  // invalid until the change is complete
    if (!strips.repack(modes, spline_factor(modes, shown, fine), pool)) return false;
    bounds = query_bounds(modes, shown, fine, options.exact, pool);
    revision = modes.revision;
    exact.reset();
    return true;
}

void SurfaceQuery::Impl::begin(const Modes& modes, const SurfaceSettings& settings,
                               const Water& water, double new_time, ThreadPool& pool,
                               FoamMap new_foam) {
    choppiness = settings.choppiness;
    time = new_time;
    foam = options.foam ? std::move(new_foam) : FoamMap{};
    const MapOutput outputs[] = {position.output(kPosition), velocity.output(kVelocity)};
    strips.begin(modes, time, outputs, pool);
    folds.begin(choppiness, reach());
    bound.begin(modes, choppiness, water, time, shown, options.exact, pool);
    if (!options.exact) return;
    if (!exact) exact.emplace(modes, water, shown);
    exact->set_time(time);
}

std::vector<int> SurfaceQuery::Impl::blocks_of(std::span<const WorldPoint> points) const {
    std::vector<int> blocks(points.size());
    std::ranges::transform(points, blocks.begin(), [this](WorldPoint p) { return block_of(p); });
    return blocks;
}

void SurfaceQuery::Impl::prepare(std::span<const int> blocks, ThreadPool* pool) const {
    TileSet places(folds.blocks());
    for (const int block : blocks) {
        if (!folds.has(block)) places.add(block);
    }
    if (places.list().empty()) return;
    const std::lock_guard lock(preparing);
    TileSet needed(strips.count());
    for (const int place : places.list()) {
        folds.each_column(position, place, strips.width(),
                          [&](int column) { needed.add(strips.strip_of(column)); });
    }
    strips.make(needed.list(), pool);
    folds.make(position, places.list(), pool);
}

/// Returns the points ordered by their blocks, so that neighbours follow each other: reads of
/// random points would wait for memory.
std::vector<SurfaceQuery::Impl::Numbered> SurfaceQuery::Impl::in_order(
    std::span<const WorldPoint> points, std::span<const int> blocks) const {
    std::vector<std::size_t> next(static_cast<std::size_t>(folds.blocks()) + 1, 0);
    for (const int block : blocks) ++next[static_cast<std::size_t>(block) + 1];
    for (std::size_t block = 1; block < next.size(); ++block) next[block] += next[block - 1];
    std::vector<Numbered> numbered(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        numbered[next[static_cast<std::size_t>(blocks[i])]++] = {points[i], i};
    }
    return numbered;
}

Solution SurfaceQuery::Impl::solve(const InversionTarget& target, WorldPoint start) const {
    SplineJet jet;
    const auto look = [&](double x, double y) {
        need(x);
        jet = position.jet(x, y);
        return displacement_of(jet);
    };
    const ShownLabel label = find_label(look, target, start.x, start.y);
    // find_label returns the label of its last look.
    const BoundSample second = bound.at(label.x, label.y);
    jet.value[2] += static_cast<float>(second.height);
    jet.by_x[2] += static_cast<float>(second.slope_x);
    jet.by_y[2] += static_cast<float>(second.slope_y);
    return {label, jet};
}

/// Returns the top solution and sets the flags of the sample.
Solution SurfaceQuery::Impl::top_solution(WorldPoint place, WorldPoint guess, Starts& starts,
                                          QuerySample& sample) const {
    TopSheet sheet;
    const bool listed = folds.labels_near(place.x, place.y, starts);
    const double search = std::max(10.0 * spacing(), 2.0 * reach());
    if (starts.empty()) starts.push_back(guess);  // no fold there
    for (const WorldPoint& start : starts) sheet.add(solve(target(place), start));
    // All of these may end in a fold that just misses this place: then searches around the first of
    // them, as far as a label can be.
    constexpr int kDirections = 8;
    for (double distance = spacing(); !sheet.converged() && distance < search; distance *= 2.0) {
        for (int i = 0; i < kDirections; ++i) {
            const double angle = kTwoPi * i / kDirections;
            sheet.add(solve(target(place), {starts.front().x + distance * std::cos(angle),
                                            starts.front().y + distance * std::sin(angle)}));
        }
    }
    sample.folded = sheet.folded();
    sample.undecided = !listed || !sheet.converged();
    return sheet.top();
}

QuerySample SurfaceQuery::Impl::sample(WorldPoint point, WorldPoint place, WorldPoint guess,
                                       Starts& starts) const {
    QuerySample sample{};
    const Solution solution = top_solution(place, guess, starts, sample);
    if (exact) {
        fill_exactly(sample, place, solution.label);
    } else {
        fill(sample, solution);
    }
    sample.foam = foam_at(sample.label[0], sample.label[1]);
    sample.label[0] += point.x - place.x;
    sample.label[1] += point.y - place.y;
    return sample;
}

/// Samples in stages, some points apart: the maps exceed the caches, and each stage reads what the
/// previous stage has prefetched.
void SurfaceQuery::Impl::sample_in_order(std::span<const Numbered> points,
                                         std::span<QuerySample> samples) const {
    static_assert(FoldIndex::kLooks == 2);
    constexpr std::size_t kApart = 4;
    struct Search {
        WorldPoint place;
        WorldPoint label;
    };
    std::array<Search, 4 * kApart> searches;
    Starts starts;
    for (std::size_t now = 0; now < points.size() + 3 * kApart; ++now) {
        const auto stage = [&](std::size_t number, const auto& body) {
            const std::size_t i = now - number * kApart;  // wraps while it has not begun
            if (i < points.size()) body(points[i], searches[i % searches.size()]);
        };
        stage(0, [&](const Numbered& point, Search& search) {
            search.place = search.label = wrapped_place(point.point);
            folds.prefetch(search.label);
        });
        stage(1, [&](const Numbered&, Search& search) {
            search.label = folds.look(search.place, search.label);
            folds.prefetch(search.label);
        });
        stage(2, [&](const Numbered& point, Search& search) {
            search.label = folds.look(search.place, search.label);
            position.prefetch(search.label.x, search.label.y);
            velocity.prefetch(search.label.x, search.label.y);
            prefetch_for_writing(samples[point.number]);
        });
        stage(3, [&](const Numbered& point, Search& search) {
            samples[point.number] = sample(point.point, search.place, search.label, starts);
        });
    }
}

void SurfaceQuery::Impl::fill(QuerySample& sample, const Solution& solution) const {
    const ShownLabel& label = solution.label;
    sample.height = solution.height();
    set_normal(sample, choppiness, displacement_of(solution.jet),
               static_cast<double>(solution.jet.by_x[2]),
               static_cast<double>(solution.jet.by_y[2]));
    const SplineValue rate = velocity.value(label.x, label.y);
    for (std::size_t i = 0; i < 3; ++i) {
        sample.velocity[i] = (i < 2 ? choppiness : 1.0) * static_cast<double>(rate.value[i]);
    }
    sample.velocity[2] += bound.at(label.x, label.y).height_rate;
    sample.label[0] = label.x;
    sample.label[1] = label.y;
}

/// Fills a sample with the sum over all modes, beginning at the label that the map displays: a
/// search with this sum would be too expensive.
void SurfaceQuery::Impl::fill_exactly(QuerySample& sample, WorldPoint place,
                                      ShownLabel label) const {
    constexpr double kDoubleTolerance = 1e-12;  // relative to the reach
    InversionTarget exactly = target(place);
    exactly.tolerance = kDoubleTolerance * exactly.reach;
    const auto look = [this](double x, double y) { return exact->displacement_at(x, y); };
    const ShownLabel polished = find_label(look, exactly, label.x, label.y);
    if (polished.converged) label = polished;
    const LinearSample linear = exact->at_label(label.x, label.y);
    const BoundSample second = bound.exactly_at(label.x, label.y);
    sample.height = linear.height + second.height;
    set_normal(sample, choppiness,
               {linear.displacement_x, linear.displacement_y, linear.gradient_xx,
                linear.gradient_yy, linear.gradient_xy},
               linear.slope_x + second.slope_x, linear.slope_y + second.slope_y);
    sample.velocity[0] = -choppiness * linear.displacement_x_rate;
    sample.velocity[1] = -choppiness * linear.displacement_y_rate;
    sample.velocity[2] = linear.height_rate + second.height_rate;
    sample.label[0] = label.x;
    sample.label[1] = label.y;
}

double SurfaceQuery::Impl::foam_at(double x, double y) const {
    if (foam.resolution == 0) return 0.0;
    const int mask = foam.resolution - 1;
    const double u = wrapped(x, period()) / period() * foam.resolution;
    const double v = wrapped(y, period()) / period() * foam.resolution;
    const int i = static_cast<int>(u);
    const int j = static_cast<int>(v);
    const auto at = [&](int column, int row) {
        return static_cast<double>(foam.values[static_cast<std::size_t>(row & mask) *
                                                   static_cast<std::size_t>(foam.resolution) +
                                               static_cast<std::size_t>(column & mask)]);
    };
    const auto between = [&](int row) {
        return at(i, row) + (u - i) * (at(i + 1, row) - at(i, row));
    };
    return between(j) + (v - j) * (between(j + 1) - between(j));
}

bool may_fold(const Modes& modes, double choppiness) {
    // All modes count, because they fit on the finest map.
    const GradientCovariance c = modes.gradient_covariance(kMaxResolution);
    return 6.0 * choppiness * std::sqrt(c.aa + c.bb + 2.0 * c.cc) >= 1.0;
}

SurfaceQuery::SurfaceQuery(const Modes& modes, const SurfaceSettings& settings, const Water& water,
                           double time, const QueryOptions& options, ThreadPool& pool,
                           FoamMap foam) {
    require_time(time);
    impl_ = std::make_unique<Impl>(modes, options, pool);
    impl_->begin(modes, settings, water, time, pool, std::move(foam));
}

void SurfaceQuery::move_to(const Modes& modes, const SurfaceSettings& settings, const Water& water,
                           double time, ThreadPool& pool, FoamMap foam) {
    require_time(time);
    if (!impl_->use(modes, pool)) {
        impl_ = std::make_unique<Impl>(modes, QueryOptions(impl_->options), pool);
    }
    impl_->begin(modes, settings, water, time, pool, std::move(foam));
}

SurfaceQuery::~SurfaceQuery() = default;
SurfaceQuery::SurfaceQuery(SurfaceQuery&&) noexcept = default;
SurfaceQuery& SurfaceQuery::operator=(SurfaceQuery&&) noexcept = default;

void SurfaceQuery::sample(std::span<const WorldPoint> points, std::span<QuerySample> samples,
                          ThreadPool& pool) const {
    require_finite(points);
    const std::vector<int> blocks = impl_->blocks_of(points);
    impl_->prepare(blocks, &pool);
    const auto numbered = impl_->in_order(points, blocks);
    for_each_point(
        pool, points.size(), impl_->options.exact, [&](std::size_t first, std::size_t last) {
            impl_->sample_in_order(std::span(numbered).subspan(first, last - first), samples);
        });
}

QuerySample SurfaceQuery::sample(WorldPoint point) const {
    require_finite({&point, 1});
    const int block = impl_->block_of(point);
    impl_->prepare({&block, 1}, nullptr);
    const WorldPoint place = impl_->wrapped_place(point);
    Impl::Starts starts;
    return impl_->sample(point, place, impl_->folds.guess(place), starts);
}

double SurfaceQuery::time() const {
    return impl_->time;
}
double SurfaceQuery::spacing() const {
    return impl_->spacing();
}
double SurfaceQuery::reach() const {
    return impl_->reach();
}
double SurfaceQuery::height_error() const {
    return impl_->bounds.error;
}

WorldPoint SurfaceQuery::shown(WorldPoint label) const {
    require_finite({&label, 1});
    const double x = wrapped(label.x, impl_->period());
    impl_->need(x);
    const SplineValue offset = impl_->position.value(x, wrapped(label.y, impl_->period()));
    return {label.x + impl_->choppiness * static_cast<double>(offset.value[0]),
            label.y + impl_->choppiness * static_cast<double>(offset.value[1])};
}

std::uint64_t SurfaceQuery::bytes(const Modes& modes, const QueryOptions& options) {
    const std::uint64_t sums = options.exact ? WaveSum::bytes(modes, 1) : 0;
    const std::uint64_t bound =
        modes.binding_limit > 0.0 ? BoundSplines::bytes(modes.lattice.resolution) : 0;
    return map_bytes(modes.lattice.resolution, options) + sums + bound;
}

std::uint64_t SurfaceQuery::map_bytes(int grid_resolution, const QueryOptions& options) {
    return spline_bytes(grid_resolution, options, 2, 6) +
           FoldIndex::bytes(fold_resolution(grid_resolution, options));
}

}  // namespace ocean
