// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The files of povray_macros/ for the POV-Ray folders of seas, terrains and coasts. The build fills
// them in.
#pragma once

#include <string_view>

namespace ocean {

extern const std::string_view kCoastInc;
extern const std::string_view kCoastScenePov;
extern const std::string_view kHullScenePov;
extern const std::string_view kOceanInc;
extern const std::string_view kScenePov;
extern const std::string_view kTerrainInc;
extern const std::string_view kTerrainScenePov;

}  // namespace ocean
