// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The machine and the build. Nothing here changes from run to run.
#include <fstream>
#include <string>

#include "ocean/internal/kernel_backends.hpp"
#include "ocean/internal/platform.hpp"
#include "ocean/internal/verify.hpp"
#include "ocean/version.hpp"

namespace ocean::verify {
namespace {

/// Returns the processor's name as Linux reports it; elsewhere its architecture.
std::string processor_name() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const std::size_t value = line.find(": ");
        if (line.starts_with("model name") && value != std::string::npos) {
            return line.substr(value + 2);
        }
    }
#if defined(__aarch64__) || defined(_M_ARM64)
    return "ARM64";
#else
    return "x86-64";
#endif
}

constexpr const char* kSystem =
#if defined(_WIN32)
    "Windows";
#elif defined(__APPLE__)
    "macOS";
#else
    "Linux";
#endif

constexpr const char* kCompiler =
#if defined(__clang__)
    "clang " __clang_version__;
#else
    "GNU " __VERSION__;
#endif

}  // namespace

Build this_build() {
    return {.version = OCEAN_VERSION,
            .compiler = kCompiler,
            .system = kSystem,
            .processor = processor_name(),
            .instruction_set = std::string(kernel_backends().front().name),
            .cores = available_cores()};
}

}  // namespace ocean::verify
