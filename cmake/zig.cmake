# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
# Toolchain: the clang, libc and libc++ of the PyPI package ziglang, for systems other than this
# one. Needs OCEAN_ZIG, the path of its program zig, and OCEAN_ZIG_TARGET: x86_64-linux-gnu.2.28,
# x86_64-windows-gnu, aarch64-macos. scripts/cross-check uses it.
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES OCEAN_ZIG OCEAN_ZIG_TARGET)

if(OCEAN_ZIG_TARGET MATCHES "windows")
  set(CMAKE_SYSTEM_NAME Windows)
elseif(OCEAN_ZIG_TARGET MATCHES "macos")
  set(CMAKE_SYSTEM_NAME Darwin)
  # Zig 0.17: <cmath> and others first make a later <cfloat> empty there; toml++ asks this of it.
  set(CMAKE_CXX_FLAGS_INIT "-DFLT_RADIX=2")
else()
  set(CMAKE_SYSTEM_NAME Linux)
  set(CMAKE_SHARED_LINKER_FLAGS_INIT "-s")  # libc++ would bring 50 MB of debug information along
endif()
string(REGEX MATCH "^[^-]+" CMAKE_SYSTEM_PROCESSOR "${OCEAN_ZIG_TARGET}")

set(CMAKE_C_COMPILER ${OCEAN_ZIG} cc -target ${OCEAN_ZIG_TARGET})
set(CMAKE_CXX_COMPILER ${OCEAN_ZIG} c++ -target ${OCEAN_ZIG_TARGET})
foreach(language C CXX)
  set(CMAKE_${language}_ARCHIVE_CREATE "\"${OCEAN_ZIG}\" ar qc <TARGET> <OBJECTS>")
  set(CMAKE_${language}_ARCHIVE_FINISH "\"${OCEAN_ZIG}\" ranlib <TARGET>")
endforeach()

# Headers and libraries of this machine are not the target's; the script names those it wants.
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE NEVER)

# One build at least reads each file's own includes alone.
set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
