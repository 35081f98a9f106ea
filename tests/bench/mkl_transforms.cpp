// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Intel MKL's transforms, a module of its own: the benchmark needs no MKL to be built or to run.
#include <mkl_dfti.h>
#include <mkl_service.h>

#include <cstdio>
#include <initializer_list>
#include <memory>

#include "ocean/internal/map_request.hpp"
#include "transforms.hpp"

namespace ocean::bench {

namespace {

/// Strides along the first and the second axis, in elements.
using Strides = std::initializer_list<MKL_LONG>;

class Descriptor {
  public:
    Descriptor(DFTI_CONFIG_VALUE domain, std::initializer_list<MKL_LONG> lengths) {
        if (lengths.size() == 1) {
            status_ = DftiCreateDescriptor(&handle_, DFTI_SINGLE, domain, 1, *lengths.begin());
        } else {
            status_ = DftiCreateDescriptor(&handle_, DFTI_SINGLE, domain,
                                           static_cast<MKL_LONG>(lengths.size()), lengths.begin());
        }
        if (domain == DFTI_REAL) set(DFTI_CONJUGATE_EVEN_STORAGE, DFTI_COMPLEX_COMPLEX);
    }
    ~Descriptor() { DftiFreeDescriptor(&handle_); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    template <typename Value>
    void set(DFTI_CONFIG_PARAM parameter, Value value) {
        if (status_ == DFTI_NO_ERROR) status_ = DftiSetValue(handle_, parameter, value);
    }
    /// From the spectrum ("backward") to the map ("forward").
    void set_strides(Strides spectrum, Strides map) {
        set(DFTI_BWD_STRIDES, spectrum.begin());
        set(DFTI_FWD_STRIDES, map.begin());
    }
    void set_distances(MKL_LONG spectrum, MKL_LONG map) {
        set(DFTI_BWD_DISTANCE, spectrum);
        set(DFTI_FWD_DISTANCE, map);
    }
    bool commit() {
        if (status_ == DFTI_NO_ERROR) status_ = DftiCommitDescriptor(handle_);
        return status_ == DFTI_NO_ERROR;
    }
    void run(float* in, float* out) const {
        if (in == out) {
            DftiComputeBackward(handle_, in);
        } else {
            DftiComputeBackward(handle_, in, out);
        }
    }

  private:
    DFTI_DESCRIPTOR_HANDLE handle_ = nullptr;
    MKL_LONG status_ = DFTI_NO_ERROR;
};

struct MapPlan {
    explicit MapPlan(const MapRequest& r)
        : request(r), descriptor(r.complex ? DFTI_COMPLEX : DFTI_REAL, {r.n, r.n}) {}
    void run(int map) const {
        descriptor.run(request.in.data + request.in.plane * map,
                       request.out.data + request.out.plane * map);
    }

    MapRequest request;
    Descriptor descriptor;
};

void* plan_maps(const MapRequest& r) {
    auto plan = std::make_unique<MapPlan>(r);
    Descriptor& d = plan->descriptor;
    d.set(DFTI_PLACEMENT, r.in.data == r.out.data ? DFTI_INPLACE : DFTI_NOT_INPLACE);
    d.set_strides({0, r.in.row / 2, 1}, {0, r.complex ? r.out.row / 2 : r.out.row, 1});
    d.set(DFTI_THREAD_LIMIT, static_cast<MKL_LONG>(r.field_per_thread ? 1 : r.threads));
    if (r.field_per_thread) d.set(DFTI_NUMBER_OF_USER_THREADS, static_cast<MKL_LONG>(r.threads));
    return d.commit() ? plan.release() : nullptr;
}

void run_maps(void* plan) {
    const MapPlan& p = *static_cast<MapPlan*>(plan);
    mkl_set_dynamic(0);
    mkl_set_num_threads(p.request.threads);
    if (p.request.field_per_thread) {
#pragma omp parallel for num_threads(p.request.threads) schedule(dynamic, 1)
        for (int map = 0; map < p.request.maps; ++map) p.run(map);
    } else {
        for (int map = 0; map < p.request.maps; ++map) p.run(map);
    }
}

void free_maps(void* plan) {
    delete static_cast<MapPlan*>(plan);
}

struct LinePlan {
    Descriptor columns;
    Descriptor rows;
};

void* plan_lines(const LineRequest& r) {
    auto plan = std::unique_ptr<LinePlan>(new LinePlan{{DFTI_COMPLEX, {r.n}}, {DFTI_REAL, {r.n}}});
    Descriptor& columns = plan->columns;
    columns.set(DFTI_PLACEMENT, DFTI_INPLACE);
    columns.set(DFTI_NUMBER_OF_TRANSFORMS, static_cast<MKL_LONG>(r.columns));
    columns.set_strides({0, r.in_row / 2}, {0, r.in_row / 2});
    columns.set_distances(1, 1);
    Descriptor& rows = plan->rows;
    rows.set(DFTI_PLACEMENT, DFTI_NOT_INPLACE);
    rows.set(DFTI_NUMBER_OF_TRANSFORMS, static_cast<MKL_LONG>(r.rows));
    rows.set_strides({0, 1}, {0, 1});
    rows.set_distances(r.in_row / 2, r.out_row);
    for (Descriptor* d : {&columns, &rows}) d->set(DFTI_THREAD_LIMIT, static_cast<MKL_LONG>(1));
    return columns.commit() && rows.commit() ? plan.release() : nullptr;
}

void run_columns(void* plan, float* spectra) {
    static_cast<LinePlan*>(plan)->columns.run(spectra, spectra);
}

void run_rows(void* plan, float* spectra, float* real) {
    static_cast<LinePlan*>(plan)->rows.run(spectra, real);
}

void free_lines(void* plan) {
    delete static_cast<LinePlan*>(plan);
}

const char* version() {
    static char text[32];
    MKLVersion found;
    mkl_get_version(&found);
    std::snprintf(text, sizeof(text), "%d.%d", found.MajorVersion, found.UpdateVersion);
    return text;
}

}  // namespace

}  // namespace ocean::bench

extern "C" __attribute__((visibility("default"))) const ocean::bench::TransformLibrary*
ocean_bench_mkl() {
    using namespace ocean::bench;
    static constexpr TransformLibrary kLibrary = {version,    plan_maps,   run_maps, free_maps,
                                                  plan_lines, run_columns, run_rows, free_lines};
    return &kLibrary;
}
