// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What OpenGL reports only when it is asked.
#pragma once

namespace ocean::gl {

/// Throws Error no_gpu if anything failed since the last call, or the context was lost; and
/// out_of_memory if the GPU has none left. `doing`: "uploading the modes".
void require_no_error(const char* doing);

}  // namespace ocean::gl
