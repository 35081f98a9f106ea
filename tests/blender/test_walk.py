# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A slider's walk: how often an object is handed on between the property and the mesh.

A place is a call of one of the add-on's functions that is given the object, or what it was
looked up as. sys.setprofile counts them from the property's update to its end.
"""

import sys
from pathlib import Path

import bpy
import libocean_addon
import pytest
from conftest import add_horizon, add_ocean, camera
from libocean_addon.shared import hooks
from libocean_addon.shared.subject import Shown

ROOT = Path(libocean_addon.__file__).parent
MOST_PLACES = 20
SEA = {"foam_lifetime": 1.0}


def walk(ob, name: str, value) -> list[str]:
    """Sets a property; returns the places that the object passes, in order."""
    places = []

    def is_it(given) -> bool:
        given = given.ob if isinstance(given, Shown) else given
        return isinstance(given, bpy.types.Object) and given == ob

    def note(frame, event, _argument) -> None:
        code = frame.f_code
        path = Path(code.co_filename)
        if event != "call" or ROOT not in path.parents or ROOT / "bundled" in path.parents:
            return
        names = code.co_varnames[: code.co_argcount + code.co_kwonlyargcount]
        if any(is_it(frame.f_locals.get(name)) for name in names):
            places.append(f"{path.stem}.{code.co_name}")

    sys.setprofile(note)
    try:
        setattr(ob.libocean, name, value)
    finally:
        sys.setprofile(None)
    return places


@pytest.mark.parametrize("kind", ["PATCH", "HORIZON"])
@pytest.mark.parametrize("name, value", [("choppiness", 0.5), ("patch_size", 90.0)])
def test_it_is_short(scene, kind, name, value):
    camera(scene, width=6.0)
    few = {"kind": "PATCH"} if kind == "PATCH" else {"vertices": 5000}
    ob = (add_ocean if kind == "PATCH" else add_horizon)(64, sea=SEA, preset="beaufort_6", **few)
    ob.libocean.use_detail = True
    before = [vertex.co.x for vertex in ob.data.vertices[:1]]
    places = walk(ob, name, value)
    assert len(places) <= MOST_PLACES, places
    assert places[-1] == "meshes.follow"  # it ends at the mesh
    if name == "patch_size":
        assert before != [vertex.co.x for vertex in ob.data.vertices[:1]]


def test_the_modifiers_are_looked_up_once_for_a_change(scene):
    ob = add_ocean(64, sea=SEA, kind="PATCH", preset="beaufort_6")
    places = walk(ob, "choppiness", 0.5)
    assert places.count("subject.look_up") == 1
    # Spray looks for all oceans of the file.
    assert places.count("modifier_groups.modifiers") == 2


def test_without_the_add_on_nothing_is_called(monkeypatch):
    """Hooks that are missing do not pass in silence; disconnected ones do nothing."""
    with pytest.raises(TypeError, match="followers"):
        hooks.Hooks(
            property_changed=lambda _: None,
            make_draft_job=lambda _: None,
            finish_draft_job=lambda *_: None,
        )
    ob = add_ocean(64, sea=SEA, kind="PATCH", preset="beaufort_6")
    monkeypatch.setattr(hooks, "_connected", hooks._NONE)
    assert walk(ob, "choppiness", 0.25) == ["hooks.<lambda>"]
