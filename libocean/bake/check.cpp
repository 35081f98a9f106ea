// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See check.hpp.
#include "ocean/internal/bake/check.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>

#include "complete_file.hpp"
#include "frame_baker.hpp"
#include "manifest.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/io/output_file.hpp"
#include "ocean/internal/io/read_provenance.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/text.hpp"
#include "refuse.hpp"
#include "sha256.hpp"

namespace ocean {
namespace {

constexpr std::string_view kEndings[] = {".json", ".man"};

/// Returns a pattern whose manifests are those that `path` names.
OutputPattern pattern_of(const std::string& path) {
    const bool is_manifest = std::ranges::any_of(
        kEndings, [&](std::string_view ending) { return path.ends_with(ending); });
    if (!is_manifest) return OutputPattern(path);
    const std::string name = text::to_utf8(utf8_path(path).filename());
    const std::string folder = path.substr(0, path.size() - name.size());
    const auto is_of = [&](const OutputPattern& pattern) {
        return pattern.manifest() == path || pattern.shard_of_manifest(name).has_value();
    };
    // "sea.manifest.3of20.json" is one of sea.exr; "manifest.json" of ####.exr.
    for (std::size_t end = name.rfind('.'); end != 0 && end != name.npos;
         end = name.rfind('.', end - 1)) {
        const OutputPattern pattern(folder + name.substr(0, end) + ".exr");
        if (is_of(pattern)) return pattern;
    }
    const OutputPattern nameless(folder + "####.exr");
    if (is_of(nameless)) return nameless;
    refuse("'" + path + "': neither a manifest of a bake nor its -o, out/sea.####.exr");
}

/// Returns a file's name with its frame number as #, which all files of a sequence share. A digit
/// behind a letter, as in .df3.inc, is the number only where nothing else is.
std::string sequence_name(const ManifestEntry& entry) {
    const std::string digits = std::to_string(std::abs(static_cast<long long>(entry.frame)));
    const std::string& name = entry.name;
    const std::size_t last = name.rfind(digits, name.rfind('.'));
    if (last == name.npos) return name;
    std::size_t end = last;
    while (end != 0 && end != name.npos &&
           std::isalpha(static_cast<unsigned char>(name[end - 1])) != 0) {
        end = name.rfind(digits, end - 1);
    }
    if (end == name.npos) end = last;
    const std::size_t before = name.find_last_not_of('0', end == 0 ? 0 : end - 1);
    const std::size_t first = end == 0 || before == name.npos ? end : before + 1;
    return name.substr(0, first) + "#" + name.substr(end + digits.size());
}

class Check {
  public:
    explicit Check(const CheckRequest& request)
        : request_(request),
          pattern_(pattern_of(request.path)),
          folder_(pattern_.folder()),
          manifests_(find_manifests(pattern_)) {}

    BakeCheck run() {
        read_manifests();
        read_files();
        find_gaps();
        find_others();
        find_foreign_files();
        std::ranges::stable_sort(result_.faults, {}, &FaultyFile::path);
        result_.files = entries_.size();
        if (request_.merge && result_.faults.empty()) merge();
        return std::move(result_);
    }

  private:
    std::string path_of(const std::string& name) const {
        return folder_.empty() ? name : folder_ + "/" + name;
    }
    void add(BakeFault fault, const std::string& path, std::string reason) {
        result_.faults.push_back({fault, path, std::move(reason)});
    }

    void read_manifests() {
        std::set<int> numbers;
        int shards = 0;
        for (const ManifestFile& manifest : manifests_) {
            try {
                for (auto& [name, entry] : parse_manifest(read_manifest_text(manifest.path))) {
                    listed_[name].push_back(std::move(entry));
                    entries_.insert({name, listed_[name].front()});
                }
            } catch (const Error& error) {
                add(BakeFault::damaged, manifest.path, error.what());
            }
            if (!manifest.shard) continue;
            shards = std::max(shards, manifest.shard->count);
            numbers.insert(manifest.shard->number);
        }
        if (manifests_.empty()) {
            add(BakeFault::missing, pattern_.manifest(), "no manifest, nor one of a shard");
        }
        if (manifests_.empty() || !manifests_.front().shard) return;  // the whole has all frames
        for (int number = 1; number <= shards; ++number) {
            if (numbers.contains(number)) continue;
            add(BakeFault::missing, pattern_.manifest(Shard{number, shards}),
                format_text("shard %d of %d has not finished a file", number, shards));
        }
    }

    /// Finds the frames that a sequence lacks. A file of all frames, such as a stage, is listed
    /// once.
    void find_gaps() {
        std::map<std::string, std::set<int>> frames_of;
        for (const auto& [name, entry] : entries_) {
            frames_of[sequence_name(entry)].insert(entry.frame);
        }
        const bool is_sequence = std::ranges::any_of(
            frames_of, [](const auto& sequence) { return sequence.second.size() > 1; });
        for (const auto& [sequence, found] : frames_of) {
            if (is_sequence && found.size() == 1) continue;
            std::vector<int> expected = request_.frames;
            const int step = common_step({found.begin(), found.end()});
            for (long long frame = *found.begin(); frame <= *found.rbegin(); frame += step) {
                if (request_.frames.empty()) expected.push_back(static_cast<int>(frame));
            }
            std::erase_if(expected, [&](int frame) { return found.contains(frame); });
            if (expected.empty()) continue;
            add(BakeFault::missing, pattern_.manifest(),
                "it lists no frame " + frames_text(expected) + " of " + sequence);
        }
    }

    /// Finds the files of other options than most of their sequence, and those of another subject
    /// than requested or than most files of their format: a mesh may lie beside images of another.
    void find_others() {
        using Counts = std::map<std::string, int>;
        const auto format = [](const std::string& name) {
            return name.substr(name.rfind('.') + 1);
        };
        std::map<std::string, Counts> subjects;   // by the names' extensions
        std::map<std::string, Counts> sequences;  // by their names
        for (const auto& [name, entry] : entries_) {
            ++subjects[format(name)][entry.subject];
            ++sequences[sequence_name(entry)][entry.sequence];
        }
        const auto most = [](const Counts& counts) {
            return std::ranges::max_element(counts, {}, &Counts::value_type::second)->first;
        };
        for (const auto& [name, entry] : entries_) {
            const std::string expected = request_.against.empty() ? most(subjects.at(format(name)))
                                                                  : short_hash(request_.against);
            if (!entry.subject.empty() && entry.subject != expected) {
                add(BakeFault::other, path_of(name), "it is of another subject");
            } else if (!entry.sequence.empty() &&
                       entry.sequence != most(sequences.at(sequence_name(entry)))) {
                add(BakeFault::other, path_of(name), "it is of other options or another version");
            }
        }
    }

    /// Returns the fault of a file, or "" for a whole one, and sets its entry to the one that has
    /// its hash: a shard may have baked again what the whole lists.
    std::string fault_of(ManifestEntry& entry) const {
        const std::string path = path_of(entry.name);
        try {
            ManifestEntry read;
            hash_file({path, entry.frame, 0, entry.product}, read);
            const std::vector<ManifestEntry>& listed = listed_.at(entry.name);
            const auto same = std::ranges::find(listed, read.sha256, &ManifestEntry::sha256);
            if (same == listed.end()) {
                return read.bytes == entry.bytes
                           ? "its SHA-256 is not that of the manifest"
                           : std::to_string(read.bytes) + " bytes, " + std::to_string(entry.bytes) +
                                 " were written";
            }
            entry = *same;
            // An older manifest does not name the subject, but the header has it.
            if (request_.against.empty() || !entry.subject.empty()) return "";
            const auto header = io::read_provenance(path);
            if (header && !is_same_text(header->text, request_.against)) {
                return "its header names another subject";
            }
        } catch (const Error& failure) {
            return failure.what();
        }
        return "";
    }

    void read_files() {
        std::vector<ManifestEntry*> files;
        for (auto& [name, entry] : entries_) {
            std::error_code error;
            if (std::filesystem::is_regular_file(utf8_path(path_of(name)), error)) {
                files.push_back(&entry);
            } else {
                add(BakeFault::missing, path_of(name), "a manifest lists it");
            }
        }
        std::vector<std::string> faults(files.size());
        const int count = static_cast<int>(files.size());
        const int threads = request_.threads > 0 ? request_.threads : available_cores();
        run_in_order(
            count, std::clamp(count, 1, threads),
            [&](int, int index) {
                const auto i = static_cast<std::size_t>(index);
                faults[i] = fault_of(*files[i]);
                return true;
            },
            [&](int index) {
                const auto i = static_cast<std::size_t>(index);
                if (request_.progress) {
                    request_.progress("the hashes of files", (index + 1.0) / count);
                }
                if (!faults[i].empty()) {
                    add(BakeFault::damaged, path_of(files[i]->name), faults[i]);
                } else {
                    ++result_.whole;
                    result_.bytes += files[i]->bytes;
                }
            });
    }

    /// Finds files beside the listed ones that have their stem and extension.
    void find_foreign_files() {
        std::set<std::string> extensions;
        for (const auto& [name, entry] : entries_) {
            extensions.insert(text::to_utf8(utf8_path(name).extension()));
        }
        std::error_code error;
        std::filesystem::directory_iterator file(utf8_path(folder_.empty() ? "." : folder_), error);
        for (; !error && file != std::filesystem::directory_iterator(); file.increment(error)) {
            const std::string name = text::to_utf8(file->path().filename());
            const bool is_like_ours = name.starts_with(pattern_.stem()) && !name.starts_with('.') &&
                                      extensions.contains(text::to_utf8(file->path().extension()));
            const std::string path = path_of(name);
            const bool is_manifest =
                std::ranges::find(manifests_, path, &ManifestFile::path) != manifests_.end();
            if (!is_like_ours || entries_.contains(name) || is_manifest) continue;
            add(BakeFault::foreign, path, "no manifest lists it");
        }
    }

    /// Writes the entries as the manifest of the whole, and removes those of shards.
    void merge() {
        result_.merged = pattern_.manifest();
        io::write_file_atomically(result_.merged, manifest_text(entries_));
        for (const ManifestFile& manifest : manifests_) {
            std::error_code error;
            if (manifest.shard) std::filesystem::remove(utf8_path(manifest.path), error);
            if (error) throw Error(ErrorKind::output, "cannot remove '" + manifest.path + "'");
        }
    }

    const CheckRequest& request_;
    OutputPattern pattern_;
    std::string folder_;
    std::vector<ManifestFile> manifests_;
    std::map<std::string, std::vector<ManifestEntry>> listed_;  // by all manifests
    ManifestEntries entries_;
    BakeCheck result_;
};

}  // namespace

std::string_view fault_name(BakeFault fault) {
    constexpr std::string_view kNames[] = {"missing", "damaged", "foreign", "other"};
    return kNames[static_cast<std::size_t>(fault)];
}

BakeCheck check_bake(const CheckRequest& request) {
    return Check(request).run();
}

}  // namespace ocean
