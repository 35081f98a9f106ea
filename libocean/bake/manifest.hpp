// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The manifest beside baked files: what each of them is, and its hashes. Runs of one bake on many
// machines share one file, so that writing it means merging into it. Nothing in it changes from run
// to run.
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

namespace ocean {

struct ManifestEntry {
    std::string name;  // of the file, without a folder
    int frame = 0;
    double time = 0.0;    // s
    std::string product;  // several in comma lists
    std::uint64_t bytes = 0;
    std::string sha256;         // of the file
    std::string pixels_sha256;  // of the decoded samples; "" for what is no image
    std::string recipe;         // SHA-256 of all that decides the file's content

    bool operator==(const ManifestEntry&) const = default;
};

/// A manifest opens with this key and its version.
inline constexpr const char* kManifestKey = "libocean_manifest";

/// By name.
using ManifestEntries = std::map<std::string, ManifestEntry>;

/// `missing` are frames that a reader would fill without a word.
std::string manifest_text(const ManifestEntries& entries, std::span<const int> missing = {});
/// Throws Error bad_file with the reason; safe on hostile text.
ManifestEntries parse_manifest(std::string_view text);

class Manifest {
  public:
    /// Reads the file `path` if it is there. A damaged manifest is not trusted: `distrust()` says
    /// why, and save() replaces it. Throws Error invalid_value for what is none: it is the user's.
    explicit Manifest(std::string path);

    const std::string& distrust() const { return distrust_; }
    /// What the file said of `name` when this object was made; null if nothing.
    const ManifestEntry* find(const std::string& name) const;

    /// Any thread.
    void add(ManifestEntry entry);
    /// Returns the entry of `name` that was added last. Any thread.
    std::optional<ManifestEntry> added(const std::string& name);
    /// Frames that are named as not there.
    void set_missing(std::vector<int> frames);
    /// Merges into the file what was added since it was saved last: what was saved before may be
    /// older than what another run has written over it. Entries without a file are dropped.
    /// `before_it` is called when no other run merges into the folder, for what must agree with it.
    /// Any thread, one at a time. Throws Error output.
    void save(const std::function<void()>& before_it = {});

  private:
    void note_saved(ManifestEntries& fresh);

    std::string path_;
    std::string distrust_;
    ManifestEntries found_;
    std::mutex mutex_;
    ManifestEntries added_;  // since the last save
    ManifestEntries saved_;
    std::vector<int> missing_;
};

}  // namespace ocean
