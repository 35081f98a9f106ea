# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A sea to look at: with sky, sun and camera, so that the first picture is one."""

from __future__ import annotations

import math

import bpy

from ..sea import operators
from ..shared import compat, console, registration
from ..shared.compat import tr
from ..shared.table_properties import settings_of
from . import material, start_up

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


def make_sky(elevation: float, azimuth: float):
    """A world with a clear sky. Degrees; azimuth counter-clockwise from +x."""
    world = bpy.data.worlds.new("Ocean Sky")
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


def make_sun(elevation: float, azimuth: float):
    """The lamp that belongs to that sky."""
    irradiance = sun_irradiance(elevation)
    brightest = max(irradiance)
    lamp = bpy.data.lights.new("Ocean Sun", "SUN")
    lamp.energy = STRENGTH * brightest
    if brightest > 0.0:
        lamp.color = tuple(part / brightest for part in irradiance)
    lamp.angle = _SUN_DIAMETER
    ob = bpy.data.objects.new("Ocean Sun", lamp)
    # A lamp shines along its -z.
    ob.rotation_euler = (0.0, math.radians(90.0 - elevation), math.radians(azimuth))
    ob.location.z = 20.0
    return ob


def make_camera(height: float, heading: float):
    """A little below the horizon, which lies in the upper half of the picture."""
    data = bpy.data.cameras.new("Ocean Camera")
    data.lens = 28.0
    data.clip_start, data.clip_end = 0.1, 1e5
    ob = bpy.data.objects.new("Ocean Camera", data)
    ob.location.z = height
    ob.rotation_euler = (math.radians(90.0 - 5.0), 0.0, math.radians(heading - 90.0))
    return ob


def _look_through_camera(space) -> None:
    """Has the 3D view, from which the operator was called, show the picture that a render will
    give."""
    space.clip_end = max(space.clip_end, 1e5)
    space.shading.use_scene_world = True  # of the material preview
    space.shading.use_scene_lights = True
    space.region_3d.view_perspective = "CAMERA"


class AddScene(bpy.types.Operator):
    """Add a sea to the horizon with sky, sun and camera. The scene's world and camera stay in the
    file, but others take their places"""

    bl_idname = "libocean.add_scene"
    bl_label = "Ocean Scene"
    bl_options = {"REGISTER", "UNDO"}

    preset: bpy.props.EnumProperty(
        name="Preset",
        description="The sea to begin with",
        items=operators.PRESETS,
        default=operators.DEFAULT_PRESET,
    )
    water_type: material.water_type_property()
    __annotations__.update(settings_of("look")["AddScene"])

    def execute(self, context):
        with console.work("Ocean Scene", "sky, sun and camera"):
            self._make(context, context.scene)
        return {"FINISHED"}

    def _make(self, context, scene) -> None:
        for kept in (scene.world, scene.camera and scene.camera.data):
            if kept is not None:
                kept.use_fake_user = True
        if self.remove_start_up:
            start_up.remove_untouched(scene)
        bpy.ops.libocean.add(kind="HORIZON", preset=self.preset, water_type=self.water_type)
        ocean = context.view_layer.objects.active
        # Against the waves, which is where they look like waves.
        heading = 180.0
        azimuth = heading + math.degrees(self.sun_bearing)
        elevation = math.degrees(self.sun_elevation)
        scene.world = make_sky(elevation, azimuth)
        camera = make_camera(self.camera_height, heading)
        for ob in (make_sun(elevation, azimuth), camera):
            context.collection.objects.link(ob)
        scene.camera = camera
        for slot in ocean.material_slots:
            material.fit(slot.material, ocean, scene)
        ocean.libocean.use_detail = self.near_detail
        context.view_layer.objects.active = ocean
        if context.space_data is not None and context.space_data.type == "VIEW_3D":
            _look_through_camera(context.space_data)
        if compat.denoises_without_denoiser(scene):
            scene.cycles.use_denoising = False
            self.report({"INFO"}, tr("Denoise is off: {}", compat.no_denoiser()))


CLASSES = (AddScene,)


def _draw_add(self, _context) -> None:
    self.layout.operator(AddScene.bl_idname, icon="MOD_OCEAN")


register, unregister = registration.functions(CLASSES, menus={"VIEW3D_MT_add": _draw_add})
