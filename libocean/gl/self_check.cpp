// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Phase, noise and coefficients of the GPU against those of the processor; see self_check.hpp.
#include "self_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

#include "checks.hpp"
#include "compute_program.hpp"
#include "frame_plan.hpp"
#include "modes_on_gpu.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/linear_shape.hpp"
#include "ocean/internal/text.hpp"
#include "wave/wave.hpp"

namespace ocean::gl {

namespace {

constexpr std::size_t kModes = 256;
constexpr double kTimes[] = {0.0, 12.0, 3600.0, 1e5, 1e6};
using Numbers = std::array<std::array<float, 4>, kModes>;

struct Mode {
    double rate;
    double tau;
};

/// Returns one of several waves, of 4 km to a centimetre, at the times in turn.
Mode mode(std::size_t i) {
    const double share = static_cast<double>(i) / (kModes - 1);
    return {0.02 * std::pow(1000.0, share), kTimes[i % std::size(kTimes)] * (1.0 + 1e-3 * share)};
}

double low_part(double value) {
    return value - static_cast<double>(static_cast<float>(value));
}

constexpr std::size_t kPairs = std::size(kFieldPairs);
constexpr float kGradientScale = 4.0f;
using Coefficients = std::array<std::array<std::array<float, 2>, kPairs>, kModes>;

/// The results of the shader.
struct Computed {
    Numbers numbers;
    Coefficients coefficients;
};

Computed run(const Numbers& given) {
    ComputeProgram program("compute/self_check.comp", self_check_defines());
    std::array<Buffer, 3> buffers;
    for (GLuint i = 0; i < buffers.size(); ++i) {
        resize_storage(buffers[i], i < 2 ? sizeof given : sizeof(Coefficients),
                       i == 0 ? &given : nullptr);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, i, buffers[i].name());
    }
    program.use();
    program.set("gradient_scale", kGradientScale);
    glDispatchCompute(kModes / 64, 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    Computed result;
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffers[1].name());
    glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof result.numbers, &result.numbers);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffers[2].name());
    glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof result.coefficients,
                       &result.coefficients);
    require_no_error("its arithmetic was checked");
    return result;
}

/// Returns the coefficient of a field for mode i of the shader, by the definition of its shape.
std::complex<double> expected_coefficient(Linear field, std::size_t i, std::complex<double> xi) {
    const LinearShape shape = linear_shape(field);
    const std::complex<double> state =
        shape.rate ? std::complex<double>(xi.imag(), -2.0 * xi.real()) : xi;
    const double kx = static_cast<double>(i % 16) - 7.0, ky = static_cast<double>(i / 16) - 5.0;
    double factor = shape.sign * std::pow(kx, shape.x_power) * std::pow(ky, shape.y_power);
    if (shape.displacement) factor *= 0.25 + static_cast<double>(i % 3);
    if (field == Linear::gradient_xy) factor *= static_cast<double>(kGradientScale);
    return factor * (shape.odd ? std::complex<double>(0.0, 1.0) * state : state);
}

/// Returns the largest error of a pair's coefficient, relative to the larger of its terms.
double coefficient_error(const Computed& result) {
    double error = 0.0;
    for (std::size_t i = 0; i < kModes; ++i) {
        const std::complex<double> xi(result.numbers[i][2], result.numbers[i][3]);
        for (std::size_t p = 0; p < kPairs; ++p) {
            const FieldPair& pair = kFieldPairs[p];
            const std::complex<double> a = expected_coefficient(pair.real, i, xi);
            const std::complex<double> b = expected_coefficient(pair.imaginary, i, xi);
            const std::complex<double> both =
                pair.real == pair.imaginary ? a : a + std::complex<double>(0.0, 1.0) * b;
            const auto& found = result.coefficients[i][p];
            const double off = std::abs(std::complex<double>(found[0], found[1]) - both);
            const double size = std::max({std::abs(a), std::abs(b), 1e-6});
            // A NaN stays the largest.
            error = off / size <= error ? error : off / size;
        }
    }
    return error;
}

}  // namespace

std::string self_check_defines() {
    std::string text;
    for (std::size_t p = 0; p < kPairs; ++p) {
        text += "#define PAIR_" + std::to_string(p) + " " + coefficients(kFieldPairs[p]) + "\n";
    }
    return text;
}

void check_shader_arithmetic() {
    namespace wave = ocean::wave::double_precision;
    constexpr double kMaxTurns = 5e-7;
    constexpr double kMaxNoise = 3e-6;
    constexpr double kMaxPair = 1e-6;
    Numbers given;
    for (std::size_t i = 0; i < kModes; ++i) {
        const auto [rate, tau] = mode(i);
        given[i] = {static_cast<float>(rate), static_cast<float>(low_part(rate)),
                    static_cast<float>(tau), static_cast<float>(low_part(tau))};
    }
    const Computed computed = run(given);
    const Numbers& result = computed.numbers;
    double turns_error = 0.0;
    double noise_error = 0.0;
    for (std::size_t i = 0; i < kModes; ++i) {
        const auto number = static_cast<std::uint32_t>(i);
        const double rate = static_cast<double>(given[i][0]) + given[i][1];
        const double tau = static_cast<double>(given[i][2]) + given[i][3];
        const double turns = wave::phase_turns(rate, 0.0, tau, 0.0);
        const double difference = static_cast<double>(result[i][0]) - turns;
        turns_error = std::max({turns_error, std::abs(difference - std::round(difference)),
                                std::abs(result[i][1] - wave::sin_cos_turns(turns).sine) / 6.3});
        const auto xi = wave::gaussian_noise(number + 1, number % 5, static_cast<int>(i) - 7,
                                             3 - static_cast<int>(i));
        noise_error =
            std::max({noise_error, std::abs(result[i][2] - xi.re), std::abs(result[i][3] - xi.im)});
    }
    const double pair_error = coefficient_error(computed);
    // Not "more than", which NaN is not.
    if (turns_error < kMaxTurns && noise_error < kMaxNoise && pair_error < kMaxPair) return;
    throw Error(ErrorKind::no_gpu,
                format_text("this GPU's driver does not compute as the shaders need it: its phases "
                            "are off by %.1e of a turn (allowed %.0e), its noise by %.1e (%.0e), "
                            "its pairs of fields by %.1e (%.0e)",
                            turns_error, kMaxTurns, noise_error, kMaxNoise, pair_error, kMaxPair));
}

}  // namespace ocean::gl
