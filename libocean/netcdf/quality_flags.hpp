// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Flags of quality in NetCDF: which of a variable's values are good, doubtful or bad.
#pragma once

#include <vector>

#include "netcdf_content.hpp"

namespace ocean::netcdf {

enum class Quality { good, doubtful, bad };

/// The meaning of a variable's flags: of its flag_values and flag_meanings, otherwise of the
/// oceanographic scale, where 4 is bad and 9 missing, 3 doubtful.
class QualityFlags {
  public:
    explicit QualityFlags(const Variable& flags);
    Quality quality(double flag) const;

  private:
    std::vector<std::pair<double, Quality>> known_;
};

}  // namespace ocean::netcdf
