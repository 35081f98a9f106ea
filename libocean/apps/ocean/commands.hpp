// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The commands of `ocean`, a file each. Whatever the options of a command are read into belongs to
// the command that is returned.
#pragma once

#include "command.hpp"

namespace ocean {
struct Catalogue;
}

namespace ocean::app {

Command info_command();
/// The catalogue must outlive the command.
Command bake_command(const Catalogue& catalogue);
Command povray_command();
Command query_command();
Command gauge_command();
Command spectrum_command();
Command records_command();
Command foam_texture_command();
Command params_command();
Command presets_command();

}  // namespace ocean::app
