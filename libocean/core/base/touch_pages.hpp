// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Memory behind a large map before it is written.
#pragma once

#include <cstddef>

#include "ocean/page_vector.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

/// Has the system clear its huge pages now, by all threads and so that a call may be stopped in
/// between. Who first writes a column of a map of 8192 x 8192 otherwise waits for all of them:
/// a tenth of a second [measured]. Values are lost.
template <typename T>
void touch_pages(PageVector<T>& values, ThreadPool& pool) {
    constexpr std::size_t kHugePage = std::size_t{2} << 20;
    volatile char* const bytes = reinterpret_cast<char*>(values.data());
    const std::size_t pages = values.size() * sizeof(T) / kHugePage;
    pool.for_each_range(static_cast<int>(pages), [&](int first, int last) {
        for (int page = first; page < last; ++page) {
            bytes[static_cast<std::size_t>(page) * kHugePage] = 0;
        }
    });
}

}  // namespace ocean
