#!/bin/bash
# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
#
# The tests of the GPU by zink on lavapipe: OpenGL over Vulkan, another compiler of shaders. In X.
# usage: by_zink.sh GL_TESTS
set -euo pipefail
export LIBGL_ALWAYS_SOFTWARE=1 LIBGL_KOPPER_DRI2=1 MESA_LOADER_DRIVER_OVERRIDE=zink
export OCEAN_GL_TEST_RENDERER=zink
# zink 22.3 keeps its own copies of what is read back and uploaded, 128 kB a frame in some runs and
# none in others, while no object is more: the memory of a thousand frames is judged by llvmpipe.
exec "$1" --gtest_filter=-GlBackend.AThousandFrames*
