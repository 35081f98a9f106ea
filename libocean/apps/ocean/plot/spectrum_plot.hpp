// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The plot of `ocean spectrum --plot`: on the left the frequency spectrum as asked and as the grid
// resolves it, on the right the directional spectrum.
#pragma once

#include <string>

namespace ocean {
class Ocean;
}

namespace ocean::app {

/// Returns the bytes of a PNG file; `name` is part of its title.
std::string plot_spectrum(Ocean& ocean, const std::string& name, int threads);

}  // namespace ocean::app
