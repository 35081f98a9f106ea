// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The large arrays of the benchmark's subjects. On huge pages where the system gives them: a
// transform that strides through 4 KB pages is 2 to 6 % slower, and nobody is to lose by that.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>

namespace ocean::bench {

/// `size` zeros, aligned to a huge page.
template <typename T>
class HugeArray {
  public:
    HugeArray() = default;
    explicit HugeArray(std::size_t size) {
        constexpr std::size_t kPage = std::size_t{2} << 20;
        const std::size_t bytes = (size * sizeof(T) + kPage - 1) / kPage * kPage;
        void* memory = std::aligned_alloc(kPage, bytes);
        if (memory == nullptr) throw std::bad_alloc();
        madvise(memory, bytes, MADV_HUGEPAGE);
        data_.reset(static_cast<T*>(memory));
        std::uninitialized_value_construct_n(data_.get(), size);
    }

    T* data() const { return data_.get(); }
    T& operator[](std::size_t i) const { return data_[i]; }

  private:
    struct Free {
        void operator()(T* memory) const { std::free(memory); }
    };
    std::unique_ptr<T[], Free> data_;
};

}  // namespace ocean::bench
