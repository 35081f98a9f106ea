// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Phase and noise of the GPU against those of the processor; see self_check.hpp.
#include "self_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "checks.hpp"
#include "compute_program.hpp"
#include "modes_on_gpu.hpp"
#include "ocean/error.hpp"
#include "ocean/text.hpp"
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

Numbers run(const Numbers& given) {
    ComputeProgram program("compute/self_check.comp", "");
    std::array<Buffer, 2> buffers;
    for (GLuint i = 0; i < buffers.size(); ++i) {
        resize_storage(buffers[i], sizeof given, i == 0 ? &given : nullptr);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, i, buffers[i].name());
    }
    program.use();
    glDispatchCompute(kModes / 64, 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    Numbers result;
    glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof result, &result);
    require_no_error("its arithmetic was checked");
    return result;
}

}  // namespace

void check_shader_arithmetic() {
    namespace wave = ocean::wave::double_precision;
    constexpr double kMaxTurns = 5e-7;
    constexpr double kMaxNoise = 3e-6;
    Numbers given;
    for (std::size_t i = 0; i < kModes; ++i) {
        const auto [rate, tau] = mode(i);
        given[i] = {static_cast<float>(rate), static_cast<float>(low_part(rate)),
                    static_cast<float>(tau), static_cast<float>(low_part(tau))};
    }
    const Numbers result = run(given);
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
    // Not "more than", which NaN is not.
    if (turns_error < kMaxTurns && noise_error < kMaxNoise) return;
    throw Error(ErrorKind::no_gpu,
                format_text("this GPU's driver does not compute as the shaders need it: its phases "
                            "are off by %.1e of a turn (allowed %.0e), its noise by %.1e (%.0e)",
                            turns_error, kMaxTurns, noise_error, kMaxNoise));
}

}  // namespace ocean::gl
