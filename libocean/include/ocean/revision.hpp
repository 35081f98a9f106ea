// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether what was made of something still holds.
#pragma once

#include <memory>
#include <utility>

namespace ocean {

/// Which content something has. Copies of the content have copies of its revision; two that were
/// begun apart are never equal, of whichever objects and threads, as long as anyone has either:
/// a revision is the address of a byte that all its copies own. May be compared and copied in
/// several threads at once.
class Revision {
  public:
    /// Of nothing that is known: equal to none, not to itself either.
    Revision() = default;
    /// Of new content.
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
