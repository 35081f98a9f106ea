// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A plot of a case as SVG for a page of HTML.
#pragma once

#include <string>

#include "ocean/internal/verify.hpp"

namespace ocean::app {

/// Returns the text with the characters that HTML reserves escaped.
std::string html_text(std::string_view text);

/// Returns an <svg> element: measured points with their bars over the curve of the reference. The
/// classes of its parts are those of report.cpp.
std::string svg_plot(const verify::Plot& plot);

}  // namespace ocean::app
