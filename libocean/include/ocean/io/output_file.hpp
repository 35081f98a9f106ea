// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The last metre of every output: bytes go into a temporary beside the target and take its name
// only when the disk has all of them. All writers of files use this and no other way. They take no
// notice of signals: an interrupted program finishes the file or unwinds by an exception, and both
// leave no temporary.
#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <string_view>

namespace ocean::io {

/// A file being written. The target appears, or is replaced, by commit() and not before; without it
/// the temporary is removed again. A device or pipe is written directly: it cannot be replaced.
/// Every failure throws Error output with the target's path and the system's reason.
class OutputFile {
  public:
    explicit OutputFile(const std::string& path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void write(std::string_view bytes);
    void seek(std::uint64_t position);
    std::uint64_t tell();
    /// For C libraries that write to a stream themselves; their errors are found by commit().
    std::FILE* stream() { return file_; }
    /// Flushes, asks the disk for a confirmation, closes and renames. Once.
    void commit();

  private:
    void open_temporary();
    [[noreturn]] void fail(const char* what, int error) const;
    void discard() noexcept;

    std::string path_;       // as the user named it, for messages
    std::string target_;     // symbolic links resolved
    std::string temporary_;  // empty: the target itself is open
    std::FILE* file_ = nullptr;
};

/// Writes bytes so that `path` is either the old file or the whole new one, also when the disk is
/// full or the process is killed. Throws Error output with the path and the system's reason.
void write_file_atomically(const std::string& path, std::string_view bytes);

/// Keeps other processes from a folder's common files while it lives, so that what they list can be
/// read, merged and replaced. The lock of a process that is killed goes with it. Some network disks
/// have no locks: there the last of two writers wins. Not for one thread twice.
class FolderLock {
  public:
    /// Waits for others. "" is the current folder.
    explicit FolderLock(const std::string& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

  private:
    int descriptor_;
};

/// Makes `folder` and those above it; "" is the current one. Throws Error output.
void make_folder(const std::string& folder);
/// Throws what make_folder or a file in it would, as far as that is known without making them.
void require_folder(const std::string& folder);
/// Of the file system that the folder is on, or will be.
std::uint64_t free_bytes(const std::string& folder);
/// Throws Error invalid_value if `path` is a file with content that `is_ours` denies: what others
/// wrote is not replaced. `writer`: who wrote those that are, "a bake".
void refuse_to_replace_foreign_file(const std::string& path, std::string_view writer,
                                    const std::function<bool()>& is_ours);
/// write_file_atomically, the file's folder made first.
void write_output(const std::string& path, std::string_view bytes);

/// Removes what writers killed outright (power, kill -9, out of memory) left in a directory; "" is
/// the current one. Temporaries of writers that still live are kept. Returns how many it removed.
int remove_abandoned_temporaries(const std::string& directory);

}  // namespace ocean::io
