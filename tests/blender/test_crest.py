# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Light of the sun through crests: the formula of shaders/wave/crest_light.glsl in tiny renders,
and that the sun is the scene's, whatever moves it."""

import math

import bpy
import numpy as np
import other_blender
import pytest
from conftest import (
    add_horizon,
    add_ocean,
    attribute,
    in_another_blender,
    keyed,
    plane,
    positions,
    presets_with,
    save,
    white,
)
from libocean_addon.look import first_view, material, sunlight, water_shader
from libocean_addon.sea import facts, open_sea
from mathutils import Euler, Matrix, Vector
from test_material import (
    BLACK,
    fresnel,
    light_all_round,
    look,
    put,
    seen,
    studio,  # noqa: F401 (for each test here too)
    water,
)

COLOUR, LIGHT = (0.2, 0.5, 0.4), (90.0, 80.0, 70.0)
VIEW, TILT, SUN = 60.0, 20.0, 15.0  # degrees: from the vertical, of the water, over the horizon
HEIGHT, OF_WAVES = 1.2, 2.0  # m


def crest_light(height: float, jacobian: float, against: float, toward: float) -> float:
    high = min(max(height - 0.1, 0.0), 1.0)
    squeezed = min(max(1.4 - jacobian, 0.0), 1.0)
    away = min(max(0.15 - toward, 0.0), 1.0)
    if against <= 0.0 or away <= 0.0:
        return 0.0
    return high * squeezed * against * against * away**0.7


def expected(jacobian: float, *, azimuth: float = 90.0, tilt: float = TILT) -> np.ndarray:
    """Returns the light that reaches the camera, on the side of -y; the water leans to it."""
    level = math.cos(math.radians(SUN))
    sun = level * np.array([math.cos(math.radians(azimuth)), math.sin(math.radians(azimuth))])
    against = sun[1] * math.sin(math.radians(VIEW))
    toward = -sun[1] * math.sin(math.radians(tilt))
    share = crest_light(HEIGHT / OF_WAVES, jacobian, against, toward)
    return (1.0 - fresnel(VIEW - tilt)) * share * np.array(COLOUR) * np.array(LIGHT)


def crest(jacobian: float | None = 0.6, *, azimuth: float = 90.0, tilt: float = TILT, **inputs):
    """A level mesh HEIGHT over its origin, of a crest's normal, with the sun behind it."""
    ob = plane(200.0, 2)
    ob.data.transform(Matrix.Translation((0.0, 0.0, HEIGHT)))
    a, e = math.radians(azimuth), math.radians(SUN)
    sun = (math.cos(a) * math.cos(e), math.sin(a) * math.cos(e), math.sin(e))
    settings = {
        "Water_Colour": BLACK,
        "Bubble_Colour": BLACK,
        "Roughness": 0.0,
        "Crest_Colour": (*COLOUR, 1.0),
        "Sun_Light": (*LIGHT, 1.0),
        "Sun_Direction": sun,
        "Wave_Height": OF_WAVES,
    }
    water(ob, **{**settings, **inputs})
    lean = math.radians(tilt)
    put(ob, "ocean_normal", (0.0, -math.sin(lean), math.cos(lean)))
    if jacobian is not None:
        put(ob, "jacobian", jacobian)
    light_all_round(bpy.context.scene, (0.0, 0.0, 0.0))
    look(bpy.context.scene, VIEW)
    return ob


@pytest.mark.parametrize("jacobian", [-0.2, 0.6, 1.0, 1.5])
def test_crests_shine_as_crest_light_glsl_says(scene, tmp_path, jacobian):
    crest(jacobian)
    want = expected(jacobian)
    assert (want > 1.0).all() == (jacobian < 1.4)
    assert seen(scene, tmp_path) == pytest.approx(want, rel=0.01, abs=1e-6)


@pytest.mark.parametrize(
    "azimuth, tilt", [(50.0, 20.0), (-50.0, 20.0), (90.0, -5.0), (90.0, -20.0)]
)
def test_the_sun_must_be_behind_a_slope_that_faces_away(scene, tmp_path, azimuth, tilt):
    crest(azimuth=azimuth, tilt=tilt)
    want = expected(0.6, azimuth=azimuth, tilt=tilt)
    assert (want > 0.0).all() == (azimuth > 0.0 and tilt > -9.0)
    assert seen(scene, tmp_path) == pytest.approx(want, rel=0.01, abs=1e-6)


def test_without_a_jacobian_it_is_1(scene, tmp_path):
    crest(None)
    assert seen(scene, tmp_path) == pytest.approx(expected(1.0), rel=0.01)


@pytest.mark.parametrize(
    "turn, scale", [((0.0, 0.0, 0.0), 1.0), ((0.0, 0.0, 0.0), 3.0), ((1.2, 0.4, 2.0), 0.5)]
)
def test_height_is_over_the_object_whichever_way_it_lies(scene, tmp_path, turn, scale):
    """Its mesh is turned back, as the modifier turns the sea back; waves grow with its scale."""
    ob = crest()
    turned = Euler(turn).to_matrix().to_4x4()
    ob.data.transform(turned.inverted())
    lean = math.radians(TILT)
    normal = turned.to_3x3().inverted() @ Vector((0.0, -math.sin(lean), math.cos(lean)))
    ob.data.attributes.remove(ob.data.attributes["ocean_normal"])
    put(ob, "ocean_normal", tuple(normal))
    ob.matrix_world = Matrix.Translation((3.0, 4.0, 5.0)) @ turned @ Matrix.Scale(scale, 4)
    assert seen(scene, tmp_path) == pytest.approx(expected(0.6), rel=0.01)


def test_foam_hides_it_and_clear_water_and_the_other_side_have_none(scene, tmp_path):
    ob = crest()
    put(ob, "cover", 1.0)
    assert (seen(scene, tmp_path) < 1e-6).all()
    ob = crest(Transparency=1.0)
    assert (seen(scene, tmp_path) < 1e-6).all()
    bpy.data.objects.remove(ob)
    crest(Crest_Light=0.0)
    assert (seen(scene, tmp_path) < 1e-6).all()


def test_it_is_not_seen_from_below(scene, tmp_path):
    crest(tilt=0.0)
    look(scene, VIEW)
    assert (seen(scene, tmp_path) > 1.0).all()
    look(scene, 20.0, below=True)
    assert (seen(scene, tmp_path) < 1e-6).all()


def test_no_triangle_of_it_is_a_lamp(scene):
    made = material.make(material.DEFAULT_TYPE)
    if hasattr(made.cycles, "emission_sampling"):
        assert made.cycles.emission_sampling == "NONE"
    else:
        assert not made.cycles.sample_as_light


@pytest.mark.parametrize("kind", ["PATCH", "HORIZON"])
def test_points_carry_the_jacobian(scene, kind):
    """The Jacobian of the displaced surface is less than 1 where waves squeeze it, as on crests,
    and 1 in the mean."""
    few = {"kind": "PATCH"} if kind == "PATCH" else {"vertices": 40000}
    ob = (add_ocean if kind == "PATCH" else add_horizon)(256, preset="beaufort_6", **few)
    scene.frame_set(30)
    jacobian, height = attribute(ob, "jacobian"), positions(ob)[:, 2]
    print(f"\n{kind}: {jacobian.mean():.3f}, on crests {jacobian[height > 1.5].mean():.3f}")
    assert jacobian[height > 1.5].mean() < 0.9 and jacobian[height < -1.0].mean() > 1.05
    if kind == "PATCH":
        side = facts.map_resolution(ob)
        found = np.empty((side, side, 1), np.float32)
        open_sea.sea_of(ob.name_full).handle.fill(29 / 24, [(found, ("jacobian",))])
        mesh = jacobian.reshape(side + 1, side + 1)[:-1, :-1]
        assert np.abs(np.sort(mesh.ravel()) - np.sort(found.ravel())).max() < 1e-6


# The sun of the scene -------------------------------------------------------------


def sun_lamp(scene, *, energy: float = 3.0, turn=(0.3, 0.7, 2.0)):
    lamp = bpy.data.lights.new("Sun", "SUN")
    lamp.energy, lamp.color = energy, (1.0, 0.8, 0.5)
    ob = bpy.data.objects.new("Sun", lamp)
    ob.rotation_euler = turn
    scene.collection.objects.link(ob)
    return ob


def sky_world(scene, *, elevation: float, disc: bool = True, rotation: float = 0.7):
    scene.world = first_view.make_sky(elevation, 0.0)
    sky = next(node for node in scene.world.node_tree.nodes if node.type == "TEX_SKY")
    sky.sun_disc, sky.sun_rotation = disc, rotation
    return sky


def ocean():
    return add_ocean(64, preset="beaufort_2")


def of_water(ob, name: str) -> tuple:
    """A socket of an object's material as it is evaluated."""
    made = ob.material_slots[0].material.evaluated_get(bpy.context.evaluated_depsgraph_get())
    node = next(node for node in made.node_tree.nodes if water_shader.is_water(node))
    return tuple(node.inputs[name].default_value)[:3]


def towards(elevation: float, rotation: float) -> tuple:
    """Radians; the rotation is a sky texture's, clockwise from +y."""
    level = math.cos(elevation)
    return (level * math.sin(rotation), level * math.cos(rotation), math.sin(elevation))


def shown_by_lamp(lamp) -> tuple[tuple, tuple]:
    light = [lamp.data.energy * part / math.pi for part in lamp.data.color]
    return tuple(lamp.matrix_world.to_3x3() @ Vector((0.0, 0.0, 1.0))), tuple(light)


def assert_follows_lamp(ob, lamp) -> None:
    bpy.context.view_layer.update()
    direction, light = shown_by_lamp(lamp)
    assert of_water(ob, "Sun Direction") == pytest.approx(direction, abs=1e-6)
    assert of_water(ob, "Sun Light") == pytest.approx(light, rel=1e-5)


def test_it_is_the_first_lamp_and_follows_it(scene):
    hidden = sun_lamp(scene, turn=(0.0, 0.1, 0.0))
    hidden.hide_render = True
    lamp = sun_lamp(scene)
    sky_world(scene, elevation=30.0)
    ob = ocean()
    assert_follows_lamp(ob, lamp)
    lamp.rotation_euler = (1.0, 0.2, 0.3)
    lamp.data.energy = 5.0
    assert_follows_lamp(ob, lamp)
    keyed(lamp, rotation_euler={1: (1.0, 0.2, 0.3), 11: (1.0, 1.2, 0.3)})
    keyed(lamp.data, energy={1: 2.0, 11: 12.0})
    for frame in (1, 5, 11, 3):
        scene.frame_set(frame)
        assert_follows_lamp(ob, lamp)
    lamp.hide_render = True
    bpy.context.view_layer.update()
    assert of_water(ob, "Sun Light") == (0.0, 0.0, 0.0)


def test_it_is_the_sun_of_the_sky_and_follows_it(scene):
    sky = sky_world(scene, elevation=20.0)
    ob = ocean()
    assert of_water(ob, "Sun Direction") == pytest.approx(
        towards(math.radians(20.0), 0.7), abs=1e-6
    )
    keyed(sky, sun_elevation={1: 0.1, 11: 1.1})
    lights = []
    for frame in (1, 5, 11, 3, 8):  # back and forth: what is a frame late would be seen
        scene.frame_set(frame)
        found = of_water(ob, "Sun Direction")
        assert found == pytest.approx(towards(sky.sun_elevation, 0.7), abs=1e-5)
        lights.append((sky.sun_elevation, of_water(ob, "Sun Light")[0]))
    assert sorted(lights) == sorted(lights, key=lambda pair: pair[1])
    sky.sun_elevation = -0.1
    sky.driver_remove("sun_elevation")
    scene.world.node_tree.animation_data_clear()
    sky.sun_elevation = -0.1
    bpy.context.view_layer.update()
    assert of_water(ob, "Sun Light") == (0.0, 0.0, 0.0)


def test_drivers_need_no_python(scene):
    sky_world(scene, elevation=20.0)
    of_sky = ocean().material_slots[0].material
    sun_lamp(scene)
    of_lamp = ocean().material_slots[0].material
    for made in (of_sky, of_lamp):
        drivers = [curve.driver for curve in made.node_tree.animation_data.drivers]
        assert len(drivers) == 6
        assert all(driver.is_simple_expression and driver.is_valid for driver in drivers)


def white_towards(direction):
    """A plane that sends all light back, and faces that way."""
    ob = plane(10.0, 2)
    ob.data.materials.append(white())
    ob.rotation_euler = Vector(direction).to_track_quat("Z", "Y").to_euler()
    camera = bpy.context.scene.camera
    camera.rotation_euler, camera.location = ob.rotation_euler, 5.0 * Vector(direction)


def test_light_is_what_white_that_faces_the_lamp_sends_back(scene, tmp_path):
    lamp = sun_lamp(scene)
    ob = ocean()
    direction, light = of_water(ob, "Sun Direction"), of_water(ob, "Sun Light")
    bpy.data.objects.remove(ob)
    light_all_round(scene, (0.0, 0.0, 0.0))
    white_towards(direction)
    assert seen(scene, tmp_path) == pytest.approx(light, rel=0.02)
    assert lamp.data.energy == 3.0


@pytest.mark.parametrize("model", sunlight._DISCS)
@pytest.mark.parametrize("elevation", [4.0, 40.0])
def test_light_is_what_white_that_faces_the_skys_sun_sends_back(scene, tmp_path, model, elevation):
    sky = sky_world(scene, elevation=elevation)
    if model not in sky.bl_rna.properties["sky_type"].enum_items:
        pytest.skip("no such sky in this Blender")
    sky.sky_type = model
    sky.sun_intensity, sky.air_density = 0.7, 1.3
    ob = ocean()
    direction, light = of_water(ob, "Sun Direction"), np.array(of_water(ob, "Sun Light"))
    bpy.data.objects.remove(ob)
    white_towards(direction)
    pictures = []
    for disc in (True, False):
        sky.sun_disc = disc
        pictures.append(seen(scene, tmp_path))
    found = pictures[0] - pictures[1]
    print(f"\n{model} {elevation}: {light} of {found}")
    assert np.abs(light - found).max() < 0.07 * found.max()


def test_where_no_sun_shines_there_is_none(scene):
    sky_world(scene, elevation=20.0, disc=False)
    ob = ocean()
    assert of_water(ob, "Sun Direction") == (0.0, 0.0, 0.0)
    lamp = sun_lamp(scene)
    bpy.ops.libocean.add_material()
    assert_follows_lamp(ob, lamp)
    bpy.data.objects.remove(lamp)
    material.fit(ob.material_slots[0].material, ob, scene)
    assert of_water(ob, "Sun Direction") == (0.0, 0.0, 0.0)
    assert not ob.material_slots[0].material.node_tree.animation_data.drivers


def test_a_new_scene_has_its_sun(scene, waiting):
    with presets_with(resolution=64):
        bpy.ops.libocean.add_scene(preset="beaufort_6")
    ob = bpy.context.object
    lamp = next(ob for ob in bpy.context.scene.objects if ob.type == "LIGHT")
    assert_follows_lamp(ob, lamp)
    node = next(
        n for n in ob.material_slots[0].material.node_tree.nodes if water_shader.is_water(n)
    )
    assert 2.0 < node.inputs["Wave Height"].default_value < 5.0


def test_undo_takes_it_back(scene):
    sky_world(scene, elevation=20.0, disc=False)
    ocean()
    lamp = sun_lamp(scene)
    bpy.ops.ed.undo_push(message="before")
    bpy.ops.libocean.add_material()
    bpy.ops.ed.undo_push(message="after")
    assert_follows_lamp(bpy.context.object, lamp)
    bpy.ops.ed.undo()
    assert of_water(bpy.context.object, "Sun Direction") == (0.0, 0.0, 0.0)
    bpy.ops.ed.redo()
    assert_follows_lamp(bpy.context.object, bpy.data.objects["Sun"])


def test_a_file_keeps_it_without_the_addon(scene, tmp_path):
    sun_lamp(scene)
    ocean().name = "Sea"
    in_another_blender(other_blender.follow_lamp, save(tmp_path / "sea.blend"))
