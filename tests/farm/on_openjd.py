# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""A bundle of Open Job Description runs as it is, the one of the page too: bake, check, render by
POV-Ray or Blender."""

import jobs
import OpenImageIO as oiio
import pytest


def check_pictures(job, count: int) -> None:
    pictures = sorted(job.glob("scene*.png"))
    assert len(pictures) == count
    for picture in pictures:
        image = oiio.ImageBuf(str(picture))
        assert oiio.ImageBufAlgo.computePixelStats(image).max[2] > 0.2


def test_the_commands_of_the_page_render_by_blender(tmp_path):
    commands, job = jobs.of_page(tmp_path, "openjd")
    jobs.run("bash", "-euc", commands, folder=tmp_path)
    assert (job / "out/sea.manifest.json").exists()
    assert len(list((job / "out").glob("*.exr"))) == 4
    check_pictures(job, 4)


@pytest.mark.parametrize("template", ["template.yaml", "template_shards.yaml"])
def test_a_bundle_bakes_checks_and_renders(tmp_path, template):
    job = jobs.write_job(tmp_path, "openjd", range(1, 5), render="scene.pov")
    told = jobs.run(
        jobs.OPENJD, "run", template, "--step", "Render", "--run-dependencies",
        "-p", f"Job={job}", folder=job,
    )  # fmt: skip
    assert "openjd_progress: 50" in told and "openjd_progress: 100" in told
    assert (job / "out/sea.manifest.json").exists()
    assert sorted(path.name for path in (job / "out").glob("*.exr")) == [
        f"sea.displacement.{frame:04d}.exr" for frame in range(1, 5)
    ], told
    check_pictures(job, 4)
    # A check that fails ends the job with its status.
    (job / "out/sea.displacement.0003.exr").write_bytes(b"half")
    with pytest.raises(AssertionError, match=r"damaged .*sea[.]displacement[.]0003[.]exr"):
        jobs.run(jobs.OPENJD, "run", template, "--step", "Check", "-p", f"Job={job}", folder=job)
