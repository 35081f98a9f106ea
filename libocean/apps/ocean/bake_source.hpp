// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// --from: a baked file says how it was made.
#pragma once

#include "bake_plan.hpp"

namespace ocean::app {

/// The options with SEA or --from settled. With --from those that are not given are taken from the
/// file's header, so that the same bytes come out again. Throws Error invalid_value unless exactly
/// one of the two is given, and bad_file or unsupported for a file that does not say enough.
BakeOptions with_source(BakeOptions options);

}  // namespace ocean::app
