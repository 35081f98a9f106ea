# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Programs for a Blender of their own, which has no add-on at first: functions of this file, whose
arguments are texts. conftest.py starts them.

A generator runs in a real window. It yields the seconds until it goes on, or None for half a
second.
"""

import inspect
import os
import sys
import traceback
from pathlib import Path

import bpy
import numpy as np


def enable_addon() -> None:
    assert bpy.ops.preferences.addon_enable(module="libocean_addon") == {"FINISHED"}


def open_file(path: str, *, addon: bool = False) -> None:
    if addon:
        enable_addon()
    bpy.ops.wm.open_mainfile(filepath=path, use_scripts=addon)
    assert addon == any("libocean" in name for name in sys.modules)
    assert addon == hasattr(bpy.types.Object, "libocean")


def value_of(ob, name: str) -> np.ndarray:
    """Returns the matrix of an object, or what its evaluated mesh has at each vertex."""
    ob = ob.evaluated_get(bpy.context.evaluated_depsgraph_get())
    if name == "matrix":
        return np.array(ob.matrix_world)
    if name == "position":
        found, width, kind = ob.data.vertices, 3, "co"
    else:
        found = ob.data.attributes[name]
        width, kind = {"FLOAT": (1, "value"), "FLOAT_VECTOR": (3, "vector")}[found.data_type]
        found = found.data
    out = np.empty(width * len(found), np.float32)
    found.foreach_get(kind, out)
    return out.reshape(-1, width) if width > 1 else out


def shows(path: str, wanted: str) -> None:
    """wanted: a file of arrays, by the name of an object, that of a value, and a frame."""
    open_file(path)
    for key, values in np.load(wanted).items():
        name, value, frame = key.rsplit(" ", 2)
        bpy.context.scene.frame_set(int(frame))
        found = value_of(bpy.data.objects[name, None], value)
        assert np.array_equal(found, values), key


def render(path: str, pictures: str, addon: str, *frames: str) -> None:
    """Renders frames, or as one of a farm's computers those that no other one has begun."""
    open_file(path, addon=bool(addon))
    scene = bpy.context.scene
    for frame in frames:
        scene.frame_set(int(frame))
        scene.render.filepath = pictures.replace("####", f"{int(frame):04}")
        bpy.ops.render.render(write_still=True)
    if not frames:
        scene.render.filepath = pictures
        scene.render.use_overwrite, scene.render.use_placeholder = False, True
        bpy.ops.render.render(animation=True)


def follow_lamp(path: str) -> None:
    open_file(path)
    ob, lamp = bpy.data.objects["Sea"], bpy.data.objects["Sun"]
    lamp.rotation_euler = (0.0, 1.0, 0.5)
    lamp.data.energy = 7.0
    bpy.context.view_layer.update()
    made = ob.material_slots[0].material.evaluated_get(bpy.context.evaluated_depsgraph_get())
    node = next(node for node in made.node_tree.nodes if node.type == "GROUP")
    towards = np.array(lamp.matrix_world)[:3, 2]
    found = node.inputs["Sun Direction"].default_value
    assert np.abs(found - towards).max() < 1e-6, (list(found), towards)
    assert abs(node.inputs["Sun Light"].default_value[0] - 7.0 / np.pi) < 1e-5


def follow_air(path: str) -> None:
    open_file(path)
    scene = bpy.context.scene
    shown = next(node for node in scene.world.node_tree.nodes if node.type == "BACKGROUND")
    shown.inputs["Color"].default_value = (0.7, 0.6, 0.5, 1.0)
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(scene.render.filepath)
    found = np.array(image.pixels[:]).reshape(-1, 4).mean(axis=0)
    assert np.abs(found[:3] - (0.7, 0.6, 0.5)).max() < 0.01, found


def count_no_points(path: str) -> None:
    open_file(path)
    graph = bpy.context.evaluated_depsgraph_get()
    kinds = [instance.object.type for instance in graph.object_instances]
    assert kinds.count("MESH") == 1, kinds
    clouds = [i.object.data for i in graph.object_instances if i.object.type == "POINTCLOUD"]
    assert sum(len(cloud.points) for cloud in clouds) == 0


def append_flat_water(path: str, name: str) -> None:
    open_file(path)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.wm.append(directory=path + "/Object/", filename=name)
    (ob,) = bpy.data.objects
    bpy.context.scene.frame_set(10)
    places = value_of(ob, "position")
    assert len(places) == 4 and not places[:, 2].any()


def bake_until_killed(path: str) -> None:
    open_file(path, addon=True)
    bpy.context.view_layer.objects.active = bpy.data.objects["Water"]
    from libocean_addon.bake import exr_files

    write = exr_files._write_image

    def dying(package, path, provenance, field, values):
        write(package, path, provenance, field, values)
        if provenance.frame == 2 and field == "velocity":
            os.kill(os.getpid(), 9)

    exr_files._write_image = dying
    bpy.ops.libocean.bake()


class NoNumPy:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] == "numpy":
            raise ModuleNotFoundError("No module named 'numpy'", name="numpy")


def enable_without_numpy() -> None:
    hidden = [name for name in sys.modules if name.partition(".")[0] in ("numpy", "libocean_addon")]
    for name in hidden:
        del sys.modules[name]
    sys.meta_path.insert(0, NoNumPy())
    enable_addon()
    assert bpy.context.preferences.addons["libocean_addon"].preferences is not None
    assert not hasattr(bpy.types.Object, "libocean")
    assert bpy.ops.preferences.addon_disable(module="libocean_addon") == {"FINISHED"}


def install_extension(path: str) -> None:
    assert os.environ["PATH"] == ""
    before = list(sys.path)
    bpy.ops.extensions.package_install_files(
        filepath=os.environ["OCEAN_EXTENSION"],
        repo="user_default",
        enable_on_install=True,
        overwrite=True,
    )
    bpy.ops.libocean.add(kind="PATCH", preset="beaufort_6")
    ob = bpy.context.object
    bpy.context.scene.frame_set(20)
    import libocean

    assert np.ptp(value_of(ob, "position")[:, 2]) > 1.0
    assert "site-packages" in libocean.__file__, libocean.__file__
    assert ob.libocean.problem == ""

    ob.libocean.resolution = 64
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.libocean.bake(frame_start=1, frame_end=1)
    import OpenEXR

    assert "site-packages" in OpenEXR.__file__, OpenEXR.__file__
    assert ob.libocean.use_bake

    from bl_ext.user_default.libocean.shared import compat
    from bl_ext.user_default.libocean.volumes import volumes

    assert volumes.ocean_command is None
    preferences = bpy.context.preferences.addons["bl_ext.user_default.libocean"].preferences
    assert not hasattr(preferences, "ocean_command")
    try:
        told = bpy.ops.libocean.write_volumes(frame_start=1, frame_end=1)
    except RuntimeError as failure:
        told = str(failure)
    if compat.load_openvdb() is None:
        assert bpy.app.version < (4, 5) and "has no OpenVDB module" in told, told
    else:
        assert told == {"FINISHED"}, told
        assert any(other.type == "VOLUME" for other in bpy.data.objects)
    sites = [folder for folder in sys.path if folder not in before]
    assert all(folder.endswith("site-packages") and ".local" in folder for folder in sites), sites

    bpy.ops.libocean.add_scene(preset="beaufort_6", near_detail=False)
    bpy.ops.libocean.add_terrain(preset="tujunga")
    assert bpy.context.object.libocean_terrain.problem == ""


# In a window ----------------------------------------------------------------------


def in_window(operator, *arguments, **settings):
    with bpy.context.temp_override(window=bpy.context.window_manager.windows[0]):
        return operator(*arguments, **settings)


def draw_every_panel(picture: str):
    """Keeps a picture of the editor of properties with all panels open."""
    from libocean_addon.sea import crest_panels, hulls, open_sea, panels
    from libocean_addon.shared import drafts

    for panel in (*panels.CLASSES, *crest_panels.CLASSES, *hulls.CLASSES):
        if issubclass(panel, bpy.types.Panel) and getattr(panel, "bl_options", None):
            bpy.utils.unregister_class(panel)
            panel.bl_options = set()
            bpy.utils.register_class(panel)
    in_window(bpy.ops.libocean.add, kind="PATCH", preset="beaufort_6")
    ob = bpy.context.object
    ob.libocean.resolution = 128
    in_window(bpy.ops.libocean.add_waves)
    ob.libocean.waves[1].wind_direction = 40.0
    assert drafts.progress("Ocean") is not None  # nobody has waited
    yield
    window = bpy.context.window_manager.windows[0]
    area = next(area for area in window.screen.areas if area.type == "PROPERTIES")
    area.spaces.active.context = "MODIFIER"  # known once it has been drawn
    while drafts.progress("Ocean") is not None:
        yield 1.0
    ready = open_sea.sea_of(ob.name_full).ready
    assert ready is not None and ready[1:3] == (128, "cover")
    yield 2.0
    region = next(region for region in area.regions if region.type == "WINDOW")
    with bpy.context.temp_override(window=window, screen=window.screen, area=area, region=region):
        bpy.ops.screen.screenshot_area(filepath=picture)


def small_sea(folder: str):
    """Adds a sea to a new file."""
    from subjects import Sea

    bpy.ops.wm.save_as_mainfile(filepath=os.path.join(folder, "shot.blend"))
    ob = in_window(Sea().add, Path(folder))
    ob.libocean.use_foam, ob.libocean.resolution = False, 32
    return ob, bpy.context.scene


def stop_a_bake_by_escape(folder: str):
    from libocean_addon.bake import bake, bake_state

    ob, scene = small_sea(folder)
    scene.frame_start, scene.frame_end = 1, 2000
    assert in_window(bpy.ops.libocean.bake, "INVOKE_DEFAULT") == {"RUNNING_MODAL"}
    while bake.running.job.done < 3:
        yield 0.05
    assert "of 2002 frames; ESC stops" in bake_state.state(ob, scene)[0][0]
    for value in ("PRESS", "RELEASE"):
        window = bpy.context.window_manager.windows[0]
        window.event_simulate(type="ESC", value=value, x=300, y=300)
        yield 0.05
    while bake.running is not None:
        yield 0.05
    assert not ob.libocean.use_bake
    fields = len({path.name.split(".")[1] for path in Path(folder).rglob("*.exr")})
    assert fields > 1 and 3 * fields <= len(list(Path(folder).rglob("*.exr"))) < 2002 * fields
    scene.frame_end = 2
    assert in_window(bpy.ops.libocean.bake, "INVOKE_DEFAULT") == {"RUNNING_MODAL"}
    while bake.running is not None:
        yield 0.05
    assert ob.libocean.use_bake


def see_renders_cancelled(folder: str):
    """Renders frames of which the second has no file."""
    from conftest import picture_settings
    from libocean_addon.bake import render_check

    _, scene = small_sea(folder)
    picture_settings(scene, 4)
    scene.render.filepath = os.path.join(folder, "out", "####")
    scene.frame_start, scene.frame_end = 1, 3
    bpy.ops.libocean.bake()
    lost = os.path.join(folder, "ocean_bake", "Ocean", "shot.displacement.0002.exr")
    os.remove(lost)
    said, show, camera = [], render_check._show, scene.camera

    def pop_up(texts):
        said.extend(texts)
        show(texts)

    render_check._show = pop_up
    bpy.app.handlers.render_cancel.append(lambda *_: said.append("cancelled"))
    bpy.app.handlers.render_complete.append(lambda *_: said.append("complete"))
    missing = f"Ocean: files of the bake are missing, of the frames 2 ({lost})"
    for frame, animation, wanted in (
        (1, False, ["complete"]),
        (2, False, ["cancelled", missing]),
        (1, True, ["cancelled", missing]),
    ):
        scene.frame_set(frame)
        said.clear()
        in_window(bpy.ops.render.render, "INVOKE_DEFAULT", animation=animation)
        while not {"cancelled", "complete"} & {*said} or scene.camera != camera:
            yield 0.05
        while bpy.app.is_job_running("RENDER"):
            yield 0.05
        assert sorted(said, key=missing.__eq__) == wanted
    assert os.listdir(os.path.join(folder, "out")) == ["0001.exr"]
    leave(0)  # to quit, Blender would wait for the message that is open


def render_while_it_changes(folder: str, kind: str):
    """Renders into window_PICTURE.exr what renders that wait for all show in still_PICTURE.exr:
    each frame of an animation, a frame whose render begins while a draft is shown, and, of a land,
    the last frame of an animation during which it changes."""
    from libocean_addon.shared import drafts
    from subjects import CarvedLand, Coast

    case, last = {"coast": (Coast(), 3), "land": (CarvedLand(), 4)}[kind]
    scene, ended = bpy.context.scene, []
    bpy.app.handlers.render_complete.append(lambda *_: ended.append("complete"))
    bpy.app.handlers.render_cancel.append(lambda *_: ended.append("cancel"))
    bpy.data.objects["Cube"].hide_render = True
    ob = in_window(case.add, Path(folder))
    name = ob.name_full
    case.film(ob, scene)
    scene.render.resolution_percentage = 100
    scene.frame_start, scene.frame_end = 1, last
    assert drafts.is_draft(name)
    yield
    while drafts.is_draft(name):
        yield

    def render(picture, **options):
        ended.clear()
        scene.render.filepath = f"{folder}/window_{picture}"
        begun = in_window(bpy.ops.render.render, "INVOKE_DEFAULT", **options)
        assert begun == {"RUNNING_MODAL"}

    def rests():
        while not ended:
            yield 0.1
        assert ended == ["complete"]
        yield

    def still(picture, frame):
        scene.frame_set(frame)
        drafts.complete()
        scene.render.filepath = f"{folder}/still_{picture}.exr"
        bpy.ops.render.render(write_still=True)

    render("", animation=True)
    yield from rests()
    for frame in range(1, last + 1):
        still(f"{frame:04d}", frame)
    yield
    case.change(ob, 2)
    assert drafts.is_draft(name)
    render("pressed.exr", write_still=True)
    yield from rests()
    still("pressed", scene.frame_current)
    if kind == "land":
        yield
        render("anew_", animation=True)
        yield 0.05
        assert not ended  # the render is at work
        case.change(ob, 3)
        assert drafts.is_draft(name)
        yield from rests()
        still(f"anew_{last:04d}", last)


# The start ------------------------------------------------------------------------


def leave(status: int) -> None:
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(status)


def main() -> None:
    name, *arguments = sys.argv[sys.argv.index("--") + 1 :]
    program = globals()[name]
    if not inspect.isgeneratorfunction(program):
        try:
            program(*arguments)
        except BaseException:
            traceback.print_exc()
            leave(1)
        leave(0)
    bpy.context.preferences.view.show_splash = False
    enable_addon()
    for area in bpy.context.window_manager.windows[0].screen.areas:
        if area.type == "VIEW_3D":  # without a graphics card it takes seconds to draw
            area.type = "INFO"
    steps = program(*arguments)

    def go_on() -> float | None:
        try:
            return next(steps) or 0.5
        except StopIteration:
            bpy.ops.wm.quit_blender()
        except Exception:
            traceback.print_exc()
            leave(1)

    bpy.app.timers.register(go_on, first_interval=1.0)


if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).parent))
    main()
