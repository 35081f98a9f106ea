# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Every shader passes glslangValidator and, compiled by it, spirv-val; those that draw, in the
OpenGL 4.1 that SPIR-V does not know, glslangValidator alone.

usage: check_shaders.py WRITE_SHADERS GLSLANG SPIRV_VAL
"""

import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path


def problems(shader: Path, glslang: str, spirv_val: str) -> str:
    binary = shader.with_suffix(".spv")
    commands = [[glslang, shader]]
    if shader.suffix == ".comp":
        commands = [[glslang, "-G", "-o", binary, shader], [spirv_val, binary]]
    for command in commands:
        run = subprocess.run(command, capture_output=True, text=True)
        if run.returncode != 0:
            return f"{shader.name}: {run.stdout}{run.stderr}"
    return ""


def main(write_shaders: str, glslang: str, spirv_val: str) -> int:
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([write_shaders, folder], check=True)
        shaders = sorted(Path(folder).iterdir())
        kinds = {shader.suffix: shader for shader in shaders}
        assert len(shaders) > 100 and set(kinds) == {".comp", ".vert", ".frag"}
        # A broken shader must fail.
        for kind, shader in kinds.items():
            wrong = Path(folder) / f"wrong{kind}"
            wrong.write_text(shader.read_text().replace("void main()", "int main()"))
            assert problems(wrong, glslang, spirv_val)
        # A fifth of them are equal: programs of other names with the same settings.
        different = {(shader.suffix, shader.read_text()): shader for shader in shaders}.values()
        with ThreadPoolExecutor(2) as pool:
            found = list(pool.map(lambda shader: problems(shader, glslang, spirv_val), different))
    print("".join(found) or f"{len(shaders)} shaders are valid")
    return 1 if any(found) else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
