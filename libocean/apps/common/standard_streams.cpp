// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See standard_streams.hpp.
#include "standard_streams.hpp"

#include <cstdio>

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#else
#include <unistd.h>
#endif

namespace ocean::app {

#ifdef _WIN32
void use_binary_streams() {
    _setmode(_fileno(stdin), _O_BINARY);
    _setmode(_fileno(stdout), _O_BINARY);
}
bool standard_error_is_terminal() {
    static const bool terminal = _isatty(_fileno(stderr)) != 0;
    return terminal;
}
#else
void use_binary_streams() {}
bool standard_error_is_terminal() {
    static const bool terminal = ::isatty(STDERR_FILENO) != 0;
    return terminal;
}
#endif

}  // namespace ocean::app
