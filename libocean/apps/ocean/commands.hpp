// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The commands of `ocean`, one file each. A returned command owns the values of its options.
#pragma once

#include "command.hpp"

namespace ocean {
struct Catalogue;
}

namespace ocean::app {

Command info_command();
Command check_command();
Command verify_command();
/// Refers to the catalogue, which must outlive the command.
Command bake_command(const Catalogue& catalogue);
/// Refers to the catalogue, which must outlive the command.
Command farm_command(const Catalogue& catalogue);
Command terrain_import_command();
Command terrain_fit_command();
Command povray_command();
/// Refers to the catalogue, which must outlive the command.
Command terrain_command(const Catalogue& catalogue);
Command query_command();
Command gauge_command();
Command spectrum_command();
Command records_command();
Command foam_texture_command();
Command params_command();
Command presets_command();

}  // namespace ocean::app
