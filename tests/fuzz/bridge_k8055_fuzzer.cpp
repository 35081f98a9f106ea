// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Whatever a board sends: a report is refused, or its values are those that its channels may have.
#include <cstdint>
#include <cstdlib>
#include <span>

#include "k8055_report.hpp"
#include "ocean/internal/bridge/k8055_source.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ocean::bridge;
    static const std::vector<Channel> channels = k8055_channels("board0");
    const auto inputs = decode_k8055_report(std::span(data, size));
    if (inputs.has_value() != (size == kK8055Bytes)) std::abort();
    if (!inputs) return 0;
    for (std::size_t i = 0; i < inputs->size(); ++i) {
        const double value = (*inputs)[i];
        if (channels[i].output || !(value >= channels[i].min && value <= channels[i].max)) {
            std::abort();
        }
    }
    return 0;
}
