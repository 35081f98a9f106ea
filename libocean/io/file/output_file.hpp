// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The last metre of every output: bytes go into a temporary beside the target and take its name
// only when the disk has all of them. All writers of ocean::io use this class and no other way.
#pragma once

#include <cstdint>
#include <cstdio>
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

}  // namespace ocean::io
