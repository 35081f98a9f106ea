// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See standard_streams.hpp.
#include "standard_streams.hpp"

#include <cerrno>
#include <cstdio>
#include <initializer_list>

#include <fcntl.h>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace ocean::app {

#ifdef _WIN32
void prepare_standard_streams() {
    _setmode(_fileno(stdin), _O_BINARY);
    _setmode(_fileno(stdout), _O_BINARY);
}
bool standard_error_is_terminal() {
    static const bool terminal = _isatty(_fileno(stderr)) != 0;
    return terminal;
}
#else
void prepare_standard_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) >= 0 || errno != EBADF) continue;
        // A file gets the lowest number that is free.
        if (::open("/dev/null", O_RDWR) != stream) return;
    }
}
bool standard_error_is_terminal() {
    static const bool terminal = ::isatty(STDERR_FILENO) != 0;
    return terminal;
}
#endif

}  // namespace ocean::app
