// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Directions of spectrum formats: see directional_record.hpp.
#include "ocean/internal/directional_record.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ocean/internal/grid.hpp"
#include "ocean/seafile.hpp"
#include "spectrum_format.hpp"

namespace ocean {
namespace {

/// Bins closer than this count as one: 0 and 360, or radians printed with three digits.
constexpr double kSameDirection = 0.01;
/// A gap counts as the outside of a sector if it is wider than this and than a multiple of the
/// widest bin: gaps between uneven bins of a full circle are narrower.
constexpr double kSectorGap = 60.0;
constexpr double kSectorBins = 3.0;

double wrapped(double degrees) {
    const double turn = degrees - 360.0 * std::floor(degrees / 360.0);
    return turn >= 360.0 ? 0.0 : turn;  // -1e-20 rounds up to 360
}

/// Returns the step from direction j to the next one, around the circle.
double step_after(const std::vector<double>& direction, std::size_t j) {
    const bool last = j + 1 == direction.size();
    return last ? direction.front() + 360.0 - direction.back() : direction[j + 1] - direction[j];
}

}  // namespace

double travel_direction(double degrees, DirectionConvention convention) {
    switch (convention) {
        case DirectionConvention::from_nautical:
            return wrapped(270.0 - degrees);
        case DirectionConvention::to_nautical:
            return wrapped(90.0 - degrees);
        case DirectionConvention::to_cartesian:
            break;
    }
    return wrapped(degrees);
}

double coming_from(double travelling_to) {
    return wrapped(270.0 - travelling_to);
}

std::string DirectionAxis::fault(std::span<const double> degrees) {
    if (degrees.size() < 3) return "a directional spectrum needs at least 3 directions";
    if (degrees.size() > kMaxDirections) return "a spectrum has at most 720 directions";
    std::vector<double> sorted;
    for (const double d : degrees) {
        if (!(std::abs(d) <= 1080.0)) return "a direction is not a number of degrees";
        sorted.push_back(wrapped(d));
    }
    std::sort(sorted.begin(), sorted.end());
    std::size_t doubles = 0;
    for (std::size_t j = 0; j < sorted.size(); ++j) {
        doubles += step_after(sorted, j) < kSameDirection ? 1 : 0;
    }
    // Only the bin that closes the circle may appear twice.
    const auto [least, most] = std::minmax_element(degrees.begin(), degrees.end());
    const bool closed = std::abs(*most - *least - 360.0) < kSameDirection;
    if (doubles > (closed ? 1u : 0u)) return "a direction appears twice";
    if (degrees.size() - doubles < 3) return "a directional spectrum needs at least 3 directions";
    return "";
}

DirectionAxis::DirectionAxis(std::span<const double> degrees, DirectionConvention convention)
    : bins_(degrees.size()) {
    std::vector<double> travel;
    for (const double d : degrees) travel.push_back(travel_direction(d, convention));
    std::vector<std::size_t> order(bins_);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return travel[a] < travel[b]; });
    for (const std::size_t bin : order) {
        const bool again =
            !direction_.empty() && (travel[bin] - direction_.back() < kSameDirection ||
                                    direction_.front() + 360.0 - travel[bin] < kSameDirection);
        if (again) continue;  // the bin that closes the circle
        direction_.push_back(travel[bin]);
        source_.push_back(bin);
    }
    close_sector();
    for (std::size_t j = 0; j < direction_.size(); ++j) {
        const std::size_t before = j == 0 ? direction_.size() - 1 : j - 1;
        weight_.push_back(0.5 * (step_after(direction_, before) + step_after(direction_, j)));
    }
}

void DirectionAxis::close_sector() {
    std::size_t edge = 0;  // the direction before the widest gap
    double widest = 0.0;
    double second = 0.0;
    for (std::size_t j = 0; j < direction_.size(); ++j) {
        const double step = step_after(direction_, j);
        if (step > widest) {
            second = widest;
            widest = step;
            edge = j;
        } else {
            second = std::max(second, step);
        }
    }
    if (widest <= kSectorGap || widest <= kSectorBins * second) return;
    const std::size_t last = edge;
    const std::size_t first = (edge + 1) % direction_.size();
    const std::size_t before = last == 0 ? direction_.size() - 1 : last - 1;
    for (const double zero : {direction_[last] + step_after(direction_, before),
                              direction_[first] - step_after(direction_, first)}) {
        const double at = wrapped(zero);
        const auto place = std::lower_bound(direction_.begin(), direction_.end(), at);
        source_.insert(source_.begin() + (place - direction_.begin()), bins_);
        direction_.insert(place, at);
    }
}

void DirectionAxis::fill(SpectrumRecord& record, std::span<const double> values,
                         double to_per_degree) const {
    const std::size_t width = direction_.size();
    record.direction = direction_;
    record.directional_density.assign(record.frequency.size() * width, 0.0);
    record.density.assign(record.frequency.size(), 0.0);
    for (std::size_t i = 0; i < record.frequency.size(); ++i) {
        for (std::size_t j = 0; j < width; ++j) {
            if (source_[j] == bins_) continue;
            const double value = values[i * bins_ + source_[j]] * to_per_degree;
            if (std::isnan(value)) continue;
            record.directional_density[i * width + j] = value;
            record.density[i] += value * weight_[j];
        }
    }
}

void append_mean_and_spread(SpectrumRecord& record, double mean, double spread) {
    const double sigma = spread * kDegree;
    // A spread beyond 81 degrees is impossible for a distribution around a mean.
    const double r1 = std::clamp(1.0 - 0.5 * sigma * sigma, 0.0, 1.0);
    const bool known = !std::isnan(mean) && !std::isnan(spread);
    record.a1.push_back(known ? r1 * std::cos(mean * kDegree) : kMissing);
    record.b1.push_back(known ? r1 * std::sin(mean * kDegree) : kMissing);
    record.a2.push_back(kMissing);
    record.b2.push_back(kMissing);
}

void append_mean_and_principal(SpectrumRecord& record, double mean, double principal, double r1,
                               double r2) {
    const double theta1 = mean * kDegree;
    const double theta2 = principal * kDegree;
    append_moments(record, {r1 * std::cos(theta1), r1 * std::sin(theta1),
                            r2 * std::cos(2.0 * theta2), r2 * std::sin(2.0 * theta2)});
}

void append_moments(SpectrumRecord& record, const std::array<double, 4>& a1_b1_a2_b2) {
    const auto& [a1, b1, a2, b2] = a1_b1_a2_b2;
    const bool whole = !std::isnan(a1 + b1 + a2 + b2);
    record.a1.push_back(whole ? a1 : kMissing);
    record.b1.push_back(whole ? b1 : kMissing);
    record.a2.push_back(whole ? a2 : kMissing);
    record.b2.push_back(whole ? b2 : kMissing);
}

void drop_unknown_moments(SpectrumRecord& record) {
    const auto missing = [](double a) { return std::isnan(a); };
    if (!std::all_of(record.a1.begin(), record.a1.end(), missing)) return;
    for (auto* moment : {&record.a1, &record.b1, &record.a2, &record.b2}) moment->clear();
}

}  // namespace ocean
