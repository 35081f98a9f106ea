# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The cost of a played frame per vertex, against Blender's own Ocean modifier in one process."""

import statistics
import time

import bpy
import pytest
from conftest import add_ocean, evaluated_mesh
from libocean_addon.sea import live, open_sea
from libocean_addon.shared import changes, images
from test_hull_cut import trough

FRAMES = range(2, 26)
LIMIT = 0.35 if bpy.app.version < (4, 2) else 0.20
LIBRARY_SHARE = 0.25


def built_in(side: int):
    """Blender's modifier with foam and about side x side vertices, its time driven: to set it from
    a script would build its spectrum again for each frame."""
    bpy.ops.mesh.primitive_plane_add()
    ob = bpy.context.object
    modifier = ob.modifiers.new("Ocean", "OCEAN")
    modifier.resolution = round(side**0.5)
    modifier.viewport_resolution = modifier.resolution
    modifier.use_foam = True
    modifier.foam_layer_name = "foam"
    modifier.driver_add("time").driver.expression = "frame / 24"
    return ob


def ours(side: int):
    bpy.ops.libocean.add(kind="PATCH")
    bpy.context.object.libocean.resolution = bpy.context.object.libocean.mesh_resolution = side
    return bpy.context.object


def frame_seconds(scene, ob) -> tuple[float, int]:
    """The median time of a frame, the evaluated mesh included, and its vertices."""
    times = []
    for frame in FRAMES:
        start = time.perf_counter()
        scene.frame_set(frame)
        vertices = len(evaluated_mesh(ob).vertices)
        times.append(time.perf_counter() - start)
    return statistics.median(times), vertices


def library_seconds(ob, side: int) -> float:
    """The library's part of such a frame, into buffers like the add-on's."""
    sea = open_sea.sea_of(ob.name_full).handle
    buffers = [(images.aligned((side, side)), channels) for channels in open_sea.CHANNELS.values()]
    times = []
    for frame in FRAMES:
        start = time.perf_counter()
        sea.fill((frame + 100) / 24, buffers)
        times.append(time.perf_counter() - start)
    return statistics.median(times[1:])  # the first fetches foam up to its time


@pytest.mark.parametrize("side, use_detail", [(512, False), (512, True), (1024, False)])
def test_a_played_frame_costs_less_than_blenders_own(scene, side, use_detail, record_property):
    theirs = built_in(side)
    their_seconds, their_vertices = frame_seconds(scene, theirs)
    bpy.data.objects.remove(theirs)
    ob = ours(side)
    ob.libocean.use_detail = use_detail
    seconds, vertices = frame_seconds(scene, ob)
    share = library_seconds(ob, side) / seconds
    ratio = seconds / vertices / (their_seconds / their_vertices)
    print(
        f"\n{bpy.app.version_string}, {side}{' with detail' * use_detail}: "
        f"{1e3 * seconds:.1f} ms, {vertices} vertices; "
        f"Blender's {1e3 * their_seconds:.1f} ms, {their_vertices}; "
        f"a vertex {ratio:.3f}, the library's share {share:.2f}"
    )
    assert ratio <= LIMIT
    assert share <= LIBRARY_SHARE


@pytest.mark.parametrize("engine", ["CYCLES", "BLENDER_EEVEE"])
def test_spray_costs_a_few_times_what_the_library_takes_for_it(scene, engine):
    """As points and, where Eevee draws none, as spheres. Until the evaluated object is there, its
    points included; what an engine then does with them is its own."""
    if engine == "BLENDER_EEVEE" and bpy.app.version >= (4, 2):
        pytest.skip("Eevee draws points")
    scene.render.engine = engine
    bpy.ops.libocean.add(kind="PATCH", preset="beaufort_8", use_material=False)
    ob = bpy.context.object
    without, _ = frame_seconds(scene, ob)
    start = time.perf_counter()
    ob.libocean.use_spray = True
    first = time.perf_counter() - start
    scene.frame_set(1)
    seconds, _ = frame_seconds(scene, ob)
    sea, times = open_sea.sea_of(ob.name_full), []
    sea.spray(100 / 24, live.spray_settings(ob.libocean))
    for frame in FRAMES:
        start = time.perf_counter()
        count = len(sea.spray((frame + 100) / 24, live.spray_settings(ob.libocean)).id)
        times.append(time.perf_counter() - start)
    library = statistics.median(times)
    print(
        f"\n{bpy.app.version_string}, {engine}: {count} points, {1e3 * (seconds - without):.1f} ms "
        f"more than {1e3 * without:.1f}, {1e3 * library:.1f} the library's; the first {first:.2f} s"
    )
    assert seconds - without <= 5 * library


def processor_seconds(scene, ob, frames) -> list[float]:
    """The times of the processor that frames take, the evaluated mesh included."""
    taken = []
    for frame in frames:
        start = time.process_time()
        scene.frame_set(frame)
        evaluated_mesh(ob)
        taken.append(time.process_time() - start)
    return taken


WITH_A_BOAT = {"HORIZON": 1.5, "PATCH": 1.6}
"""The cost of a frame with a boat and its wake, in frames of the sea alone. The library's sums of a
wake at the vertices of a patch are two thirds of what a boat adds."""


@pytest.mark.parametrize("kind, repeats", [("HORIZON", 3), ("PATCH", 10)])
def test_a_frame_with_a_boat_and_its_wake_costs_half_as_much_again(scene, kind, repeats):
    """A boat of 12 m at 8 m/s, its wake alone, and the sea alone, in turns in one run. Whitecaps
    have no past: a past would make the sea's own frame longer."""
    scene.frame_end = 241
    ob = add_ocean(512, kind=kind)
    if kind == "PATCH":
        ob.libocean.mesh_resolution = 512
    boat = trough(size=(12.0, 3.0), way=40.0, frames=(1, 241))
    assert bpy.ops.libocean.add_wake(ocean=ob.name) == {"FINISHED"}
    settings, hull = ob.libocean, ob.libocean.hulls[0]
    kept = {name: getattr(hull, name) for name in ("length", "beam", "draught", "outline")}
    kept |= {"track_lines": hull.track_lines, "track_key": hull.track_key}
    taken = {"sea": [], "wake": [], "cut": []}
    for repeat in range(repeats):
        for state, all_times in taken.items():
            with changes.quiet():
                settings.hulls.clear()
                settings.use_hull_cut = state == "cut"
                if state != "sea":
                    hull = settings.hulls.add()
                    hull.source = boat
                    for name, value in kept.items():
                        setattr(hull, name, value)
            changes.tell(settings)
            first = 20 + 8 * repeat
            times = processor_seconds(scene, ob, range(first, first + 6))
            all_times.append(min(times[2:]))  # the first two fill what is kept
    sea, wake, cut = (min(times) for times in taken.values())
    print(
        f"\n{bpy.app.version_string}, {kind.lower()}: {1e3 * sea:.1f} ms of the processor; with a "
        f"wake {wake / sea:.2f} times as much, the boat cut out {cut / sea:.2f} times"
    )
    assert cut <= WITH_A_BOAT[kind] * sea
