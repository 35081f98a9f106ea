# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""Broken NetCDF spectra, written byte by byte: the classic format needs no library.

A file is (dimensions, variables): {name: size} and a list of
(name, dimension names, attributes, type, values). HDF5 is here as ruins only. What readers refuse
of a content that arrives whole is tested in process (BrokenContentsAreRefusedAndNamed).
"""

import struct

CHAR, SHORT, INT, FLOAT, DOUBLE = 2, 3, 4, 5, 6
CODES = {SHORT: "h", INT: "i", FLOAT: "f", DOUBLE: "d"}
NAN = float("nan")


def padded(data):
    return data + b"\0" * (-len(data) % 4)


def name(text):
    data = text if isinstance(text, bytes) else text.encode()
    return struct.pack(">i", len(data)) + padded(data)


def numbers(kind, values):
    return struct.pack(f">{len(values)}{CODES[kind]}", *values)


def items(tag, entries):
    return struct.pack(">ii", tag if entries else 0, len(entries)) + b"".join(entries)


def attribute(key, value):
    if isinstance(value, (str, bytes)):
        data = value if isinstance(value, bytes) else value.encode()
        return name(key) + struct.pack(">ii", CHAR, len(data)) + padded(data)
    return name(key) + struct.pack(">ii", DOUBLE, 1) + numbers(DOUBLE, [value])


def classic(dimensions, variables, version=1):
    """A CDF-1 file."""
    order = list(dimensions)
    data = [
        padded(values if kind == CHAR else numbers(kind, values))
        for _, _, _, kind, values in variables
    ]

    def header(begins):
        entries = []
        for (text, axes, attributes, kind, _), own, begin in zip(
            variables, data, begins, strict=True
        ):
            entries.append(
                name(text)
                + struct.pack(f">i{len(axes)}i", len(axes), *[order.index(a) for a in axes])
                + items(12, [attribute(k, v) for k, v in attributes.items()])
                + struct.pack(">iii", kind, len(own), begin)
            )
        sizes = [name(n) + struct.pack(">I", s) for n, s in dimensions.items()]
        return (
            b"CDF"
            + bytes([version, 0, 0, 0, 0])
            + items(10, sizes)
            + items(0, [])
            + items(11, entries)
        )

    begin = len(header([0] * len(variables)))
    begins = []
    for own in data:
        begins.append(begin)
        begin += len(own)
    return header(begins) + b"".join(data)


DIMENSIONS = {"time": 2, "site": 1, "freq": 3, "dir": 4}


def sea(dimensions=None, drop=(), **changed):
    """The good file, some variables otherwise: NAME=(attributes, values), None as it was."""
    variables = [
        ("efth", ("time", "site", "freq", "dir"), {"units": "m2 s degree-1"}, [0.01] * 24),
        ("time", ("time",), {"units": "days since 1990-01-01"}, [11000.0, 11000.125]),
        ("lat", ("site",), {"units": "degrees_north"}, [50.0]),
        ("lon", ("site",), {"units": "degrees_east"}, [-3.0]),
        ("freq", ("freq",), {"units": "Hz"}, [0.1, 0.2, 0.3]),
        ("dir", ("dir",), {"units": "degree"}, [0.0, 90.0, 180.0, 270.0]),
    ]
    return classic({**DIMENSIONS, **(dimensions or {})}, edited(variables, drop, changed))


def edited(variables, drop, changed):
    made = []
    for text, axes, attributes, values in variables:
        if text in drop:
            continue
        own, other = changed.get(text, (None, None))
        made.append((text, axes, own if own is not None else attributes, DOUBLE, other or values))
    return made


def ndbc(**changed):
    """A buoy's file of the National Data Buoy Center, some variables otherwise."""
    axes = ("time", "frequency", "latitude", "longitude")
    variables = [
        ("spectral_wave_density", axes, {"units": "(meter * meter)/Hz"}, [1.0, 2.0, 3.0]),
        ("mean_wave_dir", axes, {"units": "degrees_true"}, [10.0, 20.0, 30.0]),
        ("principal_wave_dir", axes, {"units": "degrees_true"}, [10.0, 20.0, 30.0]),
        ("wave_spectrum_r1", axes, {}, [0.9, 0.8, 0.7]),
        ("wave_spectrum_r2", axes, {}, [0.6, 0.5, 0.4]),
        ("time", ("time",), {"units": "seconds since 1970-01-01T00:00:00+00:00"}, [1.6e9]),
        ("frequency", ("frequency",), {"units": "Hz"}, [0.1, 0.2, 0.3]),
        ("latitude", ("latitude",), {"units": "degrees_north"}, [27.59]),
        ("longitude", ("longitude",), {"units": "degrees_east"}, [-82.931]),
    ]
    sizes = {"time": 1, "frequency": 3, "latitude": 1, "longitude": 1}
    return classic(sizes, edited(variables, (), changed))


GOOD = sea()


def efth(*values):
    return sea(efth=(None, list(values) + [0.01] * (24 - len(values))))


def case(label, data, fragment):
    return (label, {"sea.nc": data}, None, fragment)


LIBRARY = "NetCDF"
CASES = [
    case("signature_alone", b"CDF\1", LIBRARY),
    case("cut_in_the_dimensions", GOOD[:30], "holds no wave spectrum"),
    case("cut_in_the_variables", GOOD[:200], LIBRARY),
    case("cut_in_the_spectrum", GOOD[:-150], "the file is cut off"),
    case("cut_by_a_value", GOOD[:-8], "the file is cut off: it has 780 bytes of 788"),
    case("unknown_version", b"CDF\4" + GOOD[4:], ""),
    case("hdf5_signature_alone", b"\x89HDF\r\n\x1a\n", LIBRARY),
    case("hdf5_with_zeros", b"\x89HDF\r\n\x1a\n" + bytes(4096), LIBRARY),
    case("hdf5_with_ones", b"\x89HDF\r\n\x1a\n" + b"\xff" * 4096, LIBRARY),
    case("no_variables", classic(DIMENSIONS, []), "holds no wave spectrum"),
    case("a_billion_times", sea(dimensions={"time": 1_000_000_000}), "sea.nc: "),
    case("a_million_directions", sea(dimensions={"time": 1, "dir": 1_000_000}), "sea.nc: "),
    case(
        "negative_density",
        efth(*[0.1, -0.5] * 12),
        "efth: record 2020-02-13T00:00: a density of -0.5",
    ),
    case(
        "latin_1_units", sea(efth=({"units": b"m\xb5 s deg-1"}, None)), "efth: units 'm? s deg-1'"
    ),
    case(
        "scale_of_zero",
        sea(efth=({"units": "m2 s rad-1", "scale_factor": 0.0}, None)),
        "scale_factor",
    ),
    case("frequency_below_zero", sea(freq=(None, [-0.1, 0.1, 0.2])), "freq: a frequency of -0.1"),
    case("longitude_400", sea(lon=(None, [400.0])), "lon: 400"),
    case("no_directions", sea(drop=("dir",)), "no variable with its directions"),
    case(
        "buoy_density_negative",
        ndbc(spectral_wave_density=(None, [1.0, -2.0, 3.0])),
        "spectral_wave_density: record 2020-09-13T12:27: a density of -2",
    ),
    case(
        "buoy_density_in_cubic_feet",
        ndbc(spectral_wave_density=({"units": "(foot * foot * foot)/Hz"}, None)),
        "spectral_wave_density: units '(foot * foot * foot)/Hz'",
    ),
    case(
        "buoy_direction_800",
        ndbc(mean_wave_dir=(None, [10.0, 800.0, 30.0])),
        "mean_wave_dir: record 2020-09-13T12:27: a direction of 800 degrees; allowed: -360 .. 720",
    ),
    case(
        "buoy_direction_negative",
        ndbc(principal_wave_dir=(None, [-500.0, 20.0, 30.0])),
        "principal_wave_dir: record 2020-09-13T12:27: a direction of -500 degrees; allowed: -360",
    ),
    case(
        "buoy_ratio_in_thousandths",
        ndbc(wave_spectrum_r1=(None, [900.0, 800.0, 700.0])),
        "wave_spectrum_r1: record 2020-09-13T12:27: 900; allowed: 0 .. 1",
    ),
    case(
        "buoy_ratio_infinite",
        ndbc(wave_spectrum_r2=(None, [0.6, float("inf"), 0.4])),
        "wave_spectrum_r2: record 2020-09-13T12:27: inf; allowed: 0 .. 1",
    ),
]
