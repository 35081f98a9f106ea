// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A bridge joined without a window.
#pragma once

#include <functional>

#include "console.hpp"
#include "live_sea.hpp"
#include "ocean/bridge/line_client.hpp"

namespace ocean::app {

/// Joins, applies what has been moved there, and calls `changed` once; then, for so many seconds,
/// whenever the sea has been moved again, with the milliseconds since that was heard. Values hold
/// at once, nothing glides. Throws Error output where no bridge is to be had.
void run_with_bridge(const bridge::LineClientOptions& options, double seconds, LiveSea& sea,
                     Console& console, const std::function<void(double milliseconds)>& changed);

}  // namespace ocean::app
