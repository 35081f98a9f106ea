// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What files of all formats say of the moment of a sea that they show.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

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

/// A text of a file's header.
struct HeaderString {
    std::string name;
    std::string text;
};

/// ocean:sea, frame, time, period, backend and version: what re-makes a frame.
std::vector<HeaderString> label_strings(const FrameLabel& label);

/// The first bytes of a file, as many as the longest header may have; all of a shorter one, none of
/// one that cannot be read.
std::string read_head(const std::string& path);

/// For files whose header is made of comments: "PREFIX NAME LINE" for each line of each text.
std::string comment_lines(std::span<const HeaderString> strings, std::string_view prefix);
/// The strings again, of all lines that begin so; other lines are left out.
std::vector<HeaderString> parse_comment_lines(std::string_view text, std::string_view prefix);

}  // namespace ocean::io
