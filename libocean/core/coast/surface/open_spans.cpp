// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "coast/surface/open_spans.hpp"

#include <array>
#include <vector>

#include "coast/statics/shore_blend.hpp"
#include "field/quad_grid.hpp"
#include "ocean/thread_pool.hpp"

namespace ocean {
namespace {

/// Adds the labels first .. first + count - 1 of row j.
void add_block(const ShoreStatics& statics, const Domain& labels, int j, int first,
               std::size_t count, OpenSpans& spans) {
    const Domain& domain = statics.domain();
    std::array<double, kShoreBlock> x{}, y{};
    for (std::size_t i = 0; i < count; ++i) {
        const auto place = labels.place(first + static_cast<int>(i), j);
        x[i] = place[0];
        y[i] = place[1];
    }
    GridPlaces places;
    QuadBlock ground, remainder;
    places.find(domain, count, x.data(), y.data());
    statics.delays->ground.read(places, false, ground);
    places.find(statics.energy->remainder.domain(), count, x.data(), y.data());
    statics.energy->remainder.read(places, false, remainder);
    for (std::size_t i = 0; i < count; ++i) {
        const float share = statics.share_of_coast(x[i], y[i]).value();
        const Plain lee(statics.energy->lee.at(x[i], y[i]).height.value());
        const float bed_influence =
            share > 0.0f
                ? bed_influence_in_lee(bed_influence_at<Plain>(ground, remainder, i), lee).value()
                : 0.0f;
        if (share < 1.0f || bed_influence < 1.0f) spans.open.add(x[i]);
        if (bed_influence > 0.0f) spans.remainder.add(x[i]);
    }
}

}  // namespace

OpenSpans find_open_spans(const ShoreStatics& statics, const Domain& labels, ThreadPool& pool) {
    std::vector<OpenSpans> rows(static_cast<std::size_t>(labels.samples[1]));
    pool.for_each_item(labels.samples[1], [&](int j, int) {
        const int columns = labels.samples[0];
        for (int first = 0; first < columns; first += static_cast<int>(kShoreBlock)) {
            const auto left = static_cast<std::size_t>(columns - first);
            add_block(statics, labels, j, first, std::min(left, kShoreBlock),
                      rows[static_cast<std::size_t>(j)]);
        }
    });
    OpenSpans spans;
    for (const OpenSpans& row : rows) {
        spans.open.add(row.open);
        spans.remainder.add(row.remainder);
    }
    return spans;
}

}  // namespace ocean
