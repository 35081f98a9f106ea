// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Atomic output, which all writers of files use: bytes go into a temporary beside the target, which
// is renamed when the disk has all of them. Signals are not handled here: an interrupted program
// either finishes the file or unwinds by an exception, and neither leaves a temporary.
#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ocean::io {

/// A file being written. Only commit() creates or replaces the target; without it the destructor
/// removes the temporary. A device or pipe cannot be replaced and is written directly. Every
/// failure throws Error output with the target's path and the system's reason.
class OutputFile {
  public:
    explicit OutputFile(const std::string& path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void write(std::string_view bytes);
    void seek(std::uint64_t position);
    std::uint64_t tell();
    /// Returns the stream, for C libraries that write to it; commit() detects their errors.
    std::FILE* stream() { return file_; }
    /// Flushes, waits for the disk's confirmation, closes and renames. Call it once.
    void commit();

  private:
    void open_temporary();
    [[noreturn]] void fail(const char* action, int error) const;
    void discard() noexcept;

    std::string path_;       // as the user named it, for messages
    std::string target_;     // symbolic links resolved
    std::string temporary_;  // empty: the target itself is open
    std::FILE* file_ = nullptr;
};

/// Writes bytes so that `path` is either the old file or the complete new one, even if the disk is
/// full or the process is killed. Throws Error output with the path and the system's reason.
void write_file_atomically(const std::string& path, std::string_view bytes);

/// Locks a folder's shared files against other processes as long as this object lives, so that they
/// can be read, merged and replaced. The lock ends with its process, even if that is killed. On
/// network disks without locks the last of two writers wins. A thread must not lock a folder twice.
class FolderLock {
  public:
    /// Blocks until no other process holds the lock. "" is the current folder.
    explicit FolderLock(const std::string& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

  private:
    int descriptor_;
};

/// Returns the name of a file, `stem` + `ending`. File systems take at most 255 bytes: in a longer
/// name the stem is cut, and a hash of the stem added.
std::string name_of_file(std::string_view stem, std::string_view ending);
/// Creates `folder` and its parents; "" is the current folder. Throws Error output.
void make_folder(const std::string& folder);
/// Throws the error that make_folder, or creating a file in it, would throw, as far as that is
/// known without creating them.
void require_folder(const std::string& folder);
/// Returns the free bytes of the file system that has, or will have, the folder.
std::uint64_t free_bytes(const std::string& folder);
/// Throws Error invalid_value if `path` is a file with content for which `is_ours` returns false: a
/// file of another program is not replaced. `writer` names the writer of our files, "a bake".
void refuse_to_replace_foreign_file(const std::string& path, std::string_view writer,
                                    const std::function<bool()>& is_ours);
/// Creates the file's folder, then calls write_file_atomically.
void write_output(const std::string& path, std::string_view bytes);

/// Removes the temporaries that killed writers (power, kill -9, out of memory) left in a directory;
/// "" is the current one; with `paths` those of these files alone. Keeps the temporaries of writers
/// that are still running on this machine. Returns the number of removed files.
int remove_abandoned_temporaries(const std::string& directory,
                                 const std::optional<std::vector<std::string>>& paths = {});

}  // namespace ocean::io
