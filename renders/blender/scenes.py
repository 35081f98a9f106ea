# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The pictures of the Blender add-on, made from nothing through its operators.

usage: blender --background --python renders/blender/scenes.py -- SCENE PICTURE [SAMPLES] [PERCENT]
       [CYCLES|EEVEE] [LAST STEP]

The add-on must be installed. SCENE is open_sea, dusk, storm, volume, below, ferry, ferry_above,
hero, hero_before, coast_dusk or coast_bay, or one of first_ocean, first_coast and first_terrain,
which are what *Add > ... Scene* makes, or fly_terrain; PICTURE ends in .jpg or .png, and has ## for
the number of the frame where each STEPth from 1 to LAST is made. Storm and volume also need the
command `ocean` (or another by the environment variable OCEAN), and volume OpenVDB's Python module.
"""

import atexit
import math
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import bpy
from mathutils import Vector

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE))
import volumes  # noqa: E402

PACKAGES = ("bl_ext.user_default.libocean", "libocean_addon")


def enable_addon() -> None:
    import addon_utils  # of Blender, found once bpy is there

    there = {module.__name__ for module in addon_utils.modules()}
    for module in PACKAGES:
        if module in there and addon_utils.enable(module) is not None:
            return
    sys.exit("the libocean add-on is not installed: see blender_addon/README.md")


def can_denoise() -> bool:
    import _cycles  # of Blender; Debian builds it without a denoiser

    return bool(getattr(_cycles, "with_openimagedenoise", False))


# The world --------------------------------------------------------------------


def sky(scene, *, elevation: float, azimuth: float, strength: float, dust: float) -> None:
    """A clear sky with a sun. Degrees; azimuth counter-clockwise from +x."""
    world = bpy.data.worlds.new("Sky")
    scene.world = world
    if bpy.app.version < (5, 0):
        world.use_nodes = True
    nodes = world.node_tree.nodes
    texture = nodes.new("ShaderNodeTexSky")
    kinds = texture.bl_rna.properties["sky_type"].enum_items.keys()
    texture.sky_type = next(k for k in ("MULTIPLE_SCATTERING", "NISHITA") if k in kinds)
    texture.sun_elevation = math.radians(elevation)
    texture.sun_rotation = math.radians(90.0 - azimuth)  # Blender's is clockwise from +y
    texture.sun_intensity = 0.6
    aerosols = "dust_density" if hasattr(texture, "dust_density") else "aerosol_density"
    setattr(texture, aerosols, dust)
    background = nodes["Background"]
    background.inputs["Strength"].default_value = strength
    world.node_tree.links.new(texture.outputs["Color"], background.inputs["Color"])


def camera(scene, place, target, lens: float):
    data = bpy.data.cameras.new("Camera")
    ob = bpy.data.objects.new("Camera", data)
    scene.collection.objects.link(ob)
    ob.location = place
    ob.rotation_euler = (Vector(target) - Vector(place)).to_track_quat("-Z", "Y").to_euler()
    data.lens = lens
    data.clip_end = 1e5
    scene.camera = ob
    return ob


# A buoy -----------------------------------------------------------------------


def paint(name: str, color, *, metallic=0.0, roughness=0.4):
    material = volumes.new_material(name)
    shader = material.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*color, 1.0)
    shader.inputs["Metallic"].default_value = metallic
    shader.inputs["Roughness"].default_value = roughness
    return material


def rod(start, end, radius: float):
    start, end = Vector(start), Vector(end)
    bpy.ops.mesh.primitive_cylinder_add(
        radius=radius, depth=(end - start).length, location=(start + end) / 2, vertices=16
    )
    ob = bpy.context.object
    ob.rotation_euler = (end - start).to_track_quat("Z", "Y").to_euler()
    return ob


def drum(bottom: float, top: float, radius: float, bevel: float = 0.03):
    bpy.ops.mesh.primitive_cylinder_add(
        radius=radius, depth=top - bottom, location=(0, 0, (top + bottom) / 2), vertices=256
    )
    ob = bpy.context.object
    edges = ob.modifiers.new("Bevel", "BEVEL")
    edges.width, edges.segments, edges.limit_method = bevel, 3, "ANGLE"
    return ob


def discus_buoy():
    """A weather buoy with a hull of 3 m, its waterline at 0: disc, tripod, sensors, lamp."""
    yellow = paint("Yellow", (0.72, 0.38, 0.01))
    red = paint("Bottom", (0.25, 0.02, 0.015), roughness=0.6)
    steel = paint("Steel", (0.45, 0.46, 0.48), metallic=0.9, roughness=0.35)
    white = paint("White", (0.75, 0.75, 0.72))
    dark = paint("Panel", (0.01, 0.012, 0.02), roughness=0.15)
    parts = []

    def part(ob, material):
        ob.data.materials.append(material)
        parts.append(ob)

    part(drum(-0.55, 0.12, 1.42, 0.12), red)
    part(drum(0.12, 0.55, 1.5, 0.06), yellow)
    part(drum(0.55, 0.62, 0.55), yellow)
    part(drum(0.62, 1.05, 0.42), white)
    for turn in range(4):
        angle = math.radians(45 + 90 * turn)
        foot = (1.15 * math.cos(angle), 1.15 * math.sin(angle), 0.55)
        head = (0.22 * math.cos(angle), 0.22 * math.sin(angle), 2.75)
        part(rod(foot, head, 0.035), steel)
    for height, radius in ((1.35, 0.83), (2.1, 0.5)):
        corners = [
            (
                radius * math.cos(math.radians(45 + 90 * t)),
                radius * math.sin(math.radians(45 + 90 * t)),
                height,
            )
            for t in range(4)
        ]
        for first, second in zip(corners, corners[1:] + corners[:1], strict=True):
            part(rod(first, second, 0.022), steel)
    for turn in range(4):
        angle = math.radians(90 * turn)
        bpy.ops.mesh.primitive_cube_add(
            size=1.0, location=(0.62 * math.cos(angle), 0.62 * math.sin(angle), 1.7)
        )
        panel = bpy.context.object
        panel.scale = (0.03, 0.62, 0.5)
        panel.rotation_euler = (0.0, -0.22, angle)
        part(panel, dark)
    part(drum(2.75, 2.81, 0.42, 0.02), white)
    part(rod((0, 0, 2.8), (0, 0, 3.9), 0.03), steel)
    part(rod((-0.35, 0, 3.55), (0.35, 0, 3.55), 0.02), steel)
    for x in (-0.35, 0.35):
        part(rod((x, 0, 3.45), (x, 0, 3.75), 0.06), dark)
    part(rod((0.22, 0.15, 2.8), (0.22, 0.15, 3.15), 0.09), white)
    part(rod((-0.2, -0.15, 2.8), (-0.2, -0.15, 3.05), 0.08), yellow)
    bpy.ops.object.select_all(action="DESELECT")
    for ob in parts:
        ob.select_set(True)
    bpy.context.view_layer.objects.active = parts[0]
    bpy.ops.object.convert(target="MESH")
    bpy.ops.object.join()
    buoy = bpy.context.object
    buoy.name = "Buoy"
    bpy.ops.object.transform_apply(location=True, rotation=True, scale=True)
    return buoy


def afloat(ob, ocean, place, heading: float, *, length: float = 3.0, width: float = 3.0) -> None:
    ob.location = (*place, 0.0)
    ob.rotation_euler.z = math.radians(heading)
    bpy.ops.object.select_all(action="DESELECT")
    ob.select_set(True)
    bpy.ops.libocean.add_float(ocean=ocean.name)
    ob.libocean_float.length, ob.libocean_float.width = length, width


# The scenes -------------------------------------------------------------------


def ocean_of(sea_file: Path, water_type: str = "jerlov_ib"):
    """Rings to the horizon, of this sea."""
    enable_addon()
    bpy.ops.libocean.add(kind="HORIZON", preset="beaufort_0", water_type=water_type)
    ocean = bpy.context.object
    ocean.libocean.horizon_vertices = 1500000
    bpy.ops.libocean.load_sea(filepath=str(sea_file))
    ocean.libocean.use_detail = True
    return ocean


def open_sea(scene) -> None:
    """Beaufort 7 by day: whitecaps to the horizon, a weather buoy 17 m away."""
    sky(scene, elevation=32.0, azimuth=120.0, strength=0.16, dust=0.6)
    camera(scene, (0.0, 0.0, 4.4), (30.0, 5.0, 2.3), 30.0)
    ocean = ocean_of(HERE / "open_sea.toml")
    afloat(discus_buoy(), ocean, (17.0, 0.5), 25.0)
    scene.frame_set(73)


def dusk(scene) -> None:
    """What buoy 41010 measured on 8 June 2020, with the sun on the horizon."""
    sky(scene, elevation=2.2, azimuth=25.0, strength=0.25, dust=0.5)
    camera(scene, (0.0, 0.0, 2.2), (30.0, 8.0, 1.9), 45.0)
    ocean = ocean_of(HERE.parent / "buoy_41010.toml")
    afloat(discus_buoy(), ocean, (24.0, 3.0), -20.0)
    scene.frame_set(40)


def storm(scene) -> None:
    """Beaufort 9 from a trough, against a low sun: drops and mist off the crests."""
    sky(scene, elevation=11.0, azimuth=52.0, strength=0.13, dust=2.0)
    camera(scene, (776.0, 214.0, 4.5), (876.0, 224.0, 4.0), 40.0)
    sea = HERE.parent / "povray" / "storm.toml"
    ocean = ocean_of(sea, "jerlov_iii")
    ocean.libocean.use_spray = True
    ocean.libocean.spray_lifetime = 0.8
    ocean.libocean.spray_density = 0.6
    ocean.libocean.spray_size = 40.0
    scene.render.use_motion_blur = True
    box = ("--box", "770,100,-8,1070,400,crest", "--velocity-voxel", "0.75")
    baked = bake(sea, "--products", "density", "--spray-density", "2", "--mist", "0.12", *box)
    volumes.mist(baked, 1.0)
    scene.cycles.volume_max_steps = 256
    scene.cycles.volume_bounces = 1


def volume(scene) -> None:
    """The water of a box as a baked level set, cut open: its velocity dies out with the depth."""
    volumes.studio(scene)
    camera(scene, (3.0, -42.0, 13.0), (23.6, 4.0, -2.2), 35.0)
    baked = bake(HERE / "volume.toml", "--box", "0,0,-7,48,22,crest", "--voxel", "0.1")
    volumes.water_block(baked, volumes.cut_water())
    places, velocities = volumes.velocity_on_a_cut(baked, 0.75)
    volumes.arrows(places, velocities, 1.15, volumes.speed_paint())


def below(scene) -> None:
    """Beaufort 5 from 5 m below, at a weather buoy: the sun's light in shafts, the sky in Snell's
    window, foam against it."""
    enable_addon()
    sun = {"sun_elevation": math.radians(60.0), "sun_bearing": math.radians(25.0)}
    bpy.ops.libocean.add_scene(preset="beaufort_5", water_type="jerlov_ib", **sun)
    ocean = bpy.context.object
    bpy.ops.libocean.add_material(
        water_type="jerlov_ib", underwater=True, god_rays=True, focus_depth=12.0
    )
    ocean.libocean.patch_size = 150.0  # finer maps: shafts as narrow as 0.15 m
    ocean.libocean.use_detail = True
    camera(scene, (0.0, 0.0, -5.0), (-5.0, 1.3, -0.5), 20.0)
    afloat(discus_buoy(), ocean, (-4.2, 1.6), 25.0)
    scene.render.resolution_x, scene.render.resolution_y = 960, 540
    # What few rays find by themselves is left to those that are sent there.
    scene.cycles.sample_clamp_indirect = 1.0
    scene.frame_set(73)


def slab(stations, bottom: float, top: float, material):
    """A body between two heights over a plan: stations (x, half breadth) from stern to bow."""
    plan = [*stations, *((x, -half) for x, half in reversed(stations[1:-1]))]
    corners = [(x, y, z) for z in (bottom, top) for x, y in plan]
    n = len(plan)
    sides = [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
    mesh = bpy.data.meshes.new(material.name)
    mesh.from_pydata(corners, [], [*sides, range(n - 1, -1, -1), range(n, 2 * n)])
    mesh.materials.append(material)
    ob = bpy.data.objects.new(material.name, mesh)
    bpy.context.scene.collection.objects.link(ob)
    return ob


def ferry_boat(place: tuple[float, float], heading: float) -> None:
    """A ferry of 30 x 6 x 1.8 m, whose water line is two parabolas. heading: degrees."""
    blue = paint("Side", (0.02, 0.05, 0.14), roughness=0.6)
    white = paint("House", (0.75, 0.75, 0.72))
    glass = paint("Glass", (0.01, 0.012, 0.02), roughness=0.1)
    red = paint("Funnel", (0.5, 0.05, 0.02))
    plan = [(0.75 * i, 3.05 * (1.0 - (i / 20.0) ** 2)) for i in range(-20, 21)]
    parts = [slab(plan, -1.8, 1.7, blue), slab([(x, 1.03 * y) for x, y in plan], 1.7, 2.0, white)]

    def house(stern: float, bow: float, half: float, bottom: float, top: float) -> None:
        for wider, low, high, material in (
            (0.0, bottom, top, white),
            (0.03, top - 1.5, top - 0.7, glass),
        ):
            ends = stern - wider, bow + wider
            box = [(ends[0], 0.0), *((x, half + wider) for x in ends), (ends[1], 0.0)]
            parts.append(slab(box, low, high, material))

    house(-10.0, 6.0, 2.2, 2.0, 4.6)
    house(-7.0, 4.5, 1.8, 4.6, 6.8)
    house(-0.5, 4.0, 1.5, 6.8, 8.8)
    funnel, mast = (
        rod((-4.0, 0.0, 6.8), (-4.4, 0.0, 9.6), 0.75),
        rod((1.5, 0, 8.8), (1.5, 0, 13), 0.07),
    )
    funnel.data.materials.append(red)
    mast.data.materials.append(white)
    whole = bpy.data.objects.new("Ferry", None)
    bpy.context.scene.collection.objects.link(whole)
    for part in (*parts, funnel, mast):
        part.parent = whole
    whole.location = (*place, 0.0)
    whole.rotation_euler.z = math.radians(heading)


QUARTER = (74.0, 66.0, 9.0), (126.0, 6.0, 1.5), 32.5


def ferry(scene, view=QUARTER) -> None:
    """A ferry in a turn on the sea of Beaufort 4, from 9 m over its port quarter: the picture of
    POV-Ray. The list by which it is judged:
    hull      at the point of the wedge, in the water
    wake      Kelvin's wedge astern, no square, no second one
    horizon   a line"""
    sky(scene, elevation=32.0, azimuth=-15.0, strength=0.16, dust=0.6)
    camera(scene, *view)
    ocean_of(HERE.parent / "hulls" / "ferry.toml", "jerlov_ib")
    ferry_boat((129.6, 5.8), -43.8)
    scene.frame_set(1)


def ferry_above(scene) -> None:
    """The same ferry from above, as POV-Ray and the preview show it."""
    ferry(scene, ((-60.0, -110.0, 150.0), (50.0, 25.0, 0.0), 27.7))


def hero(scene, *, has_crest: bool = True) -> None:
    """A storm with the crest of 7.2 m that its file asks for, before a buoy of 4 m: the picture of
    POV-Ray and the preview, and the list by which they are judged."""
    sky(scene, elevation=22.0, azimuth=75.0, strength=0.16, dust=0.8)
    camera(scene, (338.0, 258.0, 3.2), (400.0, 300.0, 4.4), 38.6)  # 50 degrees
    ocean = ocean_of(HERE.parent / "crests" / "hero.toml", "jerlov_ii")
    if not has_crest:
        bpy.ops.libocean.remove_crest()
    afloat(discus_buoy(), ocean, (396.0, 304.0), 30.0)
    settings = ocean.libocean
    settings.use_custom_time, settings.custom_time = True, 20.0
    scene.render.resolution_x, scene.render.resolution_y = 1440, 600


def hero_before(scene) -> None:
    """The same storm without the crest."""
    hero(scene, has_crest=False)


FLIGHT = 72  # frames
BEACH = HERE.parent / "coast" / "beach.toml"


def coast_of(
    region: tuple[float, ...], cell: float, sea: Path = BEACH, water_type: str = "jerlov_1c"
):
    """The water and the land of a rectangle of a sea's bed, and the open sea around it."""
    enable_addon()
    look = {"use_far_water": True, "water_type": water_type}
    bpy.ops.libocean.add_coast(filepath=str(sea), cell=50.0, **look)
    water = bpy.context.object
    settings = water.libocean_coast
    settings.region, settings.use_region = region, True
    settings.cell, settings.use_wetness = cell, True
    return water


def coast_dusk(scene) -> None:
    """A beach at dusk, from a man's height, against the sun. The list by which it is judged:
    horizon   a line at the height of the eye, without a step where the map ends
    surf      two or more lines of white water that break towards the beach
    wet sand  darker than the dry, mirrors the bright sky, ends in lobes where waves ended
    land      the headland a silhouette
    edges     water meets sand in a closed line, without gaps"""
    sky(scene, elevation=3.0, azimuth=40.0, strength=0.25, dust=2.0)
    water = coast_of((850.0, 560.0, 1530.0, 1530.0), 1.0)
    scene.frame_set(1)
    land = water.libocean_coast.land
    eye = Vector((905.0, 640.0, 0.0))
    eye.z = max(v.co.z for v in land.data.vertices if (v.co.xy - eye.xy).length < 1.5) + 1.8
    camera(scene, eye, eye + Vector((0.7, 0.7, -0.1)), 28.0)


def coast_bay(scene) -> None:
    """The bay from above, in the afternoon. The list by which it is judged:
    waves   the swell bends into the bay
    surf    white where it is shallow: lines along the beach, at the feet of the headland
    sand    a belt between water and grass, dark where it is wet
    edges   the water ends at the land in a closed line; no step where the map ends"""
    sky(scene, elevation=28.0, azimuth=100.0, strength=0.16, dust=0.8)
    coast_of((400.0, 140.0, 1530.0, 1300.0), 2.0)
    scene.frame_set(1)
    camera(scene, (1420.0, 1150.0, 600.0), (960.0, 700.0, 0.0), 45.0)


def first_scene(operator: str):
    """Returns the scene that one entry of the menu makes, as it is, for 16:9."""

    def make(scene) -> None:
        enable_addon()
        getattr(bpy.ops.libocean, operator)()
        scene.render.resolution_x, scene.render.resolution_y = 1600, 900

    return make


def fly_terrain(scene) -> None:
    """Two metres a frame over the land of *Terrain Scene*, the way that its camera looks."""
    first_scene("add_terrain_scene")(scene)
    eye = scene.camera
    way = eye.matrix_world.to_quaternion() @ Vector((0.0, 0.0, -1.0))
    start, per_frame = eye.location.copy(), 2.0 * Vector((way.x, way.y, 0.0)).normalized()
    for frame in range(1, FLIGHT + 1):
        eye.location = start + (frame - 1) * per_frame
        eye.keyframe_insert("location", frame=frame)


def bake(sea: Path, *arguments: str) -> Path:
    """Volumes of a sea's first frame, by the command in OCEAN."""
    folder = Path(tempfile.mkdtemp(prefix="libocean-"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    output = folder / f"{sea.stem}.vdb"
    command = [os.environ.get("OCEAN", "ocean"), "-q", "bake", str(sea), "-o", str(output)]
    subprocess.run([*command, *arguments], check=True)
    return output


SCENES = {
    "open_sea": open_sea,
    "dusk": dusk,
    "storm": storm,
    "volume": volume,
    "below": below,
    "ferry": ferry,
    "ferry_above": ferry_above,
    "hero": hero,
    "hero_before": hero_before,
    "coast_dusk": coast_dusk,
    "coast_bay": coast_bay,
    "first_ocean": first_scene("add_scene"),
    "first_coast": first_scene("add_coast_scene"),
    "first_terrain": first_scene("add_terrain_scene"),
    "fly_terrain": fly_terrain,
}


def engine_named(name: str) -> str:
    """Returns the identifier in this Blender of CYCLES or EEVEE."""
    if name != "EEVEE":
        return name
    return "BLENDER_EEVEE_NEXT" if (4, 2) <= bpy.app.version < (5, 0) else "BLENDER_EEVEE"


def main() -> None:
    name, picture, *more = sys.argv[sys.argv.index("--") + 1 :]
    samples, percent, engine, *every = (*more, *("128", "100", "CYCLES")[len(more) :])
    samples, percent = int(samples), int(percent)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = engine_named(engine)
    scene.cycles.samples = samples
    scene.eevee.taa_render_samples = max(1, samples // 12)  # a minute each without a GPU
    scene.cycles.use_denoising = can_denoise()
    if engine == "CYCLES" and not can_denoise():
        print(
            f"warning: this Blender has no denoiser, {samples} samples leave noise", file=sys.stderr
        )
    scene.render.resolution_x, scene.render.resolution_y = 1600, 800
    scene.render.resolution_percentage = percent
    SCENES[name](scene)
    scene.render.image_settings.file_format = "PNG" if picture.endswith(".png") else "JPEG"
    scene.render.image_settings.quality = 92
    scene.render.filepath = str(Path(picture).resolve())
    if every:
        scene.frame_start, scene.frame_end, scene.frame_step = 1, *map(int, every)
        bpy.ops.render.render(animation=True)
    else:
        bpy.ops.render.render(write_still=True)


if __name__ == "__main__":
    main()
