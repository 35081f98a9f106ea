#!/bin/bash
# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
# make.sh OCEAN: the bakes of this folder, by the program of commit 2c77838.
set -euo pipefail
cd "$(dirname "$0")"
rm -rf bake
"$1" bake sea.toml -o bake/s.####.exr --frames 3-4 --products displacement,foam -q
"$1" bake sea.toml -o bake/s.####.ply --frames 3 -q
