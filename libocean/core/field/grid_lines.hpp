// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Lines of a grid. Separable operations (blurs, distances) work along rows and along columns by the
// same code, on blocks of neighbouring lines that are copied into a buffer.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "ocean/thread_pool.hpp"

namespace ocean {

/// The samples of a row-major grid along x and y.
struct SampleGrid {
    int columns;
    int rows;

    std::size_t count() const {
        return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    }
    std::size_t index(int i, int j) const {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(i);
    }
};

/// The rows or the columns of a grid: sample k of line l has the index l across + k along.
struct GridLines {
    int count;
    int length;
    std::size_t across;
    std::size_t along;

    static GridLines rows(const SampleGrid& grid) {
        return {grid.rows, grid.columns, static_cast<std::size_t>(grid.columns), 1};
    }
    static GridLines columns(const SampleGrid& grid) {
        return {grid.columns, grid.rows, 1, static_cast<std::size_t>(grid.columns)};
    }
    std::size_t index(int line, int k) const {
        return static_cast<std::size_t>(line) * across + static_cast<std::size_t>(k) * along;
    }
};

/// Lines of a block: one float of each fills a cache line.
inline constexpr int kGridLanes = 16;

/// Copies lines first .. first + lanes - 1 one after the other: sample k of the line first + l goes
/// to buffer[l length + k].
template <typename T>
void load_lines(const T* map, const GridLines& lines, int first, int lanes, T* buffer) {
    for (int k = 0; k < lines.length; ++k) {
        for (int l = 0; l < lanes; ++l) {
            buffer[l * lines.length + k] = map[lines.index(first + l, k)];
        }
    }
}
/// Copies a buffer back to the lines of load_lines.
template <typename T>
void store_lines(const T* buffer, const GridLines& lines, int first, int lanes, T* map) {
    for (int k = 0; k < lines.length; ++k) {
        for (int l = 0; l < lanes; ++l) {
            map[lines.index(first + l, k)] = buffer[l * lines.length + k];
        }
    }
}

/// A buffer for each thread of a pool. It keeps the largest requested size.
template <typename T>
class LineBuffers {
  public:
    explicit LineBuffers(const ThreadPool& pool)
        : buffers_(static_cast<std::size_t>(pool.size())) {}

    T* of(int thread, std::size_t size) {
        std::vector<T>& buffer = buffers_[static_cast<std::size_t>(thread)];
        if (buffer.size() < size) buffer.resize(size);
        return buffer.data();
    }

  private:
    std::vector<std::vector<T>> buffers_;
};

/// Runs passes over blocks of lines in the pool and reports progress between batches of them, so
/// that a report that throws stops soon.
class GridPasses {
  public:
    GridPasses(ThreadPool& pool, std::function<void(double share)> report, int passes)
        : pool_(pool), report_(std::move(report)), passes_(passes) {}

    ThreadPool& pool() { return pool_; }

    /// Calls body(first, lanes, thread) for blocks of `lines` lines.
    void run(int lines, const std::function<void(int first, int lanes, int thread)>& body) {
        const int blocks = (lines + kGridLanes - 1) / kGridLanes;
        const int batch = report_ ? std::max(blocks / kReports, 4 * pool_.size()) : blocks;
        for (int begin = 0; begin < blocks; begin += batch) {
            report((done_ + static_cast<double>(begin) / blocks) / passes_);
            pool_.for_each_item(std::min(batch, blocks - begin), [&](int item, int thread) {
                const int first = (begin + item) * kGridLanes;
                body(first, std::min(kGridLanes, lines - first), thread);
            });
        }
        ++done_;
    }
    void report(double share) const {
        if (report_) report_(share);
    }

  private:
    static constexpr int kReports = 8;  // within a pass

    ThreadPool& pool_;
    std::function<void(double share)> report_;
    int passes_;
    int done_ = 0;
};

}  // namespace ocean
