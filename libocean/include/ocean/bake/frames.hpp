// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Frame numbers and the names of the files they go into: the grammar of --frames and of -o.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ocean {

/// INT[-INT[xINT]], in comma lists: "1-250x2", "-10--5", "1,5,9-12". In the order given, each
/// frame once. Throws Error invalid_value with the part that is wrong.
std::vector<int> parse_frames(std::string_view text);

/// "7, 9-11, 20-90x10": the frames by their ranges, as parse_frames takes them, in the order given.
/// Longer than some 200 bytes it is cut off after a range, with "... LAST".
std::string frames_text(const std::vector<int>& frames);
/// The greatest step that reaches all of them, ascending, from the first; 1 for one frame.
int common_step(const std::vector<int>& frames);

/// A part of a list for one machine of a farm: the i-th of n blocks as even as can be, so that
/// frames in sequence stay together.
struct Shard {
    int number = 1;  // 1 .. count
    int count = 1;

    std::vector<int> of(const std::vector<int>& frames) const;
};
/// "2/5". Throws Error invalid_value.
Shard parse_shard(std::string_view text);

/// The pattern of -o: "out/sea.####.exr". A lone # is four digits, ## and more are as many as they
/// are; %04d and $F4 are understood too.
class OutputPattern {
  public:
    OutputPattern() = default;
    /// Throws Error invalid_value for an empty name or two frame tokens.
    explicit OutputPattern(const std::string& path);

    /// The same with .#### before the extension if it has no token.
    OutputPattern with_token() const;
    bool has_token() const { return width_ > 0; }
    /// Lower case with its dot, ".exr"; "" for none.
    std::string extension() const;
    /// The file of one frame; a product goes before the number: out/sea.normal.0001.exr.
    std::string file(int frame, std::string_view product = "") const;
    /// The number in the place of the frame token of a name without a folder; nothing if the name
    /// does not begin as the pattern does. What follows the number is not looked at.
    std::optional<int> number_in(std::string_view name) const;
    /// The manifest of all files: out/sea.manifest.json.
    std::string manifest() const;
    /// The folder of all files; "" for the current one.
    std::string folder() const;

  private:
    std::string folder_;  // with its final slash
    std::string before_;  // of the file's name
    std::string after_;
    int width_ = 0;  // digits; 0 = no token
};

}  // namespace ocean
