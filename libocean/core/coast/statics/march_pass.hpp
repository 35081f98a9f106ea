// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// One march of energy over a bed, from column to column.
#pragma once

#include <functional>
#include <vector>

#include "march_bed.hpp"
#include "march_waves.hpp"

namespace ocean {

class ThreadPool;

struct MarchLoss {
    bool breaking = false;
    /// This march's share of the variance of all marches, [i][j]. Empty: 1.
    std::vector<float> own_share{};
    double open_variance = 0.0;  // of all marches in the open sea [m^2]
};

/// The outcome, [i][j]: energies relative to the open sea.
struct MarchField {
    std::vector<std::vector<float>> energy;  // one for each wave of the group
    std::vector<float> unshoaled;            // of all waves together, at the speed of the open sea
};

/// Marches a group of waves. `column_done` is called on the calling thread after each column and
/// may throw.
MarchField march_group(const MarchGroup& group, const DirectionBins& bins, const MarchBed& bed,
                       const DepthTables& depths, const MarchLoss& loss, ThreadPool& pool,
                       const std::function<void()>& column_done);

}  // namespace ocean
