# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Has MaterialX make OSL of the node `ocean_maps`, a shader for each of its outputs, with the
headers that it includes.

usage: materialx_osl.py DOCUMENT FOLDER [--downwards]    (by a Python that has MaterialX)

--downwards: for a host whose images begin at the top.

The place is the attribute `place` of the mesh, in metres; what else the node takes are parameters
of the shaders, maps_NAME.
"""

import shutil
import sys
from pathlib import Path

import MaterialX
from MaterialX import PyMaterialXGenOsl, PyMaterialXGenShader

TYPES = {"displacement": "vector3", "normal": "vector3", "foam": "float"}


def connect(node, name: str, kind: str, source, output: str = "") -> None:
    port = node.addInput(name, kind)
    port.setNodeName(source.getName())
    if output:
        port.setOutputString(output)


def main(source: str, folder: Path, downwards: bool) -> None:
    library = MaterialX.createDocument()
    search = MaterialX.getDefaultDataSearchPath()
    MaterialX.loadLibraries(MaterialX.getDefaultDataLibraryFolders(), search, library)
    document = MaterialX.createDocument()
    document.setDataLibrary(library)
    MaterialX.readFromXmlFile(document, source)

    graph = document.addNodeGraph("test")
    attribute = graph.addNode("geompropvalue", "attribute", "vector3")
    attribute.setInputValue("geomprop", "place")
    parts = graph.addNode("separate3", "parts", "multioutput")
    connect(parts, "in", "vector3", attribute)
    place = graph.addNode("combine2", "place", "vector2")
    connect(place, "in1", "float", parts, "outx")
    connect(place, "in2", "float", parts, "outy")
    maps = graph.addNode("ocean_maps", "maps", "multioutput")
    connect(maps, "texcoord", "vector2", place)
    for name in TYPES:
        maps.setInputValue(f"{name}_map", "", "filename")
    maps.setInputValue("resolution", 1.0)
    maps.setInputValue("period", 1.0)
    maps.setInputValue("axes", 0)

    for name, kind in TYPES.items():
        output = graph.addOutput(f"{name}_out", kind)
        output.setNodeName("maps")
        output.setOutputString(name)
        generator = PyMaterialXGenOsl.OslShaderGenerator.create()
        context = PyMaterialXGenShader.GenContext(generator)
        context.registerSourceCodeSearchPath(search)
        context.getOptions().fileTextureVerticalFlip = downwards
        generator.registerTypeDefs(document)
        shader = generator.generate(f"maps_{name}", output, context)
        text = shader.getSourceCode(PyMaterialXGenShader.PIXEL_STAGE)
        (folder / f"{name}.osl").write_text(text)
    assert document.validate() == (True, ""), document.validate()[1]
    for header in Path(MaterialX.__file__).parent.glob("libraries/stdlib/genosl/include/*.h"):
        shutil.copy(header, folder)


main(sys.argv[1], Path(sys.argv[2]), "--downwards" in sys.argv)
