// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Bound waves by transforms of products; second_order.cpp has their kernels. On a choppy map, which
// shows the label a at a - c D(a), the heights
//     h(a) + eta2(a) - c D . grad h
// are those of the surface eta1(x) + eta2(x) up to third order, because h(x) there is that at the
// label plus c D . grad h. The products of long and short waves nearly cancel in the difference:
// the map already carries short waves on long ones.
//
// Waves of up to n lattice steps have products of up to 2 n, which alias on fewer than 4 n samples.
// On 9/4 n samples at least, aliases and the products that are left out are 0.8 % of the bound
// waves' rms height on a choppy map, 4 % at choppiness 0, whose eta2 also carries short waves on
// long ones [measured]: two short waves bind little. The lattice is that of the sea, never that of
// the map, so that maps of all resolutions show one surface. Test:
// SecondOrder.HasTheKernelsOfItsProducts.
#include "waves/bound/bound_waves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <optional>
#include <vector>

#include "base/batch_fft.hpp"
#include "ocean/internal/second_order.hpp"
#include "ocean/page_vector.hpp"
#include "ocean/thread_pool.hpp"
#include "waves/kernel/map_kernel.hpp"
#include "waves/kernel/packed_modes.hpp"

namespace ocean {

namespace {

/// The fields that are multiplied, and their time derivatives.
enum Field { kDx, kDy, kHx, kHy, kDxRate, kDyRate, kHxRate, kHyRate, kFields };

/// The transforms, each of two real products: a in the real part, b in the imaginary part.
enum Pair { kSquares, kMixed, kSquaresRate, kMixedRate, kPairs };

/// The waves of one scale, and the kernel that makes their fields.
struct BindingWaves {
    std::shared_ptr<PackedModes> packed;
    std::optional<MapKernel> kernel;

    void pack(const MapModes& modes, const ModeFactor& factor, ThreadPool& pool) {
        if (!packed || !packed->refill(modes, pool, factor)) {
            packed = std::make_shared<PackedModes>(modes, pool, simd_level(), factor);
            kernel.reset();
        }
        kernel ? kernel->use(packed) : static_cast<void>(kernel.emplace(packed));
    }
};

/// The whole numbers of a lattice of products.
struct ProductLattice {
    int binding = 0;  // the longest index of a wave that binds others
    int samples = 0;
    int reach = 0;  // the longest index of a bound wave

    explicit ProductLattice(double modes) : binding(std::max(1, static_cast<int>(modes + 1e-6))) {
        samples = kMinResolution;
        while (samples < kSamplesPerBinding * binding) samples *= 2;
        reach = samples / 2 - 1;
    }
    bool operator==(const ProductLattice&) const = default;
    int width() const { return 2 * reach + 1; }
    std::size_t index(int n, int m) const {
        return static_cast<std::size_t>((m + reach) * width() + n + reach);
    }
};

}  // namespace

struct BoundWaves::Impl {
    ProductLattice lattice{1.0};
    BatchFft fft{kMinResolution, kMinResolution / 2};
    BindingWaves waves;       // h
    BindingWaves wavenumber;  // |k| h, whose displacement is -grad h
    Revision packed_revision;
    double packed_limit = 0.0;
    std::array<PageVector<float>, kFields> field;
    std::array<std::vector<std::complex<float>>, kPairs> spectrum;
    std::vector<BatchRow> lines;              // between the two directions
    std::vector<std::vector<BatchRow>> work;  // one for each thread
    Modes bound;
    double mean = 0.0;  // at choppiness 1 [m]
    double choppiness = 0.0;
    double tau = 0.0;
    bool has_rates = false;

    const Modes& at(const MapModes& sea, double c, bool rates, ThreadPool& pool) {
        const bool same_waves =
            packed_revision == sea.revision && packed_limit == sea.binding_limit;
        if (!same_waves) pack(sea, pool);
        const bool same = same_waves && static_cast<bool>(bound.revision) && tau == sea.tau &&
                          choppiness == c && (has_rates || !rates);
        if (same) return bound;
        bound.revision = {};
        tau = sea.tau;
        choppiness = c;
        has_rates = rates;
        make_fields(pool);
        for (int pair = 0; pair < (rates ? kPairs : kSquaresRate); ++pair) {
            transform(static_cast<Pair>(pair), pool);
        }
        fill_modes(pool);
        bound.revision = Revision::begin();
        return bound;
    }

    /// Packs the waves that bind others.
    void pack(const MapModes& sea, ThreadPool& pool) {
        packed_revision = {};
        const double step = sea.wavenumber_step();
        const ProductLattice now(sea.binding_limit / step);
        if (!(now == lattice) || bound.lattice.period != sea.period) resize(now, sea.period);
        MapModes binding = sea;
        binding.cascades = sea.cascades.first(1);
        binding.resolution = lattice.samples;
        binding.held_by = 0;
        const double limit = sea.binding_limit;
        waves.pack(
            binding,
            [=](std::size_t, int n, int m) {
                return ModeScale{step * std::hypot(n, m) <= limit ? 1.0f : 0.0f, 1.0f};
            },
            pool);
        wavenumber.pack(
            binding,
            [=](std::size_t, int n, int m) {
                const double k = step * std::hypot(n, m);
                return ModeScale{k <= limit ? static_cast<float>(k) : 0.0f, 1.0f};
            },
            pool);
        mean = mean_rise(sea.cascades.front(), step, limit);
        packed_revision = sea.revision;
        packed_limit = limit;
    }

    /// Returns sum |k| <|h|^2> = -<D . grad h> of the waves that bind others.
    double mean_rise(const CascadeModes& cascade, double step, double limit) const {
        const int half = std::min(cascade.lattice.resolution / 2, lattice.binding + 1);
        double sum = 0.0;
        for (int m = 1 - half; m < half; ++m) {
            for (int n = 1 - half; n < half; ++n) {
                const double k = step * std::hypot(n, m);
                if (k > limit) continue;
                const std::size_t i = mode_index(n, m, cascade.lattice.resolution);
                sum += 2.0 * k * std::norm(std::complex<double>(cascade.h0[i]));
            }
        }
        return sum;
    }

    void resize(const ProductLattice& to, double period) {
        lattice = to;
        fft = BatchFft(lattice.samples, lattice.samples / 2);
        const std::size_t samples = Lattice{lattice.samples, period}.size();
        for (PageVector<float>& plane : field) plane = PageVector<float>(samples);
        const auto width = static_cast<std::size_t>(lattice.width());
        for (std::vector<std::complex<float>>& values : spectrum)
            values.assign(width * width, 0.0f);
        lines.assign(static_cast<std::size_t>(blocks() * (lattice.samples + 1)), {});
        work.clear();
        bound = {};
        bound.lattice = {lattice.samples, period};
        bound.lattice_revision = Revision::begin();
        CascadeModes& modes = bound.cascades.emplace_back();
        modes.lattice = bound.lattice;
        modes.h0.assign(samples, 0.0f);
        // Any rate would do: amplitude and mirror hold the height and its rate at time 0.
        modes.rate_high.assign(samples, static_cast<float>(1.0 / kTwoPi));
        modes.rate_low.assign(samples, 0.0f);
        modes.displacement.assign(samples, 0.0f);
        modes.shell_covariance.resize(static_cast<std::size_t>(lattice.samples / 2));
    }

    void make_fields(ThreadPool& pool) {
        std::vector<MapOutput> outputs;
        const auto add = [&](Field x, Linear of_x, Field y, Linear of_y, float factor) {
            outputs.push_back({field[x].data(), 1, {{{of_x, factor}}}});
            outputs.push_back({field[y].data(), 1, {{{of_y, factor}}}});
        };
        SurfaceSettings plain;
        plain.choppiness = 1.0;
        add(kDx, Linear::displacement_x, kDy, Linear::displacement_y, 1.0f);
        add(kHx, Linear::slope_x, kHy, Linear::slope_y, 1.0f);
        if (has_rates) {
            add(kDxRate, Linear::displacement_x_rate, kDyRate, Linear::displacement_y_rate, 1.0f);
        }
        waves.kernel->run({tau, plain, outputs, {}}, pool);
        if (!has_rates) return;
        outputs.clear();
        add(kHxRate, Linear::displacement_x_rate, kHyRate, Linear::displacement_y_rate, -1.0f);
        wavenumber.kernel->run({tau, plain, outputs, {}}, pool);
    }

    int blocks() const { return (lattice.width() + kFftBatch - 1) / kFftBatch; }
    /// Returns where a sample stands in the input of the transform.
    int input_of(int sample) const {
        const int half = lattice.samples / 2;
        return sample <= half ? sample + half : sample - half;
    }
    /// Returns where the transform, whose sign is that of the inverse, writes a wave.
    int output_of(int wave) const { return (lattice.samples - wave) % lattice.samples; }

    /// Writes two products at sixteen samples of a row.
    void multiply(Pair pair, std::size_t first, BatchRow& row) const {
        std::array<const float*, kFields> f;
        for (std::size_t i = 0; i < f.size(); ++i) f[i] = field[i].data() + first;
        float* const a = row.re;
        float* const b = row.im;
        const auto each = [](const auto& write) {
            for (int i = 0; i < kFftBatch; ++i) write(i);
        };
        const auto dot = [&f](Field x, Field y, Field u, Field v, int i) {
            return f[x][i] * f[u][i] + f[y][i] * f[v][i];
        };
        switch (pair) {
            case kSquares:
                return each([&](int i) {
                    a[i] = f[kDx][i] * f[kDx][i];
                    b[i] = f[kDy][i] * f[kDy][i];
                });
            case kMixed:
                return each([&](int i) {
                    a[i] = f[kDx][i] * f[kDy][i];
                    b[i] = dot(kDx, kDy, kHx, kHy, i);
                });
            case kSquaresRate:
                return each([&](int i) {
                    a[i] = 2.0f * f[kDx][i] * f[kDxRate][i];
                    b[i] = 2.0f * f[kDy][i] * f[kDyRate][i];
                });
            default:
                return each([&](int i) {
                    a[i] = dot(kDx, kDxRate, kDyRate, kDy, i);
                    b[i] = dot(kDx, kDy, kHxRate, kHyRate, i) + dot(kDxRate, kDyRate, kHx, kHy, i);
                });
        }
    }

    /// Transforms two products along y, for sixteen columns at once, and then along x.
    void transform(Pair pair, ThreadPool& pool) {
        const int size = lattice.samples;
        const int reach = lattice.reach;
        const auto inputs = static_cast<std::size_t>(size) + 1;
        work.resize(static_cast<std::size_t>(pool.size()));
        for (std::vector<BatchRow>& own : work) own.resize(2 * inputs);
        pool.for_each_item(size / kFftBatch, [&](int block, int thread) {
            BatchRow* const input = work[static_cast<std::size_t>(thread)].data();
            BatchRow* const output = input + inputs;
            for (int j = 0; j < size; ++j) {
                multiply(pair, static_cast<std::size_t>(j * size + block * kFftBatch),
                         input[input_of(j)]);
            }
            fft.transform(input, 1, {.work = output});
            for (int m = -reach; m <= reach; ++m) {
                BatchRow& from = output[output_of(m)];
                const int line = m + reach;
                BatchRow* const to =
                    lines.data() + static_cast<std::size_t>(line / kFftBatch) * inputs;
                for (int i = 0; i < kFftBatch; ++i) {
                    BatchRow& row = to[input_of(block * kFftBatch + i)];
                    row.re[line % kFftBatch] = from.re[i];
                    row.im[line % kFftBatch] = from.im[i];
                }
            }
        });
        std::vector<std::complex<float>>& values = spectrum[pair];
        pool.for_each_item(blocks(), [&](int block, int thread) {
            BatchRow* const output = work[static_cast<std::size_t>(thread)].data();
            fft.transform(lines.data() + static_cast<std::size_t>(block) * inputs, 1,
                          {.work = output});
            const int first = block * kFftBatch - reach;
            for (int n = -reach; n <= reach; ++n) {
                BatchRow& from = output[output_of(n)];
                for (int i = 0; i < kFftBatch && first + i <= reach; ++i) {
                    values[lattice.index(n, first + i)] = {from.re[i], from.im[i]};
                }
            }
        });
    }

    /// The kernel of a wave (n, m), with the scale of the transforms.
    struct Kernel {
        float xx, xy, yy, shift;
    };
    Kernel kernel(int n, int m) const {
        const float scale = 1.0f / static_cast<float>(bound.lattice.size());
        const auto step = static_cast<float>(bound.lattice.wavenumber_step());
        const auto x = static_cast<float>(n);
        const auto y = static_cast<float>(m);
        const float length = std::sqrt(x * x + y * y);
        const auto along = -0.5f * scale * static_cast<float>(kBoundAlong) * step / length;
        const auto alike = -0.5f * scale * static_cast<float>(1.0 - kBoundAlong) * step * length;
        return {along * x * x + alike, 2.0f * along * x * y, along * y * y + alike,
                -scale * static_cast<float>(choppiness)};
    }

    /// Returns the bound wave of the products in two transforms.
    std::complex<float> bound_wave(const Kernel& kernel, Pair squares, Pair mixed, int n,
                                   int m) const {
        const auto sum_of = [&](Pair pair, float of_a, float of_b) {
            const std::complex<float> z = spectrum[pair][lattice.index(n, m)];
            const std::complex<float> mirror = std::conj(spectrum[pair][lattice.index(-n, -m)]);
            const std::complex<float> a = 0.5f * (z + mirror);
            const std::complex<float> b = 0.5f * (z - mirror);  // times i
            return std::complex<float>(of_a * a.real() + of_b * b.imag(),
                                       of_a * a.imag() - of_b * b.real());
        };
        return sum_of(squares, kernel.xx, kernel.yy) + sum_of(mixed, kernel.xy, kernel.shift);
    }

    // With h(k, 0) = h0(k) + conj h0(-k) and dh/dt = -i omega (h0(k) - conj h0(-k)), a wave of
    // height b and rate r has h0 = (b + i r / omega) / 2; omega = 1 rad/s.
    void fill_modes(ThreadPool& pool) {
        CascadeModes& modes = bound.cascades.front();
        pool.for_each_item(lattice.reach + 1, [&](int m, int) {
            for (int n = m == 0 ? 1 : -lattice.reach; n <= lattice.reach; ++n) {
                if (n * n + m * m > lattice.reach * lattice.reach) continue;
                const Kernel factors = kernel(n, m);
                const std::complex<float> b = bound_wave(factors, kSquares, kMixed, n, m);
                const std::complex<float> r =
                    has_rates ? bound_wave(factors, kSquaresRate, kMixedRate, n, m) : 0.0f;
                modes.h0[mode_index(n, m, lattice.samples)] = {0.5f * (b.real() - r.imag()),
                                                               0.5f * (b.imag() + r.real())};
                modes.h0[mode_index(-n, -m, lattice.samples)] = {0.5f * (b.real() + r.imag()),
                                                                 0.5f * (r.real() - b.imag())};
            }
        });
    }
};

BoundWaves::BoundWaves() : impl_(std::make_unique<Impl>()) {}
BoundWaves::~BoundWaves() = default;
BoundWaves::BoundWaves(BoundWaves&&) noexcept = default;
BoundWaves& BoundWaves::operator=(BoundWaves&&) noexcept = default;

const Modes& BoundWaves::at(const MapModes& sea, double choppiness, bool rates, ThreadPool& pool) {
    return impl_->at(sea, choppiness, rates, pool);
}

double BoundWaves::mean() const {
    return impl_->choppiness * impl_->mean;
}

std::uint64_t BoundWaves::bytes(int grid_resolution) {
    // Eight planes, four spectra, the lines between them, the modes, and two kernels.
    constexpr std::uint64_t kFloats = 40;
    const int samples = std::max(grid_resolution / 2, kMinResolution);
    return kFloats * sizeof(float) * Lattice{samples, 1.0}.size();
}

}  // namespace ocean
