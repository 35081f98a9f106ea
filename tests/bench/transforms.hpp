// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// What the benchmark asks of a library of Fourier transforms, FFTW3f or MKL: inverse transforms of
// several maps, and of lines alone. A table of plain functions, because MKL's are in a module that
// is loaded if it is there.
#pragma once

#include <cstddef>

#include "base/simd/simd_level.hpp"
#include "ocean/internal/map_request.hpp"

namespace ocean::bench {

/// Maps one after the other: `row` floats from row to row, `plane` from map to map.
struct MapLayout {
    float* data;
    std::ptrdiff_t row;
    std::ptrdiff_t plane;
};

struct MapRequest {
    int n;
    int maps;
    int threads;
    bool complex;           // else from half a spectrum to real maps
    bool field_per_thread;  // else all threads on one map after the other
    MapLayout in;
    MapLayout out;  // the same as `in`: in place
};

/// A real map by its lines: first `columns` columns at a time, complex, in place; then `rows` rows
/// at a time to real ones.
struct LineRequest {
    int n;
    int columns;
    int rows;
    std::ptrdiff_t in_row;  // floats
    std::ptrdiff_t out_row;
};

struct TransformLibrary {
    const char* (*version)();
    /// Null where the library refuses.
    void* (*plan_maps)(const MapRequest& request);
    void (*run_maps)(void* plan);
    void (*free_maps)(void* plan);
    void* (*plan_lines)(const LineRequest& request);
    void (*run_columns)(void* plan, float* spectra);
    void (*run_rows)(void* plan, float* spectra, float* real);
    void (*free_lines)(void* plan);
};

/// Debian's FFTW3f.
const TransformLibrary& fftw_library();
/// Null if the module is not there. `level` is the most that MKL may use; it is fixed by the first
/// call in a process.
const TransformLibrary* mkl_library(SimdLevel level);

}  // namespace ocean::bench
