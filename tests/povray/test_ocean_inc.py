# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""What POV-Ray makes of the folders of `ocean povray` and of the macros of ocean.inc.

The truth is libocean's own arrays and `ocean query`; POV-Ray is asked by pictures of an
orthographic camera whose pixel centres are samples, by rays, and by the macros.
"""

import io
import re
import subprocess

import numpy
import OpenImageIO as oiio
import pytest
from conftest import Folder, ocean, povray, sea_text

import libocean

N, PERIOD = 128, 100.0


@pytest.fixture(scope="session")
def upright(tmp_path_factory):
    """Without choppiness: every form shows the heights of the map."""
    return Folder(tmp_path_factory.mktemp("upright"), sea_text(choppiness=0.0, wind=10.0))


@pytest.fixture(scope="session")
def upright_field(tmp_path_factory):
    path = tmp_path_factory.mktemp("upright_field")
    return Folder(path, sea_text(choppiness=0.0, wind=10.0), "--format", "height_field")


def surface(folder, resolution=N):
    """libocean's arrays of the folder's first frame."""
    sea = libocean.open(folder.path / "sea.toml")
    return sea.surface(0.0, resolution=resolution)


def read_png(path):
    image = oiio.ImageInput.open(str(path))
    pixels = image.read_image("uint16").astype(float)[::-1] / 65535.0  # the bottom row first
    image.close()
    return pixels


# ---- Heights and normals -------------------------------------------------------------------------

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
    folder.run(
        f"""global_settings {{ assumed_gamma 1.0 }}
Ocean_Load("sea_0001")
background {{ rgb <1, 0, 1> }}
camera {{ orthographic location <{middle}, 50, {middle}> direction -y
         right {PERIOD}*x up {PERIOD}*z }}
object {{ {form} {texture} }}""",
        width=N,
        height=N,
    )
    pixels = read_png(folder.path / "out.png")
    assert numpy.all(pixels[1:, 1:, 0] == pixels[1:, 1:, 1]), "a ray missed the sea"
    return pixels[..., 0]


@pytest.mark.parametrize("form", ["mesh", "height_field", "isosurface"])
def test_a_picture_shows_the_heights(upright, upright_field, form):
    if form == "height_field":
        folder, macro = upright_field, "Ocean_Height_Field()"
        text = (folder.path / "sea_0001.png.txt").read_text()
        own = 0.5 * float(re.search(r"quantum = (\S+)", text).group(1))
        assert own <= 0.5 * 8.0 / 65536 * 1.0001  # of heights of 6 m or less
    elif form == "mesh":
        # Vertices are single precision, triangles at up to 141 m: 2^-17 m.
        folder, macro, own = upright, "Ocean_Mesh()", 2.0**-17
    else:
        macro = f"Ocean_Isosurface(<0, -4, 0>, <{PERIOD}, 4, {PERIOD}>)"
        folder, own = upright, 4e-3  # its accuracy
    truth = surface(folder).height
    error = seen_from_above(folder, macro, HEIGHT) * (HIGH - LOW) + LOW - truth
    assert numpy.abs(error[1:, 1:]).max() <= 0.5 * QUANTUM + own + 2e-6
    if form != "isosurface":
        assert numpy.abs(error[1:, 1:]).max() <= 1.1e-4 + 0.5 * (QUANTUM - 6.0 / 65535)


def test_a_picture_shows_the_normals(upright):
    truth = surface(upright).normal  # x, y, z up
    worst = 0.0
    for axis, component in (("x", 0), ("z", 1)):
        texture = (
            f"texture {{ pigment {{ slope {axis} color_map {{ [0 rgb 0] [1 rgb 1] }} }} {GREY} }}"
        )
        seen = -numpy.cos(numpy.pi * seen_from_above(upright, "Ocean_Mesh()", texture))
        angle = numpy.degrees(numpy.arccos(seen) - numpy.arccos(truth[..., component]))
        worst = max(worst, numpy.abs(angle[2:-2, 2:-2]).max())
    assert worst < 0.01


def floats_of(log):
    return numpy.array([float(word) for word in re.findall(r"^V (\S+)$", log, re.MULTILINE)])


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
    done = ocean(
        folder.path, "query", "sea.toml", "--time", 0, "--points", "-", *arguments, input=text
    )
    assert done.returncode == 0, done.stderr
    return numpy.genfromtxt(io.StringIO(done.stdout), delimiter=",", names=True)


def test_height_at_a_place_is_that_of_ocean_query(tmp_path):
    """On a map of twice the grid's samples, which holds four of the shortest wave."""
    folder = Folder(tmp_path, sea_text(resolution=128), "--resolution", "256")
    points = numpy.random.default_rng(5).uniform(-150, 250, (1000, 2))
    places = ", ".join(f"<{x:.9f}, {z:.9f}>" for x, z in points)
    folder.run(
        f"""Ocean_Load("sea_0001")
#declare Places = array[1000] {{ {places} }}
#fopen Out "at.txt" write
#for (K, 0, 999)
    #local X = Places[K].u;
    #local Z = Places[K].v;
    #local Normal = Ocean_Normal_At(X, Z);
    #write (Out, str(Ocean_Height_At(X, Z), 0, 9), " ", str(Normal.x, 0, 9), " ",
            str(Normal.z, 0, 9), " ", str(Ocean_Foam_At(X, Z), 0, 6), "\\n")
#end
#fclose Out"""
    )
    found = numpy.loadtxt(tmp_path / "at.txt")
    truth = query(folder, points, "--refine", "2")
    assert numpy.abs(found[:, 0] - truth["height"]).max() < 2e-4
    assert numpy.abs(found[:, 1] - truth["normal_x"]).max() < 2e-3
    assert numpy.abs(found[:, 2] - truth["normal_y"]).max() < 2e-3


@pytest.mark.parametrize("form", ["mesh2", "height_field"])
def test_height_at_a_place_of_other_formats_is_traced(tmp_path, form):
    folder = Folder(tmp_path, sea_text(), "--format", form, "--resolution", "256")
    points = numpy.random.default_rng(6).uniform(-150, 250, (100, 2))
    places = ", ".join(f"<{x:.9f}, {z:.9f}>" for x, z in points)
    log = folder.run(
        f"""Ocean_Load("sea_0001")
#declare Places = array[100] {{ {places} }}
#for (K, 0, 99)
    #debug concat("V ", str(Ocean_Height_At(Places[K].u, Places[K].v), 0, 9), "\\n")
#end"""
    )
    truth = query(folder, points, "--refine", "2")["height"]
    assert numpy.abs(floats_of(log) - truth).max() < 2e-2  # triangles of 0.4 m


def test_a_thing_floats_on_the_plane_that_fits_best(choppy):
    """Against the library's own float_pose: position and axes."""
    log = choppy.run(
        """Ocean_Load("sea_0001")
#declare Corner = array[4] { <0, 0, 0>, x, y, z }
#macro Probe(P)
    #local Box = Ocean_Float(sphere { P, 0.001 }, 31, 47, 35, 6, 3)
    #local At = (min_extent(Box) + max_extent(Box))/2;
    #debug concat("V ", str(At.x, 0, 6), "\\nV ", str(At.y, 0, 6), "\\nV ", str(At.z, 0, 6), "\\n")
#end
#for (K, 0, 3) Probe(Corner[K]) #end"""
    )
    origin, bow, up, side = floats_of(log).reshape(4, 3)
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
    scene = """Ocean_Load("sea_0001")
#declare Sea = Ocean_Mesh()
#declare Random = seed(2);
#for (K, 1, 500)
    #local Normal = <0, 0, 0>;
    #local Hit = trace(Sea, <5 + 90*rand(Random), 50, 5 + 90*rand(Random)>, -y, Normal);
    #debug concat("V ", str(Hit.y, 0, 9), "\\n")
#end"""
    with_file = floats_of(folder.run(scene))
    (tmp_path / "faces.inc").unlink()
    assert numpy.array_equal(floats_of(folder.run(scene)), with_file)
    assert numpy.std(with_file) > 0.05


def test_functions_at_labels_are_the_maps(choppy):
    maps = surface(choppy)
    log = choppy.run(
        f"""Ocean_Load("sea_0001")
#macro Tell(Value) #debug concat("V ", str(Value, 0, 9), "\\n") #end
#for (K, 0, 99)
    #local X = mod(K*37, {N})*{PERIOD / N} + {PERIOD}*(mod(K, 3) - 1);
    #local Z = mod(K*53, {N})*{PERIOD / N};
    #local Normal = Ocean_Normal(X, Z);
    Tell(Ocean_Height(X, Z)) Tell(Ocean_DX(X, Z)) Tell(Ocean_DZ(X, Z)) Tell(Ocean_Foam(X, Z))
    Tell(Normal.x) Tell(Normal.y) Tell(Normal.z)
#end"""
    )
    i, j = numpy.arange(100) * 37 % N, numpy.arange(100) * 53 % N
    truth = numpy.stack(
        [
            maps.height[j, i],
            maps.displacement[j, i, 0],
            maps.displacement[j, i, 1],
            maps.foam[j, i],
            maps.normal[j, i, 0],
            maps.normal[j, i, 2],
            maps.normal[j, i, 1],
        ],
        axis=1,
    )
    assert numpy.abs(floats_of(log).reshape(100, 7) - truth).max() < 1e-5


# ---- Tiles ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("neighbour", ["x", "z"])
def test_tiles_meet_without_a_crack(choppy, neighbour):
    """50 000 rays within 2e-5 m of the seam between two copies."""
    maps = surface(choppy)
    step = PERIOD / N
    along = numpy.arange(N) * step
    dx, dy = maps.displacement[..., 0], maps.displacement[..., 1]
    if neighbour == "x":
        edge = numpy.stack([PERIOD + dx[:, 0], along + dy[:, 0]], axis=1)
    else:
        edge = numpy.stack([along + dx[0], PERIOD + dy[0]], axis=1)
    points = ",".join(f"<{a:.12f},0,{b:.12f}>" for a, b in edge)
    log = choppy.run(
        f"""Ocean_Load("sea_0001")
#declare Tile = Ocean_Mesh()
#declare Two = Ocean_Tiles(Tile, {2 if neighbour == "x" else 1}, {2 if neighbour == "z" else 1})
#declare Edge = array[{N}] {{ {points} }}
#declare Random = seed(3);
#declare Misses = 0;
#for (K, 0, {N - 2})
    #for (L, 1, 400)
        #local At = Edge[K] + (Edge[K + 1] - Edge[K])*rand(Random);
        #local Normal = <0, 0, 0>;
        #local Hit = trace(Two, At + {neighbour}*(rand(Random) - 0.5)*4e-5 + 50*y, -y, Normal);
        #if (vlength(Normal) = 0) #declare Misses = Misses + 1; #end
    #end
#end
#debug concat("V ", str(Misses, 0, 0), "\\n")"""
    )
    assert floats_of(log) == [0.0]


def peak_memory(folder, scene):
    """MiB of a run of POV-Ray."""
    (folder.path / "test.pov").write_text('#version 3.7;\n#include "ocean.inc"\n' + scene)
    command = ["povray", "test.pov", "-O/dev/null", "+W8", "+H8", "-D", "-A"]
    script = (
        "import resource,subprocess,sys;"
        "subprocess.run(sys.argv[1:],check=True,capture_output=True);"
        "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)"
    )
    done = subprocess.run(
        ["/usr/bin/python3", "-c", script, *command],
        cwd=folder.path,
        capture_output=True,
        text=True,
        check=True,
    )
    return int(done.stdout) / 1024.0


def test_ten_thousand_tiles_share_the_memory_of_one(tmp_path):
    folder = Folder(tmp_path, sea_text(resolution=256, period=200.0))
    scene = """global_settings {{ assumed_gamma 1.0 }}
Ocean_Load("sea_0001")
#declare Tile = Ocean_Mesh()
camera {{ location 9*y look_at z*100 }}
object {{ Ocean_Tiles(Tile, {0}, {0}) pigment {{ rgb 1 }} }}"""
    one, many = peak_memory(folder, scene.format(1)), peak_memory(folder, scene.format(100))
    print(f"\n1 tile {one:.0f} MiB, 10 000 tiles {many:.0f} MiB")
    assert many <= 1.5 * one


# ---- To the horizon ------------------------------------------------------------------------------

VIEW = """global_settings {{ assumed_gamma 1.0 max_trace_level 4 }}
Ocean_Load("sea_0001")
#declare Eye = <{eye}, 8, 0>;
camera {{ location Eye right x*image_width/image_height angle 50 look_at Eye + <1, -0.1, {turn}> }}
Ocean_Sun(24, 12)
Ocean_Sky(0.3)
object {{ Ocean_View(Eye, Eye + <1, -0.1, {turn}>, 50, 0.5) Ocean_Material("jerlov_ii")
         no_reflection }}"""


def test_the_far_sea_holds_still_when_the_camera_moves_a_tenth_of_a_pixel(tmp_path):
    folder = Folder(tmp_path, sea_text(resolution=256, period=200.0, wind=9.0))
    width, height = 320, 180
    pixel = 2 * numpy.tan(numpy.radians(25)) / width
    pictures = []
    for turn in (0.0, 0.1 * pixel):
        folder.run(
            VIEW.format(eye=0, turn=turn), "+A0.05", "+R3", "+AM2", width=width, height=height
        )
        pictures.append(read_png(folder.path / "out.png"))
    sea = pictures[0][: int(0.62 * height)]  # below the horizon
    far = slice(2 * len(sea) // 3, len(sea))
    difference = (pictures[1] - pictures[0])[far] * 255
    rms = numpy.sqrt(numpy.mean(difference**2))
    print(f"\nrms {rms:.2f}/255 in the far third")
    assert rms < 2.0
    assert numpy.std(pictures[0][far]) * 255 > 1.0, "there is nothing to be seen"


def test_the_far_sea_does_not_repeat(tmp_path):
    """Rays down on a ring twice five periods away: heights a period apart are not alike."""
    folder = Folder(tmp_path, sea_text(wind=10.0, period=150.0))
    log = folder.run(
        """Ocean_Load("sea_0001")
#declare Ocean_Repeats_ = 1;
#declare Sea = Ocean_View(<0, 60, 0>, <1, 60, 0>, 10, 1.5)
#for (K, 0, 399)
    #local P = <600 + 0.75*K, 900, 5*sin(K)>;
    #local Normal = <0, 0, 0>;
    #local Hit = trace(Sea, P, -y, Normal);
    #debug concat("V ", str(Hit.y + (P.x*P.x + P.z*P.z)/2/Ocean_Earth_Radius, 0, 6), "\\n")
#end"""
    )
    heights = floats_of(log)
    apart = 200  # 150 m
    repeats = numpy.corrcoef(heights[:-apart], heights[apart:])[0, 1]
    assert abs(repeats) < 0.5
    truth = surface(folder).height.std()
    assert 0.5 * truth < heights.std() < 1.5 * truth


def test_the_copies_of_the_far_sea_fade_into_each_other(choppy):
    """No step where one triangle of copies meets the next, and the variance of the sea."""
    log = choppy.run(
        f"""Ocean_Load("sea_0001")
Ocean_Load_Far_Maps_()
#for (K, 0, 9999)
    #local Way = 0.03*K;
    #debug concat("V ", str(Ocean_Seen_((500 + Way)/{PERIOD}, (90 + 0.7*Way)/{PERIOD}, 0, 0, 0, 1)
                            *Ocean_Metre_, 0, 6), "\n")
#end"""
    )
    heights = floats_of(log)
    truth = surface(choppy)
    steepest = numpy.abs(truth.slope).max()
    assert numpy.abs(numpy.diff(heights)).max() < 2 * steepest * 0.03 * 1.22
    assert heights.std() == pytest.approx(truth.height.std(), rel=0.25)


# ---- Under water ---------------------------------------------------------------------------------


@pytest.mark.parametrize("form", ["Ocean_Volume(<30, 0, 30>, 60, 20, 0.25)", "Ocean_Block(20)"])
def test_light_is_lost_by_beers_law_for_a_camera_under_water(choppy, form):
    losses = []
    for depth in (4.0, 9.0, 16.0):
        choppy.run(
            f"""global_settings {{ assumed_gamma 1.0 }}
Ocean_Load("sea_0001")
camera {{ orthographic location <30, -3, 30> direction -y right 0.5*x up 0.5*z }}
object {{ {form} Ocean_Clear_Material("jerlov_3c") hollow }}
box {{ <-500, -{3 + depth} - 1, -500>, <500, -{3 + depth}, 500>
      pigment {{ rgb 1 }} finish {{ ambient 0 diffuse 0 emission 0.9 }} }}"""
        )
        seen = read_png(choppy.path / "out.png").mean(axis=(0, 1)) / 0.9
        absorption = numpy.array([0.314, 0.128, 0.180])  # of jerlov_3c, as water_types.cpp has it
        losses.append(seen / numpy.exp(-absorption * depth))
    print(losses)
    assert numpy.abs(numpy.array(losses) - 1.0).max() < 0.01


POOL = """global_settings { assumed_gamma 1.0 max_trace_level 10 photons { count 150000 } }
Ocean_Load("sea_0001")
camera { orthographic location <5, 8, 5> direction -y right 5*x up 5*z }
light_source { <20, 60, 10> rgb 0.2 parallel point_at 0 photons { refraction on reflection off } }
intersection {
    object { Ocean_Block(4) }
    box { <1, -1.6, 1>, <9, 1, 9> }
    Ocean_Clear_Material("jerlov_i")
    hollow
    Ocean_Caustics()
}
box { <-20, -3, -20>, <20, -1.7, 20> pigment { rgb 0.8 } finish { ambient 0 diffuse 1 } }"""


def test_the_waves_of_a_pool_gather_light(tmp_path):
    """Brightest over mean light on its floor, without and with photons."""
    folder = Folder(
        tmp_path,
        sea_text(
            resolution=128,
            period=10.0,
            choppiness=0.5,
            wind=3.0,
            more="shortest_wavelength = 0.4",
            waves="significant_wave_height = 0.12\npeak_period = 1.2",
        ),
    )
    folder.run(POOL, width=100, height=100)
    light = read_png(folder.path / "out.png")[..., 1]
    contrast = numpy.percentile(light, 99.5) / light.mean()
    print(f"\ncontrast {contrast:.2f}")
    assert contrast > 2.0


# ---- Size and speed ------------------------------------------------------------------------------


def parse_seconds(log):
    """Of the processor: other work on the machine counts for less."""
    return float(re.search(r"Parse Time:[^%]*?([\d.]+) CPU-seconds", log).group(1))


def test_a_choppy_frame_is_small_and_parses_fast(tmp_path):
    sea = sea_text(resolution=512, period=400.0, wind=10.0)
    exact = Folder(tmp_path / "df3", sea, "--near-only")
    text = Folder(tmp_path / "mesh2", sea, "--format", "mesh2")
    scene = 'Ocean_Load("sea_0001")\nobject { Ocean_Mesh() }'
    seconds = {"df3": [], "mesh2": []}
    for _ in range(3):
        seconds["df3"].append(parse_seconds(exact.run(scene)))
        seconds["mesh2"].append(parse_seconds(text.run(scene)))
    ratio = min(seconds["df3"]) / min(seconds["mesh2"])
    size = (exact.path / "sea_0001.df3").stat().st_size
    share = size / (text.path / "sea_0001.inc").stat().st_size
    print(f"\n{seconds}, ratio {ratio:.2f}; {size} bytes, {share:.3f} of the text")
    assert ratio <= 2.5
    assert share <= 0.25


# ---- Folders -------------------------------------------------------------------------------------


def test_every_parameter_is_declared(choppy):
    text = (choppy.path / "ocean_parameters.inc").read_text()
    sea = libocean.open(choppy.path / "sea.toml")
    known = 0
    for parameter in libocean.parameters():
        section = "waves.0" if parameter["section"] == "waves" else parameter["section"]
        path = f"{section}.{parameter['key']}"
        value = sea.get(path)
        if not value or value == "[]":
            continue
        words = [word.capitalize() for word in re.split(r"[._]", path)]
        declared = re.search(rf"^#declare Ocean_{'_'.join(words)} = (.*?);", text, re.MULTILINE)
        assert declared, path
        if value not in ("inf", "-inf") and not declared.group(1).startswith('"'):
            assert float(declared.group(1)) == pytest.approx(float(value), rel=1e-12), path
        known += 1
    assert known > 25


def test_a_folder_renders_as_it_is_and_its_loop_closes(tmp_path):
    """povray ocean.ini: a picture for each frame; a period on the sea is the same to the bit."""
    sea = sea_text(resolution=32, period=60.0).replace(
        "[[waves]]", "[time]\nfps = 4.0\nloop_period = 2.0\n[[waves]]", 1
    )
    Folder(tmp_path, sea, "--frames", "1-9")
    done = subprocess.run(
        ["povray", "ocean.ini", "+W32", "+H18", "-A"], cwd=tmp_path, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr[-2000:]
    pictures = sorted(path.name for path in tmp_path.glob("scene*.png"))
    assert pictures == [f"scene{frame}.png" for frame in range(1, 10)]
    assert (tmp_path / "sea_0001.df3").read_bytes() == (tmp_path / "sea_0009.df3").read_bytes()
    assert (tmp_path / "sea_0001.df3").read_bytes() != (tmp_path / "sea_0005.df3").read_bytes()


def test_frames_that_are_no_range_are_counted_from_one(tmp_path):
    folder = Folder(tmp_path, sea_text(resolution=32), "--frames", "3-9x3")
    log = folder.run(
        """#for (K, 0, 3)
    Ocean_Load(Ocean_Frame_Name(K))
    #debug concat("V ", str(Ocean_Frame_Number, 0, 0), "\\nV ", str(Ocean_Time, 0, 6), "\\n")
#end"""
    )
    found = floats_of(log).reshape(4, 2)
    assert list(found[:, 0]) == [3, 3, 6, 9]
    assert found[:, 1] == pytest.approx((found[:, 0] - 1) / 24, abs=1e-6)
    assert "Final_Frame=3\n" in (tmp_path / "ocean.ini").read_text()


def test_the_macros_work_from_a_library_path(choppy, tmp_path):
    """As installed: the scene lies elsewhere, the folder is named by +L."""
    log = povray(
        tmp_path,
        '#version 3.7;\n#include "ocean.inc"\nOcean_Load("sea_0001")\n'
        '#debug concat("V ", str(Ocean_Height(0, 0), 0, 9), "\\n")\nobject { Ocean_Mesh() }',
        f"+L{choppy.path}",
    )
    assert floats_of(log)[0] == pytest.approx(surface(choppy).height[0, 0], abs=1e-6)


def test_every_public_macro_is_in_the_table_at_the_top(choppy):
    text = (choppy.path / "ocean.inc").read_text()
    head = text[: text.index("#ifndef(Ocean_Inc_Temp)")]
    macros = set(re.findall(r"^#macro (Ocean_\w*[^_\W])\(", text, re.MULTILINE))
    assert len(macros) > 18
    for macro in macros:
        assert macro + "(" in head, macro
        assert re.search(rf"^//   .*\b{macro}\(", text[len(head) :], re.MULTILINE), macro


def test_a_folder_without_far_maps_says_so_to_the_horizon(tmp_path):
    folder = Folder(tmp_path, sea_text(resolution=64), "--near-only")
    scene = 'Ocean_Load("sea_0001")\nobject { Ocean_View(<0, 9, 0>, <9, 8, 0>, 50, 0.2) }'
    log = re.sub(r"\s+", " ", folder.run(scene, good=False))
    assert "Ocean_View needs the coarser maps, which --near-only left out" in log
    folder.run('Ocean_Load("sea_0001")\nobject { Ocean_Mesh() }')


@pytest.mark.parametrize("format_", ["df3", "mesh2", "height_field"])
def test_the_scene_of_every_format_renders(tmp_path, format_):
    Folder(tmp_path, sea_text(resolution=32), "--format", format_)
    done = subprocess.run(
        ["povray", "scene.pov", "+W32", "+H18", "-D"], cwd=tmp_path, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr[-2000:]
    sky, water = read_png_8(tmp_path / "scene.png")
    assert sky[2] > 1.1 * water[2], "the sea is not darker than the sky"


def read_png_8(path):
    image = oiio.ImageInput.open(str(path))
    pixels = image.read_image("uint8").astype(float)
    image.close()
    return pixels[1].mean(axis=0), pixels[-3].mean(axis=0)


# ---- What goes wrong -----------------------------------------------------------------------------


@pytest.mark.parametrize(
    "scene,words",
    [
        ('Ocean_Load("sea_0007")', ["no sea_0007.df3"]),
        ("object { Ocean_Mesh() }", ["Ocean_Mesh comes before Ocean_Load"]),
        ('Ocean_Load("sea_0001") object { Ocean_Height_Field() }', ["--format height_field"]),
        (
            'Ocean_Load("sea_0001") object { Ocean_Mesh() Ocean_Material("tap") }',
            ['no water type "tap"', "jerlov_9c"],
        ),
        ("Ocean_Sky(0)", ["Ocean_Sky comes before Ocean_Sun"]),
    ],
)
def test_the_macros_say_what_is_wrong(choppy, scene, words):
    log = re.sub(r"\s+", " ", choppy.run(scene, good=False))
    for word in words:
        assert word in log


def test_data_of_another_version_are_refused(tmp_path):
    folder = Folder(tmp_path, sea_text(resolution=32))
    path = tmp_path / "ocean_parameters.inc"
    path.write_text(path.read_text().replace("Data_Version = 1", "Data_Version = 2"))
    log = re.sub(r"\s+", " ", folder.run("", good=False))
    assert "data are of version 2, this file reads version 1" in log


def test_a_folder_without_its_parameters_says_how_to_make_one(tmp_path):
    folder = Folder(tmp_path, sea_text(resolution=32))
    (tmp_path / "ocean_parameters.inc").unlink()
    assert "ocean povray SEA -o FOLDER" in re.sub(r"\s+", " ", folder.run("", good=False))


def test_bad_exports_are_refused_in_a_line(tmp_path):
    (tmp_path / "sea.toml").write_text(sea_text(resolution=32))

    def line(*arguments, code):
        done = ocean(tmp_path, "povray", "sea.toml", *arguments)
        assert done.returncode == code, done.stderr
        return done.stderr

    assert "at most 2048" in line("-o", "f", "--resolution", "4096", code=2)
    assert "--format" in line("-o", "f", "--format", "obj", code=2)
    assert "--near-only" in line("-o", "f", "--format", "mesh2", "--near-only", code=2)
    assert not (tmp_path / "f").exists()
    (tmp_path / "file").write_text("")
    assert "file" in line("-o", "file", code=1)
    assert "-o" in line(code=2)


def test_a_scene_that_is_there_is_kept(tmp_path):
    Folder(tmp_path, sea_text(resolution=32))
    (tmp_path / "scene.pov").write_text("// mine\n")
    done = ocean(tmp_path, "povray", "its_sea.toml", "-o", ".", "-v")
    assert done.returncode == 0
    assert (tmp_path / "scene.pov").read_text() == "// mine\n"
    assert "kept as it is" in done.stderr
