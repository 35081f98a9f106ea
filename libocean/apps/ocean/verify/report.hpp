// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The reports of `ocean verify`: a page of HTML that needs no other file, JSON, and a line a case.
#pragma once

#include <span>
#include <string>

#include "ocean/internal/verify.hpp"

namespace ocean::app {

/// The rows of a run, and how many have each verdict.
struct VerifyReport {
    std::span<const verify::Row> rows;
    std::string subject = {};  // the source of the user's sea; empty: none

    std::ptrdiff_t count(verify::Verdict verdict) const;
    /// Returns "57 of 60 cases pass, 1 fails ...".
    std::string summary() const;
    std::string html() const;
    std::string json() const;
};

/// Returns "pass spectra.jonswap_height  5.93859 m for 5.9386 +- 6e-05, 6.1 digits".
std::string row_line(const verify::Row& row);

}  // namespace ocean::app
