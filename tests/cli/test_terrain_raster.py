# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""`ocean terrain import` by ocean-raster: what GDAL knows of a raster arrives, units and maps that
stretch the ground are told, a crop reads its window alone, and the program touches nothing else."""

import hashlib
import os
import re
import shutil
import subprocess
from pathlib import Path

import numpy
import pytest
from conftest import table
from rasters import (
    CELL,
    COLUMNS,
    NORTH,
    ROWS,
    WEST,
    exact_land,
    facts,
    placed_tags,
    png,
    read_back,
    write_tags,
    write_tiff,
)

# Found by rasters.
import rasterio  # isort: skip
from rasterio.transform import Affine, from_origin  # isort: skip

pytestmark = pytest.mark.filterwarnings("ignore::rasterio.errors.NotGeoreferencedWarning")
OCEAN = Path(os.environ["OCEAN"])
HELPER = OCEAN.parent.parent / "libexec" / "libocean" / "ocean-raster"
FOOT, US_FOOT = 0.3048, 1200 / 3937
UTM_KEYS = (1024, 0, 1, 1, 1025, 0, 1, 1, 3072, 0, 1, 32611)
POINT_KEYS = (1024, 0, 1, 1, 1025, 0, 1, 2, 3072, 0, 1, 32611)


def changed(path, **attributes) -> None:
    with rasterio.open(path, "r+") as file:
        for name, value in attributes.items():
            setattr(file, name, value)


# The reader before GDAL ------------------------------------------------------------


def with_marks(dtype: str, *marks) -> numpy.ndarray:
    data = exact_land(dtype)
    data[3, : len(marks)] = marks
    return data


def matrix_tags(*matrix) -> list:
    return [(34264, "d", 16, matrix, True), *placed_tags(*UTM_KEYS)[2:]]


def write_scaled(path) -> None:
    write_tiff(path, exact_land("int16"))
    changed(path, scales=[0.1], offsets=[-50.0])


SECOND = 1 / 1200
# How a file is made, and options.
BEFORE = {
    "uint32": (lambda p: write_tiff(p, exact_land("uint32"), compress="lzw"), ""),
    "int8": (lambda p: write_tags(p, (exact_land("int32") % 200 - 100).astype("int8"),
                                  placed_tags(*UTM_KEYS)), ""),
    "zstd": (lambda p: write_tiff(p, exact_land("float64"), compress="zstd", tiled=True,
                                  blockxsize=16, blockysize=16), ""),
    "marks": (lambda p: write_tiff(p, with_marks("float32", -9999.9, numpy.nan, -3.4e38),
                                   nodata=-9999.9), ""),
    "marks64": (lambda p: write_tiff(p, with_marks("float64", numpy.float32(-9999.9), -9999.9),
                                     nodata=-9999.9), ""),
    "void16": (lambda p: write_tiff(p, with_marks("int16", -32768)), ""),
    "scale": (write_scaled, ""),
    "feet": (lambda p: write_tiff(p, exact_land(), "EPSG:2229",
                                  from_origin(6480000.0, 1840000.0, 10.0, 10.0)), ""),
    "degrees": (lambda p: write_tiff(p, exact_land(), "EPSG:4326",
                                     from_origin(-119.0, 34.5, SECOND, SECOND)), ""),
    "point": (lambda p: write_tags(p, exact_land(), placed_tags(
        *POINT_KEYS, cell=(0.1, 0.1), tie=(0.0, 0.0, 0.0, 500000.3, 3800000.7, 0.0))), ""),
    "matrix": (lambda p: write_tags(p, exact_land(), matrix_tags(
        CELL, 0, 0, WEST, 0, -CELL, 0, NORTH, 0, 0, 0, 0, 0, 0, 0, 1)), ""),
    "nztm": (lambda p: write_tiff(p, exact_land(), "EPSG:2193",
                                  from_origin(1600000.0, 5400000.0, 8.0, 8.0)), ""),
    "nowhere": (lambda p: write_tiff(p, exact_land(), None), ""),
    "vertical foot": (lambda p: write_tags(p, exact_land(), placed_tags(
        *UTM_KEYS, 4099, 0, 1, 9002)), ""),
    "vertical US foot": (lambda p: write_tags(p, exact_land(), placed_tags(
        *UTM_KEYS, 4099, 0, 1, 9003)), ""),
    "tie": (lambda p: write_tags(p, exact_land(), placed_tags(
        *UTM_KEYS, cell=(CELL, 20.0), tie=(10.0, 5.0, 0.0, WEST, NORTH, 0.0))), ""),
    "no place": (lambda p: write_tags(p, exact_land()), "--cell 2.5"),
    "png 16": (lambda p: p.write_bytes(png((65 * exact_land("int32")).astype("uint16"))),
               "--cell 5 --range -100,900.3"),
    "png 8": (lambda p: p.write_bytes(png((exact_land("int32") % 256).astype("uint8"))),
              "--cell 5 --range -100,900.3"),
    "jacksboro": (lambda p: shutil.copy(
        Path(__file__).parent.parent / "data/elevation/jacksboro.tif", p), ""),
}  # fmt: skip


def test_what_was_right_before_gdal_has_the_same_bits(ocean):
    """The hashes were printed by the version that read TIFF by libtiff and PNG by libpng."""
    found = {}
    for name, (write, options) in BEFORE.items():
        write(ocean.folder / "dem")
        ocean.good("terrain import dem -o bed.flt --holes fill", *options.split())
        content = (ocean.folder / "bed.flt").read_bytes() + (ocean.folder / "bed.hdr").read_bytes()
        found[name] = hashlib.sha256(content).hexdigest()[:16]
    assert found == table("terrain_raster")["hashes"]


# What GDAL brings ------------------------------------------------------------------


def test_each_form_of_missing_heights_is_a_hole(ocean):
    data = exact_land()
    known = numpy.full(data.shape, 255, "uint8")
    known[10:12, 20:26] = 0
    masked = numpy.where(known == 0, 0, data + 100).astype("float32")
    least = float(masked[known == 255].min())

    def check(name: str) -> None:
        found = facts(ocean, name)
        assert (found["holes"], found["lowest"]) == (12, least), name

    for name, internal in (("inside.tif", True), ("beside.tif", False)):
        with rasterio.Env(GDAL_TIFF_INTERNAL_MASK=internal):
            write_tiff(ocean.folder / name, masked)
            with rasterio.open(ocean.folder / name, "r+") as file:
                file.write_mask(known)
        assert (ocean.folder / f"{name}.msk").exists() != internal
        check(name)
    both = numpy.stack([masked, numpy.where(known == 0, 0, 255)]).astype("float32")
    with rasterio.open(
        ocean.folder / "alpha.tif", "w", driver="GTiff", width=COLUMNS, height=ROWS, count=2,
        dtype="float32", crs="EPSG:32611", transform=from_origin(WEST, NORTH, CELL, CELL),
        ALPHA="YES",
    ) as file:  # fmt: skip
        file.write(both)
    check("alpha.tif")
    write_tiff(ocean.folder / "sidecar.tif", numpy.where(known == 0, -999, data + 100).astype("f4"))
    (ocean.folder / "sidecar.tif.aux.xml").write_text(
        '<PAMDataset><PAMRasterBand band="1"><NoDataValue>-999</NoDataValue></PAMRasterBand>'
        "</PAMDataset>"
    )
    check("sidecar.tif")


def test_tiles_that_are_not_in_the_file_are_holes(ocean):
    with rasterio.open(
        ocean.folder / "dem.tif", "w", driver="GTiff", width=96, height=64, count=1, tiled=True,
        dtype="float32", crs="EPSG:32633", transform=from_origin(5e5, 5.3e6, 10, 10), nodata=-9.0,
        blockxsize=32, blockysize=32, SPARSE_OK=True,
    ) as file:  # fmt: skip
        file.write(numpy.full((32, 32), 7.0, "float32"), 1, window=((32, 64), (0, 32)))
    found = facts(ocean, "dem.tif")
    assert (found["holes"], found["lowest"], found["highest"]) == (5120, 7.0, 7.0)


def test_half_floats_world_files_and_other_formats_are_read(ocean):
    data = exact_land()
    half = data.astype("float16").astype("float32")
    write_tiff(ocean.folder / "half.tif", half, NBITS=16)
    write_tags(ocean.folder / "world.tif", data)
    (ocean.folder / "world.tfw").write_text(f"30.0\n0.0\n0.0\n-30.0\n{WEST + 15}\n{NORTH - 15}\n")
    write_tiff(ocean.folder / "envi.dat", data, driver="ENVI")
    write_tiff(ocean.folder / "surfer.grd", data, None, driver="GSBG")
    write_tiff(ocean.folder / "surfer7.grd", data, None, driver="GS7BG")
    for name in ("half.tif", "world.tif", "envi.dat", "surfer.grd", "surfer7.grd"):
        found = facts(ocean, name, "-o", "bed.flt")
        assert found["origin"] == [WEST + 15.0, NORTH - ROWS * CELL + 15.0], name
        assert found["cell"] == [CELL, CELL]
        assert (read_back(ocean)[0] == (half if name == "half.tif" else data)).all(), name
    (ocean.folder / "t.toml").write_text('libocean = 1\n[terrain]\nmeasured = "surfer.grd"\n')
    message = ocean.bad("terrain t.toml -o t.exr")
    assert "format Surfer: convert it by `ocean terrain import surfer.grd -o bed.flt`" in message


def test_rows_from_south_to_north_are_turned_over(ocean):
    data = exact_land()
    south = NORTH - ROWS * CELL
    write_tiff(ocean.folder / "up.tif", data[::-1], transform=Affine(CELL, 0, WEST, 0, CELL, south))
    write_tiff(ocean.folder / "down.tif", data)
    edges = f"{WEST + 90},{south + 60},{WEST + 600},{NORTH - 300}"
    for options in ([], ["--crop", edges]):
        expected = facts(ocean, "down.tif", "-o", "a.flt", *options)
        found = facts(ocean, "up.tif", "-o", "b.flt", *options)
        assert (found["origin"], found["cell"]) == (expected["origin"], expected["cell"])
        assert (read_back(ocean, "a.flt")[0] == read_back(ocean, "b.flt")[0]).all()


# Units and maps --------------------------------------------------------------------


def test_units_of_bands_and_of_vertical_systems_are_known(ocean):
    highest = float(exact_land().max())
    long_island = from_origin(1e6, 2e5, 10.0, 10.0)
    write_tiff(ocean.folder / "dem.tif", exact_land())
    for unit, metres, word in (
        ("US survey foot", US_FOOT, "are feet"),
        ("ft", FOOT, "are feet"),
        ("metre", 1.0, ""),
        ("meters above the geoid", 1.0, ""),
        ("cm", 0.01, "units of 0.01 m"),
        ("furlong", 1.0, "the unit 'furlong' for its heights, which is not known"),
    ):
        changed(ocean.folder / "dem.tif", units=[unit])
        found = facts(ocean, "dem.tif")
        assert found["highest"] == pytest.approx(highest * metres, rel=1e-7), unit
        assert word in " ".join(found["notes"]) and bool(word) == bool(found["notes"]), unit
    # Codes alone, as GeoTIFF 1.1 has them: cells in feet, heights in feet.
    write_tiff(ocean.folder / "codes.tif", exact_land(), "EPSG:2263+6360", long_island)
    found = facts(ocean, "codes.tif")
    assert found["highest"] == pytest.approx(highest * US_FOOT, rel=1e-7)
    assert found["cell"] == pytest.approx([10 * US_FOOT] * 2, rel=1e-12)
    assert found["system"] == 'LOCAL_CS["metres of EPSG:2263",UNIT["metre",1]]'
    assert facts(ocean, "codes.tif", "--unit", "m")["highest"] == pytest.approx(highest)
    changed(ocean.folder / "codes.tif", units=["m"])
    found = facts(ocean, "codes.tif")
    assert found["highest"] == pytest.approx(highest)
    assert "its band one of 1 m, which is taken" in " ".join(found["notes"])


def test_maps_that_stretch_the_ground_are_scaled_and_told(ocean):
    def mercator(latitude):
        sine = numpy.sin(numpy.radians(latitude))
        return float(numpy.cos(numpy.radians(latitude)) / (1 - 0.00669438 * sine**2) ** 0.5)

    for system, place, scale in (
        ("EPSG:3857", (1113194.9, 8399747.9), mercator(60)),
        ("EPSG:3395", (2226389.8, 10002381.0), mercator(66.6)),
        ("EPSG:3413", (-750.0, 500.0), 1.0309),  # the north pole
        ("EPSG:32633", (500000.0, 6651411.0), None),
    ):
        write_tiff(ocean.folder / "dem.tif", exact_land(), system,
                   from_origin(*place, 20.0, 20.0))  # fmt: skip
        found = facts(ocean, "dem.tif", "-o", "bed.flt")
        notes = " ".join(found["notes"])
        assert found["cell"] == pytest.approx([20 * (scale or 1.0)] * 2, rel=2e-3), system
        assert found["origin"] == [place[0] + 10.0, place[1] - ROWS * 20.0 + 10.0]
        assert (f"of {system} are" in notes and "on the ground" in notes) == (scale is not None)
        again = facts(ocean, "bed.flt")
        assert again["cell"] == pytest.approx(found["cell"], rel=1e-12) and not again["notes"]
        assert again["origin"] == found["origin"]
    # A place that its system was not made for says nothing of the ground.
    write_tiff(
        ocean.folder / "far.tif", exact_land(), "EPSG:32633", from_origin(2.5e6, 5e6, 20, 20)
    )
    found = facts(ocean, "far.tif")
    assert found["cell"] == [20.0, 20.0] and "outside the area" in found["notes"][0]
    # From 0 to 70 degrees north one scale is none.
    tall = from_origin(0.0, 1.1e7, 20.0, 11e6 / ROWS)
    write_tiff(ocean.folder / "tall.tif", exact_land(), "EPSG:3857", tall)
    assert "times that at the centre" in facts(ocean, "tall.tif")["notes"][0]


def test_the_projection_beside_the_result_is_the_whole_definition(ocean):
    write_tiff(ocean.folder / "dem.tif", exact_land(), "EPSG:2193", from_origin(1.6e6, 5.4e6, 8, 8))
    assert facts(ocean, "dem.tif", "-o", "bed.flt")["system"] == "EPSG:2193"
    assert read_back(ocean)[2].to_epsg() == 2193
    text = (ocean.folder / "bed.prj").read_text()
    assert text.startswith('PROJCS["NZGD2000 / New Zealand Transverse Mercator 2000"')
    assert text.count("\n") == 1


# Large rasters ---------------------------------------------------------------------


def test_a_raster_beyond_the_limit_is_read_by_a_window(ocean):
    """As large as GEBCO's, which has 3.7 billion cells."""
    cell = 1 / 240
    with rasterio.open(
        ocean.folder / "globe.tif", "w", driver="GTiff", width=86400, height=43200, count=1,
        dtype="int16", crs="EPSG:4326", transform=from_origin(-180, 90, cell, cell), tiled=True,
        compress="deflate", SPARSE_OK=True, blockxsize=512, blockysize=512,
    ) as file:  # fmt: skip
        block = numpy.arange(512 * 512).reshape(512, 512).astype("int16")
        file.write(block, 1, window=((8192, 8704), (43008, 43520)))
    assert (
        "has 86400 x 43200 cells; allowed: 2 .. 65536 along each side; --crop "
        "WEST,SOUTH,EAST,NORTH keeps a part"
    ) in ocean.bad("terrain import globe.tif")
    # Edges are metres from the south-west, by the scale of the globe's centre.
    east, north = 6378137.0 * numpy.pi / 180 * cell, 110574.27 * cell
    first, last = 43008 + 8, 43008 + 40
    top, bottom = 8192 + 16, 8192 + 32
    edges = [(first - 0.5) * east, (43200 - bottom - 0.5) * north,
             (last - 0.5) * east, (43200 - top - 0.5) * north]  # fmt: skip
    found = facts(ocean, "globe.tif", "-o", "bed.flt", "--crop", ",".join(map(str, edges)))
    assert found["samples"] == [32, 16]
    assert (read_back(ocean)[0] == block[16:32, 8:40]).all()
    # The same window in degrees.
    places = [-180 + first * cell, 90 - bottom * cell, -180 + last * cell, 90 - top * cell]
    letters = ("EW", "NS", "EW", "NS")
    degrees = ",".join(f"{abs(x):.9f}{w[x < 0]}" for x, w in zip(places, letters, strict=True))
    assert facts(ocean, "globe.tif", "--crop", degrees)["samples"] == [32, 16]
    # The scale is that of the window's own latitude.
    latitude = 90 - cell * (top + 8)
    assert found["geographic_origin"] == pytest.approx(
        [-180 + (first + 0.5) * cell, 90 - (bottom - 0.5) * cell]
    )
    radius = 6378137.0 / (1 - 0.00669438 * numpy.sin(numpy.radians(latitude)) ** 2) ** 0.5
    width = radius * numpy.cos(numpy.radians(latitude)) * numpy.pi / 180 * cell
    assert found["cell"][0] == pytest.approx(width, rel=1e-6)


# A program of its own --------------------------------------------------------------


def test_without_the_program_one_sentence_says_where_it_is(ocean):
    alone = ocean.folder / "bin" / "ocean"
    alone.parent.mkdir()
    shutil.copy(OCEAN, alone)
    write_tiff(ocean.folder / "dem.tif", exact_land())
    done = subprocess.run([alone, "terrain", "import", "dem.tif"], cwd=ocean.folder,
                          capture_output=True, text=True)  # fmt: skip
    assert done.returncode == 2 and done.stdout == ""
    assert done.stderr == (
        "ocean: dem.tif: is a file of the format TIFF, which ocean-raster reads; that program is "
        "not installed (Debian: ocean-terrain; sources: a build with libgdal-dev)\n"
    )


def test_the_command_links_no_gdal(ocean):
    libraries = subprocess.run(["ldd", OCEAN], capture_output=True, text=True, check=True).stdout
    assert "libc.so" in libraries and not re.search("gdal|proj", libraries)
    assert HELPER.is_file()


def test_no_other_driver_and_no_other_place_is_opened(ocean):
    write_tiff(ocean.folder / "dem.tif", exact_land())
    dem = ocean.folder / "dem.tif"
    vrt = (
        '<VRTDataset rasterXSize="75" rasterYSize="50"><VRTRasterBand dataType="Float32" band="1">'
        f"<SimpleSource><SourceFilename>{dem}</SourceFilename><SourceBand>1</SourceBand>"
        "</SimpleSource></VRTRasterBand></VRTDataset>"
    )
    for name, content in (("vrt.tif", vrt), ("xyz.tif", "0 0 1\n1 0 2\n0 1 3\n1 1 4\n")):
        (ocean.folder / name).write_text(content)
        message = ocean.bad("terrain import", name)
        assert "is not a whole file of its format" in message, name
    for name in (
        f"/vsisubfile/0_9999999,{dem}",
        f"GTIFF_DIR:1:{dem}",
        "dem.tif",
        str(ocean.folder),
    ):
        done = subprocess.run([HELPER, name], cwd=ocean.folder, capture_output=True)
        assert done.returncode == 0 and done.stdout.endswith(b"is no file"), name


def test_the_program_touches_the_file_its_sidecars_and_projs_data_alone(ocean):
    """By strace; a sidecar names places that GDAL would open."""
    trace = ocean.folder / "trace"
    strace = ["strace", "-f", "-e", "trace=file,network,process", "-o", trace]
    if shutil.which("strace") is None or subprocess.run([*strace, "true"]).returncode != 0:
        pytest.skip("strace is not installed, or may not trace")
    write_tiff(ocean.folder / "dem.tif", exact_land(), "EPSG:3857", from_origin(1e6, 8e6, 20, 20))
    elsewhere = '<MDI key="OVERVIEW_FILE">/vsicurl/http://127.0.0.1:9/a.tif</MDI>'
    (ocean.folder / "dem.tif.aux.xml").write_text(
        f'<PAMDataset><Metadata domain="OVERVIEWS">{elsewhere}</Metadata><PAMRasterBand band="1">'
        f'<Metadata domain="OVERVIEWS">{elsewhere.replace("/vsicurl/http:/", "/etc")}</Metadata>'
        "</PAMRasterBand></PAMDataset>"
    )
    subprocess.run([*strace, HELPER, ocean.folder / "dem.tif"], env={}, cwd="/", check=True,
                   stdout=subprocess.DEVNULL)  # fmt: skip
    calls = trace.read_text().splitlines()
    loader = re.compile(r'"(/[^"]*\.so[.0-9]*|/etc/ld\.so\.(cache|preload)|/(proc|sys)/[^"]*|'
                        r'/etc/gnutls/config|/lib/share/proj|)"')  # fmt: skip
    own = re.compile(
        rf'"({re.escape(str(ocean.folder))}/dem\.[^"]*|/usr(/share(/proj(/[^"]*)?)?)?)"'
    )
    strange = [
        call
        for call in calls
        if not (loader.search(call) or own.search(call))
        and not re.search(r"AT_EMPTY_PATH|exit_group|exited with 0|execve\(", call)
    ]
    assert strange == []
    assert sum("execve(" in call for call in calls) == 1
    assert not re.search(r"\b(socket|connect|clone|fork|O_WRONLY|O_RDWR|O_CREAT)", "\n".join(calls))
    opened = [call for call in calls if "dem.tif.aux.xml" in call and "openat" in call]
    assert len(opened) == 1
