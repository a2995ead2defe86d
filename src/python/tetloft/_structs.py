"""The structs and enumerations of tetloft.h; a test compares them with the header."""

from __future__ import annotations

import ctypes
from ctypes import (
    c_char_p, c_double, c_int, c_int32, c_int64, c_size_t, c_uint32, c_uint64, c_void_p
)

NO_ID = 0xFFFFFFFF
NO_VERTEX = 0xFFFFFFFF

# Handles are names of the library's, opaque here.
Progress = ctypes.CFUNCTYPE(c_int, c_void_p, c_size_t, c_size_t)


class Place(ctypes.Structure):
    VERSION = 1
    _fields_ = [
        ("version", c_uint32),
        ("file", c_char_p),
        ("line", c_int64),
        ("section", c_int64),
        ("slab", c_int64),
        ("contour", c_int64),
        ("vertex", c_int64),
        ("has_point", c_int32),
        ("point", c_double * 3),
    ]


class Execution(ctypes.Structure):
    _fields_ = [
        ("version", c_uint32),
        ("threads", c_uint32),
        ("stop", c_void_p),
        ("progress", Progress),
        ("user", c_void_p),
    ]


class Format(ctypes.Structure):
    VERSION = 1
    _fields_ = [
        ("version", c_uint32),
        ("name", c_char_p),
        ("summary", c_char_p),
        ("extension", c_char_p),
        ("reads", c_uint32),
        ("writes", c_uint32),
    ]


class ReadOptions(ctypes.Structure):
    _fields_ = [("version", c_uint32), ("unchecked", c_int32), ("format", c_char_p)]


class StackOptions(ctypes.Structure):
    _fields_ = [
        ("version", c_uint32),
        ("unchecked", c_int32),
        ("format", c_char_p),
        ("structure", c_char_p),
        ("property", c_char_p),
        ("has_iso", c_int32),
        ("iso", c_double),
        ("lattice", c_int32),
        ("axis", c_int32),
        ("plane_tolerance", c_double),
        ("close_on_frame", c_int32),
        ("execution", ctypes.POINTER(Execution)),
    ]


class WriteOptions(ctypes.Structure):
    _fields_ = [("version", c_uint32), ("ascii", c_int32), ("format", c_char_p)]


class RepairOptions(ctypes.Structure):
    _fields_ = [
        ("version", c_uint32),
        ("fill", c_int32),
        ("distance", c_double),
        ("keyholes", c_double),
        ("execution", ctypes.POINTER(Execution)),
    ]


class RepairReport(ctypes.Structure):
    VERSION = 1
    _fields_ = [
        ("version", c_uint32),
        ("moved", c_double),
        ("area_before", c_double),
        ("area_after", c_double),
        ("copies", c_uint64),
        ("channels", c_uint64),
        ("lost", c_uint64),
        ("area_lost", c_double),
    ]


class Label(ctypes.Structure):
    _fields_ = [("section", c_uint32), ("contour", c_uint32), ("label", c_uint32)]


class Decision(ctypes.Structure):
    _fields_ = [
        ("slab", c_uint32),
        ("lower", c_uint32),
        ("upper", c_uint32),
        ("join", c_int32),
    ]


class Correspondence(ctypes.Structure):
    _fields_ = [
        ("version", c_uint32),
        ("criterion", c_int32),
        ("tau", c_double),
        ("chain", c_int32),
        ("lone", c_int32),
        ("void_rule", c_int32),
        ("void_reach", c_double),
        ("labels", c_void_p),
    ]


class Link(ctypes.Structure):
    _fields_ = [
        ("slab", c_uint32),
        ("lower", c_uint32),
        ("upper", c_uint32),
        ("evidence", c_int32),
        ("fate", c_int32),
        ("ratio", c_double),
        ("moved", c_double),
        ("distance", c_double),
        ("margin", c_double),
        ("lead", c_double),
    ]


class ReconstructOptions(ctypes.Structure):
    _fields_ = [
        ("version", c_uint32),
        ("correspondence", ctypes.POINTER(Correspondence)),
        ("ends", c_int32),
        ("engine", c_int32),
        ("between", c_int64),
        ("divide_coarse", c_int32),
        ("thickness", c_double),
        ("work_limit", c_double),
        ("execution", ctypes.POINTER(Execution)),
    ]


class Report(ctypes.Structure):
    VERSION = 1
    _fields_ = [
        ("version", c_uint32),
        ("slices", c_uint64),
        ("sections_between", c_uint64),
        ("sections_given_up", c_uint64),
        ("contours", c_uint64),
        ("input_vertices", c_uint64),
        ("split_vertices", c_uint64),
        ("dividing_vertices", c_uint64),
        ("vertices", c_uint64),
        ("tets", c_uint64),
        ("components", c_uint64),
        ("volume", c_double),
        ("smallest_lift", c_double),
        ("work", c_uint64),
        ("seconds", c_double),
    ]


class RenderOptions(ctypes.Structure):
    _fields_ = [
        ("version", c_uint32),
        ("colour", c_int32),
        ("azimuth", c_double),
        ("elevation", c_double),
        ("width", c_int32),
        ("height", c_int32),
        ("cut_axis", c_int32),
        ("cut_position", c_double),
        ("explode", c_double),
        ("stretch", c_double),
        ("edges", c_int32),
        ("contours", c_int32),
        ("white", c_int32),
        ("title", c_char_p),
        ("execution", ctypes.POINTER(Execution)),
    ]


class CheckOptions(ctypes.Structure):
    _fields_ = [
        ("version", c_uint32),
        ("correspondence", ctypes.POINTER(Correspondence)),
        ("split_ulps", c_double),
        ("places", c_uint64),
        ("recompute_motions", c_int32),
        ("strict", c_int32),
        ("execution", ctypes.POINTER(Execution)),
    ]


class Figures(ctypes.Structure):
    VERSION = 1
    _fields_ = [
        ("version", c_uint32),
        ("components", c_uint64),
        ("volume", c_double),
        ("overshoot", c_double),
        ("smallest_dihedral_degrees", c_double),
        ("largest_split_ulps", c_double),
        ("inner_vertices", c_uint64),
        ("dropped_links", c_uint64),
        ("cavities", c_int64),
        ("expected_cavities", c_int64),
        ("least_genus", c_int64),
        ("most_genus", c_int64),
        ("deviations", c_uint64),
        ("forced_voids", c_uint64),
        ("unrealisable_voids", c_uint64),
    ]


class Delaunay3Options(ctypes.Structure):
    _fields_ = [
        ("version", c_uint32),
        ("engine", c_int32),
        ("most_tets", c_uint64),
        ("execution", ctypes.POINTER(Execution)),
    ]


# The values of the enumerations, by the names that callers use.
CONTENTS = {"stack": 1, "model": 2, "surface": 4, "points": 8, "labels": 16, "lines": 32}
FILL = {"odd": 0, "union": 1, "winding": 2}
PLANES = {"sort": 0, "flip": 1, "merge": 2}
CRITERION = {"overlap": 0, "reverse": 1, "moved": 2}
VOIDS = {"overlap": 0, "near": 1, "free": 2}
ENDS = {"flat": 0, "half": 1}
ENGINE = {"automatic": 0, "incremental": 1, "slab": 2}
COLOUR = {"component": 0, "slab": 1, "kind": 2, "dihedral": 3, "evidence": 4}
CROSSING = {"refuse": 0, "split": 1}
LOCATION = {"vertex": 0, "edge": 1, "facet": 2, "tet": 3, "outside": 4}
SIDE = {"none": 0, "low_x": 1, "high_x": 2, "low_y": 3, "high_y": 4, "low_z": 5, "high_z": 6}
WEIGHTS = {"sibson": 0, "laplace": 1}
LINK = {"disc": 0, "sphere": 1, "empty": 2, "components": 3, "pinch": 4, "holes": 5}
STATUS = {
    "ok": 0,
    "usage": 2,
    "invalid_input": 3,
    "io": 4,
    "unrepresentable": 5,
    "cancelled": 6,
    "work_limit": 7,
    "bad_handle": 8,
    "too_small": 9,
    "internal": 70,
    "out_of_memory": 71,
    "unfit_arithmetic": 72,
}
