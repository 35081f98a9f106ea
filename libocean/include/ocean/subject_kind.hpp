// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The kinds of subjects by name: what Subject::kind returns and what headers of files say.
#pragma once

#include <string_view>

namespace ocean {

inline constexpr std::string_view kSeaKind = "sea";
inline constexpr std::string_view kTerrainKind = "terrain";

}  // namespace ocean
