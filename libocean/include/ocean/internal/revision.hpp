// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Revisions: a cache compares them to find out whether its content is still valid.
#pragma once

#include <memory>
#include <utility>

namespace ocean {

/// Identifies a content. Copies of the content carry copies of its revision; two revisions that
/// were begun separately are never equal, whichever objects and threads they belong to, while
/// either exists: a revision is the address of a byte that all its copies own. Several threads may
/// compare and copy a revision at once.
class Revision {
  public:
    /// Makes the revision of an unknown content: it equals no revision, not even itself.
    Revision() = default;
    /// Returns the revision of a new content.
    static Revision begin() { return Revision(std::make_shared<const char>('\0')); }

    explicit operator bool() const { return byte_ != nullptr; }
    friend bool operator==(const Revision& a, const Revision& b) {
        return a.byte_ != nullptr && a.byte_ == b.byte_;
    }

  private:
    explicit Revision(std::shared_ptr<const char> byte) : byte_(std::move(byte)) {}

    std::shared_ptr<const char> byte_;
};

}  // namespace ocean
