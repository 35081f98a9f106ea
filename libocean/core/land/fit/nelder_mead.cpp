// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The simplex of Nelder and Mead, with its standard coefficients: see nelder_mead.hpp.
#include "nelder_mead.hpp"

#include <algorithm>
#include <utility>

namespace ocean {
namespace {

class Simplex {
  public:
    Simplex(const std::function<double(std::span<const double>)>& function,
            std::span<const double> start, std::span<const double> steps,
            std::span<const Bounds> bounds)
        : function_(function), bounds_(bounds) {
        corners_.push_back(evaluated({start.begin(), start.end()}));
        for (std::size_t i = 0; i < start.size(); ++i) {
            std::vector<double> place = corners_.front().place;
            const bool fits = place[i] + steps[i] <= bounds[i].highest;
            place[i] += fits ? steps[i] : -steps[i];
            corners_.push_back(evaluated(std::move(place)));
        }
        sort();
    }

    bool has_shrunk() const {
        constexpr double kFineEnough = 1e-6;
        for (std::size_t i = 0; i < bounds_.size(); ++i) {
            double low = corners_.front().place[i], high = low;
            for (const Minimum& corner : corners_) {
                low = std::min(low, corner.place[i]);
                high = std::max(high, corner.place[i]);
            }
            if (high - low > kFineEnough * (bounds_[i].highest - bounds_[i].lowest)) return false;
        }
        return true;
    }
    int calls() const { return calls_; }
    const Minimum& best() const { return corners_.front(); }

    /// Replaces the worst corner, or shrinks the simplex towards the best one.
    void step() {
        const Minimum reflected = along(2.0);
        if (reflected.value < best().value) {
            const Minimum expanded = along(3.0);
            corners_.back() = expanded.value < reflected.value ? expanded : reflected;
        } else if (reflected.value < corners_[corners_.size() - 2].value) {
            corners_.back() = reflected;
        } else {
            const Minimum contracted = along(reflected.value < corners_.back().value ? 1.5 : 0.5);
            if (contracted.value < std::min(reflected.value, corners_.back().value)) {
                corners_.back() = contracted;
            } else {
                shrink();
            }
        }
        sort();
    }

  private:
    Minimum evaluated(std::vector<double> place) {
        for (std::size_t i = 0; i < place.size(); ++i) {
            place[i] = std::clamp(place[i], bounds_[i].lowest, bounds_[i].highest);
        }
        ++calls_;
        const double value = function_(place);
        return {std::move(place), value};
    }
    /// Returns the point on the line from the worst corner (0) through the middle of the others
    /// (1).
    Minimum along(double part) {
        std::vector<double> place(bounds_.size());
        for (std::size_t i = 0; i < place.size(); ++i) {
            double middle = 0.0;
            for (std::size_t c = 0; c + 1 < corners_.size(); ++c) {
                middle += corners_[c].place[i] / static_cast<double>(corners_.size() - 1);
            }
            const double worst = corners_.back().place[i];
            place[i] = worst + part * (middle - worst);
        }
        return evaluated(std::move(place));
    }
    void shrink() {
        for (std::size_t c = 1; c < corners_.size(); ++c) {
            std::vector<double> place = corners_[c].place;
            for (std::size_t i = 0; i < place.size(); ++i) {
                place[i] = 0.5 * (place[i] + best().place[i]);
            }
            corners_[c] = evaluated(std::move(place));
        }
    }
    void sort() { std::ranges::stable_sort(corners_, {}, &Minimum::value); }

    const std::function<double(std::span<const double>)>& function_;
    std::span<const Bounds> bounds_;
    std::vector<Minimum> corners_;
    int calls_ = 0;
};

}  // namespace

Minimum minimize(const std::function<double(std::span<const double>)>& function,
                 std::span<const double> start, std::span<const double> steps,
                 std::span<const Bounds> bounds) {
    constexpr int kMaxCalls = 2000;
    Simplex simplex(function, start, steps, bounds);
    while (simplex.calls() < kMaxCalls && !simplex.has_shrunk()) simplex.step();
    return simplex.best();
}

}  // namespace ocean
