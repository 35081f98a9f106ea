# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""The forms that ocean.inc gives the sea, and what it tells of a place, in POV-Ray itself.

The truth is libocean's own arrays and `ocean query`; POV-Ray is asked by pictures of an
orthographic camera whose pixel centres are samples, by rays, and by the macros.
"""

import io
import re

import numpy
import pytest
from conftest import PERIOD, Folder, N, ocean, sea_text, surface

import libocean


@pytest.fixture(scope="session")
def upright(tmp_path_factory):
    """Folders of each format without choppiness, where every form shows the heights of the map, and
    of a smoother sea."""
    smooth = "shortest_wavelength = 7.0"
    return {
        name: Folder(
            tmp_path_factory.mktemp(name),
            sea_text(choppiness=0.0, wind=10.0, more=smooth if name == "smooth" else ""),
            *("--format", "height_field" if name == "smooth" else name),
        )
        for name in ("df3", "mesh2", "height_field", "smooth")
    }


MESH = "Ocean_Mesh()"
FIELD = "Ocean_Height_Field()"
ISOSURFACE = f"Ocean_Isosurface(<0, -4, 0>, <{PERIOD}, 4, {PERIOD}>)"
LOW, HIGH = -4.0, 4.0
QUANTUM = (HIGH - LOW) / 65535.0
GREY = "finish { ambient 0 diffuse 0 emission 1 }"
HEIGHT = (
    f"texture {{ pigment {{ gradient y color_map {{ [0 rgb 0] [1 rgb 1] }} "
    f"scale {HIGH - LOW} translate {LOW}*y }} {GREY} }}"
)


def seen_from_above(folder, form, texture):
    """[j, i] as the map: pixel centres are samples. Row and column 0 lie on the border."""
    middle = PERIOD / 2 - PERIOD / N / 2
    pixels = folder.seen(
        f"""background {{ rgb <1, 0, 1> }}
camera {{ orthographic location <{middle}, 50, {middle}> direction -y
         right {PERIOD}*x up {PERIOD}*z }}
object {{ {form} {texture} }}""",
        width=N,
        height=N,
    )
    assert numpy.all(pixels[1:, 1:, 0] == pixels[1:, 1:, 1]), "a ray missed the sea"
    return pixels[..., 0]


@pytest.mark.parametrize(
    ("form", "macro", "own"),
    [
        # Vertices are single precision, triangles at up to 141 m: 2^-17 m.
        ("df3", MESH, 2.0**-17),
        # As text, to 2^-16 m.
        ("mesh2", MESH, 2.0**-17 + 2.0**-18),
        # Half the quantum that its file states, of heights of 6 m or less.
        ("height_field", FIELD, 0.5 * 8.0 / 65536 * 1.0001),
        ("df3", ISOSURFACE, 4e-3),  # its accuracy
    ],
)
def test_a_picture_shows_the_heights(upright, form, macro, own):
    folder = upright[form]
    if form == "height_field":
        text = (folder.path / "sea_0001.png.txt").read_text()
        stated = 0.5 * float(re.search(r"quantum = (\S+)", text).group(1))
        assert stated <= own
        own = stated
    truth = surface(folder).height
    error = seen_from_above(folder, macro, HEIGHT) * (HIGH - LOW) + LOW - truth
    assert numpy.abs(error[1:, 1:]).max() <= 0.5 * QUANTUM + own + 2e-6
    if macro != ISOSURFACE:
        assert abs(error[1:, 1:].mean()) < 0.2 * (QUANTUM + own)
        assert numpy.abs(error[1:, 1:]).max() <= 1.1e-4 + 0.5 * (QUANTUM - 6.0 / 65535)


@pytest.mark.parametrize(
    ("form", "macro", "bound"),
    [("df3", MESH, 0.01), ("mesh2", MESH, 0.01), ("smooth", FIELD, 3.0)],
)
def test_a_picture_shows_the_normals(upright, form, macro, bound):
    """Degrees. `slope` gives the angle between the normal and an axis, in units of pi."""
    truth = surface(upright[form]).normal  # x, y, z up
    for axis, component in (("x", 0), ("z", 1)):
        texture = (
            f"texture {{ pigment {{ slope {axis} color_map {{ [0 rgb 0] [1 rgb 1] }} }} {GREY} }}"
        )
        seen = -numpy.cos(numpy.pi * seen_from_above(upright[form], macro, texture))
        seen = numpy.clip(seen, -1, 1)
        angle = numpy.degrees(numpy.arccos(seen) - numpy.arccos(truth[..., component]))
        print(f"\n{axis}: off by {numpy.abs(angle[2:-2, 2:-2]).max():.3f} degrees")
        assert numpy.abs(angle[2:-2, 2:-2]).max() < bound


@pytest.mark.parametrize("form", ["df3", "mesh2"])
def test_every_vertex_of_a_choppy_sea_is_in_its_place(tmp_path, form):
    folder = Folder(tmp_path, sea_text(), "--format", form)
    maps = surface(folder)
    assert maps.jacobian.min() > 0.05, "a folded sea has no single height"
    j, i = numpy.mgrid[1:N, 1:N]
    x = i * PERIOD / N + maps.displacement[1:, 1:, 0]
    z = j * PERIOD / N + maps.displacement[1:, 1:, 1]
    inside = ((x > 0.01) & (x < PERIOD - 0.01) & (z > 0.01) & (z < PERIOD - 0.01)).ravel()
    points = numpy.stack([x.ravel(), z.ravel()], axis=1)[inside]
    (tmp_path / "points.txt").write_text(",\n".join(f"{a:.9f},{b:.9f}" for a, b in points))
    folder.run(
        f"""Ocean_Load("sea_0001")
#declare Sea = Ocean_Mesh()
#fopen In "points.txt" read
#fopen Out "heights.txt" write
#for (K, 1, {len(points)})
    #read (In, X, Z)
    #local Normal = <0, 0, 0>;
    #local Hit = trace(Sea, <X, 50, Z>, -y, Normal);
    #write (Out, str(Hit.y, 0, 9), " ", str(vlength(Normal), 0, 1), "\\n")
#end
#fclose Out"""
    )
    found = numpy.loadtxt(tmp_path / "heights.txt")
    assert numpy.all(found[:, 1] == 1.0), "a ray missed the sea"
    error = found[:, 0] - maps.height[1:, 1:].ravel()[inside]
    assert len(error) > 15000
    assert numpy.abs(error).max() < 1e-4


def query(folder, points, *arguments):
    text = "x,y\n" + "".join(f"{x:.9f},{y:.9f}\n" for x, y in points)
    done = ocean(folder.path, "query sea.toml --time 0 --points -", *arguments, input=text)
    assert done.returncode == 0, done.stderr
    return numpy.genfromtxt(io.StringIO(done.stdout), delimiter=",", names=True)


HEIGHTS = """#declare Places = array[{count}] {{ {places} }}
#for (K, 0, {count} - 1) Tell(Ocean_Height_At(Places[K].u, Places[K].v)) #end"""


def heights_at(folder, points):
    """Returns the heights that Ocean_Height_At finds, and those of `ocean query`."""
    places = ", ".join(f"<{x:.9f}, {z:.9f}>" for x, z in points)
    found = folder.told(HEIGHTS.format(count=len(points), places=places))
    return found, query(folder, points, "--refine", "2")["height"]


def test_height_at_a_place_is_that_of_ocean_query(tmp_path):
    """On a map with four samples or more of the shortest wave."""
    shortest = f"shortest_wavelength = {2 * PERIOD / N}"
    folder = Folder(tmp_path, sea_text(resolution=2 * N, more=shortest))
    points = numpy.random.default_rng(5).uniform(-150, 250, (400, 2))
    places = ", ".join(f"<{x:.9f}, {z:.9f}>" for x, z in points)
    folder.run(
        f"""Ocean_Load("sea_0001")
#declare Places = array[400] {{ {places} }}
#fopen Out "at.txt" write
#for (K, 0, 399)
    #local X = Places[K].u;
    #local Z = Places[K].v;
    #local Normal = Ocean_Normal_At(X, Z);
    #local Label = Ocean_Label_At(X, Z);
    #write (Out, str(Ocean_Height_At(X, Z), 0, 9), " ", str(Normal.x, 0, 9), " ",
            str(Normal.z, 0, 9), " ", str(Ocean_Foam_At(X, Z), 0, 6), " ",
            str(Ocean_Cover_At(X, Z) - Ocean_Cover(Label.x, Label.z), 0, 9), "\\n")
#end
#fclose Out"""
    )
    found = numpy.loadtxt(tmp_path / "at.txt")
    truth = query(folder, points, "--refine", "2")
    assert numpy.abs(found[:, 0] - truth["height"]).max() < 2e-4
    assert numpy.abs(found[:, 1] - truth["normal_x"]).max() < 2e-3
    assert numpy.abs(found[:, 2] - truth["normal_y"]).max() < 2e-3
    assert numpy.abs(found[:, 3] - truth["foam"]).max() < 2e-3
    assert found[:, 3].max() > 0.3
    assert numpy.all(found[:, 4] == 0)


def test_height_at_a_place_is_that_of_ocean_query_on_the_map_of_an_export(tmp_path):
    """As `ocean povray` writes it of a preset, whose shortest waves have two samples."""
    folder = Folder(tmp_path, ocean(tmp_path, "presets beaufort_6").stdout)
    points = numpy.random.default_rng(8).uniform(-900, 1500, (300, 2))
    found, truth = heights_at(folder, points)
    error = found - truth
    print(f"\nat most {1e3 * numpy.abs(error).max():.2f} mm, rms {1e3 * error.std():.2f} mm")
    assert numpy.abs(error).max() < 2e-3


def test_a_map_that_is_fine_enough_has_no_finer_one(tmp_path):
    sea = sea_text(resolution=64, more=f"shortest_wavelength = {4 * PERIOD / 64}")
    fine, coarse = Folder(tmp_path / "a", sea), Folder(tmp_path / "b", sea_text(resolution=64))
    assert not (fine.path / "sea_0001_fine.df3").exists()
    assert (coarse.path / "sea_0001_fine.df3").stat().st_size == 6 + 128 * 128 * 3 * 4
    for folder in (fine, coarse):
        folder.run('Ocean_Load("sea_0001")\n#declare Height = Ocean_Height_At(3, 4);')


@pytest.mark.parametrize("form", ["mesh2", "height_field"])
def test_height_at_a_place_of_other_formats_is_traced(tmp_path, form):
    folder = Folder(tmp_path, sea_text(), "--format", form, "--resolution", "256")
    points = numpy.random.default_rng(6).uniform(-150, 250, (100, 2))
    found, truth = heights_at(folder, points)
    assert numpy.abs(found - truth).max() < 2e-2  # triangles of 0.4 m


def test_a_thing_floats_on_the_plane_that_fits_best(choppy):
    """Against the library's own float_pose: position and axes."""
    told = choppy.told(
        """#declare Corner = array[4] { <0, 0, 0>, x, y, z }
#macro Probe(P)
    #local Box = Ocean_Float(sphere { P, 0.001 }, 31, 47, 35, 6, 3)
    #local At = (min_extent(Box) + max_extent(Box))/2;
    Tell(At.x) Tell(At.y) Tell(At.z)
#end
#for (K, 0, 3) Probe(Corner[K]) #end"""
    )
    origin, bow, up, side = told.reshape(4, 3)
    sea = libocean.open(choppy.path / "sea.toml")
    pose = sea.float_pose([(31.0, 47.0, 35.0, 6.0, 3.0)], 0.0)
    swap = [0, 2, 1]
    assert numpy.abs(origin - numpy.asarray(pose.position)[0][swap]).max() < 0.05
    assert numpy.abs(bow - origin - numpy.asarray(pose.forward)[0][swap]).max() < 0.03
    assert numpy.abs(up - origin - numpy.asarray(pose.up)[0][swap]).max() < 0.03
    assert abs(numpy.dot(bow - origin, side - origin)) < 1e-4


def test_the_macros_make_the_faces_where_no_file_has_them(tmp_path):
    """As for maps beyond 1024 samples."""
    folder = Folder(tmp_path, sea_text(resolution=32))
    scene = """#declare Sea = Ocean_Mesh()
#declare Random = seed(2);
#for (K, 1, 500)
    #local Normal = <0, 0, 0>;
    #local Hit = trace(Sea, <5 + 90*rand(Random), 50, 5 + 90*rand(Random)>, -y, Normal);
    Tell(Hit.y)
#end"""
    with_file = folder.told(scene)
    (tmp_path / "faces.inc").unlink()
    assert numpy.array_equal(folder.told(scene), with_file)
    assert numpy.std(with_file) > 0.05


def test_functions_at_labels_are_the_maps(choppy):
    maps = surface(choppy)
    told = choppy.told(
        f"""#for (K, 0, 99)
    #local X = mod(K*37, {N})*{PERIOD / N} + {PERIOD}*(mod(K, 3) - 1);
    #local Z = mod(K*53, {N})*{PERIOD / N};
    #local Normal = Ocean_Normal(X, Z);
    Tell(Ocean_Height(X, Z)) Tell(Ocean_DX(X, Z)) Tell(Ocean_DZ(X, Z)) Tell(Ocean_Foam(X, Z))
    Tell(Ocean_Cover(X, Z))
    Tell(Normal.x) Tell(Normal.y) Tell(Normal.z)
#end"""
    )
    i, j = numpy.arange(100) * 37 % N, numpy.arange(100) * 53 % N
    offset, normal = maps.displacement[j, i], maps.normal[j, i][:, [0, 2, 1]]
    scalars = [maps.height, offset[:, 0], offset[:, 1], maps.foam, maps.cover]
    scalars = [values[j, i] if values.ndim == 2 else values for values in scalars]
    truth = numpy.column_stack([*scalars, normal])
    assert numpy.abs(told.reshape(100, 8) - truth).max() < 1e-5
