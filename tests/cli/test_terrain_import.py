# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""`ocean terrain import`: GeoTIFFs written by GDAL and tifffile, SRTM, PNG, EXR; the result read by
GDAL; what is no elevation model gets a sentence. What GDAL brings is in test_terrain_raster.py."""

import numpy
import pytest
from rasters import (
    CELL,
    COLUMNS,
    NORTH,
    ROWS,
    WEST,
    facts,
    land,
    placed_tags,
    png,
    read_back,
    write_tags,
    write_tiff,
)

# Found by rasters.
import rasterio  # isort: skip
import tifffile  # isort: skip
from rasterio.transform import Affine, from_origin  # isort: skip

pytestmark = pytest.mark.filterwarnings("ignore::rasterio.errors.NotGeoreferencedWarning")

KINDS = [
    ("float32", {}),
    ("int16", {"compress": "lzw"}),
    ("uint16", {"compress": "deflate", "predictor": 2}),
    ("int32", {"compress": "deflate"}),
    ("uint8", {"compress": "packbits"}),
    ("float32", {"compress": "deflate", "predictor": 3}),
    ("float32", {"compress": "lzw", "tiled": True, "blockxsize": 32, "blockysize": 16}),
    ("float64", {"compress": "lzw", "predictor": 3, "tiled": True, "blockxsize": 16,
                 "blockysize": 16}),
    ("int16", {"ENDIANNESS": "BIG", "compress": "lzw", "predictor": 2}),
    ("float32", {"BIGTIFF": "YES", "blockysize": 7}),
]  # fmt: skip


@pytest.mark.parametrize(("dtype", "options"), KINDS, ids=lambda part: str(part)[:60])
def test_each_kind_of_geotiff_gives_its_heights_and_its_place(ocean, dtype, options):
    data = land(dtype) if dtype != "uint8" else (land() / 4).astype("uint8")
    write_tiff(ocean.folder / "dem.tif", data, **options)
    found = facts(ocean, "dem.tif", "-o", "bed.flt")
    assert found["samples"] == [COLUMNS, ROWS]
    assert found["cell"] == [CELL, CELL]
    assert found["origin"] == [WEST + CELL / 2, NORTH - ROWS * CELL + CELL / 2]
    assert found["system"] == "EPSG:32611" and not found["was_degrees"]
    data = data.astype("float32")
    assert (found["lowest"], found["highest"]) == (data.min(), data.max())
    heights, transform, crs, nodata = read_back(ocean)
    assert (heights == data).all()
    assert transform == from_origin(WEST, NORTH, CELL, CELL)
    assert crs.to_epsg() == 32611 and nodata == -9999.0
    # The program reads its own file to the same bits.
    again = facts(ocean, "bed.flt", "-o", "again.flt")
    assert (ocean.folder / "again.flt").read_bytes() == (ocean.folder / "bed.flt").read_bytes()
    assert again["origin"] == found["origin"] and again["cell"] == found["cell"]


@pytest.mark.parametrize(
    ("order", "bigtiff", "tile"),
    [("<", False, (16, 32)), ("<", True, None), (">", False, None), (">", True, (16, 32))],
)
def test_the_geotiffs_of_another_writer_are_read(ocean, order, bigtiff, tile):
    data = land()
    tags = placed_tags(1024, 0, 1, 1, 1025, 0, 1, 1, 3072, 0, 1, 32611)
    write_tags(ocean.folder / "dem.tif", data, tags, byteorder=order, bigtiff=bigtiff, tile=tile)
    found = facts(ocean, "dem.tif", "-o", "bed.flt")
    assert found["origin"] == [WEST + 15.0, NORTH - ROWS * CELL + 15.0]
    assert found["system"] == "EPSG:32611"
    assert (read_back(ocean)[0] == data).all()


def test_a_pixel_that_is_a_point_lies_half_a_cell_elsewhere(ocean):
    write_tiff(ocean.folder / "area.tif", land())
    with rasterio.open(ocean.folder / "area.tif", "r+") as file:
        file.update_tags(AREA_OR_POINT="Point")
    # GDAL moves the tie point, so that the file means the same place.
    assert facts(ocean, "area.tif")["origin"] == [WEST + 15.0, NORTH - ROWS * CELL + 15.0]
    write_tags(ocean.folder / "p.tif", land(), placed_tags(1024, 0, 1, 1, 1025, 0, 1, 2))
    assert facts(ocean, "p.tif")["origin"] == [WEST, NORTH - (ROWS - 1) * CELL]


def test_a_matrix_places_a_raster_and_a_turned_one_is_refused(ocean):
    def write(matrix):
        write_tags(ocean.folder / "m.tif", land(), [(34264, "d", 16, matrix, True)])

    write((CELL, 0, 0, WEST, 0, -CELL, 0, NORTH, 0, 0, 0, 0, 0, 0, 0, 1))
    assert facts(ocean, "m.tif")["origin"] == [WEST + 15.0, NORTH - ROWS * CELL + 15.0]
    write((CELL, 3, 0, WEST, 3, -CELL, 0, NORTH, 0, 0, 0, 0, 0, 0, 0, 1))
    assert "is turned against east and north; `gdalwarp`" in ocean.bad("terrain import m.tif")
    write((-CELL, 0, 0, WEST, 0, -CELL, 0, NORTH, 0, 0, 0, 0, 0, 0, 0, 1))
    assert "is mirrored; `gdalwarp` turns it" in ocean.bad("terrain import m.tif")
    upside_down = [*placed_tags(1024, 0, 1, 1), (274, "H", 1, 4, True)]
    write_tags(ocean.folder / "m.tif", land(), upside_down)
    assert "its first row elsewhere than on top" in ocean.bad("terrain import m.tif")


def test_degrees_are_scaled_by_the_latitude_of_the_centre(ocean):
    cell = 1 / 1200
    write_tiff(ocean.folder / "deg.tif", land(), "EPSG:4326", from_origin(-119.0, 34.5, cell, cell))
    found = facts(ocean, "deg.tif", "-o", "bed.flt")
    assert found["was_degrees"] and found["system"] == "EPSG:4326"
    latitude = 34.5 - ROWS * cell / 2
    # The ellipsoid's own lengths, by rasterio's PROJ.
    from rasterio.warp import transform

    x, y = transform(
        "EPSG:4326",
        f"+proj=aeqd +lat_0={latitude} +lon_0=-118.97 +ellps=WGS84",
        [-118.97, -118.97 + cell, -118.97, -118.97],
        [latitude, latitude, latitude - cell / 2, latitude + cell / 2],
    )
    assert found["cell"] == pytest.approx([x[1] - x[0], y[3] - y[2]], rel=1e-6)
    assert found["origin"] == [0.0, 0.0]
    assert found["geographic_origin"] == pytest.approx(
        [-119 + cell / 2, 34.5 - (ROWS - 0.5) * cell]
    )
    assert "degrees" in found["notes"][0]
    heights, place, crs, _ = read_back(ocean)
    assert (heights == land()).all() and place.a == pytest.approx(found["cell"][0])
    assert -place.e == pytest.approx(found["cell"][1]) and not crs.is_geographic
    again = facts(ocean, "bed.flt")
    assert not again["was_degrees"] and again["cell"] == pytest.approx(found["cell"])
    # Metres from the south-west cell, and degrees.
    crop = facts(ocean, "deg.tif", "--crop", f"118.9957W,{34.5 - 45.2 * cell}N,118.98W,34.49N")
    assert crop["samples"][0] < COLUMNS and crop["origin"] == [0.0, 0.0]
    assert -118.9957 <= crop["geographic_origin"][0] < -118.9957 + cell
    assert crop["cell"][0] != found["cell"][0]
    # The user's word counts more than the file's.
    assert facts(ocean, "deg.tif", "--degrees", "no")["cell"] == pytest.approx([cell, cell])


def test_feet_of_heights_and_of_cells_become_metres(ocean):
    write_tiff(ocean.folder / "ft.tif", land(), "EPSG:2229")  # California zone 5, US survey feet
    found = facts(ocean, "ft.tif", "--unit", "us_ft", "-o", "bed.flt")
    foot = 1200 / 3937
    assert found["cell"] == pytest.approx([CELL * foot] * 2, rel=1e-12)
    assert found["highest"] == pytest.approx(float(land().max()) * foot, rel=1e-6)
    assert any("horizontal unit" in note for note in found["notes"])
    assert facts(ocean, "bed.flt")["cell"] == pytest.approx(found["cell"])
    up = facts(ocean, "ft.tif", "--unit", "ft")["highest"]
    assert facts(ocean, "ft.tif", "--unit", "ft", "--sign", "down")["lowest"] == -up


def test_holes_are_told_refused_and_filled(ocean):
    data = land()
    data[20:30, 30:50] = -32768.0
    write_tiff(ocean.folder / "holes.tif", data, nodata=-32768.0)
    found = facts(ocean, "holes.tif")
    assert found["holes"] == 200 and found["share_of_holes"] == pytest.approx(200 / 3750)
    done = ocean("terrain import holes.tif -o bed.flt")
    assert done.returncode == 2 and "200 of 3750 cells" in done.stdout
    assert done.stderr == (
        "ocean: holes.tif: 200 of 3750 heights are missing; --holes fill fills them with the "
        "smooth surface around them\n"
    )
    assert not (ocean.folder / "bed.flt").exists()
    ocean.good("terrain import holes.tif -o bed.flt --holes fill")
    heights = read_back(ocean)[0]
    known = data != -32768.0
    assert (heights[known] == data[known]).all()
    rim = data[19:31, 29:51]
    assert rim[rim > -32768].min() <= heights[~known].min()
    assert heights[~known].max() <= rim.max()
    # Integers of 16 bits have a void of their own, which no height is.
    data[0, 0] = -32768.0
    write_tiff(ocean.folder / "int.tif", data.astype("int16"))
    assert facts(ocean, "int.tif")["holes"] == 201


def test_gdals_scale_and_offset_are_applied_and_told(ocean):
    write_tiff(ocean.folder / "s.tif", land("int16"))
    with rasterio.open(ocean.folder / "s.tif", "r+") as file:
        file.scales, file.offsets = [0.1], [-50.0]
    found = facts(ocean, "s.tif")
    assert found["highest"] == pytest.approx(0.1 * land("int16").max() - 50.0, abs=1e-3)
    assert "0.1 times its sample plus -50" in found["notes"][0]
    # A mark that the file does not declare is one of its samples.
    data = land("int16")
    data[4, 5:8] = -9999
    write_tiff(ocean.folder / "s.tif", data, nodata=-32768)
    with rasterio.open(ocean.folder / "s.tif", "r+") as file:
        file.scales, file.offsets = [0.1], [-50.0]
    notes = facts(ocean, "s.tif")["notes"]
    assert any("3 heights are -9999, a common mark" in note for note in notes)


def test_srtm_tiles_lie_where_their_names_say(ocean):
    side = 1201
    data = (numpy.arange(side * side).reshape(side, side) % 2000).astype(">i2")
    data[5, 7] = -32768
    (ocean.folder / "N34W119.hgt").write_bytes(data.tobytes())
    found = facts(ocean, "N34W119.hgt")
    assert found["samples"] == [side, side] and found["geographic_origin"] == [-119.0, 34.0]
    assert found["holes"] == 1 and found["system"] == "EPSG:4326"
    assert found["cell"] == pytest.approx([76.53, 92.44], abs=0.02)
    found = facts(ocean, "N34W119.hgt", "-o", "bed.flt", "--holes", "fill")
    heights = read_back(ocean)[0]
    data[5, 7] = round(float(heights[5, 7]))
    assert (numpy.round(heights) == data).all()
    (ocean.folder / "tile.HGT").write_bytes(data.tobytes())
    assert "--corner N34W119" in ocean.bad("terrain import tile.HGT")
    assert facts(ocean, "tile.HGT", "--corner", "s01e006")["geographic_origin"] == [6.0, -1.0]


def test_a_png_has_the_heights_of_its_range(ocean):
    grey = numpy.linspace(0, 65535, 40 * 20).round().astype("uint16").reshape(20, 40)
    (ocean.folder / "h.png").write_bytes(png(grey))
    assert "--cell METRES" in ocean.bad("terrain import h.png")
    assert "--range LOWEST,HIGHEST" in ocean.bad("terrain import h.png --cell 5")
    found = facts(ocean, "h.png", "--cell", "5", "--range", "-100,900", "-o", "bed.flt")
    assert (found["lowest"], found["highest"]) == (-100.0, 900.0) and found["cell"] == [5.0, 5.0]
    assert numpy.abs(read_back(ocean)[0] - (grey / 65.535 - 100.0)).max() < 1e-4
    (ocean.folder / "8.png").write_bytes(png((grey >> 8).astype("uint8")))
    assert "8 bits" in facts(ocean, "8.png", "--cell", "5", "--range", "0,255")["notes"][0]


def test_an_exr_image_has_heights(ocean):
    ocean.good("terrain preset:gabilan_mesa --set resolution=64 --set patch_size=1000 -o t.exr")
    found = facts(ocean, "t.exr", "-o", "bed.flt")
    assert found["samples"] == [64, 64] and found["cell"] == [1000 / 64] * 2
    assert any("libocean wrote" in note for note in found["notes"])
    import OpenImageIO

    image = OpenImageIO.ImageBuf(str(ocean.folder / "t.exr")).get_pixels(OpenImageIO.FLOAT)
    assert (read_back(ocean)[0] == image[:, :, 0]).all()


def write_exr(path, **channels) -> None:
    """An image with one channel for each name, whose points are spelled as two underscores."""
    import OpenImageIO

    spec = OpenImageIO.ImageSpec(12, 10, len(channels), "float")
    spec.channelnames = tuple(name.replace("__", ".") for name in channels)
    image = OpenImageIO.ImageOutput.create(str(path))
    image.open(str(path), spec)
    image.write_image(numpy.stack(list(channels.values()), axis=2).astype("float32"))
    image.close()


def test_the_channel_of_an_exr_image_is_the_one_whose_name_says_height(ocean):
    hills = 100.0 + numpy.arange(120.0).reshape(10, 12)
    other, none, one = 7.0 * hills, 0 * hills, 0 * hills + 1
    right = {
        "rgba": {"R": hills, "G": hills, "B": hills, "A": one},
        "small": {"r": hills, "g": none, "b": none, "a": one},
        "layer": {"dem__R": hills, "dem__G": hills, "dem__B": hills, "dem__A": one},
        "z": {"A": one, "Z": hills},
        "y": {"Y": hills, "normal__X": other, "normal__Y": one, "normal__Z": none},
        "depth": {"Albedo": other, "depth": hills},
        "named": {"R": other, "G": one, "B": none, "terrain__Height": hills},
        "alone": {"anything": hills, "A": one},
    }
    for name, channels in right.items():
        write_exr(ocean.folder / f"{name}.exr", **channels)
        found = facts(ocean, f"{name}.exr", "--cell", "5")
        assert (found["lowest"], found["highest"]) == (100.0, 219.0), (name, found["notes"])
        assert "of the channel" in found["notes"][0]
    wrong = {
        "colours": {"R": hills, "G": other, "B": one},
        "render": {"R": other, "G": other, "B": other, "Z": hills},
        "vector": {"P__X": hills, "P__Y": other, "P__Z": one},
        "two": {"first": hills, "second": other},
    }
    for name, channels in wrong.items():
        write_exr(ocean.folder / f"{name}.exr", **channels)
        message = ocean.bad("terrain import", f"{name}.exr", "--cell", "5")
        listed = ", ".join(sorted(channel.replace("__", ".") for channel in channels))
        assert f"has the channels {listed}, of which several may be the heights" in message, name
    write_exr(ocean.folder / "alpha.exr", A=hills)
    message = ocean.bad("terrain import alpha.exr --cell 5")
    assert "has no channel of heights, only A" in message


def test_marks_that_a_file_does_not_declare_are_told(ocean):
    tile = numpy.full((1201, 1201), 40, ">i2")
    tile[600, 5], tile[600, 6] = 32767, -32768
    (ocean.folder / "N42W072.hgt").write_bytes(tile.tobytes())
    found = facts(ocean, "N42W072.hgt")
    assert found["holes"] == 1 and "1 height is 32767, a common mark" in found["notes"][1]
    data = land()
    data[3, 4:6], data[7, 8] = -32768.0, -9999.0
    write_tiff(ocean.folder / "other.tif", data, nodata=-9999.0)
    found = facts(ocean, "other.tif")
    assert found["holes"] == 1 and "2 heights are -32768, a common mark" in found["notes"][0]
    # Shades are none.
    grey = numpy.array([[0, 32767], [1, 65535]], "uint16")
    (ocean.folder / "h.png").write_bytes(png(grey))
    notes = facts(ocean, "h.png", "--cell", "5", "--range", "0,65535")["notes"]
    assert not any("mark" in note for note in notes)


def test_a_crop_keeps_the_cells_within_its_edges(ocean):
    data = land()
    data[0, 0] = -9999.0  # outside the crop: it need not be filled
    write_tiff(ocean.folder / "dem.tif", data, nodata=-9999.0)
    south = NORTH - ROWS * CELL
    edges = [WEST + 10 * CELL, south + 5 * CELL, WEST + 40 * CELL, south + 25 * CELL]
    found = facts(ocean, "dem.tif", "-o", "bed.flt", "--crop", ",".join(map(str, edges)))
    assert found["samples"] == [30, 20] and found["holes"] == 0
    assert (read_back(ocean)[0] == data[ROWS - 25 : ROWS - 5, 10:40]).all()
    assert read_back(ocean)[1] == Affine(CELL, 0, edges[0], 0, -CELL, edges[3])
    assert "--crop leaves fewer than 2 x 2 cells" in ocean.bad(
        "terrain import dem.tif --crop 0,0,10,10"
    )


def test_facts_without_an_output_write_nothing(ocean):
    write_tiff(ocean.folder / "dem.tif", land())
    before = sorted(ocean.folder.iterdir())
    text = ocean.good("terrain import dem.tif")
    assert sorted(ocean.folder.iterdir()) == before
    assert "size     75 x 50 cells, 2250 m x 1500 m\n" in text
    assert "cell     30.000 m x 30.000 m\n" in text
    assert "system   EPSG:32611\n" in text and "holes    0 of 3750 cells (0 %)\n" in text


def test_only_files_of_this_command_are_replaced(ocean):
    write_tiff(ocean.folder / "dem.tif", land())
    (ocean.folder / "bed.prj").write_text("mine")
    assert "'bed.prj' exists and was not written by" in ocean.bad(
        "terrain import dem.tif -o bed.flt"
    )
    (ocean.folder / "bed.prj").unlink()
    ocean.good("terrain import dem.tif -o bed.flt")
    ocean.good("terrain import dem.tif -o bed.flt")
    assert "is an input of this command" in ocean.bad("terrain import bed.flt -o bed.flt")
    header = (ocean.folder / "bed.hdr").read_text().replace("creator libocean\n", "")
    (ocean.folder / "bed.hdr").write_text(header)
    assert "'bed.flt' exists" in ocean.bad("terrain import dem.tif -o bed.flt")


def test_each_bad_file_gets_one_sentence(ocean):
    folder = ocean.folder
    write_tiff(folder / "good.tif", land(), compress="deflate")
    whole = (folder / "good.tif").read_bytes()

    def written(name: str, content: bytes) -> str:
        (folder / name).write_bytes(content)
        return name

    tifffile.imwrite(folder / "rgb.tif", numpy.zeros((20, 30, 3), "uint8"), photometric="rgb")
    tifffile.imwrite(folder / "cube.tif", numpy.zeros((20, 30), "complex64"))
    tifffile.imwrite(folder / "plain.tif", land())
    tifffile.imwrite(folder / "thin.tif", land()[:1])
    huge = numpy.full((20, 30), 1e9, "float32")
    write_tiff(folder / "huge.tif", huge)
    write_tiff(folder / "all.tif", numpy.full((20, 30), -1.0, "float32"), nodata=-1.0)
    grey = numpy.zeros((8, 8), "uint16")
    bad = {
        written("empty.tif", b""): "is not a whole file of its format",
        written("text.tif", b"hello"): "is not a whole file of its format",
        written("stub.tif", whole[:6]): "is not a whole file of its format",
        written("cut.tif", whole[: len(whole) // 2]): "cut.tif: ",
        "rgb.tif": "has 3 bands; heights are one band",
        "cube.tif": "has samples of the type CFloat32; heights are integers or floats",
        "plain.tif": "does not state the size of its cells; --cell METRES does",
        "thin.tif": "has 75 x 1 cells; allowed: 2 .. 65536",
        "huge.tif": "the height 1e+09 in row 20 from the north, column 1 is out of range",
        "all.tif": "has no heights, only holes",
        written("N34W119.hgt", b"\0" * 1000): "has 1000 bytes; an SRTM tile has 1201 x 1201",
        written("colour.png", png(numpy.zeros((8, 24), "uint8"), 2)): "has 3 bands",
        written("cut.png", png(grey)[:50]): "cannot be read in row 1",
        written("cut.exr", b"\x76\x2f\x31\x01" + b"\0" * 20): "is no whole EXR file",
        written("photo.jpg", b"\xff\xd8\xff"): "is no elevation model",
        written("wave.nc", b"CDF\1" + b"\0" * 20): "gdal_translate",
    }
    for name, sentence in bad.items():
        options = ["--cell", "2"] if name.endswith(("png", "exr")) else []
        if name.endswith("png"):
            options += ["--range", "0,1"]
        message = ocean.bad("terrain import", name, "-o", "bed.flt", *options)
        assert sentence in message, name
        assert len(message) < 400
    assert not (folder / "bed.flt").exists()


def test_options_that_a_geotiff_does_not_need_are_refused(ocean):
    write_tiff(ocean.folder / "dem.tif", land())
    for options, words in {
        ("--cell", "5"): "states the size of its cells itself",
        ("--range", "0,1"): "are heights themselves",
        ("--crop", "1E,2N,3E,4N"): "--crop in degrees: dem.tif has cells of metres",
    }.items():
        assert words in ocean.bad("terrain import dem.tif", *options), options


def test_a_big_file_is_read_in_little_memory_and_soon(ocean):
    data = numpy.zeros((4096, 4096), "int16")
    data[::7, ::5] = 9
    write_tiff(ocean.folder / "big.tif", data, compress="deflate", tiled=True)
    assert facts(ocean, "big.tif")["highest"] == 9.0
