# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The asset library: what the Asset Browser shows, seas that live where they are put, and nothing
of the user's is lost."""

import subprocess
from pathlib import Path

import bpy
import numpy as np
import other_blender
import pytest
from conftest import camera, failing, in_another_blender, pixels, positions, rest
from libocean_addon.assets import asset_library, assets
from libocean_addon.bundled import libocean
from libocean_addon.look import foam_images
from libocean_addon.sea import live, node_group
from libocean_addon.shared import modifier_groups

PATCH = "Beaufort 4 Patch"
FOREIGN = "# Mine\nVERSION 1\n\n0a0b6c1e-6a3f-4f0e-9d55-000000000001:Boats:Boats\n"


@pytest.fixture(scope="module")
def library(tmp_path_factory) -> Path:
    """As an empty folder becomes one."""
    folder = tmp_path_factory.mktemp("library")
    asset_library.make(folder)
    return folder


@pytest.fixture
def scripted(monkeypatch):
    """Files of no Blender, made at once."""
    made = []

    def written(_folder):
        made.append(f"file {len(made)}".encode())
        return made[-1]

    monkeypatch.setattr(asset_library, "_written", written)
    return made


def fetch(library: Path, name: str, kind: str = "Object", *, link: bool = False, reuse=True):
    """As the Asset Browser brings it into the scene; what came."""
    known = set(bpy.data.objects) | set(bpy.data.worlds)
    directory = f"{library / asset_library.FILE}/{kind}/"
    if link:
        bpy.ops.wm.link("EXEC_DEFAULT", True, directory=directory, filename=name)
    else:
        bpy.ops.wm.append(
            "EXEC_DEFAULT", True, directory=directory, filename=name, do_reuse_local_id=reuse
        )
    bpy.context.view_layer.update()
    (came,) = (set(bpy.data.objects) | set(bpy.data.worlds)) - known
    return came


def made_here(kind: str, preset: str):
    bpy.ops.libocean.add(kind=kind, preset=preset)
    return bpy.context.object


def refused(folder: Path) -> str:
    return failing(bpy.ops.libocean.make_asset_library, directory=str(folder))


def images_of(ob) -> set:
    (modifier,) = node_group.modifiers(ob)
    names = node_group.image_inputs(modifier.node_group)
    images = {modifier_groups.value(modifier, name) for name in names}
    return images - {None}  # a sea without hulls has no images of wakes


# Its content ----------------------------------------------------------------------


def test_the_browser_shows_a_name_a_picture_and_what_it_is(library):
    wanted = {asset.name: asset for asset in assets.table()}
    path = str(library / asset_library.FILE)
    with bpy.data.libraries.load(path, link=True, assets_only=True) as (there, into):
        into.objects, into.worlds = there.objects, there.worlds
    found = {block.name: block for block in [*into.objects, *into.worlds]}
    assert found.keys() == wanted.keys()
    seen = set()
    for name, block in found.items():
        data, asset = block.asset_data, wanted[name]
        assert (data.author, data.description) == (assets.AUTHOR, asset.description)
        assert {tag.name for tag in data.tags} == set(asset.tags)
        assert data.catalog_id == assets.CATALOGS[asset.kind][0]
        if hasattr(data, "license"):
            assert data.license == assets.LICENSE
        assert tuple(block.preview.image_size) == (256, 256)
        shown = np.array(block.preview.image_pixels_float[:]).reshape(256, 256, 4)
        assert np.abs(shown - pixels(asset.thumbnail)).max() < 1.0 / 255.0
        seen.add(shown.tobytes())
    assert len(seen) == len(found), "two have one picture"


def test_the_catalogues_are_named_in_the_file_beside_it(library):
    lines = (library / asset_library.CATALOGS).read_text().splitlines()
    assert "VERSION 1" in lines
    for identifier, path in assets.CATALOGS.values():
        assert any(line.startswith(f"{identifier}:{path}:") for line in lines)


@pytest.mark.only_reads
def test_the_heights_in_the_descriptions_are_the_librarys():
    by_name = {asset.name: asset.description for asset in assets.table()}
    assert "waves of 1.0 m" in by_name[PATCH]
    assert "Storm, waves of 9.0 m" in by_name["Beaufort 10 Horizon"]


@pytest.mark.only_reads
def test_all_pictures_together_are_small():
    sizes = [asset.thumbnail.stat().st_size for asset in assets.table()]
    assert sum(sizes) < 600_000
    assert {path.name for path in assets.THUMBNAILS.iterdir()} == {
        asset.thumbnail.name for asset in assets.table()
    }


def test_the_file_is_small_and_opens_without_making_a_sea(library):
    """Fourteen seas at once would take minutes and gigabytes."""
    path = library / asset_library.FILE
    assert path.stat().st_size < 8_000_000
    bpy.ops.wm.open_mainfile(filepath=str(path))
    assert live.ocean_objects() == []
    assert {len(mesh.vertices) for mesh in bpy.data.meshes} == {4}
    foam = {image for image in bpy.data.images if foam_images.MARK in image}
    assert len(foam) == len(foam_images.SIDES), "one of each kind, for all seas"
    assert all(max(image.size) < 100 for image in set(bpy.data.images) - foam)


# A sea out of it ------------------------------------------------------------------


@pytest.mark.parametrize("reuse", [True, False])
def test_a_sea_lives_where_it_is_put(library, scene, reuse):
    ob = fetch(library, PATCH, reuse=reuse)
    want = made_here("PATCH", "beaufort_4")
    for frame in (1, 30):
        scene.frame_set(frame)
        assert len(rest(ob)) == 513**2
        assert np.abs(positions(ob) - positions(want)).max() <= 1e-6
        assert np.ptp(positions(ob)[:, 2]) > 0.5
    assert ob.libocean.problem == ""
    (material,) = ob.data.materials
    assert "Ocean" in material.name


def test_a_horizon_follows_the_scenes_camera(library, scene):
    camera(scene, (300.0, -40.0, 5.0))
    ob = fetch(library, "Beaufort 6 Horizon")
    want = made_here("HORIZON", "beaufort_6")
    scene.frame_set(10)
    assert np.abs(positions(ob) - positions(want)).max() <= 1e-5
    assert np.abs(positions(ob)[:, :2]).max() >= 30000.0


@pytest.mark.parametrize("reuse", [True, False])
def test_each_of_two_has_a_sea_of_its_own(library, scene, reuse):
    first, second = (fetch(library, PATCH, reuse=reuse) for _ in range(2))
    assert first.name != second.name
    assert not images_of(first) & images_of(second)
    foam = {image for image in bpy.data.images if foam_images.MARK in image and image.users}
    foam = {image for image in foam if image.library is None}
    assert len(foam) == len(foam_images.SIDES)
    scene.frame_set(10)
    before = positions(first)
    assert np.abs(positions(second) - before).max() <= 1e-6
    second.libocean.choppiness = 0.0
    second.libocean.patch_size = 100.0
    scene.frame_set(10)
    assert np.abs(positions(first) - before).max() <= 1e-6
    assert len(rest(first)) == len(rest(second)) == 513**2
    assert np.ptp(rest(first)[:, 0]) == 230.0 and np.ptp(rest(second)[:, 0]) == 100.0


def test_it_is_undone_and_redone(library, scene):
    bpy.ops.ed.undo_push(message="before")
    name = fetch(library, PATCH).name
    bpy.ops.ed.undo()
    assert name not in bpy.data.objects
    bpy.ops.ed.redo()
    bpy.context.scene.frame_set(10)
    ob = bpy.data.objects[name]
    assert len(rest(ob)) == 513**2
    assert np.ptp(positions(ob)[:, 2]) > 0.5


@pytest.mark.parametrize("force, kind", [(4, "PATCH"), (6, "HORIZON")])
def test_a_linked_sea_lives_too_and_again_after_loading(library, scene, tmp_path, force, kind):
    ob = fetch(library, f"Beaufort {force} {kind.capitalize()}", link=True)
    assert ob.library is not None
    scene.frame_set(10)
    want = positions(made_here(kind, f"beaufort_{force}"))
    assert np.abs(positions(ob) - want).max() <= 1e-6
    shot = str(tmp_path / "shot.blend")
    bpy.ops.wm.save_as_mainfile(filepath=shot)
    bpy.ops.wm.open_mainfile(filepath=shot)
    bpy.context.scene.frame_set(10)
    (ob,) = (ob for ob in bpy.data.objects if ob.library is not None)
    assert np.abs(positions(ob) - want).max() <= 1e-6


def test_a_sky_lights_by_its_sun(library, scene):
    world = fetch(library, "Ocean Sky Noon", "World")
    sky = next(node for node in world.node_tree.nodes if node.type == "TEX_SKY")
    assert sky.sun_disc and np.degrees(sky.sun_elevation) == pytest.approx(60.0)


def test_without_the_add_on_it_is_flat_water(library, tmp_path):
    in_another_blender(other_blender.append_flat_water, str(library / asset_library.FILE), PATCH)


# The making -----------------------------------------------------------------------


def everything() -> set:
    groups = [
        getattr(bpy.data, prop.identifier)
        for prop in bpy.data.bl_rna.properties
        if prop.type == "COLLECTION"
    ]
    return {(block.rna_type.identifier, block.name_full) for group in groups for block in group}


def test_the_file_that_is_open_stays_as_it_is(tmp_path):
    ob = made_here("PATCH", "beaufort_4")
    ob.name = PATCH  # as one that was fetched is named
    before = everything()
    assert bpy.ops.libocean.make_asset_library(directory=str(tmp_path)) == {"FINISHED"}
    assert everything() == before
    path = str(tmp_path / asset_library.FILE)
    with bpy.data.libraries.load(path, assets_only=True) as (there, _):
        assert PATCH in there.objects


def test_it_is_added_to_the_preferences_once(scripted, tmp_path):
    libraries = bpy.context.preferences.filepaths.asset_libraries
    before = len(libraries)
    for _ in range(2):
        bpy.ops.libocean.make_asset_library(directory=str(tmp_path / "new" / "folder"))
        assert len(libraries) == before + 1
    assert libraries[-1].name == "libocean"
    assert Path(libraries[-1].path).samefile(tmp_path / "new" / "folder")
    assert getattr(libraries[-1], "import_method", "APPEND") == "APPEND"
    assert bpy.context.preferences.is_dirty


def test_without_a_folder_it_goes_to_the_users_data(scripted):
    bpy.ops.libocean.make_asset_library()
    folder = asset_library.default_folder()
    assert (folder / asset_library.FILE).read_bytes() == scripted[-1]
    assert bpy.utils.user_resource("DATAFILES") in str(folder)


def test_what_was_made_here_is_made_anew(scripted, tmp_path):
    for _ in range(2):
        asset_library.make(tmp_path)
    assert (tmp_path / asset_library.FILE).read_bytes() == scripted[1]
    assert {path.name for path in tmp_path.iterdir()} == {
        asset_library.FILE,
        asset_library.DIGEST,
        asset_library.CATALOGS,
    }


@pytest.mark.parametrize("was_ours", [False, True])
def test_a_file_of_the_users_is_refused(scripted, tmp_path, was_ours):
    if was_ours:
        asset_library.make(tmp_path)
    (tmp_path / asset_library.FILE).write_bytes(b"mine")
    before = {path: path.read_bytes() for path in tmp_path.iterdir()}
    assert "was not made here, or has been changed" in failing(
        bpy.ops.libocean.make_asset_library, directory=str(tmp_path)
    )
    assert {path: path.read_bytes() for path in tmp_path.iterdir()} == before


@pytest.mark.parametrize("end", ["\n", "", "\r\n"])
def test_catalogues_of_the_users_stay(scripted, tmp_path, end):
    text = FOREIGN.rstrip("\n") + end
    path = tmp_path / asset_library.CATALOGS
    path.write_bytes(text.encode())
    for _ in range(2):
        asset_library.make(tmp_path)
    after = path.read_bytes().decode()
    assert after.startswith(text)
    assert all(after.count(identifier) == 1 for identifier, _ in assets.CATALOGS.values())


def test_a_catalogue_that_was_renamed_stays_so(scripted, tmp_path):
    identifier, _ = assets.CATALOGS["SKY"]
    path = tmp_path / asset_library.CATALOGS
    path.write_text(f"{FOREIGN}{identifier}:My Skies:My Skies\n")
    asset_library.make(tmp_path)
    assert path.read_text().count(identifier) == 1 and "My Skies" in path.read_text()


@pytest.mark.parametrize("text", [b"VERSION 2\n", b"\xff\xfe", b"# nothing\n"])
def test_catalogues_that_nobody_understands_are_refused(scripted, tmp_path, text):
    (tmp_path / asset_library.CATALOGS).write_bytes(text)
    assert "no file of asset catalogues" in failing(
        bpy.ops.libocean.make_asset_library, directory=str(tmp_path)
    )
    assert [path.name for path in tmp_path.iterdir()] == [asset_library.CATALOGS]
    assert not scripted


def test_a_folder_that_cannot_be_made_is_named(scripted, tmp_path):
    (tmp_path / "file").write_text("")
    assert f"Error: {tmp_path / 'file'}: File exists" in failing(
        bpy.ops.libocean.make_asset_library, directory=str(tmp_path / "file")
    )
    assert not scripted


def test_a_blender_that_fails_says_why(monkeypatch, tmp_path):
    failed = subprocess.CompletedProcess([], 1, "many\nwords\nError: no space\n")
    monkeypatch.setattr(asset_library.subprocess, "run", lambda *_, **__: failed)
    assert "could not write the seas: Error: no space" in failing(
        bpy.ops.libocean.make_asset_library, directory=str(tmp_path)
    )
    assert list(tmp_path.iterdir()) == []
    assert not bpy.context.preferences.filepaths.asset_libraries.keys().count("libocean")


def test_what_goes_wrong_in_the_hidden_blender_is_said(tmp_path):
    with pytest.raises(asset_library.LibraryError, match="could not write the seas: .*none"):
        asset_library._written(tmp_path / "none")


def test_presets_of_the_library_are_the_wind_scales():
    assert {f"beaufort_{force}" for force in assets.WINDS} <= set(libocean.presets())
    assert set(assets.PATCHES) <= assets.WINDS.keys()
