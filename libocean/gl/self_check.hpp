// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A check that a driver computes as precisely as the shaders need.
#pragma once

#include <string>

namespace ocean::gl {

/// Returns the lines of #define that self_check.comp needs: the coefficients of pairs of fields.
std::string self_check_defines();
/// Compares phase and noise of the current context's shaders with the library's own at some modes
/// and times, up to 10^6 s, and the coefficients of pairs of fields. Throws Error no_gpu if they
/// differ by more than rounding.
void check_shader_arithmetic();

}  // namespace ocean::gl
