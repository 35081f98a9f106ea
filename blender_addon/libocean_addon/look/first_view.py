# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A sea, a coast or a land to look at: with sky, sun and camera, so that the first picture is one
of it.

    operator: subject -> Eye -> sky, sun, camera -> the 3D view looks through it
"""

from __future__ import annotations

import math

import bpy

from ..coast.coast_job import region_of
from ..coast.open_coast import coast_of
from ..sea import operators
from ..shared import compat, console, registration
from ..shared.compat import tr
from ..shared.table_properties import settings_of
from ..terrain import material as terrain_material
from ..terrain import operators as terrain_operators
from ..terrain.open_terrain import terrain_of
from . import framing, material, start_up
from .framing import Eye

_SKIES = bpy.types.ShaderNodeTexSky.bl_rna.properties["sky_type"].enum_items.keys()
MODEL = "MULTIPLE_SCATTERING" if "MULTIPLE_SCATTERING" in _SKIES else "NISHITA"  # from 5.0 on

STRENGTH = {"NISHITA": 0.11, "MULTIPLE_SCATTERING": 0.10}[MODEL]
"""The strength of sky and sun, which are in the sky texture's own units: a clear noon is then
neither black nor white in Filmic and AgX at exposure 0, and the sun at 30 degrees the same in
both."""

DUST = 0.6

# Irradiance of a surface that faces the sun, by the sun's elevation in degrees: what the disc of
# the sky texture lends in Cycles at intensity 1 and this dust [measured, Blender 3.4 and 5.0].
# Eevee does not see that disc: a lamp takes its place in both.
_SUN_NISHITA = (
    (2.0, (39.8, 14.0, 0.2)),
    (5.0, (79.8, 41.8, 9.0)),
    (10.0, (112.1, 74.1, 32.2)),
    (20.0, (134.3, 101.8, 64.0)),
    (32.0, (144.2, 115.2, 83.1)),
    (45.0, (148.3, 121.3, 93.3)),
    (60.0, (151.3, 125.4, 99.8)),
    (90.0, (153.0, 127.8, 103.9)),
)
_SUN_MULTIPLE_SCATTERING = (
    (2.0, (39.1, 12.6, 0.2)),
    (5.0, (76.6, 39.5, 9.3)),
    (10.0, (111.4, 74.8, 34.1)),
    (20.0, (139.4, 108.9, 69.6)),
    (32.0, (152.3, 125.9, 91.2)),
    (45.0, (158.7, 134.7, 103.3)),
    (60.0, (162.3, 139.8, 110.7)),
    (90.0, (164.7, 143.0, 115.4)),
)
_SUN = {"NISHITA": _SUN_NISHITA, "MULTIPLE_SCATTERING": _SUN_MULTIPLE_SCATTERING}[MODEL]
_SUN_DIAMETER = math.radians(0.533)
_CLEAR = 90e3
"""[m] The visibility over a land, whose far hills are then bluer than the near ones."""


def sun_irradiance(elevation: float) -> tuple[float, float, float]:
    """Linear rgb, by degrees above the horizon; 0 below it."""
    if elevation <= 0.0:
        return (0.0, 0.0, 0.0)
    below = (0.0, (0.0, 0.0, 0.0))
    for above in _SUN:
        if elevation <= above[0]:
            share = (elevation - below[0]) / (above[0] - below[0])
            return tuple(a + share * (b - a) for a, b in zip(below[1], above[1], strict=True))
        below = above
    return _SUN[-1][1]


def make_sky(elevation: float, azimuth: float, name: str = "Ocean"):
    """A world with a clear sky. Degrees; azimuth counter-clockwise from +x."""
    world = bpy.data.worlds.new(f"{name} Sky")
    compat.use_nodes(world)
    nodes = world.node_tree.nodes
    texture = nodes.new("ShaderNodeTexSky")
    texture.sky_type = MODEL
    texture.sun_disc = False
    texture.sun_elevation = math.radians(elevation)
    texture.sun_rotation = math.radians(90.0 - azimuth)  # Blender's is clockwise from +y
    aerosols = "dust_density" if hasattr(texture, "dust_density") else "aerosol_density"
    setattr(texture, aerosols, DUST)
    texture.location = (-300, 300)
    background = nodes["Background"]
    background.inputs["Strength"].default_value = STRENGTH
    world.node_tree.links.new(texture.outputs["Color"], background.inputs["Color"])
    return world


def make_sun(elevation: float, azimuth: float, name: str = "Ocean"):
    """The lamp that belongs to that sky."""
    irradiance = sun_irradiance(elevation)
    brightest = max(irradiance)
    lamp = bpy.data.lights.new(f"{name} Sun", "SUN")
    lamp.energy = STRENGTH * brightest
    if brightest > 0.0:
        lamp.color = tuple(part / brightest for part in irradiance)
    lamp.angle = _SUN_DIAMETER
    ob = bpy.data.objects.new(lamp.name, lamp)
    # A lamp shines along its -z.
    ob.rotation_euler = (0.0, math.radians(90.0 - elevation), math.radians(azimuth))
    ob.location.z = 20.0
    return ob


def make_camera(eye: Eye, name: str = "Ocean"):
    """A little below the horizon, which lies in the upper half of the picture."""
    data = bpy.data.cameras.new(f"{name} Camera")
    data.lens = 28.0
    data.clip_start, data.clip_end = 0.1, 1e5
    ob = bpy.data.objects.new(data.name, data)
    ob.location = eye.place
    ob.rotation_euler = (math.radians(90.0 - eye.down), 0.0, math.radians(eye.heading - 90.0))
    return ob


def _look_through_camera(space) -> bool:
    """Has the 3D view, from which the operator was called, show the picture that a render will
    give. Returns whether it shows materials that it did not."""
    space.clip_end = max(space.clip_end, 1e5)
    space.shading.use_scene_world = True  # of the material preview
    space.shading.use_scene_lights = True
    space.region_3d.view_perspective = "CAMERA"
    for name in ("show_floor", "show_axis_x", "show_axis_y"):  # lines across the water
        setattr(space.overlay, name, False)
    is_plain = space.shading.type in ("WIREFRAME", "SOLID")
    if is_plain:
        space.shading.type = "MATERIAL"
    return is_plain


_SCENE = settings_of("look")["AddScene"]
_OF_ALL = ("sun_elevation", "sun_bearing", "remove_start_up")


class _Scene:
    """Base of operators that add a subject with sky, sun and camera. A subclass has the names of
    the new parts begin with `prefix`."""

    bl_options = {"REGISTER", "UNDO"}
    prefix = ""

    def add(self, context):
        """Returns a new object of the subject."""
        raise NotImplementedError

    def eye(self, ob) -> Eye:
        """Returns the view of that object."""
        raise NotImplementedError

    def finish(self, context, ob) -> None:
        """Fits the object to the sky, the sun and the camera, which are there now."""
        raise NotImplementedError

    def execute(self, context):
        with console.work(self.bl_label, "sky, sun and camera"):
            self._make(context, context.scene)
        return {"FINISHED"}

    def _make(self, context, scene) -> None:
        if self.remove_start_up:
            start_up.remove_untouched(scene)
        for kept in (scene.world, scene.camera and scene.camera.data):
            if kept is not None:
                kept.use_fake_user = True
        ob = self.add(context)
        eye = self.eye(ob)
        azimuth = eye.heading + math.degrees(self.sun_bearing)
        elevation = math.degrees(self.sun_elevation)
        scene.world = make_sky(elevation, azimuth, self.prefix)
        camera = make_camera(eye, self.prefix)
        for made in (make_sun(elevation, azimuth, self.prefix), camera):
            context.collection.objects.link(made)
        scene.camera = camera
        context.view_layer.update()
        self.finish(context, ob)
        context.view_layer.objects.active = ob
        space = context.space_data
        if space is not None and space.type == "VIEW_3D" and _look_through_camera(space):
            text = tr("The 3D view shows materials now: Eevee prepares them for some seconds")
            self.report({"INFO"}, text)
        if compat.denoises_without_denoiser(scene):
            scene.cycles.use_denoising = False
            self.report({"INFO"}, tr("Denoise is off: {}", compat.no_denoiser()))


class AddScene(_Scene, bpy.types.Operator):
    """Add a sea to the horizon with sky, sun and camera. The scene's world and camera stay in the
    file, but others take their places"""

    bl_idname = "libocean.add_scene"
    bl_label = "Ocean Scene"
    prefix = "Ocean"

    preset: bpy.props.EnumProperty(
        name="Preset",
        description="The sea to begin with",
        items=operators.PRESETS,
        default=operators.DEFAULT_PRESET,
    )
    water_type: material.water_type_property()
    __annotations__.update(_SCENE)

    def add(self, context):
        bpy.ops.libocean.add(kind="HORIZON", preset=self.preset, water_type=self.water_type)
        return context.view_layer.objects.active

    def eye(self, _ob) -> Eye:
        # Against the waves, which is where they look like waves.
        return Eye((0.0, 0.0, self.camera_height), 180.0, 5.0)

    def finish(self, context, ob) -> None:
        for slot in ob.material_slots:
            material.fit(slot.material, ob, context.scene)
        ob.libocean.use_detail = self.near_detail


class AddCoastScene(_Scene, bpy.types.Operator):
    """Add an island in a sea to the horizon, with sky, sun and camera over its surf. The scene's
    world and camera stay in the file, but others take their places"""

    bl_idname = "libocean.add_coast_scene"
    bl_label = "Coast Scene"
    prefix = "Coast"

    water_type: material.water_type_property()
    __annotations__.update({key: _SCENE[key] for key in _OF_ALL})

    def add(self, context):
        bpy.ops.libocean.add_coast(use_far_water=True, water_type=self.water_type)
        return context.view_layer.objects.active

    def eye(self, ob) -> Eye:
        coast = coast_of(ob.name_full)
        extent = region_of(ob.libocean_coast).extent(coast.own)
        travel = coast.state["mean_direction"]["resolved"]
        return framing.shore_eye(framing.of_bed(coast.bed(extent), extent), travel)

    def finish(self, context, ob) -> None:
        for slot in ob.material_slots:
            material.fit(slot.material, ob, context.scene)


class AddTerrainScene(_Scene, bpy.types.Operator):
    """Add a land to the horizon with sky, sun and camera. The scene's world and camera stay in the
    file, but others take their places"""

    bl_idname = "libocean.add_terrain_scene"
    bl_label = "Terrain Scene"
    prefix = "Terrain"

    preset: bpy.props.EnumProperty(
        name="Preset",
        description="The terrain to begin with",
        items=terrain_operators.PRESETS,
        default=terrain_operators.DEFAULT_PRESET,
    )
    __annotations__.update({key: _SCENE[key] for key in _OF_ALL})

    def add(self, context):
        bpy.ops.libocean.add_terrain(preset=self.preset, use_material=False)
        return context.view_layer.objects.active

    def eye(self, ob) -> Eye:
        return framing.relief_eye(framing.of_terrain(terrain_of(ob.name_full).handle))

    def finish(self, context, ob) -> None:
        ob.libocean_terrain.use_lod = True
        terrain_material.give(ob, context.scene.world, visibility=_CLEAR)


CLASSES = (AddScene, AddCoastScene, AddTerrainScene)


def _draw_add(self, _context) -> None:
    self.layout.operator(AddScene.bl_idname, icon="MOD_OCEAN")
    self.layout.operator(AddCoastScene.bl_idname, icon="MOD_OCEAN")
    self.layout.operator(AddTerrainScene.bl_idname, icon="RNDCURVE")


register, unregister = registration.functions(CLASSES, menus={"VIEW3D_MT_add": _draw_add})
