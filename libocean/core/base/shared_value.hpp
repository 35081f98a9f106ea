// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A large value that copies of its owner share, in other threads too, until one of them replaces
// it. Its memory is reused if no copy ever had it.
#pragma once

#include <atomic>
#include <memory>
#include <utility>

namespace ocean {

template <typename T>
class SharedValue {
  public:
    SharedValue() = default;
    SharedValue(const SharedValue& other) : value_(other.value_), lent_(true) {
        other.lent_ = true;
    }
    SharedValue& operator=(std::shared_ptr<T> value) {
        value_ = std::move(value);
        lent_ = false;
        return *this;
    }

    const T* get() const { return value_.get(); }
    std::shared_ptr<const T> share() const { return value_; }
    /// Returns the value for modification; null if there is no value or a copy has shared it.
    /// Counting the owners would not suffice, because a thread that has just released the value may
    /// still be reading it.
    T* own() { return lent_ ? nullptr : value_.get(); }

  private:
    std::shared_ptr<T> value_;
    mutable std::atomic<bool> lent_ = false;
};

}  // namespace ocean
