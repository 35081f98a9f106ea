// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See complete_file.hpp.
#include "complete_file.hpp"

#include <filesystem>
#include <fstream>
#include <set>
#include <span>
#include <system_error>

#include "ocean/error.hpp"
#include "ocean/internal/bake/existing_frames.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/io/read_provenance.hpp"
#include "ocean/internal/platform.hpp"
#include "refuse.hpp"
#include "sha256.hpp"

namespace ocean {
namespace {

std::filesystem::path native(const BakeFile& file) {
    return utf8_path(file.path);
}

/// Returns the hash of a file's pixels, "" for a file that is not an image.
std::string hash_pixels(const BakePlan& plan, const BakeFile& file, int threads) {
    Sha256 hash;
    const bool image = plan.format->read_pixels(
        plan, file, threads, [&hash](std::string_view bytes) { hash.add(bytes); });
    return image ? hash.hex() : "";
}

}  // namespace

bool is_same_text(const std::string& in_header, const std::string& text) {
    return in_header == text || in_header + "\n" == text;
}

void hash_file(const BakeFile& file, ManifestEntry& entry) {
    std::ifstream stream(native(file), std::ios::binary);
    std::vector<char> block(std::size_t{1} << 20);
    Sha256 hash;
    while (stream) {
        stream.read(block.data(), static_cast<std::streamsize>(block.size()));
        const auto count = static_cast<std::size_t>(stream.gcount());
        hash.add({block.data(), count});
        entry.bytes += count;
    }
    if (!stream.eof()) throw Error(ErrorKind::bad_file, "cannot read '" + file.path + "'");
    entry.sha256 = hash.hex();
}

bool is_regular(const BakeFile& file) {
    std::error_code error;
    return std::filesystem::is_regular_file(native(file), error);
}

namespace {

/// Returns the recipe that a file would have at any frame.
std::string sequence_of(const BakePlan& plan, BakeFile file) {
    file.frame = 0;
    return plan.format->recipe(plan, file).substr(0, kShortHashDigits);
}

/// Returns true if a file shows another subject than the plan's, by its header.
bool shows_another_subject(const BakePlan& plan, const BakeFile& file) {
    try {
        const auto provenance = io::read_provenance(file.path);
        return provenance && !is_same_text(provenance->text, plan.subject_text);
    } catch (const Error&) {
        return false;  // it is damaged
    }
}

void refuse_to_overwrite_another_subject(const BakePlan& plan, const Manifest& manifest,
                                         std::span<const BakeFile> files) {
    const std::filesystem::path pattern = utf8_path(plan.pattern.file(0));
    std::set<int> others;
    for (const auto& [name, entry] : manifest.found()) {
        const std::filesystem::path path = pattern.parent_path() / utf8_path(name);
        if (path.extension() != pattern.extension()) continue;  // images beside volumes
        const BakeFile file{text::to_utf8(path), entry.frame, 0, entry.product};
        if (!is_regular(file)) continue;
        const bool is_other = entry.subject.empty() ? shows_another_subject(plan, file)
                                                    : entry.subject != plan.subject_hash;
        if (is_other) others.insert(entry.frame);
    }
    for (const BakeFile& file : files) {
        if (!is_regular(file)) continue;  // a pipe must not be read
        const bool is_listed = manifest.find(native(file).filename().string()) != nullptr;
        if (!is_listed && shows_another_subject(plan, file)) others.insert(file.frame);
    }
    if (others.empty()) return;
    const std::string path = plan.pattern.file(plan.frames.front());
    const std::string kind(plan.subject->kind());
    refuse("-o " + path + ": " +
           (plan.pattern.has_token() ? "frames of another " + kind + " are there: " +
                                           frames_text({others.begin(), others.end()})
                                     : "the file there is of another " + kind) +
           "; --overwrite replaces them");
}

}  // namespace

void refuse_to_overwrite_others(const BakePlan& plan, const Manifest& manifest) {
    const std::vector<BakeFile> files = files_that_may_exist(plan);
    for (const BakeFile& file : files) {
        io::refuse_to_replace_foreign_file(file.path, "a bake", [&] {
            return plan.format->is_baked(file) ||
                   manifest.find(native(file).filename().string()) != nullptr;
        });
    }
    if (plan.overwrite || plan.frames.empty()) return;
    refuse_to_overwrite_another_subject(plan, manifest, files);
}

void describe(const BakePlan& plan, const BakeFile& file, ManifestEntry& entry) {
    entry.name = native(file).filename().string();
    entry.frame = file.frame;
    entry.time = plan.subject->timeline().time_of(file.frame);
    entry.product = file.product;
    entry.recipe = plan.format->recipe(plan, file);
    entry.subject = plan.subject_hash;
    entry.sequence = sequence_of(plan, file);
}

ManifestEntry inspect(const BakePlan& plan, const BakeFile& file, int threads) {
    ManifestEntry entry;
    describe(plan, file, entry);
    hash_file(file, entry);
    entry.pixels_sha256 = hash_pixels(plan, file, threads);
    return entry;
}

std::optional<ManifestEntry> find_complete(const BakePlan& plan, const BakeFile& file,
                                           const Manifest& manifest, int threads) {
    const ManifestEntry* listed = manifest.find(native(file).filename().string());
    const bool header_proves_recipe = plan.format->header_proves_recipe;
    if (!is_regular(file) || (listed == nullptr && !header_proves_recipe)) return std::nullopt;
    try {
        ManifestEntry entry = inspect(plan, file, threads);
        if (listed != nullptr && listed->sha256 != entry.sha256) return std::nullopt;
        if (!header_proves_recipe && listed->recipe != entry.recipe) return std::nullopt;
        return entry;
    } catch (const Error&) {
        return std::nullopt;
    }
}

}  // namespace ocean
