# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The differences between Blender 3.4 and 5.2, in one place."""

from __future__ import annotations

import atexit
import contextlib
import ctypes
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import _bpy
import blf
import bpy

from . import modules

VERSION = bpy.app.version[:2]


# Node groups ------------------------------------------------------------------


def add_socket(group, name: str, kind: str, *, output: bool = False, **settings):
    """A new input (or output) of a node group. settings: default_value, min_value, description."""
    if hasattr(group, "interface"):  # 4.0
        direction = "OUTPUT" if output else "INPUT"
        socket = group.interface.new_socket(name=name, in_out=direction, socket_type=kind)
    else:
        socket = (group.outputs if output else group.inputs).new(kind, name)
    for key, value in settings.items():
        setattr(socket, key, value)
    return socket


def add_number(group, name: str, default: float, low: float, high: float, description: str):
    """A new input of a node group, a number that an artist may tune."""
    limits = {"min_value": low, "max_value": high, "description": description}
    return add_socket(group, name, "NodeSocketFloat", default_value=default, **limits)


def hide_inputs(group) -> None:
    """Out of the modifier's panel, where Blender lets us: from 3.5 on."""
    if hasattr(group, "interface"):  # 4.0
        sockets = [item for item in group.interface.items_tree if item.item_type == "SOCKET"]
    else:
        sockets = group.inputs
    for socket in sockets:
        if hasattr(socket, "hide_in_modifier"):
            socket.hide_in_modifier = True


def input_identifiers(group) -> dict[str, str]:
    """The identifier of each input: "Input_N" before 4.0, "Socket_N" from then on."""
    if hasattr(group, "interface"):
        sockets = [
            item
            for item in group.interface.items_tree
            if item.item_type == "SOCKET" and item.in_out == "INPUT"
        ]
    else:
        sockets = group.inputs
    return {socket.name: socket.identifier for socket in sockets}


def active(sockets, name: str):
    """Returns the socket in use among several with one name: some nodes have a socket for each
    type."""
    return next(socket for socket in sockets if socket.enabled and socket.name == name)


def capture(group, geometry, color):
    """Capture Attribute of a colour on points: the geometry and the captured colour."""
    node = group.nodes.new("GeometryNodeCaptureAttribute")
    node.domain = "POINT"
    if hasattr(node, "capture_items"):  # 4.2
        node.capture_items.new("RGBA", "Color")
        value, captured = node.inputs["Color"], node.outputs["Color"]
    else:
        node.data_type = "FLOAT_COLOR"
        value, captured = active(node.inputs, "Value"), active(node.outputs, "Attribute")
    group.links.new(geometry, node.inputs["Geometry"])
    group.links.new(color, value)
    return node.outputs["Geometry"], captured


def curves_of(animation) -> list:
    """Returns the F-curves of an object's animation data."""
    action = animation.action
    if action is None:
        return []
    if hasattr(action, "fcurves"):  # until 5.0
        return list(action.fcurves)
    from bpy_extras import anim_utils

    bag = anim_utils.action_get_channelbag_for_slot(action, animation.action_slot)
    return [] if bag is None else list(bag.fcurves)


# Inputs of a Geometry Nodes modifier ------------------------------------------

_INPUTS_ARE_PROPERTIES = "properties" in bpy.types.NodesModifier.bl_rna.properties  # 5.2


def get_input(modifier, identifier: str):
    if _INPUTS_ARE_PROPERTIES:
        return getattr(modifier.properties.inputs, identifier).value
    return modifier[identifier]


def _single(value: float) -> float:
    """Returns a number as single precision holds it. NumPy is absent where this module says so."""
    return ctypes.c_float(value).value


def set_input(modifier, identifier: str, value) -> None:
    """Sets an input of a modifier if its value differs, and notifies the object, which Blender does
    not do."""
    now = get_input(modifier, identifier)
    # From 4.0 on a value comes back in single precision.
    if isinstance(value, float):
        value = _single(value)
    elif isinstance(value, tuple):
        value = tuple(_single(part) for part in value)
    if (tuple(now) if isinstance(value, tuple) else now) == value:
        return
    if _INPUTS_ARE_PROPERTIES:
        getattr(modifier.properties.inputs, identifier).value = value
    elif isinstance(value, tuple):
        modifier[identifier][:] = (
            value  # a new array would be one of doubles, which no socket takes
        )
    else:
        modifier[identifier] = value
    modifier.id_data.update_tag()


def let_go(modifier, identifier: str) -> None:
    """Clears the object in an input before its modifier is removed: 5.2 would count it as a
    user."""
    if _INPUTS_ARE_PROPERTIES:
        getattr(modifier.properties.inputs, identifier).value = None


# Meshes -----------------------------------------------------------------------


def shade_smooth(mesh) -> None:
    if hasattr(mesh, "shade_smooth"):  # 4.1
        mesh.shade_smooth()
    else:
        mesh.polygons.foreach_set("use_smooth", [True] * len(mesh.polygons))


SHARES_LAYERS = VERSION >= (4, 0)
"""A mesh shares its unchanged layers with its evaluated copies. Before, each frame copied them."""
LOOP_TOTAL_FOLLOWS = VERSION >= (4, 1)  # MeshPolygon.loop_total is read-only, made of loop_start


# Materials --------------------------------------------------------------------

GLOSSY = (
    "ShaderNodeBsdfGlossy" if VERSION < (4, 0) else "ShaderNodeBsdfAnisotropic"
)  # one node from then on


def use_nodes(owner) -> None:
    """Switches the nodes of a material or world on: from 5.0 on they always are, and setting it
    warns."""
    if VERSION < (5, 0):
        owner.use_nodes = True


def has_nodes(owner) -> bool:
    """Returns whether the nodes of a material or world are in use."""
    return owner.node_tree is not None and (VERSION >= (5, 0) or owner.use_nodes)


def refract_in_eevee(material) -> None:
    """Has Eevee show the objects behind a material through it."""
    if hasattr(material, "use_raytrace_refraction"):  # 4.2
        material.use_raytrace_refraction = True
    else:
        material.use_screen_refraction = True


def fade_in_eevee(material) -> None:
    """Has Eevee decide transparency sample by sample, as it always does from 4.2 on."""
    if not hasattr(material, "surface_render_method"):
        material.blend_method = material.shadow_method = "HASHED"


def cut_in_eevee(material) -> None:
    """Has Eevee leave out what is transparent, as it does by itself from 4.2 on."""
    if not hasattr(material, "surface_render_method") and material.blend_method == "OPAQUE":
        material.blend_method = material.shadow_method = "CLIP"


def light_nothing(material) -> None:
    """Has Cycles show the emission of a material without counting its triangles as lamps."""
    cycles = getattr(material, "cycles", None)
    if hasattr(cycles, "emission_sampling"):  # 3.5
        cycles.emission_sampling = "NONE"
    elif cycles is not None:
        cycles.sample_as_light = False


def draws_points(scene) -> bool:
    """Returns whether the scene's engine draws points: Eevee does from 4.2 on."""
    return VERSION >= (4, 2) or scene.render.engine != "BLENDER_EEVEE"


def shutter(scene) -> tuple[float, float]:
    """Frames before and after that a frame shows for its motion blur."""
    eevee, cycles = scene.eevee, getattr(scene, "cycles", None)
    owners = (scene.render, eevee, cycles)
    if not scene.render.use_motion_blur and not getattr(eevee, "use_motion_blur", False):
        return 0.0, 0.0
    # Some of these settings are the scene's, others each engine's own: the widest counts.
    open_for = max(
        float(getattr(owner, name, 0.0))
        for owner, name in ((scene.render, "motion_blur_shutter"), (eevee, "motion_blur_shutter"))
    )
    places = {getattr(owner, "motion_blur_position", None) for owner in owners} - {None}
    before = {"START": 0.0, "CENTER": 0.5, "END": 1.0}
    shares = [before[place] for place in places] or [0.5]
    return open_for * max(shares), open_for * (1.0 - min(shares))


def renders_objects(scene) -> bool:
    """Returns whether a render of the scene shows its own objects: not if its sequencer has
    strips."""
    editor = scene.sequence_editor
    if editor is None or not scene.render.use_sequencer:
        return True
    return len(editor.strips if hasattr(editor, "strips") else editor.sequences) == 0  # 4.4


def has_denoiser() -> bool:
    """Returns whether Cycles can denoise. Built without OpenImageDenoise it ends the render of a
    scene that has Denoise on with an error."""
    try:
        import _cycles
    except ImportError:
        return True
    return getattr(_cycles, "with_openimagedenoise", True)


def denoises_without_denoiser(scene) -> bool:
    cycles = getattr(scene, "cycles", None)
    return cycles is not None and cycles.use_denoising and not has_denoiser()


# Paths ------------------------------------------------------------------------

RELATIVE_PATH = {"PATH_SUPPORTS_BLEND_RELATIVE"} if VERSION >= (4, 5) else set()
"""Option of a property that may begin with "//"."""


# Assets -----------------------------------------------------------------------


def add_asset_library(name: str, folder: Path) -> None:
    """Adds a folder to the asset libraries of the preferences, unless it is one already."""
    preferences = bpy.context.preferences
    libraries = preferences.filepaths.asset_libraries
    known = {Path(bpy.path.abspath(library.path)).resolve() for library in libraries}
    if folder.resolve() in known:
        return
    if hasattr(libraries, "new"):  # 4.0
        library = libraries.new(name=name, directory=str(folder))
    else:
        bpy.ops.preferences.asset_library_add(directory=str(folder))
        library = libraries[-1]
        library.name = name
    if hasattr(library, "import_method"):  # 3.5
        library.import_method = "APPEND"
    preferences.is_dirty = True  # without it Blender would not save them at its end


_MENUS = ("ASSETBROWSER_MT_catalog", "ASSETBROWSER_MT_edit")
ASSET_MENU = next(name for name in _MENUS if hasattr(bpy.types, name))
"""The menu of the Asset Browser for operators that make assets."""


# Volumes ----------------------------------------------------------------------


READS_VOLUMES_ONCE = VERSION >= (4, 1)  # Blender caches the grids of a file by its path


def load_openvdb():
    """Blender's own Python module of OpenVDB, by the name that it has; None where there is none, as
    in 4.2. The Python module bpy has it in a folder that Python does not look into."""
    python = f"python{sys.version_info[0]}.{sys.version_info[1]}"
    own = Path(bpy.utils.resource_path("LOCAL"), "python", "lib", python, "site-packages")
    for name in ("openvdb", "pyopenvdb"):
        with contextlib.suppress(ImportError):
            return modules.load(name, own)
    return None


# Languages --------------------------------------------------------------------

_report_text = getattr(bpy.app.translations, "pgettext_rpt", None)  # 4.1
if _report_text is None:
    _report_text = bpy.app.translations.pgettext_tip


def tr(text: str, *values) -> str:
    """Returns the text of a report in the user's language, with the values in its placeholders.
    Texts of the library are passed as values: they stay English."""
    return _report_text(text).format(*values)


def tr_label(text: str, *values) -> str:
    """Returns a drawn text in the user's language, with the values in its placeholders."""
    return bpy.app.translations.pgettext_iface(text).format(*values)


def no_denoiser() -> str:
    """Returns a sentence on Cycles without a denoiser."""
    return tr_label(
        "Cycles is built without OpenImageDenoise here, as in Debian's package blender; the "
        "Blender of blender.org has it"
    )


def in_context(context: str) -> dict[str, str]:
    """Settings of a property whose name and choices are looked up in a context; before 4.0 there is
    no such setting, and the context is "*"."""
    known = "translation_context" in bpy.props.EnumProperty.__doc__
    return {"translation_context": context} if known else {}


# Texts of panels --------------------------------------------------------------

_POINTS = 11  # of the interface's font


def text_width(text: str) -> float:
    """Returns the width of a text in the interface's font [pixels at a resolution scale of 1]."""
    blf.size(0, _POINTS)
    return blf.dimensions(0, text)[0]


# The add-on -------------------------------------------------------------------


@contextlib.contextmanager
def all_data() -> Iterator[None]:
    """Gives bpy.data and bpy.context back, which Blender withholds while an add-on registers."""
    # In the Python module of 5.2 bpy.path sees another module than `import bpy` gives.
    modules = (bpy, getattr(bpy.path, "_bpy", bpy))
    withheld = [(module, module.data, module.context) for module in modules]
    for module in modules:
        module.data, module.context = _bpy.data, _bpy.context
    try:
        yield
    finally:
        for module, data, context in withheld:
            module.data, module.context = data, context


def remove_handlers_at_exit(remove: Callable[[], None]) -> None:
    """In the Python module bpy a handler that is left at exit crashes 4.2 and hangs 4.5."""
    if not bpy.app.binary_path:
        atexit.register(remove)
