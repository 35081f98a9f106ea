// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The files of povray_macros/ that go into the folders of seas, terrains and coasts for POV-Ray;
// the build puts them here.
#pragma once

#include <string_view>

namespace ocean {

extern const std::string_view kCoastInc;
extern const std::string_view kCoastScenePov;
extern const std::string_view kOceanInc;
extern const std::string_view kScenePov;
extern const std::string_view kTerrainInc;
extern const std::string_view kTerrainScenePov;

}  // namespace ocean
