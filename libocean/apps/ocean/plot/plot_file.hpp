// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The string by which a command knows the plots that it has written.
#pragma once

#include <string>
#include <string_view>

#include "ocean/internal/io/provenance.hpp"

namespace ocean::app {

/// Returns the string that marks a plot of a command.
io::HeaderString plot_mark(std::string_view command);

/// Returns true for a PNG file with the mark of the command, which may replace it.
bool is_plot(const std::string& path, std::string_view command);

}  // namespace ocean::app
