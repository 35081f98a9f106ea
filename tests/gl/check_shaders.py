# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Every shader passes glslangValidator and, compiled by it, spirv-val.

usage: check_shaders.py WRITE_SHADERS GLSLANG SPIRV_VAL
"""

import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path


def problems(shader: Path, glslang: str, spirv_val: str) -> str:
    binary = shader.with_suffix(".spv")
    for command in ([glslang, "-G", "-o", binary, shader], [spirv_val, binary]):
        run = subprocess.run(command, capture_output=True, text=True)
        if run.returncode != 0:
            return f"{shader.name}: {run.stdout}{run.stderr}"
    return ""


def main(write_shaders: str, glslang: str, spirv_val: str) -> int:
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([write_shaders, folder], check=True)
        shaders = sorted(Path(folder).glob("*.comp"))
        assert len(shaders) > 100
        # What cannot pass does not pass.
        wrong = Path(folder) / "wrong.comp"
        wrong.write_text(shaders[0].read_text().replace("void main()", "int main()"))
        assert problems(wrong, glslang, spirv_val)
        with ThreadPoolExecutor(2) as pool:
            found = list(pool.map(lambda shader: problems(shader, glslang, spirv_val), shaders))
    print("".join(found) or f"{len(shaders)} shaders are valid")
    return 1 if any(found) else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
