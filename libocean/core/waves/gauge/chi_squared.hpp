// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The chi-squared distribution: how estimates of a variance scatter.
#pragma once

namespace ocean {

/// Returns the value below which the share `probability`, 0 .. 1 exclusive, of a chi-squared
/// variable of `degrees_of_freedom` >= 1 lies, to 1e-10 relative.
double chi_squared_quantile(double probability, double degrees_of_freedom);

}  // namespace ocean
