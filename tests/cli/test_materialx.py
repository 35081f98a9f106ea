# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""shaders/materialx/ocean.mtlx, judged by MaterialX itself (of PyPI, in the project's .venv): it is
valid, and its generators make GLSL that compiles, and OSL. What that OSL reads of our files is
tested where there is a renderer, in tests/blender/test_osl.py."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent.parent
DOCUMENT = ROOT / "shaders/materialx/ocean.mtlx"
sys.path += [str(path) for path in ROOT.glob(".venv/lib/python3.*/site-packages")]
try:
    import MaterialX
    from MaterialX import PyMaterialXGenGlsl, PyMaterialXGenOsl, PyMaterialXGenShader
except ImportError:
    pytest.skip("MaterialX is not in .venv; scripts/test installs it", allow_module_level=True)


@pytest.fixture
def document():
    library = MaterialX.createDocument()
    search = MaterialX.getDefaultDataSearchPath()
    MaterialX.loadLibraries(MaterialX.getDefaultDataLibraryFolders(), search, library)
    document = MaterialX.createDocument()
    document.setDataLibrary(library)
    MaterialX.readFromXmlFile(document, str(DOCUMENT))
    return document


def generated(document, generator, element, stage):
    context = PyMaterialXGenShader.GenContext(generator)
    context.registerSourceCodeSearchPath(MaterialX.getDefaultDataSearchPath())
    generator.registerTypeDefs(document)
    shader = generator.generate("ocean", element, context)
    return shader.getSourceCode(stage)


def test_it_is_valid(document):
    assert document.validate() == (True, "")
    # The judge sees what is wrong.
    document.getNode("sea").getInput("period").setType("color3")
    assert not document.validate()[0]


def test_every_map_repeats_and_is_read_half_a_texel_further(document):
    graph = document.getNodeGraph("NG_ocean_maps")
    images = graph.getNodes("image")
    assert len(images) == 3
    for image in images:
        assert image.getInputValue("uaddressmode") == "periodic"
        assert image.getInputValue("vaddressmode") == "periodic"
        assert image.getInput("texcoord").getNodeName() == "place"
    place = graph.getNode("place")
    assert place.getCategory() == "place2d"
    assert place.getInput("offset").getNodeName() == "half_texels"


def test_its_material_becomes_glsl_that_compiles(document, tmp_path):
    material = document.getNode("ocean")
    for stage, name in (
        (PyMaterialXGenShader.PIXEL_STAGE, "frag"),
        (PyMaterialXGenShader.VERTEX_STAGE, "vert"),
    ):
        generator = PyMaterialXGenGlsl.GlslShaderGenerator.create()
        source = tmp_path / f"ocean.{name}"
        source.write_text(generated(document, generator, material, stage))
        done = subprocess.run(["glslangValidator", source], capture_output=True, text=True)
        assert done.returncode == 0, done.stdout
    maps = set(re.findall(r"uniform sampler2D (\w+_map)", (tmp_path / "ocean.frag").read_text()))
    assert maps == {"sea_normal_map", "sea_foam_map", "sea_displacement_map"}


def test_its_material_becomes_osl(document):
    generator = PyMaterialXGenOsl.OslShaderGenerator.create()
    source = generated(
        document, generator, document.getNode("ocean"), PyMaterialXGenShader.PIXEL_STAGE
    )
    assert source.count('"periodic"') >= 6 and "NG_ocean_maps" in source
