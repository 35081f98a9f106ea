// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Quality flags in NetCDF: they mark values of a variable as good, doubtful or bad.
#pragma once

#include <vector>

#include "netcdf_content.hpp"

namespace ocean::netcdf {

enum class Quality { good, doubtful, bad };

/// The meaning of a variable's flags by its flag_values and flag_meanings. Without them by the
/// oceanographic scale: 3 is doubtful, 4 bad, 9 missing.
class QualityFlags {
  public:
    explicit QualityFlags(const Variable& flags);
    Quality quality(double flag) const;

  private:
    std::vector<std::pair<double, Quality>> known_;
};

}  // namespace ocean::netcdf
