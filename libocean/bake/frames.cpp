// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See plan.hpp.
#include "ocean/bake/plan.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <numeric>
#include <unordered_set>

#include "ocean/internal/csv_rows.hpp"
#include "ocean/internal/text.hpp"
#include "refuse.hpp"

namespace ocean {
namespace {

constexpr std::size_t kMaxFrames = 1000000;

[[noreturn]] void refuse_frames(std::string_view part, const std::string& why) {
    refuse("--frames " + std::string(part) + ": " + why +
           "; allowed are FIRST, FIRST-LAST and FIRST-LASTxSTEP in comma lists, such as 1-250x2");
}

/// Removes an integer from the front of `rest`; returns false if there is none or it does not fit.
bool read_int(std::string_view& rest, int& value) {
    const auto [stop, code] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    if (code != std::errc()) return false;
    rest.remove_prefix(static_cast<std::size_t>(stop - rest.data()));
    return true;
}

bool read_char(std::string_view& rest, char c) {
    if (rest.empty() || rest.front() != c) return false;
    rest.remove_prefix(1);
    return true;
}

/// The place of a frame number in a name: #, %d or $F. The last two may contain digits that state a
/// width.
struct FrameToken {
    std::size_t start;
    std::string_view text;
    std::string_view digits;
};

/// Returns the token at a place of a name, if there is one.
std::optional<FrameToken> token_at(std::string_view name, std::size_t start) {
    constexpr std::string_view kDigits = "0123456789";
    const auto past = [&](std::string_view of, std::size_t from) {
        return std::min(name.find_first_not_of(of, from), name.size());
    };
    const std::string_view rest = name.substr(start);
    if (rest.starts_with('#'))
        return FrameToken{start, rest.substr(0, past("#", start) - start), ""};
    if (rest.starts_with("$F")) {
        const std::size_t end = past(kDigits, start + 2);
        return FrameToken{start, rest.substr(0, end - start),
                          name.substr(start + 2, end - start - 2)};
    }
    if (!rest.starts_with('%')) return std::nullopt;
    const std::size_t end = past(kDigits, start + 1);
    if (end == name.size() || name[end] != 'd') return std::nullopt;
    const std::size_t first = start + (rest.starts_with("%0") ? 2 : 1);
    return FrameToken{start, rest.substr(0, end + 1 - start), name.substr(first, end - first)};
}

std::vector<FrameToken> tokens_in(std::string_view name) {
    std::vector<FrameToken> tokens;
    for (std::size_t at = 0; at < name.size();) {
        const auto token = token_at(name, at);
        at += token ? token->text.size() : 1;
        if (token) tokens.push_back(*token);
    }
    return tokens;
}

struct FrameRange {
    int first;
    int last;
    int step;
};

FrameRange parse_range(std::string_view part) {
    std::string_view rest = part;
    FrameRange range{0, 0, 1};
    if (!read_int(rest, range.first)) refuse_frames(part, "not a frame number");
    range.last = range.first;
    if (read_char(rest, '-')) {
        if (!read_int(rest, range.last)) refuse_frames(part, "the range has no end");
        // A colon is Open Job Description's step. (fileseq's means all frames, coarse ones first.)
        const bool has_step = read_char(rest, 'x') || read_char(rest, ':');
        if (has_step && (!read_int(rest, range.step) || range.step < 1)) {
            refuse_frames(part, "the step must be a whole number, at least 1");
        }
    }
    // y and fractions have other meanings in other tools and are refused, lest they be misread.
    if (!rest.empty()) refuse_frames(part, "'" + std::string(rest) + "' is not supported");
    if (range.last < range.first) refuse_frames(part, "the last frame comes before the first");
    return range;
}

}  // namespace

std::vector<int> parse_frames(std::string_view text) {
    std::vector<int> frames;
    std::unordered_set<int> seen;
    const std::vector<std::string> parts = split(text, ',');
    for (const std::string& part : parts) {
        const FrameRange range = parse_range(trimmed(part));
        for (long long frame = range.first; frame <= range.last; frame += range.step) {
            const int number = static_cast<int>(frame);
            if (parts.size() > 1 && !seen.insert(number).second) continue;
            if (frames.size() == kMaxFrames) refuse_frames(part, "more than a million frames");
            frames.push_back(number);
        }
    }
    return frames;
}

std::string frames_text(const std::vector<int>& frames) {
    constexpr std::size_t kMaxBytes = 200;
    constexpr std::size_t kMinSteppedFrames = 6;
    std::string text;
    for (std::size_t i = 0; i < frames.size();) {
        if (text.size() > kMaxBytes) return text + " ... " + std::to_string(frames.back());
        std::size_t last = std::min(i + 1, frames.size() - 1);
        const long long step = static_cast<long long>(frames[last]) - frames[i];
        while (last + 1 < frames.size() &&
               static_cast<long long>(frames[last + 1]) - frames[last] == step) {
            ++last;
        }
        if (step < 1 || (step > 1 && last - i + 1 < kMinSteppedFrames)) last = i;
        text += (text.empty() ? "" : ", ") + std::to_string(frames[i]);
        if (last > i) text += "-" + std::to_string(frames[last]);
        if (last > i && step > 1) text += "x" + std::to_string(step);
        i = last + 1;
    }
    return text;
}

int common_step(const std::vector<int>& frames) {
    long long step = 0;
    for (const int frame : frames) {
        step = std::gcd(step, static_cast<long long>(frame) - frames.front());
    }
    return static_cast<int>(std::clamp<long long>(step, 1, std::numeric_limits<int>::max()));
}

std::vector<int> Shard::of(const std::vector<int>& frames) const {
    const auto first = [&](long long block) {
        return frames.begin() + static_cast<long long>(frames.size()) * block / count;
    };
    return {first(number - 1), first(number)};
}

Shard parse_shard(std::string_view text) {
    Shard shard;
    std::string_view rest = text;
    const bool numbers = read_int(rest, shard.number) && read_char(rest, '/') &&
                         read_int(rest, shard.count) && rest.empty();
    if (!numbers || shard.number < 1 || shard.number > shard.count) {
        refuse("--shard " + std::string(text) +
               ": allowed is I/N, the I-th of N parts, from 1/N to N/N");
    }
    return shard;
}

OutputPattern::OutputPattern(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    const std::size_t start = slash == std::string::npos ? 0 : slash + 1;
    folder_ = path.substr(0, start);
    const std::string name = path.substr(start);
    for (const FrameToken& token : tokens_in(folder_)) {
        if (token.text == "#") continue;  // a folder may well be called that
        refuse("-o '" + path + "': " + std::string(token.text) +
               " is in the name of a folder; only names of files may contain a frame number");
    }
    if (name.empty()) refuse("-o '" + path + "': the name of a file is missing");

    const std::vector<FrameToken> tokens = tokens_in(name);
    if (tokens.size() > 1)
        refuse("-o '" + path + "': one frame token (####) is allowed, not " +
               std::to_string(tokens.size()));
    if (tokens.empty()) {
        const std::size_t dot = name.rfind('.');
        const std::size_t end = dot == std::string::npos || dot == 0 ? name.size() : dot;
        before_ = name.substr(0, end);
        after_ = name.substr(end);
        return;
    }
    const FrameToken& token = tokens.front();
    before_ = name.substr(0, token.start);
    after_ = name.substr(token.start + token.text.size());
    if (token.text.front() == '#') {
        // Some tools read # as four digits, others as one: a lone # is 4, and #### is 4 everywhere.
        width_ = token.text.size() == 1 ? 4 : static_cast<int>(token.text.size());
    } else {
        std::string_view rest = token.digits;
        width_ = 1;
        if (!rest.empty() && !read_int(rest, width_)) width_ = 0;
    }
    if (width_ < 1 || width_ > 20)
        refuse("-o '" + path + "': 1 to 20 digits are allowed for a frame number");
}

OutputPattern OutputPattern::with_token() const {
    OutputPattern pattern = *this;
    if (!pattern.has_token()) {
        pattern.before_ += '.';
        pattern.width_ = 4;
    }
    return pattern;
}

std::string OutputPattern::extension() const {
    const std::size_t dot = after_.rfind('.');
    return dot == std::string::npos ? "" : lower_case(after_.substr(dot));
}

std::string OutputPattern::file(int frame, std::string_view product) const {
    std::string name = before_;
    if (!product.empty()) {
        // sea.####.exr -> sea.normal.0001.exr, sea_####.exr -> sea_normal_0001.exr.
        const char last = name.empty() ? '\0' : name.back();
        const bool separated = last == '.' || last == '_' || last == '-';
        const char separator = separated ? last : '.';
        if (!separated && !name.empty()) name += separator;
        name += product;
        if (has_token()) name += separator;
    }
    if (has_token()) name += format_text("%0*d", width_, frame);
    return folder_ + name + after_;
}

std::optional<int> OutputPattern::number_in(std::string_view name) const {
    int number = 0;
    if (!has_token() || !name.starts_with(before_)) return std::nullopt;
    name.remove_prefix(before_.size());
    if (!read_int(name, number)) return std::nullopt;
    return number;
}

/// Returns an ending for the manifest beside frames, such that file systems accept the name (255
/// bytes).
static std::string_view manifest_ending(const std::string& stem) {
    constexpr std::string_view kEnding = ".manifest.json", kShort = ".man";
    return stem.size() + kEnding.size() <= 255 ? kEnding : kShort;
}

std::string OutputPattern::stem() const {
    std::string stem = before_ + after_.substr(0, std::min(after_.rfind('.'), after_.size()));
    while (!stem.empty() && std::string_view("._-").find(stem.back()) != std::string_view::npos) {
        stem.pop_back();
    }
    return stem;
}

std::string OutputPattern::manifest(const std::optional<Shard>& shard) const {
    const std::string stem = this->stem();
    std::string name = stem.empty() ? "manifest.json" : stem + std::string(manifest_ending(stem));
    if (shard) {
        name.insert(name.rfind('.'), format_text(".%dof%d", shard->number, shard->count));
        if (name.size() > 255) {
            refuse("--shard: the name of its manifest, " + name + ", is longer than 255 bytes");
        }
    }
    return folder_ + name;
}

std::optional<Shard> OutputPattern::shard_of_manifest(std::string_view name) const {
    const std::string whole = manifest().substr(folder_.size());
    const std::size_t dot = whole.rfind('.');
    const std::string_view start = std::string_view(whole).substr(0, dot);
    const std::string_view end = std::string_view(whole).substr(dot);
    if (!name.starts_with(start) || !name.ends_with(end)) return std::nullopt;
    if (name.size() < whole.size() + 1) return std::nullopt;
    std::string_view rest = name.substr(dot, name.size() - whole.size());
    Shard shard;
    const bool reads = read_char(rest, '.') && read_int(rest, shard.number) &&
                       read_char(rest, 'o') && read_char(rest, 'f') &&
                       read_int(rest, shard.count) && rest.empty();
    if (!reads || shard.number < 1 || shard.number > shard.count) return std::nullopt;
    return shard;
}

std::string OutputPattern::folder() const {
    if (folder_.size() <= 1) return folder_;
    return folder_.substr(0, folder_.size() - 1);
}

}  // namespace ocean
