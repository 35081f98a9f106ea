// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A stage's picture laid out to be read: pixels of the stage as squares of whole pixels.
#pragma once

#include "stage_picture.hpp"

namespace ocean::app {

/// Returns a picture of that size. A plane of wavenumbers stands left as a whole, and right its
/// middle, with 95 % of the energy, as large as fits; a frame marks the middle in the whole. A plan
/// of the transform fills the picture. A plane that is larger than its half shows the brightest
/// pixel of each square. A plane without a middle stands alone, as large as fits; where it is
/// larger than the picture, a pixel is the mean of a square.
StagePicture laid_out(const StagePicture& stage, int width, int height);

}  // namespace ocean::app
