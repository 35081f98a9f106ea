// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A connection to a bridge without a window.
#pragma once

#include <functional>

#include "console.hpp"
#include "live_sea.hpp"
#include "ocean/internal/bridge/line_client.hpp"

namespace ocean::app {

/// Joins the bridge, applies the values that its clients have set and calls `changed` once; then,
/// for so many seconds, after each further change of the sea, with the milliseconds since it
/// arrived. Values hold at once, nothing glides. Throws Error output if no bridge answers.
void run_with_bridge(const bridge::LineClientOptions& options, double seconds, LiveSea& sea,
                     Console& console, const std::function<void(double milliseconds)>& changed);

}  // namespace ocean::app
