// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Where the surface of a coast reads the maps of waves that no bed has changed. Maps are transforms
// of a whole period, made in strips along y: a region that feels its bed everywhere needs maps of
// few waves, and a small region needs few strips.
#pragma once

#include <algorithm>
#include <limits>

#include "coast/statics/shore_statics.hpp"
#include "ocean/domain.hpp"

namespace ocean {

class ThreadPool;

/// A range of x [m]. Empty until a place is added.
struct SpanAlongX {
    double first = std::numeric_limits<double>::infinity();
    double last = -std::numeric_limits<double>::infinity();

    bool is_empty() const { return first > last; }
    void add(double x) {
        first = std::min(first, x);
        last = std::max(last, x);
    }
    void add(const SpanAlongX& other) {
        first = std::min(first, other.first);
        last = std::max(last, other.last);
    }
};

/// The labels at which the maps are read.
struct OpenSpans {
    SpanAlongX open;       // maps of all waves: labels with bed_influence < 1
    SpanAlongX remainder;  // maps of the waves in no band: bed_influence > 0
};

/// Returns the spans of a lattice of labels.
OpenSpans find_open_spans(const ShoreStatics& statics, const Domain& labels, ThreadPool& pool);

}  // namespace ocean
