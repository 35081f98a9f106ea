// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "plots.hpp"

#include <algorithm>

#include "ocean/error.hpp"
#include "ocean/internal/io/png.hpp"

namespace ocean::app {
namespace {

constexpr std::string_view kMarkName = "ocean:plot";

}  // namespace

io::HeaderString plot_mark(std::string_view command) {
    return {std::string(kMarkName), std::string(command)};
}

bool is_plot(const std::string& path, std::string_view command) {
    try {
        const auto header = io::read_png_header(path);
        return std::ranges::any_of(header, [command](const io::HeaderString& string) {
            return string.name == kMarkName && string.text == command;
        });
    } catch (const Error&) {
        return false;
    }
}

}  // namespace ocean::app
