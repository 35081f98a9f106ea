# SPDX-FileCopyrightText: The libocean authors
# SPDX-License-Identifier: Apache-2.0
"""libocean.h in ctypes. make_abi.py writes this file: change the header, then run that."""

import ctypes
from ctypes import (
    POINTER,
    c_char_p,
    c_double,
    c_float,
    c_int32,
    c_int64,
    c_size_t,
    c_uint32,
    c_uint64,
    c_void_p,
)
from typing import Any

ABI_VERSION = 1

OK = 0
INVALID_ARGUMENT = 1
INVALID_VALUE = 2
BAD_FILE = 3
NOT_FOUND = 4
UNSUPPORTED = 5
OUTPUT = 6
OUT_OF_MEMORY = 7
BUFFER_TOO_SMALL = 8
INTERNAL = 9
CANCELLED = 10
BUSY = 11

CHANNELS = {
    "dx": 0,
    "dy": 1,
    "height": 2,
    "nx": 3,
    "ny": 4,
    "nz": 5,
    "slope_x": 6,
    "slope_y": 7,
    "jacobian": 8,
    "whitecap": 9,
    "foam": 10,
    "vx": 11,
    "vy": 12,
    "vz": 13,
    "dx_x": 14,
    "dy_y": 15,
    "dx_y": 16,
    "cover": 17,
    "wear": 40,
    "gully": 41,
    "ridge": 42,
    "flow": 43,
    "deposit": 44,
    "streambed": 45,
    "wetness": 46,
    "beach": 47,
    "cliff": 48,
    "shelter": 49,
    "depth": 50,
    "breaking": 51,
    "trail": 52,
    "dry": 53,
}

AXES = {"zup": 0, "yup": 1, "tnb": 2}

BACKENDS = {"cpu": 0, "gl": 1, "radix2": 2, "dft": 3}

FOAM_STARTS = {"settled": 0, "empty": 1}

Progress = ctypes.CFUNCTYPE(c_int32, c_void_p, c_int64, c_int64)

Job = ctypes.CFUNCTYPE(None, c_void_p, c_int32)

RunJobs = ctypes.CFUNCTYPE(None, c_void_p, Job, c_void_p, c_int32)


class Options(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("threads", c_int32),
        ("backend", c_int32),
        ("foam_start", c_int32),
        ("reserved", c_int32),
        ("progress", Progress),
        ("user", c_void_p),
        ("run_jobs", RunJobs),
        ("jobs_user", c_void_p),
    ]


class Output(ctypes.Structure):
    _fields_ = [
        ("data", POINTER(c_float)),
        ("count", c_size_t),
        ("channel", c_int32 * 4),
        ("channels", c_int32),
        ("axes", c_int32),
        ("row_pitch", c_size_t),
        ("seam", c_int32),
        ("reserved", c_int32),
    ]


class Request(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("time", c_double),
        ("resolution", c_int32),
        ("outputs", POINTER(Output)),
        ("output_count", c_size_t),
        ("output_size", c_size_t),
        ("cascade", c_int32),
        ("reserved", c_int32),
    ]


ERROR_FIELDS = {"what": 0, "parameter": 1, "value": 2, "allowed": 3}

FOLDED = 1
UNDECIDED = 2


class Sample(ctypes.Structure):
    _fields_ = [
        ("height", c_float),
        ("normal", c_float * 3),
        ("velocity", c_float * 3),
        ("foam", c_float),
        ("label", c_double * 2),
        ("flags", c_int32),
        ("reserved", c_int32),
    ]


class QueryRequest(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("time", c_double),
        ("xy", POINTER(c_double)),
        ("count", c_size_t),
        ("samples", POINTER(Sample)),
        ("sample_size", c_size_t),
        ("resolution", c_int32),
        ("refine", c_int32),
        ("exact", c_int32),
        ("foam", c_int32),
        ("height_error", POINTER(c_double)),
    ]


class WaterSample(ctypes.Structure):
    _fields_ = [
        ("velocity", c_float * 3),
        ("pressure", c_float),
    ]


class WaterRequest(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("time", c_double),
        ("xyz", POINTER(c_double)),
        ("count", c_size_t),
        ("samples", POINTER(WaterSample)),
        ("sample_size", c_size_t),
        ("resolution", c_int32),
        ("refine", c_int32),
        ("exact", c_int32),
        ("reserved", c_int32),
    ]


class DetailBand(ctypes.Structure):
    _fields_ = [
        ("shortest_wave", c_double),
        ("longest_wave", c_double),
        ("tile", c_double),
        ("variance_x", c_double),
        ("variance_y", c_double),
        ("covariance", c_double),
        ("mean_square", c_double),
    ]


class DetailRequest(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("time", c_double),
        ("resolution", c_int32),
        ("samples", c_int32),
        ("bands", POINTER(DetailBand)),
        ("band_count", c_size_t),
        ("band_size", c_size_t),
        ("outputs", POINTER(Output)),
        ("output_count", c_size_t),
        ("output_size", c_size_t),
    ]


class ProvenanceRequest(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("time", c_double),
        ("frame", c_int32),
        ("axes", c_int32),
        ("field", c_char_p),
        ("band", POINTER(DetailBand)),
        ("band_size", c_size_t),
        ("residual", c_double),
        ("resolution", c_int32),
        ("reserved", c_int32),
    ]


class SprayParticle(ctypes.Structure):
    _fields_ = [
        ("id", c_uint64),
        ("position", c_double * 3),
        ("velocity", c_float * 3),
        ("age", c_float),
        ("life", c_float),
        ("radius", c_float),
    ]


class SprayRequest(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("time", c_double),
        ("lifetime", c_double),
        ("density", c_double),
        ("most", c_int32),
        ("reserved", c_int32),
        ("particles", POINTER(SprayParticle)),
        ("particle_count", c_size_t),
        ("particle_size", c_size_t),
        ("region", c_double * 4),
    ]


class FoamTextureRequest(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("kind", c_char_p),
        ("size", c_int32),
        ("seed", c_uint32),
        ("data", POINTER(c_float)),
        ("count", c_size_t),
    ]


class Gauge(ctypes.Structure):
    _fields_ = [
        ("fixes", POINTER(c_double)),
        ("fix_count", c_size_t),
        ("velocity", c_double * 2),
    ]


class GaugeRequest(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("start", c_double),
        ("end", c_double),
        ("rate", c_double),
        ("gauges", POINTER(Gauge)),
        ("gauge_count", c_size_t),
        ("gauge_size", c_size_t),
        ("values", POINTER(c_double)),
        ("value_count", c_size_t),
    ]


class Domain(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("x", c_double),
        ("y", c_double),
        ("cell", c_double),
        ("columns", c_int32),
        ("rows", c_int32),
        ("wraps", c_int32),
        ("reserved", c_int32),
    ]


class RegionRequest(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("x", c_double),
        ("y", c_double),
        ("cell", c_double),
        ("columns", c_int32),
        ("rows", c_int32),
        ("outputs", POINTER(Output)),
        ("output_count", c_size_t),
        ("output_size", c_size_t),
    ]


class MeshRequest(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("x", c_double),
        ("y", c_double),
        ("z", c_double),
        ("ground", c_double),
        ("farthest", c_double),
        ("spacing", c_double),
        ("range", c_double),
        ("positions", POINTER(c_double)),
        ("vertex_capacity", c_size_t),
        ("corners", POINTER(c_uint32)),
        ("triangle_capacity", c_size_t),
    ]


class Crest(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("time", c_double),
        ("x", c_double),
        ("y", c_double),
        ("height", c_double),
    ]


class FarmRequest(ctypes.Structure):
    _fields_ = [
        ("struct_size", c_size_t),
        ("engine", c_char_p),
        ("output", c_char_p),
        ("frames", POINTER(c_int32)),
        ("frame_count", c_size_t),
        ("options", POINTER(c_char_p)),
        ("option_count", c_size_t),
        ("render", c_char_p),
        ("frames_per_task", c_int32),
        ("threads", c_int32),
        ("minutes", c_int32),
        ("reserved", c_int32),
        ("memory_bytes", c_uint64),
    ]


ARGUMENTS: dict[str, list[Any]] = {
    "ocean_abi_version": [],
    "ocean_version": [],
    "ocean_last_error": [],
    "ocean_last_error_field": [c_int32],
    "ocean_open": [c_char_p, POINTER(Options), POINTER(c_void_p)],
    "ocean_parse": [c_char_p, c_size_t, c_char_p, POINTER(Options), POINTER(c_void_p)],
    "ocean_clone": [c_void_p, POINTER(Options), POINTER(c_void_p)],
    "ocean_free": [c_void_p],
    "ocean_set": [c_void_p, c_char_p, c_char_p],
    "ocean_set_all": [c_void_p, POINTER(c_char_p), POINTER(c_char_p), c_size_t],
    "ocean_add_waves": [c_void_p, c_char_p],
    "ocean_remove_waves": [c_void_p, c_char_p],
    "ocean_set_bed": [c_void_p, POINTER(c_float), c_int32, c_int32, c_double, c_double, c_double],
    "ocean_perform": [c_void_p, c_double, c_char_p, c_char_p],
    "ocean_get": [c_void_p, c_char_p, c_char_p, c_size_t],
    "ocean_text": [c_void_p, c_char_p, POINTER(c_size_t)],
    "ocean_values_json": [c_void_p, c_char_p, POINTER(c_size_t)],
    "ocean_text_of_values": [
        POINTER(c_char_p),
        POINTER(c_char_p),
        c_size_t,
        c_char_p,
        POINTER(c_size_t),
    ],
    "ocean_parameters_json": [c_char_p, POINTER(c_size_t)],
    "ocean_state_json": [c_void_p, c_char_p, POINTER(c_size_t)],
    "ocean_records_json": [c_char_p, c_char_p, POINTER(c_size_t)],
    "ocean_preset": [c_char_p, c_char_p, POINTER(c_size_t)],
    "ocean_water_types_json": [c_char_p, POINTER(c_size_t)],
    "ocean_time_of_frame": [c_void_p, c_double, POINTER(c_double)],
    "ocean_map_resolution": [c_void_p, POINTER(c_int32)],
    "ocean_cascade_periods": [c_void_p, POINTER(c_double), POINTER(c_size_t)],
    "ocean_evaluate": [c_void_p, POINTER(Request)],
    "ocean_cover_power": [c_void_p, c_double, c_int32, POINTER(c_double)],
    "ocean_query": [c_void_p, c_double, POINTER(c_double), c_size_t, POINTER(c_float), c_size_t],
    "ocean_query_points": [c_void_p, POINTER(QueryRequest)],
    "ocean_orbital_velocity": [
        c_void_p,
        c_double,
        c_double,
        POINTER(c_double),
        c_size_t,
        POINTER(c_float),
        c_size_t,
    ],
    "ocean_water_points": [c_void_p, POINTER(WaterRequest)],
    "ocean_float_pose": [
        c_void_p,
        c_double,
        POINTER(c_double),
        c_size_t,
        POINTER(c_float),
        c_size_t,
    ],
    "ocean_detail": [c_void_p, POINTER(DetailRequest), POINTER(c_size_t), POINTER(c_double)],
    "ocean_provenance_json": [c_void_p, POINTER(ProvenanceRequest), c_char_p, POINTER(c_size_t)],
    "ocean_spray": [c_void_p, POINTER(SprayRequest), POINTER(c_size_t)],
    "ocean_foam_texture": [POINTER(FoamTextureRequest), POINTER(Options), POINTER(c_double)],
    "ocean_gauges": [c_void_p, POINTER(GaugeRequest), POINTER(c_size_t)],
    "ocean_terrain_open": [c_char_p, POINTER(Options), POINTER(c_void_p)],
    "ocean_terrain_parse": [c_char_p, c_size_t, c_char_p, POINTER(Options), POINTER(c_void_p)],
    "ocean_terrain_clone": [c_void_p, POINTER(Options), POINTER(c_void_p)],
    "ocean_terrain_free": [c_void_p],
    "ocean_terrain_set": [c_void_p, c_char_p, c_char_p],
    "ocean_terrain_set_all": [c_void_p, POINTER(c_char_p), POINTER(c_char_p), c_size_t],
    "ocean_terrain_get": [c_void_p, c_char_p, c_char_p, c_size_t],
    "ocean_terrain_text": [c_void_p, c_char_p, POINTER(c_size_t)],
    "ocean_terrain_state_json": [c_void_p, c_char_p, POINTER(c_size_t)],
    "ocean_terrain_parameters_json": [c_char_p, POINTER(c_size_t)],
    "ocean_terrain_preset": [c_char_p, c_char_p, POINTER(c_size_t)],
    "ocean_terrain_provenance_json": [c_void_p, c_char_p, c_int32, c_char_p, POINTER(c_size_t)],
    "ocean_terrain_evaluate": [c_void_p, POINTER(Request)],
    "ocean_terrain_query_points": [c_void_p, POINTER(QueryRequest)],
    "ocean_terrain_domain": [c_void_p, POINTER(Domain)],
    "ocean_terrain_region": [c_void_p, POINTER(RegionRequest)],
    "ocean_region": [c_void_p, c_double, POINTER(RegionRequest)],
    "ocean_bed_region": [
        c_void_p,
        c_double,
        c_double,
        c_double,
        c_int32,
        c_int32,
        POINTER(c_float),
    ],
    "ocean_terrain_mesh": [c_void_p, POINTER(MeshRequest), POINTER(c_size_t), POINTER(c_size_t)],
    "ocean_terrain_stage": [c_void_p, c_char_p, POINTER(c_float), c_size_t],
    "ocean_wake_count": [c_void_p, POINTER(c_size_t)],
    "ocean_wake_domain": [c_void_p, c_size_t, c_double, POINTER(Domain)],
    "ocean_wake_region": [c_void_p, c_size_t, c_double, POINTER(RegionRequest)],
    "ocean_wake_add": [c_void_p, c_size_t, c_double, POINTER(RegionRequest)],
    "ocean_find_crest": [c_void_p, c_double, c_double, POINTER(c_double), POINTER(Crest)],
    "ocean_farm_job_json": [c_void_p, POINTER(FarmRequest), c_char_p, POINTER(c_size_t)],
}

RESULTS: dict[str, Any] = {
    "ocean_abi_version": c_uint32,
    "ocean_version": c_char_p,
    "ocean_last_error": c_char_p,
    "ocean_last_error_field": c_char_p,
    "ocean_free": None,
    "ocean_terrain_free": None,
}
"""The results of functions that do not return ocean_result."""
