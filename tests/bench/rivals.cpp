// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The strongest frames that a library of transforms gives. Each variant has the same spectral
// stage, vectorised as ours is (rival_modes.hpp), and the last stage of our kernel itself
// (write_rows), so that what differs are the transforms and the traffic around them:
//   planes       half a spectrum to a real map, field by field, out of place or in place
//   pairs        two real fields in one complex map, in place
//   lines        columns, then rows with the last stage while they are in the cache
// rows packed or padded against cache-set conflicts; two threads within a transform or one field
// each. Which is best depends on machine and size: the table screens them.
#include <omp.h>

#include <array>
#include <memory>
#include <utility>

#include "frame_maps.hpp"
#include "transforms.hpp"

namespace ocean::bench {

namespace {

using Plan = std::unique_ptr<void, void (*)(void*)>;

struct Variant {
    const char* name;
    bool in_place;
    int padding;  // floats a row
    bool field_per_thread;
};

SpectralLoop loop_of(const Cell& cell, bool pairs) {
    const SpectralLoops& loops = spectral_loops(cell.level);
    if (cell.kind == FrameKind::vertices) return pairs ? loops.pairs3 : loops.planes5;
    return pairs ? loops.pairs4 : loops.planes8;
}

void fill_spectra(const RivalModes& modes, double tau, SpectralLoop loop, const MapLayout& to,
                  int threads) {
#pragma omp parallel for num_threads(threads) schedule(static)
    for (int j = 0; j < modes.rows(); ++j) {
        loop(modes.row(j, tau), to.data + to.row * j, to.plane);
    }
}

std::size_t floats(const MapLayout& layout, int maps) {
    return static_cast<std::size_t>(layout.plane) * static_cast<std::size_t>(maps);
}

/// A last stage over planes that are there.
void write_vertices(const Cell& cell, const PlanarFields& fields, const VertexMaps& maps) {
    const int n = cell.resolution();
    const auto outputs = maps.outputs();
    const KernelFrame frame{0.0, VertexMaps::settings(), outputs, {}};
#pragma omp parallel num_threads(cell.threads)
    {
        const int share = omp_get_thread_num();
        write_rows(fields, n, n * share / cell.threads, n * (share + 1) / cell.threads, frame,
                   cell.level);
    }
}

Subject subject(const char* library, std::string variant, bool pairs) {
    Subject result;
    result.library = library;
    result.variant = std::move(variant);
    result.pairs = pairs;
    // Fields of unequal size share the digits of one complex number.
    if (pairs) result.allowed_error = 2e-5;
    return result;
}

/// Half spectra to real maps.
struct Planes {
    Cell cell;
    std::vector<Linear> fields;
    MapLayout in{}, out{};
    HugeArray<float> in_memory, out_memory;
    std::unique_ptr<VertexMaps> vertices;

    Planes(const Cell& c, const Variant& variant) : cell(c), fields(fields_of(c.kind)) {
        const std::ptrdiff_t n = cell.resolution();
        const int maps = static_cast<int>(fields.size());
        in.row = n + 2 + variant.padding;
        in.plane = in.row * n + (variant.padding > 0 ? 48 : 0);
        in_memory = HugeArray<float>(floats(in, maps));
        in.data = in_memory.data();
        out = in;
        if (!variant.in_place) {
            out.row = n;
            out.plane = n * n;
            out_memory = HugeArray<float>(floats(out, maps));
            out.data = out_memory.data();
        }
        if (cell.kind == FrameKind::vertices)
            vertices = std::make_unique<VertexMaps>(cell.resolution());
    }

    FieldView field(Linear asked) const {
        if (vertices) return vertices->field(asked);
        for (std::size_t f = 0; f < fields.size(); ++f) {
            if (fields[f] != asked) continue;
            return {out.data + out.plane * static_cast<std::ptrdiff_t>(f), out.row, 1, 1.0};
        }
        return {};
    }
};

Subject planes_subject(const char* name, const TransformLibrary& library, const Cell& cell,
                       const Variant& variant) {
    const auto state = std::make_shared<Planes>(cell, variant);
    const auto plan = std::make_shared<Plan>(
        library.plan_maps({cell.resolution(), static_cast<int>(state->fields.size()), cell.threads,
                           false, variant.field_per_thread, state->in, state->out}),
        library.free_maps);
    if (!*plan) return {};
    Subject result = subject(name, variant.name, false);
    result.frame = [state, plan, &library](double time) {
        const Cell& c = state->cell;
        fill_spectra(c.rivals->half, c.sea->modes.tau(time), loop_of(c, false), state->in,
                     c.threads);
        library.run_maps(plan->get());
        if (!state->vertices) return;
        PlanarFields fields;
        fields.row_stride = static_cast<std::size_t>(state->out.row);
        for (std::size_t f = 0; f < state->fields.size(); ++f) {
            fields.plane[static_cast<std::size_t>(state->fields[f])] =
                state->out.data + state->out.plane * static_cast<std::ptrdiff_t>(f);
        }
        write_vertices(c, fields, *state->vertices);
    };
    result.field = [state](Linear field) { return state->field(field); };
    result.normal = [state](Channel channel) { return state->vertices->normal(channel); };
    return result;
}

/// Where a field is in the complex maps of SpectralLoops::pairs3 and pairs4.
struct Place {
    int map;
    int part;
};
Place place_in_pairs(Linear field) {
    constexpr std::array<Place, 8> kPlaces = {
        {{0, 0}, {1, 0}, {1, 1}, {2, 0}, {2, 1}, {3, 0}, {3, 1}, {0, 1}}};
    return kPlaces[static_cast<std::size_t>(field)];
}

/// Two real fields in one complex map.
struct Pairs {
    Cell cell;
    int maps;
    MapLayout layout{};
    HugeArray<float> memory;
    std::unique_ptr<VertexMaps> vertices;

    Pairs(const Cell& c, const Variant& variant)
        : cell(c), maps(c.kind == FrameKind::vertices ? 3 : 4) {
        const std::ptrdiff_t n = cell.resolution();
        layout.row = 2 * n + variant.padding;
        layout.plane = layout.row * n;
        memory = HugeArray<float>(floats(layout, maps));
        layout.data = memory.data();
        if (cell.kind == FrameKind::vertices)
            vertices = std::make_unique<VertexMaps>(cell.resolution());
    }

    FieldView field(Linear asked) const {
        if (vertices) return vertices->field(asked);
        const Place place = place_in_pairs(asked);
        return {layout.data + layout.plane * place.map + place.part, layout.row, 2, 1.0};
    }

    /// Row by row: the pairs are taken apart into planes that stay in the cache.
    void write() const {
        const int n = cell.resolution();
        const std::vector<Linear> fields = fields_of(cell.kind);
        const auto width = static_cast<std::size_t>(n);
#pragma omp parallel num_threads(cell.threads)
        {
            std::vector<float> rows(fields.size() * width);
            PlanarFields planes;
            planes.row_stride = width;
            for (std::size_t f = 0; f < fields.size(); ++f) {
                planes.plane[static_cast<std::size_t>(fields[f])] = rows.data() + f * width;
            }
#pragma omp for schedule(static)
            for (int j = 0; j < n; ++j) {
                for (std::size_t f = 0; f < fields.size(); ++f) {
                    const Place place = place_in_pairs(fields[f]);
                    const float* from =
                        layout.data + layout.plane * place.map + layout.row * j + place.part;
                    float* to = rows.data() + f * width;
                    for (std::size_t i = 0; i < width; ++i) to[i] = from[2 * i];
                }
                const auto outputs = vertices->outputs(j);
                write_rows(planes, n, 0, 1, {0.0, VertexMaps::settings(), outputs, {}}, cell.level);
            }
        }
    }
};

Subject pairs_subject(const char* name, const TransformLibrary& library, const Cell& cell,
                      const Variant& variant) {
    const auto state = std::make_shared<Pairs>(cell, variant);
    const auto plan = std::make_shared<Plan>(
        library.plan_maps({cell.resolution(), state->maps, cell.threads, true,
                           variant.field_per_thread, state->layout, state->layout}),
        library.free_maps);
    if (!*plan) return {};
    Subject result = subject(name, variant.name, true);
    result.frame = [state, plan, &library](double time) {
        const Cell& c = state->cell;
        fill_spectra(c.rivals->full, c.sea->modes.tau(time), loop_of(c, true), state->layout,
                     c.threads);
        library.run_maps(plan->get());
        if (state->vertices) state->write();
    };
    result.field = [state](Linear field) { return state->field(field); };
    result.normal = [state](Channel channel) { return state->vertices->normal(channel); };
    return result;
}

/// Our own rows and columns over the library's lines. The Nyquist column is zero: it stays as the
/// spectral stage leaves it.
struct Lines {
    static constexpr int kColumns = 16;
    static constexpr int kRows = 4;

    Cell cell;
    std::vector<Linear> fields;
    MapLayout in{};
    std::ptrdiff_t out_row;
    HugeArray<float> in_memory, rows;
    std::unique_ptr<VertexMaps> vertices;
    std::unique_ptr<PlanarMaps> planes;

    explicit Lines(const Cell& c) : cell(c), fields(fields_of(c.kind)) {
        const std::ptrdiff_t n = cell.resolution();
        in.row = n + 32;
        in.plane = in.row * n + 48;
        in_memory = HugeArray<float>(floats(in, static_cast<int>(fields.size())));
        in.data = in_memory.data();
        if (cell.kind == FrameKind::vertices) {
            vertices = std::make_unique<VertexMaps>(cell.resolution());
            out_row = n + 16;
            rows = HugeArray<float>(static_cast<std::size_t>(cell.threads) * rows_size());
        } else {
            planes = std::make_unique<PlanarMaps>(cell.resolution(), fields);
            out_row = n;
        }
    }

    std::size_t rows_size() const {
        return fields.size() * kRows * static_cast<std::size_t>(out_row);
    }
    float* spectra(std::size_t field, std::ptrdiff_t j) const {
        return in.data + in.plane * static_cast<std::ptrdiff_t>(field) + in.row * j;
    }

    void write(const TransformLibrary& library, void* plan, int j, float* own_rows) const {
        PlanarFields in_cache;
        in_cache.row_stride = static_cast<std::size_t>(out_row);
        for (std::size_t f = 0; f < fields.size(); ++f) {
            float* to = planes ? planes->plane(f) + out_row * j
                               : own_rows + f * kRows * in_cache.row_stride;
            library.run_rows(plan, spectra(f, j), to);
            in_cache.plane[static_cast<std::size_t>(fields[f])] = to;
        }
        if (planes) return;
        const auto outputs = vertices->outputs(j);
        write_rows(in_cache, cell.resolution(), 0, kRows,
                   {0.0, VertexMaps::settings(), outputs, {}}, cell.level);
    }

    void run(const TransformLibrary& library, void* plan) const {
        const int n = cell.resolution();
        const int blocks = n / 2 / kColumns;
#pragma omp parallel num_threads(cell.threads)
        {
#pragma omp for schedule(static)
            for (int i = 0; i < static_cast<int>(fields.size()) * blocks; ++i) {
                library.run_columns(plan,
                                    spectra(static_cast<std::size_t>(i / blocks), 0) +
                                        2 * kColumns * static_cast<std::ptrdiff_t>(i % blocks));
            }
            float* own_rows =
                vertices
                    ? rows.data() + static_cast<std::size_t>(omp_get_thread_num()) * rows_size()
                    : nullptr;
#pragma omp for schedule(static)
            for (int j = 0; j < n; j += kRows) write(library, plan, j, own_rows);
        }
    }
};

Subject lines_subject(const char* name, const TransformLibrary& library, const Cell& cell) {
    const auto state = std::make_shared<Lines>(cell);
    const auto plan =
        std::make_shared<Plan>(library.plan_lines({cell.resolution(), Lines::kColumns, Lines::kRows,
                                                   state->in.row, state->out_row}),
                               library.free_lines);
    if (!*plan) return {};
    Subject result = subject(name, "lines", false);
    result.frame = [state, plan, &library](double time) {
        const Cell& c = state->cell;
        fill_spectra(c.rivals->half, c.sea->modes.tau(time), loop_of(c, false), state->in,
                     c.threads);
        state->run(library, plan->get());
    };
    result.field = [state](Linear field) {
        return state->vertices ? state->vertices->field(field) : state->planes->field(field);
    };
    result.normal = [state](Channel channel) { return state->vertices->normal(channel); };
    return result;
}

void add_variants(const char* name, const TransformLibrary& library,
                  std::vector<SubjectMaker>& makers) {
    static constexpr Variant kPlanes[] = {{"out of place", false, 0, false},
                                          {"out of place, padded", false, 30, false},
                                          {"in place", true, 0, false},
                                          {"in place, padded", true, 30, false},
                                          {"out of place, a field a thread", false, 0, true},
                                          {"in place, a field a thread", true, 30, true}};
    static constexpr Variant kPairs[] = {{"pairs", true, 0, false},
                                         {"pairs, padded", true, 16, false},
                                         {"pairs, a map a thread", true, 16, true}};
    for (const Variant& variant : kPlanes) {
        makers.push_back({name, variant.name, variant.field_per_thread ? 2 : 1,
                          [name, &library, &variant](const Cell& cell) {
                              return planes_subject(name, library, cell, variant);
                          }});
    }
    for (const Variant& variant : kPairs) {
        makers.push_back({name, variant.name, variant.field_per_thread ? 2 : 1,
                          [name, &library, &variant](const Cell& cell) {
                              return pairs_subject(name, library, cell, variant);
                          }});
    }
    makers.push_back({name, "lines", 1, [name, &library](const Cell& cell) {
                          return lines_subject(name, library, cell);
                      }});
}

}  // namespace

std::vector<SubjectMaker> rival_makers(SimdLevel level) {
    std::vector<SubjectMaker> makers;
    add_variants("FFTW3f", fftw_library(), makers);
    const TransformLibrary* const mkl = mkl_library(level);
    if (mkl != nullptr) add_variants("MKL", *mkl, makers);
    return makers;
}

}  // namespace ocean::bench
