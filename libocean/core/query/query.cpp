// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Samples of the shown surface; see query.hpp. A place that shows one label is solved by Newton's
// method on the spline map; one near a fold starts from every label that the index of folds lists.
#include "ocean/query.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/wave.hpp"
#include "ocean/thread_pool.hpp"
#include "ocean/wave_sum.hpp"
#include "query/inversion.hpp"
#include "query/query_folds.hpp"
#include "query/query_points.hpp"
#include "query/spline_map.hpp"

namespace ocean {
namespace {

constexpr std::array kPosition = {Channel::dx, Channel::dy, Channel::height};
constexpr std::array kVelocity = {Channel::vx, Channel::vy, Channel::vz};

/// A label and the map there.
struct Solution {
    ShownLabel label;
    SplineJet jet;

    double height() const { return static_cast<double>(jet.value[2]); }
};

DisplacementSample displacement_of(const SplineJet& jet) {
    return {-static_cast<double>(jet.value[0]), -static_cast<double>(jet.value[1]),
            -static_cast<double>(jet.by_x[0]), -static_cast<double>(jet.by_y[1]),
            -0.5 * (static_cast<double>(jet.by_y[0]) + static_cast<double>(jet.by_x[1]))};
}

/// The normal of the side seen from above: on a fold's upper sheet the label's own points down.
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

/// Of the lattice of labels on which folds are looked for: two samples to each of the shown map.
int fold_resolution(int grid_resolution, const QueryOptions& options) {
    return std::min(2 * shown_resolution(grid_resolution, options),
                    spline_resolution(grid_resolution, options));
}

}  // namespace

struct SurfaceQuery::State {
    double choppiness;
    double time;
    double spacing;
    SplineMap position;  // dx, dy, height at choppiness 1
    SplineMap velocity;
    FoldIndex folds;
    std::optional<WaveSum> exact;
    FoamMap foam;

    /// Labels to start from, kept between the points of one thread.
    using Starts = std::vector<WorldPoint>;

    double period() const { return position.lattice().period; }
    InversionTarget target(WorldPoint place) const {
        return InversionTarget::at(place.x, place.y, choppiness, folds.reach());
    }
    Solution solve(const InversionTarget& target, WorldPoint start) const;
    Solution top_solution(WorldPoint place, Starts& starts, bool& folded) const;
    QuerySample sample(WorldPoint point, Starts& starts) const;
    void fill(QuerySample& sample, const Solution& solution) const;
    void fill_exactly(QuerySample& sample, WorldPoint place, ShownLabel label) const;
    double foam_at(double x, double y) const;
};

Solution SurfaceQuery::State::solve(const InversionTarget& target, WorldPoint start) const {
    SplineJet jet;
    const auto look = [&](double x, double y) {
        jet = position.jet(x, y);
        return displacement_of(jet);
    };
    const ShownLabel label = find_label(look, target, start.x, start.y);
    return {label, jet};  // find_label returns the label that it looked at last
}

/// Of the solutions that the starts lead to, the highest.
class TopSheet {
  public:
    void add(const Solution& solution) {
        folded_ = folded_ || (solution.label.converged && solution.label.jacobian <= 0.0);
        if (!top_ || rank(solution) > rank(*top_)) top_ = solution;
    }
    bool converged() const { return top_ && top_->label.converged; }
    bool folded() const { return folded_; }
    const Solution& top() const { return *top_; }

  private:
    static std::pair<bool, double> rank(const Solution& solution) {
        return {solution.label.converged, solution.height()};
    }
    std::optional<Solution> top_;
    bool folded_ = false;
};

Solution SurfaceQuery::State::top_solution(WorldPoint place, Starts& starts, bool& folded) const {
    TopSheet sheet;
    folds.labels_near(place.x, place.y, starts);  // none where nothing folds
    const double farthest = std::max(10.0 * spacing, 2.0 * folds.reach());
    if (starts.empty()) starts.push_back(place);
    for (const WorldPoint& start : starts) sheet.add(solve(target(place), start));
    // Where all of these end in a fold that just misses this place: around the first of them, as
    // far as a label can be.
    constexpr int kDirections = 8;
    for (double distance = spacing; !sheet.converged() && distance < farthest; distance *= 2.0) {
        for (int i = 0; i < kDirections; ++i) {
            const double angle = kTwoPi * i / kDirections;
            sheet.add(solve(target(place), {starts.front().x + distance * std::cos(angle),
                                            starts.front().y + distance * std::sin(angle)}));
        }
    }
    folded = sheet.folded();
    return sheet.top();
}

QuerySample SurfaceQuery::State::sample(WorldPoint point, Starts& starts) const {
    const WorldPoint place{wrapped(point.x, period()), wrapped(point.y, period())};
    QuerySample sample{};
    const Solution solution = top_solution(place, starts, sample.folded);
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

void SurfaceQuery::State::fill(QuerySample& sample, const Solution& solution) const {
    const ShownLabel& label = solution.label;
    sample.height = solution.height();
    set_normal(sample, choppiness, displacement_of(solution.jet),
               static_cast<double>(solution.jet.by_x[2]),
               static_cast<double>(solution.jet.by_y[2]));
    const SplineValue rate = velocity.value(label.x, label.y);
    for (std::size_t i = 0; i < 3; ++i) {
        sample.velocity[i] = (i < 2 ? choppiness : 1.0) * static_cast<double>(rate.value[i]);
    }
    sample.label[0] = label.x;
    sample.label[1] = label.y;
}

/// From the label that the map shows: the sum over all modes is too dear to search with.
void SurfaceQuery::State::fill_exactly(QuerySample& sample, WorldPoint place,
                                       ShownLabel label) const {
    constexpr double kDoubleTolerance = 1e-12;  // of the reach
    InversionTarget exactly = target(place);
    exactly.tolerance = kDoubleTolerance * exactly.reach;
    const auto look = [this](double x, double y) { return exact->displacement_at(x, y); };
    const ShownLabel polished = find_label(look, exactly, label.x, label.y);
    if (polished.converged) label = polished;
    const LinearSample linear = exact->at_label(label.x, label.y);
    sample.height = linear.height;
    set_normal(sample, choppiness,
               {linear.displacement_x, linear.displacement_y, linear.gradient_xx,
                linear.gradient_yy, linear.gradient_xy},
               linear.slope_x, linear.slope_y);
    sample.velocity[0] = -choppiness * linear.displacement_x_rate;
    sample.velocity[1] = -choppiness * linear.displacement_y_rate;
    sample.velocity[2] = linear.height_rate;
    sample.label[0] = label.x;
    sample.label[1] = label.y;
}

double SurfaceQuery::State::foam_at(double x, double y) const {
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

SurfaceQuery::SurfaceQuery(const Modes& modes, const SurfaceSettings& settings, const Water& water,
                           double time, const QueryOptions& options, ThreadPool& pool,
                           FoamMap foam) {
    require_finite_time(time);
    const int shown = shown_resolution(modes.lattice.resolution, options);
    const int fine = spline_resolution(modes.lattice.resolution, options);
    const Modes filtered = spline_modes(modes, shown, fine);
    SplineMap position = make_spline_map(filtered, time, kPosition, fine, pool);
    SplineMap velocity = make_spline_map(filtered, time, kVelocity, fine, pool);
    FoldIndex folds(position, settings.choppiness,
                    fold_resolution(modes.lattice.resolution, options), pool);
    std::optional<WaveSum> exact;
    if (options.exact) {
        exact.emplace(modes, water, shown);
        exact->set_time(time);
    }
    state_ = std::make_unique<const State>(
        State{settings.choppiness, time, modes.lattice.period / shown, std::move(position),
              std::move(velocity), std::move(folds), std::move(exact),
              options.foam ? std::move(foam) : FoamMap{}});
}

SurfaceQuery::~SurfaceQuery() = default;
SurfaceQuery::SurfaceQuery(SurfaceQuery&&) noexcept = default;
SurfaceQuery& SurfaceQuery::operator=(SurfaceQuery&&) noexcept = default;

void SurfaceQuery::sample(std::span<const WorldPoint> points, std::span<QuerySample> samples,
                          ThreadPool& pool) const {
    require_finite(points);
    for_each_point(pool, points.size(), [&](std::size_t first, std::size_t last) {
        State::Starts starts;
        for (std::size_t i = first; i < last; ++i) samples[i] = state_->sample(points[i], starts);
    });
}

QuerySample SurfaceQuery::sample(WorldPoint point) const {
    require_finite({&point, 1});
    State::Starts starts;
    return state_->sample(point, starts);
}

double SurfaceQuery::time() const {
    return state_->time;
}
double SurfaceQuery::spacing() const {
    return state_->spacing;
}
double SurfaceQuery::reach() const {
    return state_->folds.reach();
}

WorldPoint SurfaceQuery::shown(WorldPoint label) const {
    require_finite({&label, 1});
    const double period = state_->period();
    const SplineValue offset =
        state_->position.value(wrapped(label.x, period), wrapped(label.y, period));
    return {label.x + state_->choppiness * static_cast<double>(offset.value[0]),
            label.y + state_->choppiness * static_cast<double>(offset.value[1])};
}

std::uint64_t SurfaceQuery::bytes(const Modes& modes, const QueryOptions& options) {
    const std::uint64_t sums = options.exact ? WaveSum::bytes(modes, 1) : 0;
    return map_bytes(grid_of(modes), options) + sums;
}

std::uint64_t SurfaceQuery::map_bytes(const Grid& grid, const QueryOptions& options) {
    return modes_bytes(grid) + spline_bytes(grid.resolution, options, 2) +
           FoldIndex::bytes(fold_resolution(grid.resolution, options));
}

}  // namespace ocean
