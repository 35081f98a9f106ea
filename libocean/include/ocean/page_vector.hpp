// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Vectors for large maps that are walked through with large steps: aligned for huge pages, which
// are requested from the system, and not filled with zeros first.
//
//     PageVector<float> map(resolution * resolution);  // not filled with zeros
//     std::vector<float> copy(map.begin(), map.end());
#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace ocean {

/// Returns uninitialised memory for large arrays: from 2 MiB on aligned to 2 MiB, with huge pages
/// requested; below, aligned to 64 bytes. Returns nullptr for 0 bytes. Throws std::bad_alloc.
void* allocate_pages(std::size_t bytes);
/// Frees memory of allocate_pages.
void free_pages(void* pages, std::size_t bytes);

/// Memory from allocate_pages; elements without an initial value are left uninitialised.
template <typename T>
struct PageAllocator {
    using value_type = T;

    PageAllocator() = default;
    template <typename U>
    PageAllocator(const PageAllocator<U>&) {}

    T* allocate(std::size_t n) { return static_cast<T*>(allocate_pages(n * sizeof(T))); }
    void deallocate(T* p, std::size_t n) { free_pages(p, n * sizeof(T)); }
    template <typename U>
    void construct(U* p) {
        // std::complex would set itself to zero.
        if constexpr (!std::is_trivially_copyable_v<U>) ::new (static_cast<void*>(p)) U;
    }
    template <typename U, typename... Arguments>
    void construct(U* p, Arguments&&... arguments) {
        std::construct_at(p, std::forward<Arguments>(arguments)...);
    }
    bool operator==(const PageAllocator&) const { return true; }
};

template <typename T>
using PageVector = std::vector<T, PageAllocator<T>>;

}  // namespace ocean
