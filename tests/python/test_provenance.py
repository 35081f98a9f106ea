# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""A host keeps a sea as values, and labels its own files as `ocean bake` does."""

import pytest

import libocean


def test_values_make_the_same_sea(sea):
    sea.add_waves(spectrum="jonswap", significant_wave_height=1.25, peak_period=11)
    sea.perform(2.0, "wind_speed", 14.0)
    values = sea.values
    assert values["grid.resolution"] == "64"
    assert values["waves.1.peak_period"] == "11"
    assert values["waves.1.wind_speed"] == ""
    assert "[take]" in values
    assert all(sea.get(name) == text for name, text in values.items() if name[0] != "[")
    with libocean.parse(libocean.text_of_values(values)) as again:
        assert again.text == sea.text


def test_the_text_of_values_spells_them_as_they_are_given():
    text = libocean.text_of_values({"fps": "25.000", "waves.0.spectrum": "tma", "depth": None})
    assert text == 'libocean = 1\n\n[time]\nfps = 25.000\n\n[[waves]]\nspectrum = "tma"\n'
    with pytest.raises(libocean.InvalidValueError, match="wind_sped"):
        libocean.text_of_values({"wind_sped": 3})


def test_a_frame_has_a_time(sea):
    sea.set_all({"start": 10.0, "fps": 25.0, "first_frame": 3})
    assert sea.time_of_frame(8.5) == 10.0 + 5.5 / 25.0


def test_headers_are_those_of_a_bake(sea):
    strings = sea.provenance(7, 1.5, "displacement", axes="tnb")
    assert strings.pop("ocean:sea") == sea.text
    assert strings == {
        "ocean:frame": "7",
        "ocean:time": "1.5",
        "ocean:period": "200",
        "ocean:backend": "cpu",
        "ocean:version": libocean.version,
        "ocean:axes": "tnb",
        "ocean:field": "displacement",
        "ocean:unit": "m",
    }
    assert "ocean:field" not in sea.provenance(7, 1.5)
    assert sea.provenance(7, 1.5, "cover", axes="tnb")["ocean:axes"] == "zup"  # the same in all
    with libocean.parse(sea.text, backend="dft") as other:
        assert other.provenance(7, 1.5)["ocean:backend"] == "dft"


def test_headers_of_slope_tiles_tell_of_their_band(sea):
    detail = sea.detail(1.5, 32, samples=256)
    known = sea.provenance(7, 1.5, "detail2", resolution=32)
    strings = sea.provenance(7, 1.5, "detail2", resolution=32, detail=detail)
    assert known.items() < strings.items()
    assert known["ocean:map_resolution"] == "32"
    assert float(strings["ocean:tile"]) == detail.bands[1].tile
    variances = [float(text) for text in strings["ocean:slope_variance"].split(",")]
    assert variances == pytest.approx(detail.bands[1][4:7], abs=1e-8)
    assert float(strings["ocean:slope_residual"]) == pytest.approx(detail.residual, abs=1e-8)
