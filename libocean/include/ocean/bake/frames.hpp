// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Frame numbers and the names of their files: the grammar of --frames and -o.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ocean {

/// Returns the frames of INT[-INT[xINT]] in comma lists, such as "1-250x2", "-10--5" or "1,5,9-12",
/// in the order given, without duplicates. Throws Error invalid_value with the part that is wrong.
std::vector<int> parse_frames(std::string_view text);

/// Returns "7, 9-11, 20-90x10", the frames as ranges for parse_frames, in the order given. A text
/// of more than about 200 bytes is cut off after a range, with "... LAST".
std::string frames_text(const std::vector<int>& frames);
/// Returns the largest step that reaches all frames from the first one; 1 for one frame. `frames`
/// must be ascending.
int common_step(const std::vector<int>& frames);

/// A part of a list for one machine of a render farm: one of `count` consecutive blocks whose sizes
/// differ by at most one frame.
struct Shard {
    int number = 1;  // 1 .. count
    int count = 1;

    /// Returns the shard's part of the list.
    std::vector<int> of(const std::vector<int>& frames) const;
};
/// Reads "2/5". Throws Error invalid_value.
Shard parse_shard(std::string_view text);

/// The pattern of -o, "out/sea.####.exr". A lone # is four digits, two or more are one digit each;
/// %04d and $F4 are equivalent to ####.
class OutputPattern {
  public:
    OutputPattern() = default;
    /// Throws Error invalid_value for an empty name or two frame tokens.
    explicit OutputPattern(const std::string& path);

    /// Returns the pattern with .#### before the extension, unless it has a frame token.
    OutputPattern with_token() const;
    bool has_token() const { return width_ > 0; }
    /// Returns the extension in lower case with its dot, ".exr"; "" if it has none.
    std::string extension() const;
    /// Returns the path of a frame's file; a product precedes the number: out/sea.normal.0001.exr.
    std::string file(int frame, std::string_view product = "") const;
    /// Returns the number in the place of the frame token of a file name without its folder;
    /// nothing if the name does not begin as the pattern does. The text after the number is
    /// ignored.
    std::optional<int> number_in(std::string_view name) const;
    /// Returns the start that the names of all files share, "sea"; "" for out/####.exr.
    std::string stem() const;
    /// Returns the path of the manifest, out/sea.manifest.json, or out/sea.man where that is too
    /// long.
    std::string manifest() const;
    /// Returns the folder of all files; "" for the current one.
    std::string folder() const;

  private:
    std::string folder_;  // with its final slash
    std::string before_;  // the file name before the frame token
    std::string after_;   // the file name after it, with the extension
    int width_ = 0;       // digits of the frame token; 0 = no token
};

}  // namespace ocean
