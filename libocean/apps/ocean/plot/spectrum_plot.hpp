// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The picture of `ocean spectrum --plot`: on the left the frequency spectrum that was asked for,
// with what the grid resolves of it; on the right where the waves go.
#pragma once

#include <string>

namespace ocean {
class Ocean;
}

namespace ocean::app {

/// The bytes of a PNG file; `name` goes into its title.
std::string plot_spectrum(Ocean& ocean, const std::string& name, int threads);

}  // namespace ocean::app
