# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Reference values of the same spectra from an independent package: wavespectra, from PyPI.

usage: PYTHON tests/cli/wavespectra_reference.py FOLDER > tests/data/wavespectra.json

PYTHON has wavespectra and netCDF4. Writes spectrum files into FOLDER by the package's own writers,
reads them and the samples of tests/data/spectra by its own readers, and prints for each file the
records with their significant wave height (without a tail), peak period (of the highest bin), mean
direction (coming from) and directional spread. test_wavespectra.py compares `ocean` with it.
"""

import gzip
import json
import shutil
import sys
import warnings
from pathlib import Path

import numpy as np
import xarray as xr
from wavespectra import (
    read_datawell,
    read_era5,
    read_ndbc,
    read_ndbc_ascii,
    read_netcdf,
    read_spotter,
    read_swan,
    read_triaxys,
    read_ww3,
    read_ww3_station,
)

SAMPLES = Path(__file__).resolve().parent.parent / "data" / "spectra"
NDBC_PARTS = (".data_spec", ".swdir", ".swdir2", ".swr1", ".swr2")
warnings.filterwarnings("ignore")


def number_or_null(value: float) -> float | None:
    return None if np.isnan(value) else round(float(value), 6)


def records(data: xr.Dataset, over_frequency: xr.Dataset | None = None) -> list[dict]:
    """Time by time, and place by place within it: the order of `ocean records`. Heights and periods
    are those of the second data set where there is one; null = the package has no directions."""
    spec = data.spec
    total = spec if over_frequency is None else over_frequency.spec
    values = {
        "significant_wave_height": total.hs(tail=False),
        "peak_period": total.tp(smooth=False),
        "coming_from": spec.dm(),
        "directional_spread": spec.dspr(),
    }
    times = [str(t)[:16] for t in np.atleast_1d(data.time.values)]
    columns = {
        name: np.asarray(value.transpose("time", ...)).reshape(len(times), -1)
        for name, value in values.items()
    }
    return [
        {"time": time, **{name: number_or_null(c[i, k]) for name, c in columns.items()}}
        for i, time in enumerate(times)
        for k in range(columns["peak_period"].shape[1])
    ]


def three_places(folder: Path) -> xr.Dataset:
    """The sample of SWAN at three places: as it is, turned by 130 degrees, and halved."""
    one = read_swan(str(SAMPLES / "swan_nz_west_coast.spec"), as_site=True).isel(time=slice(0, 2))
    one = one.compute()
    turned = one.copy(deep=True)
    turned["efth"] = turned.efth.roll(dir=13, roll_coords=False)
    halved = one.copy(deep=True)
    halved["efth"] = 0.5 * halved.efth
    data = xr.concat([one, turned, halved], dim="site")
    data = data.assign_coords(site=[1, 2, 3])
    data["lon"] = ("site", [174.67, -176.2, 12.5])
    data["lat"] = ("site", [-38.17, -38.5, 54.25])
    return data


def write_era5(data: xr.Dataset, path: Path) -> None:
    """The layout of ECMWF's files: log10 of m^2 s/rad on 30 frequencies and 24 directions."""
    frequency = 0.03453 * 1.1 ** np.arange(30)
    direction = (7.5 + 15.0 * np.arange(24) + 180.0) % 360.0  # travelling to, as coming from
    place = data.isel(site=0).drop_vars(["lon", "lat", "site"], errors="ignore")
    even = place.spec.interp(freq=frequency, dir=np.sort(direction)).sel(dir=direction)
    values = np.log10((even * 180.0 / np.pi).where(even > 1e-8))
    spectra = values.transpose("time", "freq", "dir").values[:, :, :, None, None]
    xr.Dataset(
        {"d2fd": (("time", "frequency", "direction", "latitude", "longitude"), spectra)},
        coords={
            "time": data.time.values,
            "frequency": np.arange(1, 31),
            "direction": np.arange(1, 25),
            "latitude": [-38.0],
            "longitude": [174.5],
        },
    ).to_netcdf(path)


def write_csv(data: xr.Dataset, path: Path) -> None:
    with path.open("w") as file:
        file.write("time,latitude,longitude,frequency (Hz),direction,density (m2/Hz/deg)\n")
        for time in data.time.values:
            for site in range(data.site.size):
                one = data.sel(time=time).isel(site=site)
                start = f"{str(time)[:16]},{float(one.lat)},{float(one.lon)}"
                for f in one.freq.values:
                    for d in one.dir.values:
                        value = float(one.efth.sel(freq=f, dir=d))
                        file.write(f"{start},{f:.9g},{d:.9g},{value:.9g}\n")


def made(folder: Path) -> dict[str, list[dict]]:
    data = three_places(folder)
    data.spec.to_swan(str(folder / "places.swan"))
    with (folder / "places.swan").open("rb") as plain, gzip.open(folder / "p.gz", "wb") as packed:
        shutil.copyfileobj(plain, packed)
    (folder / "p.gz").rename(folder / "places.swan.gz")
    data.spec.to_netcdf(str(folder / "places.nc"))
    data.spec.to_ww3(str(folder / "places_ww3.nc"))
    write_era5(data, folder / "era5.nc")
    write_csv(data, folder / "places.csv")
    swan = read_swan(str(folder / "places.swan"), as_site=True)
    return {
        "places.swan": records(swan),
        "places.swan.gz": records(swan),
        "places.nc": records(read_netcdf(str(folder / "places.nc"))),
        "places_ww3.nc": records(read_ww3(str(folder / "places_ww3.nc"))),
        "era5.nc": records(read_era5(str(folder / "era5.nc"))),
        "places.csv": records(data),
    }


def wavewatch(path: Path) -> xr.Dataset:
    """The package weighs every bin by the distance of the first two, which radians of three digits
    make 9.74 degrees where 36 bins are 10 degrees wide: the directions are put back on the circle.
    """
    data = read_ww3_station(str(path))
    return data.assign_coords(dir=np.round((data.dir.values - 5.0) / 10.0) * 10.0 % 360.0 + 5.0)


def of_one(line: str) -> str:
    """NDBC's yearly r1 and r2 are in hundredths, which the package does not know."""
    if line.startswith("#"):
        return line
    cells = line.split()
    return " ".join(cells[:5] + [c if float(c) == 999 else f"{float(c) / 100}" for c in cells[5:]])


def with_half_edges(data: xr.Dataset) -> xr.Dataset:
    """The package gives the first and the last frequency the width of a whole bin, the trapezoid
    half of one: both are put there twice, once without energy. In short seas that tells."""
    efth = data.efth.load()
    return xr.concat([0 * efth.isel(freq=[0]), efth, 0 * efth.isel(freq=[-1])], "freq").to_dataset()


def spotter_json(path: Path) -> xr.Dataset:
    """The package takes the times of the heights beside the spectra, an hour off in this file."""
    spectra = json.loads(path.read_text())["data"]["frequencyData"]
    times = [np.datetime64(spectrum["timestamp"].removesuffix("Z")) for spectrum in spectra]
    return with_half_edges(read_spotter(str(path))).assign_coords(time=times)


def triaxys(path: Path) -> xr.Dataset:
    """The package sums 0 and 360 degrees both."""
    return read_triaxys(str(path)).isel(dir=slice(None, -1))


def samples(folder: Path) -> dict[str, list[dict]]:
    realtime = [str(SAMPLES / f"ndbc_41010{part}") for part in NDBC_PARTS]
    historical = []
    for letter in "wdijk":
        packed = SAMPLES / "ndbc_historical" / f"41010{letter}2020.txt.gz"
        plain = folder / packed.stem
        lines = gzip.decompress(packed.read_bytes()).decode().splitlines()
        plain.write_text("\n".join(map(of_one, lines) if letter in "jk" else lines) + "\n")
        historical.append(str(plain))
    yearly = read_ndbc_ascii(historical)
    return {
        "ndbc_41010.data_spec": records(read_ndbc_ascii(realtime)),
        "ndbc_historical/41010w2020.txt.gz": records(yearly),
        "ww3_station_44097.spec": records(wavewatch(SAMPLES / "ww3_station_44097.spec")),
        "swan_nz_west_coast.spec": records(read_swan(str(SAMPLES / "swan_nz_west_coast.spec"))),
        "spotter_20210929b.csv": records(
            with_half_edges(read_spotter(str(SAMPLES / "spotter_20210929b.csv")))
        ),
        "spotter_20180214.json": records(spotter_json(SAMPLES / "spotter_20180214.json")),
        "buoy}2024-09-09T01h15Z.spt": records(
            read_datawell(str(SAMPLES / "buoy}2024-09-09T01h15Z.spt"))
        ),
        "triaxys.DIRSPEC": records(triaxys(SAMPLES / "triaxys.DIRSPEC")),
        "42098w9999.nc": records(
            *[
                with_half_edges(read_ndbc(str(SAMPLES / "42098w9999.nc"), directional=directional))
                for directional in (True, False)
            ]
        ),
    }


def main() -> None:
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    print(json.dumps({"made": made(folder), "samples": samples(folder)}, indent=1))


if __name__ == "__main__":
    main()
