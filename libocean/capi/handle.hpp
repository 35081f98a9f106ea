// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What all handles of libocean.h share: one thread at a time is in a handle.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "guard.hpp"

namespace ocean::capi {

/// The base of the structs behind opaque handles.
struct Handle {
    /// The process whose thread is in this handle; 0: none.
    mutable std::atomic<std::uint64_t> user = 0;
};

/// The one thread that may be in a handle, while the object lives.
class Visit {
  public:
    /// Throws CallError OCEAN_BUSY if another is in it, OCEAN_INVALID_ARGUMENT for NULL. `name` is
    /// that of the argument: "sea".
    Visit(const Handle* handle, const char* name);
    ~Visit() { handle_->user.store(0, std::memory_order_release); }
    Visit(const Visit&) = delete;
    Visit& operator=(const Visit&) = delete;

  private:
    const Handle* handle_;
};

/// Runs `body` while the one thread in the handle is the caller's. Returns the code of what is
/// thrown. Each struct behind a handle has the name of its argument, kName.
template <typename Opened, typename Body>
ocean_result in_handle(const Opened* handle, const Body& body) noexcept {
    return guarded([&] {
        const Visit visit(handle, Opened::kName);
        body();
    });
}

/// Waits until no thread of this process is in the handle, and enters it for good. Returns false if
/// a thread of the parent process was in it at the fork: it must not be freed then, since that
/// thread can neither leave it nor say in which state it left it.
bool enter_to_free(Handle& handle);

/// Returns the folder whatever the process makes its current one later; "" if there is none.
std::string lasting_folder(const std::string& folder);
/// Returns the folder of a file, likewise.
std::string folder_of(const char* path);

}  // namespace ocean::capi
