// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// How Blender's ocean modifier makes a frame, rebuilt from a description of its method: the half
// spectrum of the height in double, each mode with its angular frequency found anew, once for each
// direction; then a task for each field, which multiplies by the field's factors, found again for
// each mode, and runs a serial c2r transform of FFTW in double (FFTW_ESTIMATE, out of place, arrays
// of its own). In its favour: products stay in double, and the last stage is ours.
#include <fftw3.h>
#include <omp.h>

#include <array>
#include <cmath>
#include <complex>
#include <memory>
#include <vector>

#include "frame_maps.hpp"

namespace ocean::bench {

namespace {

using Complex = std::complex<double>;
constexpr int kFields = 5;

struct Free {
    void operator()(void* memory) const { fftw_free(memory); }
};
template <typename T>
std::unique_ptr<T[], Free> fftw_array(std::size_t size) {
    return std::unique_ptr<T[], Free>(static_cast<T*>(fftw_malloc(size * sizeof(T))));
}

class BlenderScheme {
  public:
    explicit BlenderScheme(const Cell& cell)
        : cell_(cell),
          modes_(cell.sea->modes.cascades.front()),
          n_(cell.resolution()),
          half_(n_ / 2 + 1),
          height_(fftw_array<Complex>(size(half_))),
          wavenumber_(size(half_)),
          vertices_(n_) {
        for (int j = 0; j < n_; ++j) {
            for (int i = 0; i < half_; ++i) {
                wavenumber_[at(j, i, half_)] = static_cast<float>(std::hypot(kx(i), ky(j)));
            }
        }
        for (Task& task : tasks_) {
            task.in = fftw_array<Complex>(size(half_));
            task.out = fftw_array<double>(size(n_));
            task.plan = fftw_plan_dft_c2r_2d(n_, n_, reinterpret_cast<fftw_complex*>(task.in.get()),
                                             task.out.get(), FFTW_ESTIMATE);
        }
    }
    ~BlenderScheme() {
        for (const Task& task : tasks_) fftw_destroy_plan(task.plan);
    }
    BlenderScheme(const BlenderScheme&) = delete;
    BlenderScheme& operator=(const BlenderScheme&) = delete;

    void frame(double time) {
#pragma omp parallel for num_threads(cell_.threads) schedule(static)
        for (int j = 0; j < n_; ++j) height_row(j, static_cast<float>(time));
#pragma omp parallel for num_threads(cell_.threads) schedule(dynamic, 1)
        for (int f = 0; f < kFields; ++f) run_task(f);
        write();
    }

    const VertexMaps& maps() const {
        return vertices_;
    }

  private:
    struct Task {
        std::unique_ptr<Complex[], Free> in;
        std::unique_ptr<double[], Free> out;
        fftw_plan plan = nullptr;
    };

    std::size_t size(int columns) const {
        return static_cast<std::size_t>(n_) * static_cast<std::size_t>(columns);
    }
    std::size_t at(int j, int i, int columns) const {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(i);
    }

    float angular_frequency(float k) const {
        const Water& water = cell_.sea->parameters.water;
        return std::sqrt(static_cast<float>(water.gravity) * k *
                         std::tanh(k * static_cast<float>(water.depth)));
    }
    static Complex turn(float phase) {
        return {std::cos(phase), std::sin(phase)};
    }
    double kx(int i) const {
        return modes_.lattice.wavenumber_step() * i;
    }
    double ky(int j) const {
        return modes_.lattice.wavenumber_step() * signed_wavenumber(j, n_);
    }

    void height_row(int j, float time) {
        for (int i = 0; i < half_; ++i) {
            const std::size_t from = at(j, i, n_);
            const std::size_t mirror = at(mirror_index(j, n_), mirror_index(i, n_), n_);
            const float k = wavenumber_[at(j, i, half_)];
            const Complex forward = turn(-angular_frequency(k) * time);
            const Complex backward = turn(angular_frequency(k) * time);
            height_[at(j, i, half_)] = Complex(modes_.h0[from]) * forward +
                                       std::conj(Complex(modes_.h0[mirror])) * backward;
        }
    }

    /// height, displacement, slope: fields_of(FrameKind::vertices).
    void run_task(int f) {
        const Task& task = tasks_[static_cast<std::size_t>(f)];
        for (int j = 0; j < n_; ++j) {
            for (int i = 0; i < half_; ++i) {
                const std::size_t to = at(j, i, half_);
                const Complex h = height_[to];
                const Complex derivative(-h.imag(), h.real());
                const double k = wavenumber_[to];
                // A finite depth's coth(kd) / k instead of 1 / k.
                const double displacement =
                    k > 0.0 ? modes_.displacement[at(j, i, n_)] * k / k : 0.0;
                const std::array<double, kFields> factor = {1.0, -kx(i) * displacement,
                                                            -ky(j) * displacement, kx(i), ky(j)};
                task.in[to] = f == 0 ? h : factor[static_cast<std::size_t>(f)] * derivative;
            }
        }
        fftw_execute(task.plan);
    }

    void write() {
        const auto width = static_cast<std::size_t>(n_);
#pragma omp parallel num_threads(cell_.threads)
        {
            std::vector<float> rows(kFields * width);
            PlanarFields planes;
            planes.row_stride = width;
            for (std::size_t f = 0; f < kFields; ++f) planes.plane[f] = rows.data() + f * width;
#pragma omp for schedule(static)
            for (int j = 0; j < n_; ++j) {
                for (std::size_t f = 0; f < kFields; ++f) {
                    const double* from = tasks_[f].out.get() + at(j, 0, n_);
                    for (std::size_t i = 0; i < width; ++i) {
                        rows[f * width + i] = static_cast<float>(from[i]);
                    }
                }
                const auto outputs = vertices_.outputs(j);
                write_rows(planes, n_, 0, 1, {0.0, VertexMaps::settings(), outputs, {}},
                           cell_.level);
            }
        }
    }

    Cell cell_;
    const CascadeModes& modes_;
    int n_;
    int half_;
    std::unique_ptr<Complex[], Free> height_;
    std::vector<float> wavenumber_;
    std::array<Task, kFields> tasks_;
    VertexMaps vertices_;
};

}  // namespace

Subject make_blender_scheme(const Cell& cell) {
    const auto scheme = std::make_shared<BlenderScheme>(cell);
    Subject result;
    result.library = "Blender's scheme";
    result.variant = "FFTW double, a task a field";
    result.allowed_error = 1e-4;  // angular frequency and phase in float
    result.frame = [scheme](double time) { scheme->frame(time); };
    result.field = [scheme](Linear field) { return scheme->maps().field(field); };
    result.normal = [scheme](Channel channel) { return scheme->maps().normal(channel); };
    return result;
}

}  // namespace ocean::bench
