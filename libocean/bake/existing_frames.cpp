// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See existing_frames.hpp.
#include "ocean/bake/existing_frames.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <system_error>

#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/platform.hpp"

namespace ocean {

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
