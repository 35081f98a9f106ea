#!/bin/bash
# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
#
# The tests of the GPU by zink on lavapipe: OpenGL over Vulkan, another compiler of shaders. In X.
# usage: by_zink.sh GL_TESTS
set -euo pipefail
export LIBGL_ALWAYS_SOFTWARE=1 LIBGL_KOPPER_DRI2=1 MESA_LOADER_DRIVER_OVERRIDE=zink
export OCEAN_GL_TEST_RENDERER=zink
exec "$1"
