// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The promises of every reader of elevation models: a domain of finite numbers, as many heights as
// samples, each within the limits or a hole that was requested, notes and errors that are safe to
// print.
#pragma once

#include <cmath>

#include "ocean/internal/elevation_file.hpp"
#include "reader_fuzzer.hpp"

namespace ocean::fuzz {

inline void check_model(const ElevationModel& model, HolePolicy holes) {
    require(!model.domain.wraps && model.heights.size() == model.domain.count());
    for (std::size_t axis = 0; axis < 2; ++axis) {
        require(std::isfinite(model.domain.origin[axis]) && model.domain.size[axis] >= 0.0);
        require(model.domain.samples[axis] >= kMinElevationSide);
    }
    for (const float height : model.heights) {
        if (std::isnan(height)) require(holes == HolePolicy::keep);
        if (!std::isnan(height)) require(std::abs(height) <= 1.001 * kMaxElevation);
    }
    for (const std::string& note : model.notes) check_message(note);
    summarize(model);
}

template <typename Read>
void check_reader(HolePolicy holes, const Read& read) {
    try {
        check_model(read(ElevationOptions{.holes = holes}), holes);
    } catch (const Error& error) {
        check_message(error.what());
    }
}

}  // namespace ocean::fuzz
