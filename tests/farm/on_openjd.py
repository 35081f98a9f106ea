# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""A bundle of Open Job Description runs as it is: bake, check, render."""

import jobs
import OpenImageIO as oiio
import pytest


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
    pictures = sorted(job.glob("scene*.png"))
    assert len(pictures) == 4, told
    image = oiio.ImageBuf(str(pictures[0]))
    assert image.spec().width > 0 and max(oiio.ImageBufAlgo.computePixelStats(image).max) > 0.5
    # A check that fails ends the job with its status.
    (job / "out/sea.displacement.0003.exr").write_bytes(b"half")
    with pytest.raises(AssertionError, match=r"damaged .*sea[.]displacement[.]0003[.]exr"):
        jobs.run(jobs.OPENJD, "run", template, "--step", "Check", "-p", f"Job={job}", folder=job)
