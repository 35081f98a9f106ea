// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The backends `gl` and `thesis`: maps by compute shaders of OpenGL 4.3.
#pragma once

#include "ocean/backend.hpp"

namespace ocean::gl {

/// In the context that is current when it is first called, and from then on; where there is none,
/// in a headless one of its own. In a host's context it leaves other bindings behind: program,
/// storage buffers 0 to 9, image units 0 to 6, texture of unit 0, buffers for packing pixels.
/// Throws Error no_gpu where it cannot run or the context was lost: then it has given up all that
/// it had, and the next call takes the context that is current then, or a new one. Its fitness is
/// that of a headless context: fast is what no processor plays.
extern const Backend kBackend;

/// The same maps by the scheme of [Fluegge 2017], a dispatch for each stage of each field's
/// transform: a reference to read and to compare with, and 10 times slower.
extern const Backend kThesisBackend;

}  // namespace ocean::gl
