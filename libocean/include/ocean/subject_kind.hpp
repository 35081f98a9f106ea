// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The names of the kinds of subjects, as Subject::kind returns them and file headers store them.
#pragma once

#include <string_view>

namespace ocean {

/// The kinds of subjects, as Subject::kind returns them and file headers store them.
inline constexpr std::string_view kSeaKind = "sea";
inline constexpr std::string_view kTerrainKind = "terrain";

}  // namespace ocean
