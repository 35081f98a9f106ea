// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// FFTW3f, planned with FFTW_MEASURE. GPL: this program alone links it, and is not installed.
#include <fftw3.h>

#include <memory>

#include "huge_array.hpp"
#include "ocean/internal/map_request.hpp"
#include "transforms.hpp"

namespace ocean::bench {

namespace {

fftwf_complex* as_complex(float* data) {
    return reinterpret_cast<fftwf_complex*>(data);
}

int narrow(std::ptrdiff_t value) {
    return static_cast<int>(value);
}

struct MapPlan {
    MapRequest request;
    fftwf_plan plan;

    void run(int map) const {
        float* in = request.in.data + request.in.plane * map;
        float* out = request.out.data + request.out.plane * map;
        if (request.complex) {
            fftwf_execute_dft(plan, as_complex(in), as_complex(out));
        } else {
            fftwf_execute_dft_c2r(plan, as_complex(in), out);
        }
    }
};

void* plan_maps(const MapRequest& r) {
    static const bool threads_ready = fftwf_init_threads() != 0;
    fftwf_plan_with_nthreads(threads_ready && !r.field_per_thread ? r.threads : 1);
    const int in_row = narrow(r.in.row / 2);
    fftwf_plan plan = nullptr;
    if (r.complex) {
        const fftwf_iodim axes[2] = {{r.n, in_row, narrow(r.out.row / 2)}, {r.n, 1, 1}};
        plan = fftwf_plan_guru_dft(2, axes, 0, nullptr, as_complex(r.in.data),
                                   as_complex(r.out.data), FFTW_BACKWARD, FFTW_MEASURE);
    } else {
        const fftwf_iodim axes[2] = {{r.n, in_row, narrow(r.out.row)}, {r.n, 1, 1}};
        plan = fftwf_plan_guru_dft_c2r(2, axes, 0, nullptr, as_complex(r.in.data), r.out.data,
                                       FFTW_MEASURE | FFTW_DESTROY_INPUT);
    }
    return plan == nullptr ? nullptr : new MapPlan{r, plan};
}

void run_maps(void* plan) {
    const MapPlan& p = *static_cast<MapPlan*>(plan);
    if (p.request.field_per_thread) {
#pragma omp parallel for num_threads(p.request.threads) schedule(dynamic, 1)
        for (int map = 0; map < p.request.maps; ++map) p.run(map);
    } else {
        for (int map = 0; map < p.request.maps; ++map) p.run(map);
    }
}

void free_maps(void* plan) {
    const std::unique_ptr<MapPlan> p(static_cast<MapPlan*>(plan));
    fftwf_destroy_plan(p->plan);
}

struct LinePlan {
    fftwf_plan columns;
    fftwf_plan rows;
};

void* plan_lines(const LineRequest& r) {
    fftwf_plan_with_nthreads(1);
    const int in_row = narrow(r.in_row / 2);
    const HugeArray<float> in(static_cast<std::size_t>(r.in_row) * static_cast<std::size_t>(r.n));
    const HugeArray<float> out(static_cast<std::size_t>(r.out_row) *
                               static_cast<std::size_t>(r.rows));
    const fftwf_iodim column = {r.n, in_row, in_row};
    const fftwf_iodim columns = {r.columns, 1, 1};
    const fftwf_iodim row = {r.n, 1, 1};
    const fftwf_iodim rows = {r.rows, in_row, narrow(r.out_row)};
    return new LinePlan{fftwf_plan_guru_dft(1, &column, 1, &columns, as_complex(in.data()),
                                            as_complex(in.data()), FFTW_BACKWARD, FFTW_MEASURE),
                        fftwf_plan_guru_dft_c2r(1, &row, 1, &rows, as_complex(in.data()),
                                                out.data(), FFTW_MEASURE)};
}

void run_columns(void* plan, float* spectra) {
    fftwf_execute_dft(static_cast<LinePlan*>(plan)->columns, as_complex(spectra),
                      as_complex(spectra));
}

void run_rows(void* plan, float* spectra, float* real) {
    fftwf_execute_dft_c2r(static_cast<LinePlan*>(plan)->rows, as_complex(spectra), real);
}

void free_lines(void* plan) {
    const std::unique_ptr<LinePlan> p(static_cast<LinePlan*>(plan));
    fftwf_destroy_plan(p->columns);
    fftwf_destroy_plan(p->rows);
}

const char* version() {
    return fftwf_version;
}

}  // namespace

const TransformLibrary& fftw_library() {
    static constexpr TransformLibrary kLibrary = {version,    plan_maps,   run_maps, free_maps,
                                                  plan_lines, run_columns, run_rows, free_lines};
    return kLibrary;
}

}  // namespace ocean::bench
