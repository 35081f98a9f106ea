// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Provides the memory of a large map before it is written.
#pragma once

#include <cstddef>

#include "ocean/page_vector.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {

/// Makes the system clear the huge pages of a vector now, on all threads and interruptibly.
/// Otherwise the first thread that writes a column of a map of 8192 x 8192 waits for all pages: a
/// tenth of a second [measured]. Loses the values.
template <typename T>
void prefault_pages(PageVector<T>& values, ThreadPool& pool) {
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
