// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What a machine can draw in time.
#pragma once

#include "ocean/gl/context.hpp"
#include "ocean/preview/renderer.hpp"
#include "ocean/preview/sea_maps.hpp"
#include "ocean/sea.hpp"
#include "preview_options.hpp"

namespace ocean::app {

struct Workload {
    preview::SeaMapsOptions maps;
    preview::RendererOptions renderer;
    /// Of a window's pixels along a side, those that are drawn.
    double scale = 1.0;
};

/// Whether the sea can be computed in that context, and fast.
bool computes_well(const gl::ContextInfo& context);
Workload workload_for(const PreviewOptions& options, const Sea& sea, const gl::ContextInfo& context,
                      bool computes);

}  // namespace ocean::app
