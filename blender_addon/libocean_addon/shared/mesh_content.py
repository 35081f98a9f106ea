# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The content of a mesh that the add-on makes, apart from Blender's data: to know it again, to pack
it into few bytes, to show it with few vertices.

    mesh, as mark_of() knows it -> Content.of -> packed, few -> Content.unpacked -> fill -> mesh
"""

from __future__ import annotations

import dataclasses
import json
import lzma
import zlib

import numpy as np

from . import compat

_SIDE = 45
"""The vertices along each side of a mesh with few of them, at most."""
_PRESET = 0  # of lzma: higher ones save 5 % and take four times as long
_VECTORS = {1: ("FLOAT", "value"), 3: ("FLOAT_VECTOR", "vector")}
"""Types and keys of attributes of vertices by their components. Layers of two are UV maps."""
_GEOMETRY = {"position", "sharp_face"}  # attributes of all meshes in later Blenders
_FACES = "libocean_faces"  # custom property: _sum_of the faces as written, which take long to read


def read(elements, name: str, kind, width: int = 1) -> np.ndarray:
    """Returns a property of all elements, (n, width)."""
    out = np.empty(width * len(elements), kind)
    elements.foreach_get(name, out)
    return out.reshape(-1, width)


def _sum_of(arrays) -> str:
    sum_ = 0
    for array in arrays:
        sum_ = zlib.crc32(np.ascontiguousarray(array).data, sum_)
    return f"{sum_:08x}"


def write_geometry(mesh, places: np.ndarray, corners: np.ndarray, counts: np.ndarray) -> None:
    """Replaces all of a mesh by smooth faces. places: of the vertices, (n, 3); corners: the vertex
    of each corner, face by face; counts: the number of corners of each face."""
    mesh.clear_geometry()
    mesh.vertices.add(len(places))
    mesh.vertices.foreach_set("co", np.ascontiguousarray(places, dtype=np.float32).ravel())
    mesh.loops.add(len(corners))
    mesh.loops.foreach_set("vertex_index", corners)
    mesh.polygons.add(len(counts))
    mesh.polygons.foreach_set("loop_start", np.cumsum(counts, dtype=np.int32) - counts)
    if not compat.LOOP_TOTAL_FOLLOWS:
        mesh.polygons.foreach_set("loop_total", counts)
    mesh.update(calc_edges=True)
    compat.shade_smooth(mesh)
    mesh[_FACES] = _sum_of([corners, counts])


def _layers(mesh) -> dict[str, np.ndarray] | None:
    """Returns the layers of a mesh by name, of two components those of UV maps, at each corner;
    None if it has layers of other kinds. Names of Blender's own layers begin with a point."""
    found = {uv.name: read(uv.data, "uv", np.float32, 2) for uv in mesh.uv_layers}
    for layer in mesh.attributes:
        if layer.name in found or layer.name in _GEOMETRY or layer.name[0] == ".":
            continue
        width = next((w for w, (kind, _) in _VECTORS.items() if kind == layer.data_type), None)
        if width is None or layer.domain != "POINT":
            return None
        found[layer.name] = read(layer.data, _VECTORS[width][1], np.float32, width)
    return found


def mark_of(mesh) -> str:
    """Returns a text that tells vertices and layers of a mesh, and the faces written last, from
    others; "" for a mesh that has more than a Content holds."""
    layers = _layers(mesh)
    if layers is None or mesh.shape_keys is not None or mesh.has_custom_normals:
        return ""
    arrays = [read(mesh.vertices, "co", np.float32, 3), *(layers[name] for name in sorted(layers))]
    return " ".join([mesh.get(_FACES, ""), _sum_of(arrays), *sorted(layers)])


def _coded(plane: np.ndarray) -> bytes:
    """Returns numbers as lzma packs them well: the differences of neighbours, their highest bytes
    first."""
    steps = np.diff(plane.view(np.uint32), prepend=np.uint32(0))
    return steps.view(np.uint8).reshape(-1, 4).T.tobytes()


def _decoded(packed: bytes, kind) -> np.ndarray:
    steps = np.frombuffer(packed, np.uint8).reshape(4, -1).T.copy().view(np.uint32)
    return np.cumsum(steps.ravel(), dtype=np.uint32).view(kind)


@dataclasses.dataclass(frozen=True)
class Content:
    """Smooth faces with layers."""

    places: np.ndarray
    """The vertices, (n, 3), float32 [m]."""
    corners: np.ndarray
    """The vertex of each corner, face by face, int32."""
    counts: np.ndarray
    """The number of corners of each face, int32."""
    layers: dict[str, np.ndarray]
    """Values of each vertex, (n, 1 .. 3), float32, by name: of two components, those of a UV map,
    which has them at each corner."""

    @staticmethod
    def of(mesh) -> Content | None:
        """Returns the content of a mesh whose faces are as they were written; None for others."""
        layers, polygons = _layers(mesh), mesh.polygons
        corners = read(mesh.loops, "vertex_index", np.int32).ravel()
        counts = read(polygons, "loop_total", np.int32).ravel()
        is_plain = (
            layers is not None
            and mesh.get(_FACES) == _sum_of([corners, counts])
            and not read(polygons, "material_index", np.int32).any()
            and read(polygons, "use_smooth", bool).all()
        )
        if not is_plain:
            return None
        for name, values in layers.items():
            if values.shape[1] == 2:
                layers[name] = np.zeros((len(mesh.vertices), 2), np.float32)
                layers[name][corners] = values
                if not np.array_equal(layers[name][corners], values):
                    return None
        return Content(read(mesh.vertices, "co", np.float32, 3), corners, counts, layers)

    def fill(self, mesh) -> None:
        """Makes this the content of a mesh."""
        write_geometry(mesh, self.places, self.corners, self.counts)
        for name, values in self.layers.items():
            width = values.shape[1]
            if width == 2:
                layer = mesh.uv_layers.new(name=name, do_init=False)
                layer.data.foreach_set("uv", values[self.corners].ravel())
            else:
                kind, key = _VECTORS[width]
                layer = mesh.attributes.new(name, kind, "POINT")
                layer.data.foreach_set(key, values.ravel())

    def _arrays(self) -> list[np.ndarray]:
        flat = [self.corners[:, None], self.counts[:, None]]
        return [self.places, *flat, *(self.layers[name] for name in sorted(self.layers))]

    def packed(self) -> bytes:
        """Returns the content in few bytes, for unpacked()."""
        planes: dict[bytes, int] = {}  # components, of which some are equal
        columns = [
            [planes.setdefault(_coded(np.ascontiguousarray(part)), len(planes)) for part in array.T]
            for array in self._arrays()
        ]
        head = json.dumps([sorted(self.layers), columns, [len(plane) for plane in planes]])
        return lzma.compress(b"\0".join([head.encode(), b"".join(planes)]), preset=_PRESET)

    @staticmethod
    def unpacked(packed: bytes) -> Content:
        head, _, body = lzma.decompress(packed).partition(b"\0")
        names, columns, sizes = json.loads(head)
        ends = np.cumsum(sizes)
        planes = [body[end - size : end] for end, size in zip(ends, sizes, strict=True)]
        kinds = [np.float32, np.int32, np.int32, *[np.float32] * len(names)]
        places, corners, counts, *layers = [
            np.stack([_decoded(planes[index], kind) for index in array], axis=1)
            for array, kind in zip(columns, kinds, strict=True)
        ]
        layers = dict(zip(names, layers, strict=True))
        return Content(places, corners.ravel(), counts.ravel(), layers)

    def few(self) -> Content:
        """Returns a content that looks alike from above: of the vertices in each cell of a grid
        the one in its middle, and a triangle where three of them meet."""
        level = self.places[:, :2]
        low, high = level.min(axis=0), level.max(axis=0)
        at = (level - low) / np.maximum(high - low, 1e-6) * (_SIDE - 1)
        cell = np.rint(at)
        cluster = (cell[:, 1] * _SIDE + cell[:, 0]).astype(int)
        order = np.argsort(np.abs(at - cell).max(axis=1), kind="stable")
        kept, first = np.unique(cluster[order], return_index=True)
        chosen = order[first]
        number = np.empty(_SIDE * _SIDE, np.int32)
        number[kept] = np.arange(len(kept))
        start = np.cumsum(self.counts) - self.counts
        fans = [
            np.stack([start, start + k, start + k + 1], axis=1)[self.counts > k + 1]
            for k in range(1, self.counts.max(initial=0) - 1)
        ]
        triangles = number[cluster[self.corners[np.concatenate(fans)]]]
        triangles = triangles[(triangles != np.roll(triangles, 1, axis=1)).all(axis=1)]
        counts = np.full(len(triangles), 3, np.int32)
        layers = {name: values[chosen] for name, values in self.layers.items()}
        return Content(self.places[chosen], triangles.ravel(), counts, layers)

    @property
    def is_large(self) -> bool:
        """Returns whether few() has much less."""
        return len(self.places) > 4 * _SIDE * _SIDE and len(self.counts) > 0
