// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace ocean {

/// Called on the calling thread with the share of the work that is done, 0 .. 1; may throw to stop
/// the work. Empty: no reports.
using ShoreProgress = std::function<void(double share)>;

}  // namespace ocean
