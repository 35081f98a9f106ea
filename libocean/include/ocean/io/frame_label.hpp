// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What files of all formats say of the moment of a sea that they show.
#pragma once

#include <string_view>

namespace ocean::io {

/// The texts must outlive the call.
struct FrameLabel {
    std::string_view sea_text;  // the resolved sea file
    int number = 1;
    double time = 0.0;    // s
    double period = 0.0;  // m
    /// Which computed the surface: the last bits differ.
    std::string_view backend = "cpu";
    /// A short name of the sea on its map: others have another.
    std::string_view sea_id = "";
};

}  // namespace ocean::io
