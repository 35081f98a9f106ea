// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See existing_frames.hpp.
#include "ocean/internal/bake/existing_frames.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string_view>
#include <system_error>

#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/platform.hpp"

namespace ocean {
namespace {

/// Returns the frames, of the ascending `frames`, whose numbers appear in a name, as a run of
/// digits or a part of a run, since a name may have digits beside its token.
std::vector<int> frames_in_name(std::string_view name, std::span<const int> frames) {
    constexpr long long kMaxSize = 1LL << 31;
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    std::vector<int> found;
    for (std::size_t start = 0; start < name.size(); ++start) {
        long long number = 0;
        for (std::size_t i = start; i < name.size() && is_digit(name[i]); ++i) {
            number = number * 10 + (name[i] - '0');
            if (number > kMaxSize) break;
            for (const long long frame : {number, -number}) {
                if (std::ranges::binary_search(frames, frame)) {
                    found.push_back(static_cast<int>(frame));
                }
            }
        }
    }
    return found;
}

}  // namespace

std::vector<int> frames_that_may_exist(const BakePlan& plan) {
    std::vector<int> frames = plan.frames;
    std::ranges::sort(frames);
    if (!plan.pattern.has_token()) return frames;
    const std::string folder = plan.pattern.folder();
    const std::filesystem::path path = utf8_path(folder.empty() ? "." : folder);
    std::error_code error;
    if (!std::filesystem::exists(path, error)) return error ? frames : std::vector<int>();
    std::vector<int> found;
    std::filesystem::directory_iterator entry(path, error);
    for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
        std::ranges::copy(frames_in_name(text::to_utf8(entry->path().filename()), frames),
                          std::back_inserter(found));
    }
    if (error) return frames;  // the folder is perhaps writable but not readable
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

std::vector<BakeFile> files_that_may_exist(const BakePlan& plan) {
    std::vector<BakeFile> files = plan.format->shared_files(plan);
    for (const int frame : frames_that_may_exist(plan)) {
        std::ranges::move(plan.format->files(plan, frame), std::back_inserter(files));
    }
    return files;
}

std::vector<std::string> paths_that_may_exist(const BakePlan& plan) {
    std::vector<std::string> paths = {plan.pattern.manifest(), plan.pattern.manifest(plan.shard)};
    for (BakeFile& file : files_that_may_exist(plan)) paths.push_back(std::move(file.path));
    return paths;
}

ExistingFrames find_frames(const BakePlan& plan,
                           const std::function<bool(std::span<const BakeFile>)>& matches_plan) {
    ExistingFrames existing;
    const std::string folder = plan.pattern.folder();
    const OutputPattern pattern = plan.pattern.with_token();
    std::error_code error;
    std::filesystem::directory_iterator entry(utf8_path(folder.empty() ? "." : folder), error);
    for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
        const std::string name = text::to_utf8(entry->path().filename());
        const std::optional<int> frame = pattern.number_in(name);
        if (!frame) continue;
        const std::vector<BakeFile> files = plan.format->files(plan, *frame);
        if (!files.front().path.ends_with("/" + name) && files.front().path != name) continue;
        (matches_plan(files) ? existing.of_plan : existing.foreign).push_back(*frame);
    }
    std::ranges::sort(existing.of_plan);
    std::ranges::sort(existing.foreign);
    return existing;
}

std::vector<int> united(std::vector<int> frames, std::span<const int> others) {
    frames.insert(frames.end(), others.begin(), others.end());
    std::ranges::sort(frames);
    frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
    return frames;
}

std::string foreign_frames_warning(const ExistingFrames& existing, std::span<const int> written,
                                   const std::string& list) {
    std::vector<int> left_out;
    std::ranges::copy_if(existing.foreign, std::back_inserter(left_out), [&](int frame) {
        return std::ranges::find(written, frame) == written.end();
    });
    if (left_out.empty()) return "";
    return "existing frames are of another sea or of other options: " + frames_text(left_out) +
           "; " + list + " leaves them out";
}

}  // namespace ocean
