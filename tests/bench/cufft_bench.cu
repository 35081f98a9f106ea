// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The same frame as gpu_bench.cpp, as one makes it with NVIDIA's library: a kernel that brings the
// modes to a time, a batch of complex transforms by cuFFT, a kernel that puts eight fields
// together; pass by pass beside a copy of memory, as a Markdown table. Exit status 77 and a
// sentence where there is no device. usage: cufft_bench [--sizes 512,1024] [--frames N]
#include <cufft.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr double kTime = 12.345;
constexpr int kPacks = 4;  // (h, Dxy) (Dx, Dy) (slope x, slope y) (Dxx, Dyy)
constexpr int kNoDevice = 77;

[[noreturn]] void fail(const std::string& message, int status = 1) {
    std::fprintf(stderr, "cufft_bench: %s\n", message.c_str());
    std::exit(status);
}

void check(cudaError_t status, const char* doing) {
    if (status != cudaSuccess) fail(std::string(doing) + ": " + cudaGetErrorString(status));
}

void check(cufftResult status, const char* doing) {
    if (status != CUFFT_SUCCESS)
        fail(std::string(doing) + ": cuFFT error " + std::to_string(status));
}

template <typename T>
class DeviceArray {
  public:
    explicit DeviceArray(std::size_t count) {
        check(cudaMalloc(&data_, count * sizeof(T)), "memory of the device");
    }
    explicit DeviceArray(const std::vector<T>& values) : DeviceArray(values.size()) {
        check(cudaMemcpy(data_, values.data(), values.size() * sizeof(T), cudaMemcpyHostToDevice),
              "uploading");
    }
    ~DeviceArray() { cudaFree(data_); }
    DeviceArray(const DeviceArray&) = delete;
    DeviceArray& operator=(const DeviceArray&) = delete;

    T* get() const { return data_; }

  private:
    T* data_ = nullptr;
};

/// Modes of deep water on a lattice of N x N, in FFT order: as many bytes as those of the library.
struct Modes {
    std::vector<float2> h0;    // m
    std::vector<float2> rate;  // turns a second: high and low part
    std::vector<float> displacement;
    float step;  // of the wavenumber, rad/m

    explicit Modes(int n) {
        const auto size = static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
        h0.resize(size);
        rate.resize(size);
        displacement.resize(size);
        const double wide_step = kTwoPi / (0.8 * n);
        step = static_cast<float>(wide_step);
        unsigned state = 12345;
        const auto uniform = [&state] {
            state = state * 1664525u + 1013904223u;
            return static_cast<double>(state >> 8) / (1 << 24) - 0.5;
        };
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                const std::size_t at = static_cast<std::size_t>(y) * n + x;
                const double kx = wide_step * (x < n / 2 ? x : x - n);
                const double ky = wide_step * (y < n / 2 ? y : y - n);
                const double k = std::hypot(kx, ky);
                const bool nyquist = x == n / 2 || y == n / 2;
                const double amplitude = k == 0.0 || nyquist ? 0.0 : 1e-3 / (1.0 + k * k * k * k);
                h0[at] = {static_cast<float>(amplitude * uniform()),
                          static_cast<float>(amplitude * uniform())};
                const double turns = std::sqrt(9.81 * k) / kTwoPi;
                const auto high = static_cast<float>(turns);
                rate[at] = {high, static_cast<float>(turns - static_cast<double>(high))};
                displacement[at] = k == 0.0 ? 0.0f : static_cast<float>(1.0 / k);
            }
        }
    }
};

/// rate * tau modulo 1; here fma is fused for certain.
__device__ float phase_turns(float2 rate, float2 tau) {
    const float product = __fmul_rn(rate.x, tau.x);
    const float rest = fmaf(rate.x, tau.x, -product);
    return (product - rintf(product)) + (rest + fmaf(rate.x, tau.y, rate.y * tau.x));
}

/// a and b of one complex number: a + i b.
__device__ float2 pair(float2 a, float2 b) {
    return make_float2(a.x - b.y, a.y + b.x);
}
__device__ float2 times(float2 a, float factor) {
    return make_float2(a.x * factor, a.y * factor);
}

/// From the modes to the coefficients of the packs, N x N each.
__global__ void evolve(int n, float step, float2 tau, const float2* __restrict__ h0,
                       const float2* __restrict__ rate, const float* __restrict__ displacement,
                       float2* __restrict__ packs) {
    const int x = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
    const int y = static_cast<int>(blockIdx.y * blockDim.y + threadIdx.y);
    const int at = y * n + x;
    const float2 own = h0[at];
    const float2 mirror = h0[((n - y) & (n - 1)) * n + ((n - x) & (n - 1))];
    float sine;
    float cosine;
    sincospif(2.0f * phase_turns(rate[at], tau), &sine, &cosine);
    const float2 h =
        make_float2(own.x * cosine + own.y * sine + mirror.x * cosine + mirror.y * sine,
                    own.y * cosine - own.x * sine + mirror.x * sine - mirror.y * cosine);
    const float2 ih = make_float2(-h.y, h.x);
    const float kx = step * static_cast<float>(x < n / 2 ? x : x - n);
    const float ky = step * static_cast<float>(y < n / 2 ? y : y - n);
    const float u = displacement[at];
    const int size = n * n;
    packs[at] = pair(h, times(h, kx * ky * u));
    packs[at + size] = pair(times(ih, -kx * u), times(ih, -ky * u));
    packs[at + 2 * size] = pair(times(ih, kx), times(ih, ky));
    packs[at + 3 * size] = pair(times(h, kx * kx * u), times(h, ky * ky * u));
}

/// From the packs to two maps of four fields.
__global__ void assemble(int size, const float2* __restrict__ packs, float4* __restrict__ maps) {
    const int at = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
    const float2 height = packs[at];
    const float2 displaced = packs[at + size];
    const float2 slope = packs[at + 2 * size];
    const float2 gradient = packs[at + 3 * size];
    maps[at] = make_float4(displaced.x, displaced.y, height.x, height.y);
    maps[at + size] = make_float4(slope.x, slope.y, gradient.x, gradient.y);
}

float2 split(double value) {
    const auto high = static_cast<float>(value);
    return {high, static_cast<float>(value - static_cast<double>(high))};
}

class Frame {
  public:
    explicit Frame(int n)
        : n_(n),
          size_(static_cast<std::size_t>(n) * n),
          modes_(n),
          h0_(modes_.h0),
          rate_(modes_.rate),
          displacement_(modes_.displacement),
          packs_(kPacks * size_),
          maps_(2 * size_) {
        int shape[] = {n, n};
        check(cufftPlanMany(&plan_, 2, shape, nullptr, 1, n * n, nullptr, 1, n * n, CUFFT_C2C,
                            kPacks),
              "planning");
        for (cudaEvent_t& event : marks_) check(cudaEventCreate(&event), "making events");
    }
    ~Frame() {
        cufftDestroy(plan_);
        for (cudaEvent_t event : marks_) cudaEventDestroy(event);
    }
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;

    /// Seconds of the three steps.
    std::array<double, 3> make(double time) {
        const dim3 block(32, 8);
        const dim3 tiles(static_cast<unsigned>(n_) / block.x, static_cast<unsigned>(n_) / block.y);
        cudaEventRecord(marks_[0]);
        evolve<<<tiles, block>>>(n_, modes_.step, split(time), h0_.get(), rate_.get(),
                                 displacement_.get(), packs_.get());
        cudaEventRecord(marks_[1]);
        check(cufftExecC2C(plan_, packs_.get(), packs_.get(), CUFFT_INVERSE), "transforming");
        cudaEventRecord(marks_[2]);
        assemble<<<static_cast<unsigned>(size_ / 256), 256>>>(static_cast<int>(size_), packs_.get(),
                                                              maps_.get());
        cudaEventRecord(marks_[3]);
        check(cudaEventSynchronize(marks_[3]), "making a frame");
        std::array<double, 3> seconds{};
        for (int i = 0; i < 3; ++i) {
            float milliseconds = 0.0f;
            check(cudaEventElapsedTime(&milliseconds, marks_[i], marks_[i + 1]), "timing");
            seconds[static_cast<std::size_t>(i)] = 1e-3 * milliseconds;
        }
        return seconds;
    }

    /// Height and slope x of a frame at kTime against sums over all modes in double, at some
    /// places: a rival that computes something else is none.
    void judge() {
        make(kTime);
        std::vector<float4> maps(2 * size_);
        check(cudaMemcpy(maps.data(), maps_.get(), maps.size() * sizeof maps[0],
                         cudaMemcpyDeviceToHost),
              "reading a frame back");
        double error = 0.0;
        double size = 0.0;
        for (int place = 0; place < 8; ++place) {
            const int x = (place * 1237 + 5) % n_;
            const int y = (place * 771 + 3) % n_;
            const auto [height, slope] = exact(x, y);
            const std::size_t at = static_cast<std::size_t>(y) * n_ + x;
            error += std::pow(maps[at].z - height, 2) + std::pow(maps[size_ + at].x - slope, 2);
            size += height * height + slope * slope;
        }
        if (!(error <= 1e-10 * size)) fail("its frame of " + std::to_string(n_) + " is wrong");
    }

  private:
    std::pair<double, double> exact(int x, int y) const {
        std::complex<double> height;
        std::complex<double> slope;
        for (int row = 0; row < n_; ++row) {
            for (int column = 0; column < n_; ++column) {
                const std::size_t at = static_cast<std::size_t>(row) * n_ + column;
                const int kx = column < n_ / 2 ? column : column - n_;
                const int ky = row < n_ / 2 ? row : row - n_;
                const double turns =
                    (static_cast<double>(modes_.rate[at].x) + modes_.rate[at].y) * kTime;
                const std::complex<double> h0(modes_.h0[at].x, modes_.h0[at].y);
                // Twice the real part of the half that runs forward is the sum of both halves.
                const double place = static_cast<double>((kx * x + ky * y) % n_) / n_;
                const auto wave = 2.0 * h0 * std::polar(1.0, kTwoPi * (place - turns));
                height += wave.real();
                slope += -wave.imag() * kx * static_cast<double>(modes_.step);
            }
        }
        return {height.real(), slope.real()};
    }

    int n_;
    std::size_t size_;
    Modes modes_;
    DeviceArray<float2> h0_;
    DeviceArray<float2> rate_;
    DeviceArray<float> displacement_;
    DeviceArray<float2> packs_;
    DeviceArray<float4> maps_;
    cufftHandle plan_ = 0;
    std::array<cudaEvent_t, 4> marks_{};
};

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Bytes a second, read and written, of a copy too large for any cache.
double copy_bandwidth(int rounds) {
    constexpr std::size_t kBytes = std::size_t{1} << 30;
    const DeviceArray<char> from(kBytes);
    const DeviceArray<char> to(kBytes);
    cudaEvent_t begin = nullptr;
    cudaEvent_t end = nullptr;
    check(cudaEventCreate(&begin), "making events");
    check(cudaEventCreate(&end), "making events");
    std::vector<double> seconds;
    for (int i = 0; i < rounds; ++i) {
        cudaEventRecord(begin);
        cudaMemcpyAsync(to.get(), from.get(), kBytes, cudaMemcpyDeviceToDevice);
        cudaEventRecord(end);
        check(cudaEventSynchronize(end), "copying");
        float milliseconds = 0.0f;
        check(cudaEventElapsedTime(&milliseconds, begin, end), "timing");
        seconds.push_back(1e-3 * milliseconds);
    }
    cudaEventDestroy(begin);
    cudaEventDestroy(end);
    return 2.0 * static_cast<double>(kBytes) / median(seconds);
}

/// h0, its mirror, rate and displacement read, packs written; packs read and written along each
/// axis; packs read, maps written.
constexpr double kBytesPerTexel = (8 + 8 + 8 + 4 + 32) + 2 * (32 + 32) + (32 + 32);

void print_row(int n, int frames, double copy) {
    Frame frame(n);
    frame.judge();
    std::array<std::vector<double>, 3> seconds;
    for (int i = 0; i < frames + 2; ++i) {
        const std::array<double, 3> steps = frame.make(i / 60.0);
        if (i < 2) continue;
        for (std::size_t s = 0; s < steps.size(); ++s) seconds[s].push_back(steps[s]);
    }
    const double evolve_time = median(seconds[0]);
    const double transform_time = median(seconds[1]);
    const double assemble_time = median(seconds[2]);
    const double whole = evolve_time + transform_time + assemble_time;
    const double bytes = kBytesPerTexel * n * n;
    std::printf("| %d | %.3g | %.3g | %.3g | %.3g | %.0f | %.0f | %.2f |\n", n, 1e3 * evolve_time,
                1e3 * transform_time, 1e3 * assemble_time, 1e3 * whole, 1e-6 * bytes,
                1e-9 * bytes / whole, bytes / whole / copy);
    std::fflush(stdout);
}

int whole_number(const char* text, int least, int most) {
    char* end = nullptr;
    const long number = std::strtol(text, &end, 10);
    if (end == text || (*end != '\0' && *end != ',') || number < least || number > most) {
        fail(std::string("'") + text + "' is no number from " + std::to_string(least) + " to " +
             std::to_string(most));
    }
    return static_cast<int>(number);
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<int> sizes = {512, 1024, 2048, 4096};
    int frames = 200;
    for (int i = 1; i < argc; ++i) {
        if (i + 1 < argc && std::strcmp(argv[i], "--sizes") == 0) {
            sizes.clear();
            for (const char* at = argv[++i]; at != nullptr;
                 at = std::strchr(at, ',') != nullptr ? std::strchr(at, ',') + 1 : nullptr) {
                sizes.push_back(whole_number(at, 32, 8192));
                if ((sizes.back() & (sizes.back() - 1)) != 0) fail("a size is a power of two");
            }
        } else if (i + 1 < argc && std::strcmp(argv[i], "--frames") == 0) {
            frames = whole_number(argv[++i], 1, 100000);
        } else {
            fail("usage: cufft_bench [--sizes 512,1024] [--frames N]");
        }
    }
    int devices = 0;
    const cudaError_t status = cudaGetDeviceCount(&devices);
    if (status != cudaSuccess || devices == 0) {
        const std::string why =
            status == cudaSuccess ? "none is there" : cudaGetErrorString(status);
        fail("no device of CUDA (" + why + "): cuFFT is not measured", kNoDevice);
    }
    cudaDeviceProp device{};
    check(cudaGetDeviceProperties(&device, 0), "asking for the device");
    const double copy = copy_bandwidth(50);
    std::printf("cuFFT on %s. Copy of memory: %.0f GB/s, read and written.\n\n", device.name,
                1e-9 * copy);
    std::printf(
        "| N | evolve, ms | cuFFT, ms | assemble, ms | frame, ms | MB | GB/s | of the copy |\n");
    std::printf("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
    for (const int size : sizes) print_row(size, frames, copy);
}
