# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""A frame has the same bytes however it is baked: by any number of threads, in any order, in
shards, again where files are gone or cut, and from its own header. A row for each subject, product
and format; what the files hold is told where each format is tested."""

import random
from typing import NamedTuple

import pytest
from bake_runs import BOAT, TRACK
from coasts import BEACH, REGION, SEA, grid
from conftest import GALE, SMALL_SEA, Program
from lands import ISLAND, TILE

FRAMES = range(1, 5)
TEXTS = {
    "sea": SMALL_SEA,
    "foam": SMALL_SEA.replace("9.0", "15.0") + "[surface]\nfoam_lifetime = 1.0\n",
    "take": SMALL_SEA
    + '[surface]\nfoam_lifetime = 0.5\n[take]\nlines = ["0.02 waves.0.wind_speed 14", '
    + '"0.1 surface.choppiness 1.4", "0.12 waves.0.spreading mitsuyasu"]\n',
    "crest": SMALL_SEA + '[[crests]]\ntime = 0.1\nx = 120.0\ny = 50.0\nheight = "1.3 Hs"\n',
    "gale": GALE.replace("128", "64"),
    "coast": SEA + "[surface]\nfoam_step = 0.2\n",
    "boat": SMALL_SEA + BOAT + TRACK,
    "tile": TILE,
    "island": ISLAND,
}


class Row(NamedTuple):
    subject: str
    output: str
    words: str = ""


PARTS = " ".join(REGION)
BOX = "--box=-20,30,-9,120,150,crest --velocity-voxel 2.5"
SEAS = {
    "images": Row("sea", "s.####.exr", "--products displacement,normal"),
    "layered": Row("sea", "s.####.exr", "--layout layered --products displacement,velocity,normal"),
    "half": Row("sea", "s.####.exr", "--type half --axes yup --compression piz"),
    "radix2": Row("sea", "s.####.exr", "--compression none --backend radix2 --products height"),
    "pxr24": Row("sea", "s.####.exr", "--products slope,height --compression pxr24"),
    "finer": Row("sea", "s.####.exr", "--resolution 128 --products slope,jacobian"),
    "foam": Row("foam", "s.####.exr", "--products displacement,foam"),
    "take": Row("take", "s.####.exr", "--products displacement,foam"),
    "crest": Row("crest", "s.####.exr", "--products displacement"),
    "caustics": Row("sea", "s.####.exr", "--products caustics --caustics-depth 4.5 --sun 40,200"),
    "detail": Row("take", "s.####.exr", "--products detail --detail-samples 256"),
    "png": Row("sea", "s.####.png"),
    "mesh2": Row("sea", "s.####.inc"),
    "df3": Row("sea", "s.####.df3"),
    "ply": Row("foam", "s.####.ply", "--axes yup --products normal,foam --resolution 32"),
    "obj": Row("foam", "s.####.obj", "--axes yup --products normal,foam --resolution 32"),
    "usd": Row("foam", "s.usda", "--axes yup --products normal,foam --resolution 32"),
    "vdb": Row("sea", "s.####.vdb"),
    "spray": Row("gale", "s.####.ply", "--products spray --spray-lifetime 1.5 --axes yup"),
    "points": Row("gale", "s.####.vdb", "--products spray --spray-density 0.7"),
    "mist": Row("gale", "s.####.vdb", f"--products density {BOX}"),
    "coast": Row("coast", "s.####.exr", f"{PARTS} --products displacement,foam,wetness"),
    "coast ply": Row("coast", "s.####.ply", f"{PARTS} --products foam,depth"),
    "coast usd": Row("coast", "s.usda", f"{PARTS} --products normal,foam,wetness"),
    "coast vdb": Row("coast", "s.####.vdb", f"{PARTS} --products surface"),
    "coast spray": Row("coast", "s.####.vdb", f"{PARTS} --products spray"),
    "coast df3": Row("coast", "s.####.df3", PARTS),
    "boat": Row("boat", "s.####.exr", "--region=-40,-20,60,40 --cell 2 --products displacement"),
}
PART = "--region=300,1400,900,1750 --cell 10"
EYE = "--lod=101.3,1503.7,150 --farthest 700"
LANDS = {
    "tile half": Row("tile", "s.exr", "--type half"),
    "tile layered": Row("tile", "s.exr", "--products height,normal --layout layered"),
    "tiles": Row("tile", "s.exr", "--tiles 2x3"),
    "tiles png": Row("tile", "s.png", "--tiles 2x3"),
    "tiles tif": Row("tile", "s.tif", "--tiles 2x3"),
    "tiles ply": Row("tile", "s.ply", "--tiles 2x3"),
    "tiles obj": Row("tile", "s.obj", "--tiles 2x3"),
    "tiles usd": Row("tile", "s.usda", "--tiles 2x3"),
    "tiles vdb": Row("tile", "s.vdb", "--tiles 2x3"),
    "region": Row("island", "s.####.exr", f"{PART} --products height,cliff"),
    "region png": Row("island", "s.png", PART),
    "region tif": Row("island", "s.tif", PART),
    "region ply": Row("island", "s.ply", f"{PART} --products normal,cliff"),
    "region obj": Row("island", "s.obj", PART),
    "region usd": Row("island", "s.usda", PART),
    "region vdb": Row("island", "s.vdb", PART),
    "eye ply": Row("island", "s.ply", f"{EYE} --products normal,cliff,shelter"),
    "eye obj": Row("island", "s.obj", f"{EYE} --products normal,cliff"),
    "eye usd": Row("tile", "s.usda", EYE),
}


class Bakes:
    """A row's frames in the folder `whole`, and the program that made them."""

    def __init__(self, folder, row: Row):
        self.row, self.program = row, Program(folder)
        self.is_land = "[terrain]" in TEXTS[row.subject]
        self.command = "terrain" if self.is_land else "bake"
        self.program.write("subject.toml", TEXTS[row.subject])
        self.program.write("bed.asc", grid(BEACH))
        self.bake("whole", "--threads", "2")
        self.whole = self.program.hashes("whole")

    def bake(self, folder: str, *options):
        frames = () if self.is_land or "--frames" in options else ("--frames", "1-4")
        command = (self.command, "subject.toml", *self.row.words.split(), *frames)
        self.program.good(*command, "-q", "-o", f"{folder}/{self.row.output}", *options)

    def files(self, frame: int) -> dict[str, str]:
        """The hashes of what `whole` has of a frame, by name."""
        return {name: sha for name, sha in self.whole.items() if f".{frame:04}." in name}

    def bytes_of(self, name: str, folder: str = "whole") -> bytes:
        return (self.program.folder / folder / name).read_bytes()


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """The bakes of each row, made when they are first asked for."""
    known = {}

    def made_once(name: str) -> Bakes:
        if name not in known:
            folder = tmp_path_factory.mktemp(name.replace(" ", "_"))
            known[name] = Bakes(folder, (SEAS | LANDS)[name])
        return known[name]

    return made_once


@pytest.fixture(params=SEAS)
def bakes(made, request) -> Bakes:
    return made(request.param)


def test_frames_differ_and_mind_no_order_and_no_threads(bakes):
    of_frames = [bakes.files(frame) for frame in FRAMES]
    assert all(of_frames)
    hashes = [sha for files in of_frames for name, sha in files.items()]
    assert len(set(hashes)) == len(hashes)
    # A stage is of even steps, and grows by chunks.
    for frames in ("3-4", "1-2") if bakes.row.output == "s.usda" else ("4,3,2,1",):
        bakes.bake("back", "--frames", frames, "--threads", "3")
    assert bakes.program.hashes("back") == bakes.whole


def test_shards_are_joined_to_the_whole(bakes):
    """The later half comes first, alone and by one thread."""
    for shard, threads in (("2/2", 1), ("1/2", 3)):
        bakes.bake("parts", "--shard", shard, "--threads", threads)
    bakes.program.merge(f"parts/{bakes.row.output}")
    assert bakes.program.hashes("parts") == bakes.whole


def test_files_that_are_gone_or_cut_are_made_again_and_no_others(bakes):
    folder = bakes.program.folder / "whole"
    kept, gone, *cut = (folder / next(iter(bakes.files(frame))) for frame in FRAMES)
    before = kept.stat().st_mtime_ns
    gone.unlink()
    for path, size in zip(cut, (random.Random(str(bakes.row)).random(), 1.0), strict=True):
        content = path.read_bytes()
        path.write_bytes(content[: int(size * (len(content) - 1))])
    bakes.bake("whole", "--skip-existing")
    assert bakes.program.hashes("whole") == bakes.whole
    assert kept.stat().st_mtime_ns == before


WITHOUT_HEADERS = ("png", "mesh2", "df3", "coast df3")


@pytest.mark.parametrize("name", [name for name in SEAS | LANDS if name not in WITHOUT_HEADERS])
def test_a_file_makes_itself_again_and_holds_its_subject(made, name):
    bakes = made(name)
    row, program = bakes.row, bakes.program
    files = bakes.files(3)
    if bakes.is_land:
        files = {name: sha for name, sha in bakes.whole.items() if not name.endswith("json")}
    source = program.good("info --sea-file subject.toml")
    for file in files:
        if file.endswith((".txt", ".inc", ".usda", ".topology.usdc")):
            continue
        program.good(f"{bakes.command} --from", f"whole/{file}", "-q", "-o", f"again/{row.output}")
        again = program.hashes("again")
        assert again[file] == files[file]
        assert {other: again[other] for other in files if other in again}.items() <= files.items()
        assert program.good("info --sea-file", f"whole/{file}") == source
        program.write(f"cut/{file}", bakes.bytes_of(file)[:200])
        assert file in program.bad("info", f"cut/{file}")
