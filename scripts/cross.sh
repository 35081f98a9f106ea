# shellcheck shell=bash
# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
#
# The cross compiler of cmake/zig.cmake, shared by the scripts that build for other systems. Sourced
# after lib.sh, which has the version.
# shellcheck disable=SC2154

# ensure_zig: the path of the compiler is in $zig afterwards.
ensure_zig() {
    ensure_tools "$ziglang_tool"
    zig=$(.venv/bin/python -c \
        'import pathlib, ziglang; print(pathlib.Path(ziglang.__file__).parent / "zig")')
}

# offer_headers PACKAGE FOLDER: a folder of headers alone, as a CMake package of any version: all of
# /usr/include would bring this machine's C library along.
offer_headers() {
    local package=build/cross/headers/$1
    mkdir -p "$package/include"
    ln -sfn "/usr/include/$2" "$package/include/$2"
    printf 'set(PACKAGE_VERSION 99)\nset(PACKAGE_VERSION_COMPATIBLE TRUE)\n' \
        >"$package/$1ConfigVersion.cmake"
    cat >"$package/$1Config.cmake" <<CONFIG
add_library($1::$1 INTERFACE IMPORTED)
set_target_properties($1::$1 PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES "\${CMAKE_CURRENT_LIST_DIR}/include")
CONFIG
}

# configure_cross TARGET FOLDER [SOURCE] -DOPTION=VALUE...: configures a release for that target.
# SOURCE is the folder of a CMake project, by default libocean itself with its headers.
configure_cross() {
    local target=$1 folder=$2 source=. options=()
    shift 2
    if [[ ${1:-} != -D* ]]; then
        source=$1
        shift
    else
        offer_headers tomlplusplus toml++
        offer_headers nlohmann_json nlohmann
        for package in tomlplusplus nlohmann_json; do
            options+=("-D${package}_DIR=$PWD/build/cross/headers/$package")
        done
        options+=(-DCMAKE_COMPILE_WARNING_AS_ERROR=ON -DOCEAN_BUILD_TESTS=OFF)
    fi
    cmake -S "$source" -B "$folder" -G Ninja --log-level=NOTICE -Wno-dev \
        -DCMAKE_TOOLCHAIN_FILE="$PWD/cmake/zig.cmake" -DOCEAN_ZIG="$zig" \
        -DOCEAN_ZIG_TARGET="$target" -DCMAKE_BUILD_TYPE=Release "${options[@]}" "$@"
}
