// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The steps of a number of the waves: so close that the amplitudes between two of them may be
// interpolated while the number glides.
#pragma once

#include <optional>

#include "ocean/parameter_table.hpp"

namespace ocean {

class PassageSteps {
  public:
    /// Returns the steps of a parameter; none if it is no number of the waves. The surface
    /// is interpolated to 1e-3 of its height, in winds below 5 m/s to 3e-3. Test:
    /// Passage.KeepsTheSurfaceToAThousandthAndInLightWindsToThree.
    static std::optional<PassageSteps> of(const ParameterInfo& info);

    /// A glide that passes a step sooner [s] would make two states for few frames or ticks of foam.
    static constexpr double kShortest = 0.1;

    /// Returns the distance of two values in steps; of directions the short way round.
    double between(double a, double b) const;

    struct Around {
        double low;
        double high;
    };
    /// Returns the steps around a value within min .. max.
    Around around(double value, double min, double max) const;

  private:
    enum class Kind { factors, sums, directions };
    PassageSteps(Kind kind, double step, double first = 0.0)
        : kind_(kind), step_(step), first_(first) {}

    double number_of(double value) const;
    double value_of(double number) const;

    Kind kind_;
    double step_;   // factor - 1, or difference
    double first_;  // below this value [of the parameter] factors are differences
};

}  // namespace ocean
