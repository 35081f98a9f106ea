// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What OpenGL reports only when it is asked.
#pragma once

namespace ocean::gl {

struct ContextInfo;

/// Throws Error no_gpu if anything failed since the last call, or the context was lost; and
/// out_of_memory if the GPU has none left. `doing`: "uploading the modes".
void require_no_error(const char* doing);

/// Throws Error no_gpu if the current context was lost, of which not every driver makes an error.
/// To be called when a frame's results are there; it may take some microseconds.
void require_not_reset(const ContextInfo& context, const char* doing);

}  // namespace ocean::gl
