# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The material against optics: tiny renders of flat water whose light is known in closed form."""

import math

import bpy
import numpy as np
import pytest
from conftest import (
    add_ocean,
    camera,
    failing,
    light,
    picture_settings,
    pixels_of,
    plane,
    positions,
    shine,
    taken,
)
from libocean_addon.look import material
from libocean_addon.shared import compat

IOR = 1.333
EEVEE = "BLENDER_EEVEE_NEXT" if (4, 2) <= bpy.app.version < (5, 0) else "BLENDER_EEVEE"


def fresnel(degrees: float, ior: float = IOR) -> float:
    """Returns the reflectance of unpolarised light on a smooth dielectric. ior: that of the far
    side over that of the near side."""
    cosine = math.cos(math.radians(degrees))
    inside = 1 - (1 - cosine**2) / ior**2
    if inside <= 0:
        return 1.0
    inside = math.sqrt(inside)
    parallel = (ior * cosine - inside) / (ior * cosine + inside)
    crossed = (cosine - ior * inside) / (cosine + ior * inside)
    return (parallel**2 + crossed**2) / 2


@pytest.fixture(autouse=True)
def studio(scene):
    """A parallel view of 8 pixels a side."""
    camera(scene, width=1.0)
    picture_settings(scene, 8, 64)
    scene.world = bpy.data.worlds.new("World")
    compat.use_nodes(scene.world)
    light_all_round(scene, (1.0, 1.0, 1.0))


def light_all_round(scene, above, below=None) -> None:
    """The same light from everywhere, or one from above and another from below."""
    tree = scene.world.node_tree
    tree.nodes.clear()
    background = tree.nodes.new("ShaderNodeBackground")
    background.inputs["Color"].default_value = (*above, 1.0)
    shown = background.outputs[0]
    if below is not None:
        place = tree.nodes.new("ShaderNodeTexCoord")
        parts = tree.nodes.new("ShaderNodeSeparateXYZ")
        up = tree.nodes.new("ShaderNodeMath")
        up.operation = "GREATER_THAN"
        up.inputs[1].default_value = 0.0
        other = tree.nodes.new("ShaderNodeBackground")
        other.inputs["Color"].default_value = (*below, 1.0)
        mix = tree.nodes.new("ShaderNodeMixShader")
        tree.links.new(place.outputs["Generated"], parts.inputs[0])
        tree.links.new(parts.outputs["Z"], up.inputs[0])
        tree.links.new(up.outputs[0], mix.inputs[0])
        tree.links.new(other.outputs[0], mix.inputs[1])
        tree.links.new(background.outputs[0], mix.inputs[2])
        shown = mix.outputs[0]
    tree.links.new(shown, tree.nodes.new("ShaderNodeOutputWorld").inputs["Surface"])


def look(scene, degrees: float, *, below: bool = False) -> None:
    """At the origin, so many degrees from the vertical, from the side of -y."""
    angle = math.radians(180.0 - degrees if below else degrees)
    scene.camera.rotation_euler = (angle, 0.0, 0.0)
    scene.camera.location = (0.0, -50.0 * math.sin(angle), 50.0 * math.cos(angle))


def picture(scene, tmp_path) -> np.ndarray:
    """(height, width, 3), linear."""
    scene.render.filepath = str(tmp_path / "picture.exr")
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(scene.render.filepath)
    pixels = pixels_of(image)
    bpy.data.images.remove(image)
    return pixels[..., :3]


def seen(scene, tmp_path) -> np.ndarray:
    return picture(scene, tmp_path).mean(axis=(0, 1))


def water(ob, water_type: str = material.DEFAULT_TYPE, **inputs):
    """Gives an object a material; inputs: by their names with _ for a space."""
    underwater = inputs.pop("underwater", False)
    made = material.make(water_type, underwater=underwater)
    ob.data.materials.clear()
    ob.data.materials.append(made)
    node = next(n for n in made.node_tree.nodes if n.type == "GROUP")
    for name, value in inputs.items():
        node.inputs[name.replace("_", " ")].default_value = value
    return made


def put(ob, name: str, values) -> None:
    """An attribute on every point: a number, or a vector."""
    vector = np.ndim(values) > 0
    kind = "FLOAT_VECTOR" if vector else "FLOAT"
    found = ob.data.attributes.get(name) or ob.data.attributes.new(name, kind, "POINT")
    flat = np.tile(np.atleast_1d(np.asarray(values, np.float32)), len(ob.data.vertices))
    found.data.foreach_set("vector" if vector else "value", flat)


BLACK = (0.0, 0.0, 0.0, 1.0)


@pytest.mark.parametrize("degrees", [0.0, 60.0, 80.0])
def test_reflection_is_fresnels(scene, tmp_path, degrees):
    water(plane(200.0, 2), Water_Colour=BLACK)
    look(scene, degrees)
    assert seen(scene, tmp_path) == pytest.approx(fresnel(degrees), rel=0.02)


def test_the_body_shines_through_what_the_surface_lets_pass(scene, tmp_path):
    water(plane(200.0, 2), "jerlov_ii")
    look(scene, 0.0)
    albedo = np.array(material.WATER_TYPES["jerlov_ii"]["albedo"])
    expected = fresnel(0.0) + (1.0 - fresnel(0.0)) * albedo
    assert seen(scene, tmp_path) == pytest.approx(expected, rel=0.02)


def test_the_bed_is_seen_through_shallow_water(scene, tmp_path):
    """A depth of 0 is an attribute that is absent."""
    ob, kind, bed = plane(200.0, 2), material.WATER_TYPES["jerlov_ii"], np.array((0.4, 0.3, 0.2))
    lost = np.add(kind["absorption"], kind["scattering"])
    water(ob, "jerlov_ii", Bed_Colour=(*bed, 1.0), Swash_Line=0.0)
    look(scene, 0.0)
    for depth in (0.0, 0.1, 2.0):
        put(ob, "depth", depth)
        left = np.exp(-2.0 * lost * depth) if depth else 0.0
        albedo = kind["albedo"] + (bed - kind["albedo"]) * left
        expected = fresnel(0.0) + (1.0 - fresnel(0.0)) * albedo
        assert seen(scene, tmp_path) == pytest.approx(expected, rel=0.02)


def test_the_normals_of_the_sea_are_those_of_the_light(scene, tmp_path):
    ob = plane(200.0, 2)
    water(ob, Water_Colour=BLACK)
    tilt = math.radians(20.0)
    put(ob, "ocean_normal", (0.0, -math.sin(tilt), math.cos(tilt)))
    look(scene, 70.0)
    assert seen(scene, tmp_path) == pytest.approx(fresnel(50.0), rel=0.02)


def test_short_waves_take_the_mirror_from_the_far_sea(scene, tmp_path):
    ob = plane(200.0, 2)
    water(ob, Water_Colour=BLACK, Roughness=0.0)
    put(ob, "slope_variance", 0.03)
    look(scene, 80.0)
    deviation, grazing = math.sqrt(0.015), 1.0 - math.cos(math.radians(80.0))
    fit = 0.02 + 0.98 * grazing ** (5.0 * math.exp(-2.69 * deviation)) / (
        1.0 + 22.7 * deviation**1.5
    )
    got = seen(scene, tmp_path)
    # Light thrown down into the next wave is lost.
    assert (got < fit).all() and (got > 0.7 * fit).all()
    assert (got < 0.7 * fresnel(80.0)).all()


THIN, THICK = np.array((0.22, 0.29, 0.31)), np.array((0.80, 0.80, 0.80))


def foam_albedo(cover: float) -> np.ndarray:
    """Returns the mean thickness of white foam: foam_mean_thickness of foam_lace.glsl."""
    thickness = cover / 0.7 if cover < 0.35 else 1.0 - 0.175 / cover
    return THIN + (THICK - THIN) * thickness


FAR = 0.1  # rad: a pixel is then 5 m wide
SEVERAL_TILES = 66.0


def wide_picture(scene, tmp_path) -> np.ndarray:
    scene.camera.data.ortho_scale = SEVERAL_TILES
    scene.render.resolution_x = scene.render.resolution_y = 128
    scene.cycles.samples = 16
    scene.cycles.filter_width = 0.01  # a pixel is a point
    return picture(scene, tmp_path)


def test_detail_bends_the_normal_and_leaves_the_roughness(scene, tmp_path):
    """A slope upwards away from the viewer, which is all that the mesh lacks."""
    ob = plane(200.0, 2)
    slope = math.tan(math.radians(20.0))
    water(ob, Water_Colour=BLACK, Roughness=0.0, Detail=(0.0, slope, 0.03))
    put(ob, "slope_variance", 0.03)
    look(scene, 70.0)
    assert seen(scene, tmp_path) == pytest.approx(fresnel(50.0), rel=0.02)
    water(ob, Water_Colour=BLACK, Roughness=0.0, Detail=(0.0, 0.0, 0.03))
    look(scene, 80.0)
    assert seen(scene, tmp_path) == pytest.approx(fresnel(80.0), rel=0.02)


@pytest.mark.parametrize("cover", [1.0, 0.5, 0.2])
def test_far_foam_has_the_albedo_of_foam(scene, tmp_path, cover):
    ob = plane(200.0, 2)
    water(ob, Water_Colour=BLACK, Bubble_Colour=BLACK, Pixel_Angle=FAR)
    put(ob, "cover", cover)
    look(scene, 0.0)
    want = cover * foam_albedo(cover) + (1.0 - cover) * fresnel(0.0)
    assert picture(scene, tmp_path) == pytest.approx(np.broadcast_to(want, (8, 8, 3)), rel=0.02)


def test_near_foam_is_thin_and_thick_and_as_bright_as_far_foam(scene, tmp_path):
    ob = plane(200.0, 2)
    cover = 0.4
    water(ob, Water_Colour=BLACK, Bubble_Colour=BLACK, Pixel_Angle=0.0)
    put(ob, "cover", cover)
    look(scene, 0.0)
    near = wide_picture(scene, tmp_path)
    assert np.quantile(near, 0.98) > 0.7 and np.quantile(near, 0.02) < 0.03
    want = cover * foam_albedo(cover) + (1.0 - cover) * fresnel(0.0)
    assert near.mean(axis=(0, 1)) == pytest.approx(want, rel=0.02)


def test_bubbles_colour_the_water_where_foam_has_been(scene, tmp_path):
    ob = plane(200.0, 2)
    bubbles = (0.1, 0.2, 0.3)
    water(ob, Water_Colour=BLACK, Bubble_Colour=(*bubbles, 1.0))
    put(ob, "foam", 0.5)
    look(scene, 0.0)
    want = fresnel(0.0) + (1.0 - fresnel(0.0)) * 0.5**3 * np.array(bubbles)
    assert seen(scene, tmp_path) == pytest.approx(want, rel=0.02)


def test_light_through_water_follows_beer_and_lambert(scene, tmp_path):
    length = 2.0
    bpy.ops.mesh.primitive_cube_add(size=length)
    box = bpy.context.object
    lamp = plane(50.0, 2, "Light")
    lamp.location.z = -5.0
    lamp.data.materials.append(light())
    light_all_round(scene, (0.0, 0.0, 0.0))
    look(scene, 0.0)
    scene.cycles.samples = 256

    nothing = (0.0, 0.0, 0.0)
    smooth = {"underwater": True, "Roughness": 0.0, "Scattering": nothing}
    water(box, "jerlov_9c", Absorption=nothing, **smooth)
    clear = seen(scene, tmp_path)
    assert clear == pytest.approx((1.0 - fresnel(0.0)) ** 2, rel=0.02)
    water(box, "jerlov_9c", **smooth)
    absorbed = np.array(material.WATER_TYPES["jerlov_9c"]["absorption"])
    assert seen(scene, tmp_path) / clear == pytest.approx(np.exp(-length * absorbed), rel=0.02)


@pytest.mark.parametrize("degrees", [30.0, 60.0])
def test_from_below_the_sky_is_in_snells_window(scene, tmp_path, degrees):
    made = water(plane(200.0, 2), underwater=True, Roughness=0.0)
    tree = made.node_tree
    for link in [link for link in tree.links if link.to_socket.name == "Volume"]:
        tree.links.remove(link)
    light_all_round(scene, (1.0, 0.0, 0.0), below=(0.0, 1.0, 0.0))
    look(scene, degrees, below=True)
    mirrored = fresnel(degrees, 1.0 / IOR)
    assert (mirrored == 1.0) == (degrees > 48.6)
    assert seen(scene, tmp_path) == pytest.approx([1.0 - mirrored, mirrored, 0.0], abs=0.01)


def test_deep_water_from_below_mirrors_outside_snells_window(scene, tmp_path):
    water(plane(200.0, 2), Water_Colour=BLACK)
    light_all_round(scene, (1.0, 0.0, 0.0), below=(0.0, 1.0, 0.0))
    look(scene, 60.0, below=True)
    assert seen(scene, tmp_path) == pytest.approx([0.0, 1.0, 0.0], abs=0.02)


def test_under_water_a_patch_is_closed_and_water_is_all_round(scene, tmp_path):
    ob = add_ocean(64, preset="beaufort_1")
    bpy.ops.libocean.add_material(water_type="jerlov_ib", underwater=True)
    assert min(positions(ob)[:, 2]) < -99.0
    sun = bpy.data.objects.new("Sun", bpy.data.lights.new("Sun", "SUN"))
    scene.collection.objects.link(sun)
    scene.camera.data.type = "PERSP"
    scene.camera.location = (0.37, 0.21, -5.0)
    scene.camera.rotation_euler = (math.radians(90.0), 0.0, 0.0)
    scene.cycles.samples = 256
    red, green, blue = seen(scene, tmp_path)
    assert 0.0 < red < green < blue < 1.0
    bpy.ops.libocean.add_material(water_type="jerlov_ib")
    assert min(positions(ob)[:, 2]) > -1.0


def test_eevee_shows_as_much_foam(scene, tmp_path):
    """Cells as wide as pixels too: Eevee's own filter would leave a tenth to a half of it."""
    scene.render.engine = EEVEE
    scene.eevee.taa_render_samples = 8
    look(scene, 0.0)
    scene.render.resolution_x = scene.render.resolution_y = 200
    ob = plane(400.0, 2)
    made = water(ob)
    put(ob, "cover", 0.3)
    node = next(n for n in made.node_tree.nodes if n.type == "GROUP")
    shine(ob, made, node.outputs["Foam"])
    for wide in (6.6, 2 * SEVERAL_TILES):
        scene.camera.data.ortho_scale = wide
        node.inputs["Pixel Angle"].default_value = wide / 200 / 50.0
        assert seen(scene, tmp_path) == pytest.approx(0.3, rel=0.05), wide


def test_eevee_shows_foam_on_water(scene, tmp_path):
    scene.render.engine = EEVEE
    scene.eevee.taa_render_samples = 8
    look(scene, 30.0)
    open_water, foam = plane(200.0, 2), plane(200.0, 2)  # side by side in the picture
    open_water.location.x, foam.location.x = -100.0, 100.0
    foam.data.materials.append(water(open_water, Pixel_Angle=FAR))
    put(foam, "cover", 1.0)
    shown = picture(scene, tmp_path)
    dark, bright = (half.mean(axis=(0, 1)) for half in (shown[:, :3], shown[:, 5:]))
    assert (dark > 0.005).all() and (dark < 0.2).all()
    assert bright == pytest.approx(foam_albedo(1.0), rel=0.1)


def foam_inputs(ob) -> dict[str, float]:
    (node,) = material.waters_of(ob)
    names = ("Wind Direction", "Foam Stretch", "Foam Streaks")
    return {name: node.inputs[name].default_value for name in names}


def test_foam_is_that_of_the_sea(scene):
    """Streaks and long cells are of gales."""
    calm = foam_inputs(add_ocean(256, preset="beaufort_3"))
    assert calm["Foam Streaks"] == 0.0 and calm["Foam Stretch"] == 1.5
    ob = add_ocean(256, preset="beaufort_10")
    ob.libocean.waves[0].wind_direction = 30.0
    assert bpy.ops.libocean.add_material() == {"FINISHED"}
    gale = foam_inputs(ob)
    assert gale["Foam Streaks"] == pytest.approx(0.3)
    assert gale["Foam Stretch"] == pytest.approx(2.2)
    assert gale["Wind Direction"] == pytest.approx(30.0, abs=3.0)


@pytest.mark.parametrize("engine", ["CYCLES", EEVEE])
def test_the_angle_of_a_pixel_follows_the_rendered_scene(scene, tmp_path, engine):
    """Camera, lens, sensor and resolution, as they are when the picture is made."""
    eye = camera(scene, (0.0, 0.0, 100.0))
    picture_settings(scene, 16)
    scene.render.engine, scene.eevee.taa_render_samples = engine, 1
    ob = add_ocean(64, preset="beaufort_2")
    made = ob.material_slots[0].material
    (water_node,) = material.waters_of(ob)
    (link,) = water_node.inputs["Pixel Angle"].links
    material.fit(made, ob, scene)
    assert len(water_node.inputs["Pixel Angle"].links) == 1
    bpy.data.objects.remove(ob)
    lens = eye.data
    lens.sensor_width, lens.sensor_height = 36.0, 24.0
    shine(plane(400.0, 2), made, link.from_socket)

    def told(width: int, height: int, **camera) -> float:
        scene.render.resolution_x, scene.render.resolution_y = width, height
        for name, value in camera.items():
            setattr(lens, name, value)
        return taken(scene, tmp_path)[0, 0, 0]

    wide = pytest.approx(36.0 / 36.0 / 16.0, rel=2e-3)  # Eevee has halves of floats
    assert told(16, 8, lens=36.0) == wide
    assert told(16, 8, lens=72.0) == pytest.approx(0.5 / 16.0, rel=2e-3)
    if engine == EEVEE:  # which reads the same drivers, and starts slowly
        return
    assert told(8, 16, lens=36.0) == wide
    assert told(16, 8, lens=72.0, sensor_fit="VERTICAL") == pytest.approx(24.0 / 72.0 / 8.0)
    scene.render.resolution_percentage = 50
    assert told(32, 16, lens=36.0, sensor_fit="AUTO") == wide


def test_a_new_ocean_is_of_water(scene):
    ob = add_ocean(64, preset="beaufort_4")
    assert ob.material_slots[0].material.name == "Ocean Jerlov II"
    assert not add_ocean(64, preset="beaufort_4", use_material=False).material_slots


@pytest.mark.parametrize("name", material.WATER_TYPES)
def test_every_water_is_made_of_the_library_s_numbers(name):
    made = material.make(name, underwater=True)
    node = next(n for n in made.node_tree.nodes if n.type == "GROUP")
    kind = material.WATER_TYPES[name]
    for label in ("Absorption", "Scattering"):
        assert tuple(node.inputs[label].default_value) == pytest.approx(kind[label.lower()])
    assert tuple(node.inputs["Water Colour"].default_value)[:3] == pytest.approx(kind["albedo"])
    assert node.inputs["Transparency"].default_value == 1.0
    assert node.node_tree == material.get_group()


def test_one_click_gives_every_selected_ocean_the_material():
    first = add_ocean(64, preset="beaufort_2", use_material=False)
    second = add_ocean(64, preset="beaufort_2", use_material=False)
    second.libocean.use_foam = False
    old = bpy.data.materials.new("Old")
    second.data.materials.append(old)
    second.data.materials.append(old)
    first.select_set(True)
    assert bpy.ops.libocean.add_material(water_type="jerlov_3c", underwater=True) == {"FINISHED"}
    made = first.material_slots[0].material
    assert made.name == "Ocean Jerlov 3C"
    assert [slot.material for slot in second.material_slots] == [made, old]
    assert second.libocean.use_foam


def test_what_is_no_ocean_takes_no_ocean_material():
    plane(10.0, 3)
    assert not bpy.ops.libocean.add_material.poll()
    assert "No ocean" in failing(bpy.ops.libocean.add_material)


def test_undo_brings_the_old_material_back():
    add_ocean(64, preset="beaufort_2")
    bpy.ops.ed.undo_push(message="before")
    bpy.ops.libocean.add_material(water_type="jerlov_i")
    bpy.ops.ed.undo_push(message="after")
    assert bpy.context.object.material_slots[0].material.name == "Ocean Jerlov I"
    bpy.ops.ed.undo()
    assert bpy.context.object.material_slots[0].material.name == "Ocean Jerlov II"


def test_all_that_can_be_tuned_says_what_it_is():
    group = material.get_group()
    sockets = (
        group.inputs
        if hasattr(group, "inputs")
        else [item for item in group.interface.items_tree if item.in_out == "INPUT"]
    )
    assert len(sockets) == 30
    assert all(socket.description for socket in sockets)
