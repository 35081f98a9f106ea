// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Parts of a frame's outputs. Pass two makes them one after the other for each item, so that the
// data between its sweeps stay in a core's second cache. The price is small: two parts that need
// the same source both read it.
#pragma once

#include <cstddef>
#include <span>

#include "ocean/channel.hpp"

namespace ocean {

/// Disjoint sets of linear fields.
class FrameParts {
  public:
    /// Adds the fields of an output, and joins the parts that share one of them.
    void add(LinearSet fields) {
        if (fields.empty()) return;
        int kept = 0;
        for (int part = 0; part < count_; ++part) {
            if (part_[part].intersects(fields)) {
                fields = fields | part_[part];
            } else {
                part_[kept++] = part_[part];
            }
        }
        part_[kept] = fields;
        count_ = kept + 1;
    }

    /// Joins parts while they have no more than `most` fields.
    void join(std::size_t most) {
        int kept = 0;
        for (int part = 1; part < count_; ++part) {
            const LinearSet both = part_[kept] | part_[part];
            if (static_cast<std::size_t>(both.size()) <= most) {
                part_[kept] = both;
            } else {
                part_[++kept] = part_[part];
            }
        }
        count_ = kept + 1;
    }

    /// Returns how many parts there are, at least 1 after join().
    int count() const { return count_; }
    /// Returns the part of an output with these fields; the first part if there are no fields.
    int of(LinearSet fields) const {
        int part = 0;
        while (part + 1 < count_ && !part_[part].contains(fields)) ++part;
        return part;
    }

  private:
    LinearSet part_[kLinearCount + 1];
    int count_ = 0;
};

}  // namespace ocean
