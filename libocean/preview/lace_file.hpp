// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The textures of the foam's pattern as bytes that a program keeps between its runs.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lace_maps.hpp"

namespace ocean::preview {

std::string to_bytes(const LaceTextures& textures);
/// Returns nothing for bytes that were not made whole by to_bytes of this edition of the textures.
std::optional<LaceTextures> lace_of_bytes(std::string_view bytes);

}  // namespace ocean::preview
