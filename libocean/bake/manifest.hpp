// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The manifest beside baked files: an entry with hashes for each file. Chunks of one bake share one
// manifest, so that each write merges into the file; a shard has a manifest of its own, which needs
// no lock. The content is the same for every run.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ocean/bake/plan.hpp"

namespace ocean {

struct ManifestEntry {
    std::string name;  // name of the file, without a folder
    int frame = 0;
    double time = 0.0;    // [s]
    std::string product;  // its products, separated by commas
    std::uint64_t bytes = 0;
    std::string sha256;         // hash of the file
    std::string pixels_sha256;  // hash of the samples; "" for a file that is not an image
    std::string recipe;         // SHA-256 of everything that decides the file's content
    // Begins of hashes, "" in older manifests:
    std::string subject;   // of the subject's text
    std::string sequence;  // of everything that decides the content but the frame

    bool operator==(const ManifestEntry&) const = default;
};

/// The first key of a manifest; its value is the version.
inline constexpr const char* kManifestKey = "libocean_manifest";

/// Entries by the names of their files.
using ManifestEntries = std::map<std::string, ManifestEntry>;

/// Returns the manifest as JSON. `missing` lists the frames that readers silently interpolate.
std::string manifest_text(const ManifestEntries& entries, std::span<const int> missing = {});
/// Returns the entries of a manifest. Throws Error bad_file with the reason; safe on hostile text.
ManifestEntries parse_manifest(std::string_view text);

/// The manifests of an output: of the whole, and of shards.
struct ManifestFile {
    std::string path;
    std::optional<Shard> shard;
};
/// Returns the manifests that exist, that of the whole first, then those of shards.
std::vector<ManifestFile> find_manifests(const OutputPattern& pattern);
/// Returns the text of a manifest, "" if the file does not exist. Throws Error bad_file.
std::string read_manifest_text(const std::string& path);

class Manifest {
  public:
    /// Reads the manifest of the whole or of a shard if it exists, and the entries of the others. A
    /// damaged manifest counts as empty: warnings() have the reason, and save() replaces its own.
    /// Throws Error invalid_value for any other file, which is the user's.
    explicit Manifest(const OutputPattern& pattern, const std::optional<Shard>& shard = {});

    /// Returns a sentence for each manifest that was not read: which, why, and what follows.
    const std::vector<std::string>& warnings() const { return warnings_; }
    /// Returns the entry of `name` at the time of construction; null if there was none.
    const ManifestEntry* find(const std::string& name) const;
    /// Returns the entries of all manifests at the time of construction.
    const ManifestEntries& found() const { return found_; }

    /// Adds or replaces the entry of a file. Any thread.
    void add(ManifestEntry entry);
    /// Returns the entry of `name` that was added last. Any thread.
    std::optional<ManifestEntry> added(const std::string& name);
    /// Sets the frames that are listed as missing.
    void set_missing(std::vector<int> frames);
    /// Merges the entries added since the last save into the file; entries saved before may be
    /// older than those that another run has written since. Drops entries whose file is missing.
    /// Calls `before_merge` while no other run can merge into the folder, to write files that must
    /// agree with the manifest. A shard locks the folder only for these. Any thread, one at a time.
    /// Throws Error output.
    void save(const std::function<void()>& before_merge = {});

  private:
    void note_saved(ManifestEntries& fresh);

    void load(const ManifestFile& file);

    std::string path_;
    bool is_of_shard_;
    std::vector<std::string> warnings_;
    ManifestEntries found_;
    std::mutex mutex_;
    ManifestEntries added_;  // entries added since the last save
    ManifestEntries saved_;
    std::vector<int> missing_;
};

}  // namespace ocean
