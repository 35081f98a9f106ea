# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Foam of the material: its formulas, that as much of it is seen as the cover says, near and far,
and that waves take it along."""

import os
import subprocess

import bpy
import numpy as np
import pytest
from conftest import (
    add_horizon,
    add_ocean,
    attribute,
    by_nodes,
    camera,
    evaluated_mesh,
    geometry_group,
    pixels_of,
    plane,
    positions,
    rest,
    save,
    shine,
    taken,
)
from libocean_addon.bundled import libocean
from libocean_addon.look import foam_images, foam_nodes, material
from libocean_addon.shared import compat
from libocean_addon.shared.node_builder import Builder

# The formulas -------------------------------------------------------------------

FORMULAS = {
    "Ocean_Add_Uniform_": foam_nodes.add_uniform,
    "Ocean_Unite_Uniform_": foam_nodes.unite_uniform,
    "Ocean_Foam_Mask_": foam_nodes.foam_mask,
    "Ocean_Foam_Thickness_": foam_nodes.foam_thickness,
    "Ocean_Foam_Mean_Thickness_": lambda t, a, _, c: foam_nodes.foam_mean_thickness(t, a, c),
    "Ocean_Foam_Faded_": lambda t, a, b, c: foam_nodes.foam_faded(t, a, b, c, 0.86),
    "Ocean_Foam_Pixel_Edge_": foam_nodes.foam_pixel_edge,
    "Ocean_Foam_Pixel_Thickness_": lambda t, a, b, c: foam_nodes.foam_pixel_thickness(
        t, a, b, c, 0.86
    ),
    "Ocean_Foam_In_Streaks_": foam_nodes.foam_in_streaks,
    "Ocean_Foam_Bubbles_": foam_nodes.foam_bubbles,
}


@pytest.fixture(scope="module")
def calls(tmp_path_factory):
    """Lines of a formula of foam_lace.glsl: arguments and value, by name."""
    if "OCEAN_POVRAY_SAMPLES" not in os.environ:
        pytest.skip("built without what prints them")
    folder = tmp_path_factory.mktemp("calls")
    subprocess.run([os.environ["OCEAN_POVRAY_SAMPLES"], str(folder)], check=True)
    lines = [line.split(",") for line in (folder / "foam_lace.csv").read_text().split()]
    return {
        name: np.array([line[1:] for line in lines if line[0] == name], float)
        for name in {line[0] for line in lines}
    }


@pytest.mark.parametrize("name", FORMULAS)
def test_the_formulas_are_those_of_foam_lace_glsl(calls, name):
    """To single precision, of which one by the edge makes a multiple."""
    assert calls.keys() == FORMULAS.keys()
    *arguments, expected = calls[name].T
    found = by_nodes(FORMULAS[name], np.stack(arguments, axis=1))
    # An edge or a share in the divisor.
    divisor = arguments[2] if name in ("Ocean_Foam_Mask_", "Ocean_Add_Uniform_") else 0.35
    error = np.abs(found - expected) * np.minimum(divisor, 1.0)
    print(f"\n{name}: {len(expected)} calls, {np.abs(found - expected).max():.2g}")
    assert error.max() < 8 * 2.0**-24


# The textures -------------------------------------------------------------------


@pytest.mark.parametrize("kind", foam_images.SIDES)
def test_the_textures_keep_16_bits_in_a_saved_file(scene, tmp_path, kind):
    texture = libocean.foam_texture(kind, size=foam_images.SIDES[kind])
    name = foam_images.get(kind).name
    assert foam_images.get(kind).name == name, "one for all"
    foam_images.get(kind).use_fake_user = True
    bpy.ops.wm.open_mainfile(filepath=str(save(tmp_path / "foam.blend")))
    image = bpy.data.images[name]
    assert tuple(image.size) == texture.shape
    assert image.colorspace_settings.name == "Non-Color"
    assert np.abs(pixels_of(image)[..., 0] - texture).max() <= 0.5001 / 65535


def test_they_are_small():
    assert sum(foam_images.get(kind).packed_file.size for kind in foam_images.SIDES) < 3_200_000


# Its look -----------------------------------------------------------------------


def foam_of(ob, **inputs):
    made = material.make(material.DEFAULT_TYPE)
    node = next(node for node in made.node_tree.nodes if node.type == "GROUP")
    for name, value in inputs.items():
        node.inputs[name.replace("_", " ")].default_value = value
    shine(ob, made, node.outputs["Foam"])


def variance_of(cover: float, cells: float) -> float:
    """Returns the variance of the foam of an even cover, by docs/foam.md. cells: the side of a
    pixel in the widest cells."""
    edge = min(0.1 + cells, 1.0)
    share = min(cover, 1.0 - cover)
    thin = edge / 3.0 * (2.0 * share / edge) ** 1.5
    square = thin if share < edge / 2.0 else share - edge / 6.0
    far = np.clip((cells - 0.1) / 1.4, 0.0, 1.0)
    return (1.0 - far * far * (3.0 - 2.0 * far)) ** 2 * (square - share * share)


NEAR, FAR = 0.0, 3.0  # pixels as wide as so many of the widest cells


@pytest.mark.parametrize(
    ("streaks", "covers", "cells"),
    [
        *((0.0, (0.02, 0.3), cells) for cells in (NEAR, 0.2, 0.5, 1.0, FAR)),
        (0.3, (0.1, 0.7), NEAR),
        (0.3, (0.7,), FAR),
    ],
)
def test_the_net_is_white_on_the_share_that_is_covered(studio, tmp_path, cells, streaks, covers):
    """At every distance, and it varies by the rule of all hosts; streaks are seen where the net is
    not. Eleven tiles are a period of the net, which is 1.5 times as long as wide; the other
    textures have many of theirs in it."""
    ob = plane(198.0, 2)
    studio.camera.data.ortho_scale = 198.0
    studio.render.resolution_x, studio.render.resolution_y = 690, 460
    if cells >= 0.5:  # little of the net is left, or nothing
        studio.render.resolution_percentage = 20 if cells == FAR else 50
    distance = 1e4  # from which all pixels are as large
    studio.camera.location.z, studio.camera.data.clip_end = distance, 2.0 * distance
    print()
    cover = ob.data.attributes.new("cover", "FLOAT", "POINT")
    for wanted in covers:
        cover.data.foreach_set("value", np.full(len(ob.data.vertices), wanted, np.float32))
        foam_of(ob, Foam_Streaks=streaks, Pixel_Angle=cells * 0.86 / distance)
        found = taken(studio, tmp_path)[..., 0]
        spread, expected = found.std(), np.sqrt(variance_of(wanted, cells))
        print(
            f"cells {cells}, streaks {streaks}, cover {wanted}: {found.mean() / wanted - 1:+.2%},"
            f" deviation {spread:.4f} of {expected:.4f}"
        )
        assert found.mean() == pytest.approx(wanted, rel=0.02)
        if streaks == 0.0:
            assert spread == pytest.approx(expected, rel=0.1, abs=1e-3 * wanted)
        else:
            assert spread > 0.05


def eased(low: float, high: float, at):
    share = np.clip((at - low) / (high - low), 0.0, 1.0)
    return share * share * (3.0 - 2.0 * share)


def add_numbers(ob, name: str, values) -> None:
    layer = ob.data.attributes.new(name, "FLOAT", "POINT")
    layer.data.foreach_set("value", values)
    ob.data.update()


def test_a_line_of_foam_ends_the_water_on_a_beach(studio, tmp_path):
    """Where the attribute depth is a few centimetres, over ground that cusps raise: a line at the
    tip, whose lace opens, and thinner foam behind. The open sea has no depth, and no line."""
    ob = plane(20.0, 2)
    studio.camera.data.ortho_scale = 20.0
    studio.render.resolution_x = studio.render.resolution_y = 128
    foam_of(ob, Pixel_Angle=1.0, Wave_Height=1.0)
    assert taken(studio, tmp_path).max() == 0.0
    add_numbers(ob, "depth", 0.1 + 0.01 * positions(ob)[:, 0])
    add_numbers(ob, "cusp", np.full(len(ob.data.vertices), 0.05))
    line = taken(studio, tmp_path)[64, :, 0]
    at = np.linspace(-0.05, 0.15, 257)[1::2]
    cover = 0.3 + 0.5 * (1.0 - eased(0.012, 0.045, at))
    expected = cover * (1.0 - eased(0.0, 0.15, at)) * eased(0.0, 0.012, at)
    assert np.abs(line - expected).max() < 0.02
    assert line.max() > 0.6 and line[at < 0.0].max() < 0.02


def test_foam_opens_where_the_water_ends(studio, tmp_path):
    """No cover is cut off at the end of the water: over 12 mm of depth it fades."""
    ob = plane(20.0, 2)
    studio.camera.data.ortho_scale = 20.0
    studio.render.resolution_x = studio.render.resolution_y = 64
    foam_of(ob, Pixel_Angle=1.0, Wave_Height=0.0)
    add_numbers(ob, "depth", 0.02 + 0.002 * positions(ob)[:, 0])
    add_numbers(ob, "cover", np.full(len(ob.data.vertices), 0.6))
    shown = taken(studio, tmp_path)[32, :, 0]
    at = np.linspace(0.0, 0.04, 129)[1::2]
    assert np.abs(shown - 0.6 * eased(0.0, 0.012, at)).max() < 0.02


# The waves take it along ----------------------------------------------------------


def labels(ob) -> np.ndarray:
    found = attribute(ob, "label")
    assert (found[:, 2] == 1.0).all()
    return found[:, :2].astype(np.float64)


def assert_at_rest(ob, places: np.ndarray, tolerance: float) -> None:
    """Labels are the places at rest: what is left of the positions is displacement."""
    assert np.abs(labels(ob) - places).max() <= tolerance
    assert np.ptp(positions(ob)[:, :2] - rest(ob)[:, :2]) > 0.5, "no wave moves anything"


@pytest.mark.parametrize("where", [(0.0, 0.0), (1000.5, -300.25)])
@pytest.mark.parametrize("turn", [0.0, 0.6])
def test_labels_are_places_at_rest_in_every_frame(scene, where, turn):
    ob = add_ocean(128, preset="beaufort_6")
    ob.location = (*where, 3.0)
    ob.rotation_euler.z = turn
    places = rest(ob)[:, :2].astype(np.float64)
    cosine, sine = np.cos(turn), np.sin(turn)
    places = places @ np.array([[cosine, sine], [-sine, cosine]]) + where
    bpy.context.view_layer.update()
    for frame in (1, 40):
        scene.frame_set(frame)
        assert_at_rest(ob, places, 2e-4)


def test_labels_go_on_from_patch_to_patch(scene):
    """Where two meet, beyond the period's end."""
    first = add_ocean(64, preset="beaufort_6")
    period = first.libocean.patch_size
    second = add_ocean(64, preset="beaufort_6", location=(period, 0.0, 0.0))
    scene.frame_set(1)
    seam = [
        np.isclose(rest(ob)[:, 0], side * period / 2) for ob, side in ((first, 1), (second, -1))
    ]
    assert seam[0].sum() == seam[1].sum() == 65
    assert np.abs(labels(first)[seam[0]] - labels(second)[seam[1]]).max() < 1e-4


def test_labels_of_a_horizon_lie_in_the_world(scene):
    """Wherever camera and object are: a vertex is its label and the displacement there."""
    eye = camera(scene)
    ob = add_horizon(64, 20000, 2000.0, preset="beaufort_6")
    period = ob.libocean.patch_size
    for at, place in (
        ((0, 0), (0, 0)),
        ((371.3, -12.9), (0, 0)),
        ((40.0, 80.0), (1.7 * period, 9.0)),
    ):
        eye.location = (*at, 5.0)
        ob.location = (*place, 0.0)
        bpy.context.view_layer.update()
        scene.frame_set(20)
        near = attribute(ob, "ocean_ring")[:, 0] + attribute(ob, "ocean_ring")[:, 1] == 0
        found = labels(ob)[near]
        size = 64
        index = found / (period / size)
        assert np.abs(index - np.rint(index)).max() < 2e-3, "vertices lie on samples"
        index = np.rint(index).astype(int) % size
        with libocean.preset("beaufort_6") as sea:
            sea.set("resolution", "64")
            moved = sea.surface(19 / 24, size).displacement[index[:, 1], index[:, 0]]
        world = positions(ob)[near] + np.array(ob.location)
        assert np.abs(world[:, :2] - found - moved[:, :2]).max() < 1e-3
        assert np.abs(moved[:, :2]).max() > 0.5


def test_a_mesh_without_foam_pays_for_no_labels(scene):
    ob = add_ocean(64, preset="beaufort_6", use_material=False)
    ob.libocean.use_foam = False
    assert "ocean_normal" in evaluated_mesh(ob).attributes
    # The one of the mesh itself, made with it, and none of the world, whose z is 1.
    assert not attribute(ob, "label")[:, 2].any()
    ob.data.attributes.remove(ob.data.attributes["label"])
    ob.data.update()
    bpy.context.view_layer.update()
    assert "label" not in evaluated_mesh(ob).attributes


def texture_at(kind: str, u: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Bilinear, by tiles."""
    texture = libocean.foam_texture(kind, size=foam_images.SIDES[kind]).astype(np.float64)
    side = len(texture)
    x, y = u * side - 0.5, v * side - 0.5
    i, j = np.floor(x).astype(int), np.floor(y).astype(int)
    x, y = x - i, y - j
    row, above = (
        texture[k % side, i % side] * (1 - x) + texture[k % side, (i + 1) % side] * x
        for k in (j, j + 1)
    )
    return row * (1 - y) + above * y


def add_uniform(a, b, share):
    z = a + share * b
    low, high = z**2 / (2 * share), 1 - (1 + share - z) ** 2 / (2 * share)
    return np.where(z < share, low, np.where(z > 1, high, z - share / 2))


def mask_at(places: np.ndarray, cover: float, direction: float, streaks: float) -> np.ndarray:
    """Returns the cover that ocean.inc shows at labels near the eye."""
    cosine, sine = np.cos(np.radians(direction)), np.sin(np.radians(direction))
    x, y = places[..., 0], places[..., 1]
    u, v = (x * cosine + y * sine) / 12, (y * cosine - x * sine) / 12
    along = u / 1.5
    larger = texture_at("lace", (3 * along + v) / 11, (3 * v - along) / 11)
    z = np.minimum(larger, 0.08 + texture_at("lace", along, v))
    z = z + np.clip(z - 0.08, 0, 1) * (1 - z)
    z = add_uniform(z, texture_at("bubbles", 12 / 1.3 * u, 12 / 1.3 * v), 0.3)
    z = add_uniform(z, texture_at("streaks", 12 / 97 * u, 12 / 97 * v), streaks)
    return np.clip(0.5 + (cover - z) / 0.1, 0, 1)


def cover_evenly(ob, cover: float) -> None:
    """In the place of what the sea says."""
    group = geometry_group("Even")
    b = Builder(group)
    value = b.number("ADD", cover, 0.0)
    stored = b.store(b.node("NodeGroupInput").outputs[0], "cover", "FLOAT", value)
    b.link(stored, b.node("NodeGroupOutput").inputs[0])
    ob.modifiers.new("Even", "NODES").node_group = group


def test_waves_take_the_net_along(studio, tmp_path):
    """At two times the foam of a choppy sea is that of the label: it is seen where the waves have
    taken it, and nowhere else."""
    ob = add_ocean(128, preset="beaufort_6")
    cover, direction, streaks = 0.4, 30.0, 0.2
    cover_evenly(ob, cover)
    studio.camera.data.ortho_scale = 25.0
    studio.render.resolution_x = studio.render.resolution_y = 128
    told = bpy.data.materials.new("Labels")
    compat.use_nodes(told)
    read = told.node_tree.nodes.new("ShaderNodeAttribute")
    read.attribute_name = "label"
    moved = []
    for frame in (1, 40):
        studio.frame_set(frame)
        foam_of(
            ob,
            Pixel_Angle=0.0,
            Wind_Direction=direction,
            Foam_Streaks=streaks,
            Foam_Stretch=1.5,
        )
        seen = taken(studio, tmp_path)[..., 0]
        shine(ob, told, read.outputs["Vector"])
        places = taken(studio, tmp_path)
        assert (places[..., 2] > 0.5).all()
        expected = mask_at(places.astype(np.float64), cover, direction, streaks)
        # A step of the texture is a fifth of the mask where a label is wrong by a texel.
        print(f"\nframe {frame}: {np.abs(seen - expected).max():.2g}")
        assert np.abs(seen - expected).max() < 0.02
        assert 0.2 < expected.mean() < 0.6 and expected.std() > 0.3
        moved.append(places[..., :2])
    assert np.abs(moved[1] - moved[0]).max() > 0.3, "nothing has moved"
