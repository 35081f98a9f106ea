// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See handle.hpp.
#include "handle.hpp"

#include <chrono>
#include <filesystem>
#include <system_error>
#include <thread>

#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/platform.hpp"

namespace ocean::capi {
namespace {

/// Returns the number of this process, never 0: that stands for no process.
std::uint64_t this_process() {
    return process_number() + 1;
}

/// The pause between two tries to enter a handle that another thread is in.
constexpr std::chrono::milliseconds kBetweenTries{1};

}  // namespace

Visit::Visit(const Handle* handle, const char* name) : handle_(handle) {
    require(handle, name);
    std::uint64_t no_process = 0;
    if (!handle->user.compare_exchange_strong(no_process, this_process(),
                                              std::memory_order_acquire)) {
        throw CallError(OCEAN_BUSY, std::string("another thread is in this ") + name +
                                        "; give each thread its own: ocean_clone");
    }
}

bool enter_to_free(Handle& handle) {
    std::uint64_t user = 0;
    while (!handle.user.compare_exchange_strong(user, this_process(), std::memory_order_acquire)) {
        if (user != this_process()) return false;
        std::this_thread::sleep_for(kBetweenTries);
        user = 0;
    }
    return true;
}

std::string lasting_folder(const std::string& folder) {
    std::error_code code;
    const std::filesystem::path current = std::filesystem::current_path(code);
    return text::to_utf8(code ? utf8_path(folder) : current / utf8_path(folder));
}

std::string folder_of(const char* path) {
    return lasting_folder(text::to_utf8(utf8_path(path).parent_path()));
}

}  // namespace ocean::capi
