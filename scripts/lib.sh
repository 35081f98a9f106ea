# shellcheck shell=bash
# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
#
# What the scripts share: the repository's root as the current directory, the packages each job
# needs, how to install those that are missing, and how to build a preset. Sourced, never run.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# Every package that a job needs is named, also those that others bring along today: a bare machine
# has none of them. The lists are read by the scripts that source this file.
# shellcheck disable=SC2034
{
    build_packages=(
        cmake g++ ninja-build pkg-config python3 libtomlplusplus-dev libopenexr-dev
        libpng-dev libtiff-dev zlib1g-dev libcairo2-dev libnetcdf-dev libssl-dev nlohmann-json3-dev libepoxy-dev
        libglm-dev libglfw3-dev libimgui-dev libstb-dev fonts-dejavu-core libasio-dev libedit-dev
        libusb-1.0-0-dev liblo-dev librtmidi-dev libopenvdb-dev libboost-iostreams-dev)
    demo_packages=("${build_packages[@]}" povray povray-includes)
    lint_packages=(
        git python3 python3-venv python3-numpy ca-certificates clang-format shellcheck codespell)
    deb_packages=(dpkg-dev file binutils libgdal-dev)
    quick_packages=("${build_packages[@]}" "${lint_packages[@]}" binutils libgtest-dev libgmock-dev
        libfftw3-dev ccache)
    docs_packages=(python3-sphinx python3-myst-parser furo python3-breathe doxygen)
    test_packages=(
        "${demo_packages[@]}" "${lint_packages[@]}" "${docs_packages[@]}" binutils libgtest-dev libgmock-dev
        libfftw3-dev glslang-tools spirv-tools python3-numpy python3-pil python3-pytest python3-openimageio
        openimageio-tools openexr clang libclang-rt-14-dev valgrind blender libegl1 libegl-mesa0 libgl1
        libgl1-mesa-dri xvfb xauth xdotool telnet netcat-openbsd python3-meshio python3-openvdb
        libopenvdb-tools desktop-file-utils shared-mime-info
        libglib2.0-bin locales man-db systemd dpkg-dev file libgdal-dev strace umockdev libumockdev-dev liblo-tools nodejs ccache lld)
    bench_packages=(
        "${build_packages[@]}" libbenchmark-dev libfftw3-dev valgrind python3-venv ca-certificates)
    gl_packages=("${test_packages[@]}" mesa-vulkan-drivers)
    gpu_packages=(cmake g++ ninja-build pkg-config python3 libtomlplusplus-dev libepoxy-dev libegl1
        libgl1)
    bpy_packages=(
        "${build_packages[@]}" blender libegl1 xvfb xauth python3-numpy python3-pytest python3-venv
        ca-certificates libgl1 libgomp1 libice6 libsm6 libx11-6 libxext6 libxfixes3 libxi6 libxkbcommon0
        libxrender1 libxxf86vm1)
    # Long-term releases and what came between; those that the index drops are dropped here.
    bpy_versions=(4.2.23 4.5.15 5.0.1 5.2.3)
    chroot_packages=("${build_packages[@]}" "${deb_packages[@]}" debootstrap)
    cross_packages=("${build_packages[@]}" "${lint_packages[@]}" wine wine64)
    vm_packages=(qemu-system-x86 busybox-static cpio kmod udev binutils)
    farm_packages=("${test_packages[@]}" munge slurmctld slurmd slurm-client faketime iproute2 curl)
    # One release of each PyPI tool, so that a new one cannot turn a good tree red.
    ruff_tool=ruff==0.17.5
    mypy_tool=mypy==2.4.1
    usd_tool=usd_core==26.11  # judges our USD
    # write and read GeoTIFF: rasterio (GDAL), and tifffile, for which imagecodecs has the predictor
    # of floats; an affine newer than this needs newer attrs than Debian's
    geotiff_tools=(rasterio==1.4.4 affine==2.4.0 tifffile==2026.3.3 imagecodecs==2026.3.6)
    spdx_tool=spdx_tools==0.8.5  # judges scripts/sbom
    # check and run bundles of Open Job Description
    openjd_tools=(openjd_cli==0.8.0 openjd_model==0.13.0 openjd_sessions==0.13.0)
    materialx_tool=materialx==1.39.5  # judges shaders/materialx
    # draw the figures of docs/coast_accuracy.md
    figures_tool=matplotlib==3.10.0
    figures_numpy=numpy==2.1.3
    ziglang_tool=ziglang==0.17.0
    mkl_tool=mkl-static==2026.2.0
    mkl_headers_tool=mkl-include==2026.2.0
}

say() { printf '%s\n' "$*" >&2; }
fail() {
    say "$(basename "$0"): $*"
    exit 1
}

# ensure_packages NAME...: installs those Debian packages that are missing; silent if none is.
ensure_packages() {
    if ! command -v dpkg-query >/dev/null; then
        say "this is not a Debian system: make sure that it has what these packages hold: $*"
        return 0
    fi
    local missing as_root=() log
    mapfile -t missing < <(comm -13 \
        <(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "$@" 2>/dev/null |
            sed -n 's/^installed //p' | sort -u) \
        <(printf '%s\n' "$@" | sort -u))
    [ ${#missing[@]} -gt 0 ] || return 0

    local install=(apt-get install -y -qq --no-install-recommends -o DPkg::Lock::Timeout=600
        "${missing[@]}")
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || fail "packages are missing and this is neither root nor" \
            "is there sudo. As root: apt-get update && ${install[*]}"
        as_root=(sudo)
    fi
    say "installing ${#missing[@]} packages and what they need: ${missing[*]}"
    log=$(mktemp)
    as_root+=(env DEBIAN_FRONTEND=noninteractive)
    # Whether stale lists are good enough is for the installation to find out.
    "${as_root[@]}" apt-get update -qq >"$log" 2>&1 || true
    if ! "${as_root[@]}" "${install[@]}" >>"$log" 2>&1 </dev/null; then
        tail -n 20 "$log" >&2
        rm -f "$log"
        fail "the installation failed: ${install[*]}"
    fi
    rm -f "$log"
}

# ensure_tools NAME==VERSION...: PyPI packages in the project's own virtual environment, .venv.
ensure_tools() {
    local tool missing=()
    for tool; do
        compgen -G ".venv/lib/python3*/site-packages/${tool%%==*}-${tool##*==}.dist-info" >/dev/null ||
            missing+=("$tool")
    done
    [ ${#missing[@]} -gt 0 ] || return 0
    say "installing ${missing[*]} into .venv"
    [ -x .venv/bin/pip ] || /usr/bin/python3 -m venv .venv
    .venv/bin/python -m pip install --quiet --disable-pip-version-check "${missing[@]}"
}

# build_preset PRESET [-DOPTION=VALUE...] [TARGET...]: configures and builds in build/PRESET.
build_preset() {
    local preset=$1 options=()
    shift
    while [[ ${1:-} == -D* ]]; do
        options+=("$1")
        shift
    done
    cmake --preset "$preset" "${options[@]}" --log-level=NOTICE >/dev/null || return
    cmake --build "build/$preset" ${1:+--target "$@"}
}
