# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Writes ndbc_41010.csv beside this script: the first time of ndbc_41010.* as plain CSV.

The mean direction is alpha1, the spread sqrt(2 (1 - r1)) in degrees; what the buoy lacks is empty.
"""

import math
import pathlib
import re

HERE = pathlib.Path(__file__).parent


def first_row(suffix):
    line = (HERE / f"ndbc_41010.{suffix}").read_text(encoding="ascii").splitlines()[1]
    return {f: float(v) for v, f in re.findall(r"(\S+) \((.*?)\)", line)}


density, alpha1, r1 = first_row("data_spec"), first_row("swdir"), first_row("swr1")
lines = [
    "# Station 41010 of NDBC, one time",
    "station,time,frequency (Hz),density (m2/Hz),mean_direction,spread",
]
for f in density:
    known = alpha1[f] != 999.0 and r1[f] != 999.0
    angles = f"{alpha1[f]:.1f},{math.degrees(math.sqrt(2 * (1 - r1[f]))):.4f}" if known else ","
    lines.append(f"41010,2020-06-08T03:50Z,{f},{density[f]:.3f},{angles}")
(HERE / "ndbc_41010.csv").write_text("\n".join(lines) + "\n", encoding="ascii")
