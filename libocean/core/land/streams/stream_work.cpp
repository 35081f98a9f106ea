// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Batches of work between reports: see stream_work.hpp.
#include "land/streams/stream_work.hpp"

#include <algorithm>

namespace ocean {

void StreamWork::add(double work) {
    done_ += work;
    if (!progress_) return;
    const Clock::time_point now = Clock::now();
    if (now < next_) return;
    progress_(std::min(1.0, done_ / total_));
    next_ = Clock::now() + std::chrono::milliseconds(40);
}

void StreamWork::each(int count, double work, const std::function<void(int item)>& body) {
    constexpr double kBatch = 1.5e7;  // nanoseconds of one thread
    const int batch = static_cast<int>(std::clamp(kBatch / work, 16.0, 1e6));
    for (int first = 0; first < count; first += batch) {
        const int items = std::min(batch, count - first);
        pool_.for_each_item(items, [&](int item, int) { body(first + item); });
        add(work * items);
    }
}

void StreamWork::rows(const StreamGrid& grid, double cost,
                      const std::function<void(int first, int last)>& body) {
    constexpr int kCells = 1 << 14;  // cells of a block
    const int height = std::max(1, kCells / grid.columns);
    const int blocks = (grid.rows + height - 1) / height;
    each(blocks, cost * height * grid.columns,
         [&](int block) { body(block * height, std::min(grid.rows, (block + 1) * height)); });
}

}  // namespace ocean
