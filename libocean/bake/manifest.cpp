// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads, merges and writes the manifest's file; see manifest.hpp.
#include "manifest.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <system_error>

#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/platform.hpp"
#include "refuse.hpp"

namespace ocean {
namespace {

constexpr std::uintmax_t kMaxManifestBytes = std::uintmax_t{256} << 20;  // some 500 000 files

void drop_missing_files(ManifestEntries& entries, const std::filesystem::path& folder) {
    std::set<std::string> present;
    std::error_code error;
    for (std::filesystem::directory_iterator file(folder, error), end; !error && file != end;
         file.increment(error)) {
        present.insert(file->path().filename().string());
    }
    if (error) return;
    std::erase_if(entries, [&](const auto& entry) { return !present.contains(entry.first); });
}

}  // namespace

std::string read_manifest_text(const std::string& name) {
    const std::filesystem::path path = utf8_path(name);
    std::error_code error;
    if (!std::filesystem::exists(path, error)) return "";
    const auto refuse = [](const char* reason) { throw Error(ErrorKind::bad_file, reason); };
    if (!std::filesystem::is_regular_file(path, error)) refuse("it is not a file");
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error || size > kMaxManifestBytes) refuse("it is larger than 256 MiB");
    std::string text(size, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(text.data(), static_cast<std::streamsize>(size));
    if (!file) refuse("it cannot be read");
    return text;
}

std::vector<ManifestFile> find_manifests(const OutputPattern& pattern) {
    std::vector<ManifestFile> found;
    const std::string folder = pattern.folder();
    std::error_code error;
    std::filesystem::directory_iterator file(utf8_path(folder.empty() ? "." : folder), error);
    for (; !error && file != std::filesystem::directory_iterator(); file.increment(error)) {
        const auto shard = pattern.shard_of_manifest(text::to_utf8(file->path().filename()));
        if (shard) found.push_back({pattern.manifest(shard), shard});
    }
    std::ranges::sort(found, {}, [](const ManifestFile& one) {
        return std::pair(one.shard->count, one.shard->number);
    });
    if (std::filesystem::exists(utf8_path(pattern.manifest()), error)) {
        found.insert(found.begin(), {pattern.manifest(), std::nullopt});
    }
    return found;
}

Manifest::Manifest(const OutputPattern& pattern, const std::optional<Shard>& shard)
    : path_(pattern.manifest(shard)), is_of_shard_(shard.has_value()) {
    load({path_, shard});
    for (const ManifestFile& file : find_manifests(pattern)) {
        if (file.path != path_) load(file);
    }
}

void Manifest::load(const ManifestFile& file) {
    std::string text;
    try {
        text = read_manifest_text(file.path);
        if (!text.empty()) found_.merge(parse_manifest(text));
    } catch (const Error& error) {
        if (text.find(kManifestKey) == std::string::npos) {
            refuse("'" + file.path +
                   "' exists and is not a manifest "
                   "of a bake: it is not replaced; move it or "
                   "choose another --output");
        }
        const char* const then = file.path == path_ ? "; it will be replaced"
                                                    : "; the files that it lists are not known";
        warnings_.push_back(file.path + " is damaged: " + error.what() + then);
    }
}

const ManifestEntry* Manifest::find(const std::string& name) const {
    const auto entry = found_.find(name);
    return entry == found_.end() ? nullptr : &entry->second;
}

void Manifest::add(ManifestEntry entry) {
    const std::lock_guard lock(mutex_);
    std::string name = entry.name;
    added_.insert_or_assign(std::move(name), std::move(entry));
}

std::optional<ManifestEntry> Manifest::added(const std::string& name) {
    const std::lock_guard lock(mutex_);
    for (const ManifestEntries* entries : {&added_, &saved_}) {
        const auto entry = entries->find(name);
        if (entry != entries->end()) return entry->second;
    }
    return std::nullopt;
}

void Manifest::set_missing(std::vector<int> frames) {
    const std::lock_guard lock(mutex_);
    missing_ = std::move(frames);
}

void Manifest::save(const std::function<void()>& before_merge) {
    std::filesystem::path folder = utf8_path(path_).parent_path();
    if (folder.empty()) folder = ".";
    std::optional<io::FolderLock> lock;
    if (!is_of_shard_ || before_merge) lock.emplace(text::to_utf8(folder));
    if (before_merge) before_merge();
    ManifestEntries fresh, saved;
    std::vector<int> missing;
    {
        const std::lock_guard guard(mutex_);
        fresh = added_;
        saved = saved_;
        if (!is_of_shard_) missing = missing_;  // a shard sees the others at some moment
    }
    if (fresh.empty() && saved.empty()) return;
    ManifestEntries merged = fresh;
    std::string before;
    try {
        before = read_manifest_text(path_);
        if (!before.empty()) merged.merge(parse_manifest(before));
    } catch (const Error&) {
        // The manifest is replaced; the run has warned of this at its start.
    }
    merged.merge(saved);  // the file may have been lost since
    drop_missing_files(merged, folder);
    const std::string text = manifest_text(merged, missing);
    if (text != before) io::write_file_atomically(path_, text);
    note_saved(fresh);
}

void Manifest::note_saved(ManifestEntries& fresh) {
    const std::lock_guard guard(mutex_);
    for (auto& [name, entry] : fresh) {
        const auto now = added_.find(name);
        if (now->second == entry) added_.erase(now);  // unless added again meanwhile
        saved_.insert_or_assign(name, std::move(entry));
    }
}

}  // namespace ocean
