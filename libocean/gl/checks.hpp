// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Checks for faults that OpenGL reports only on request.
#pragma once

namespace ocean::gl {

struct ContextInfo;

/// Throws Error no_gpu if anything failed since the last call, or the context was lost; and
/// out_of_memory if the GPU has none left. `doing`: "uploading the modes".
void require_no_error(const char* doing);

/// Throws Error no_gpu if the current context was lost, which not every driver reports as an error.
/// To be called when a frame's results have arrived; takes some microseconds.
void require_not_reset(const ContextInfo& context, const char* doing);

}  // namespace ocean::gl
