#!/usr/bin/python3
# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""What ocean-preview shows of the seas of renders/preview/views.toml that stand beside one another:
pictures of 160 x 90 by llvmpipe, and heights.csv, the surface at twelve places of each. The test
compares with them.

usage: OCEAN_PREVIEW=build/dev/bin/ocean-preview tests/data/preview/make.py [FOLDER [SEA...]]
"""

import math
import os
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.insert(0, str(ROOT / "renders" / "preview"))
import hosts  # noqa: E402

# A spiral from 3 m to 112 m around the eye, no two places in one direction.
PLACES = [
    (round(r * math.cos(a), 2), round(r * math.sin(a), 2))
    for r, a in ((3.0 * 1.39**i, 2.4 * i) for i in range(12))
]


def shown(name: str, *arguments) -> str:
    """What ocean-preview prints of a view."""
    view = hosts.view_of(name)
    sea = view["sea"] if ":" in view["sea"] else ROOT / view["sea"]
    # The context makes no use of a display that is there.
    kept = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
    program = Path(os.environ["OCEAN_PREVIEW"]).resolve()
    command = [program, sea, *hosts.preview_words(view), *arguments]
    return subprocess.run(command, env=kept, check=True, stdout=subprocess.PIPE, text=True).stdout


def main() -> None:
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else HERE
    probes = [word for x, y in PLACES for word in ("--probe", f"{x},{y}")]
    rows = ["sea,x,y,mesh,maps"]
    for name in sys.argv[2:] or hosts.names():
        picture = ("--offscreen", folder / f"{name}.png", "--size", "160x90", "-q")
        for line in shown(name, *probes, *picture).splitlines()[: len(PLACES)]:
            x, y, mesh, maps = map(float, line.split(",")[:4])
            rows.append(f"{name},{x:g},{y:g},{mesh:.5f},{maps:.5f}")
    (folder / "heights.csv").write_text("\n".join(rows) + "\n")


if __name__ == "__main__":
    main()
