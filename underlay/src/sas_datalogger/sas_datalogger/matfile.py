"""Writes a file that MATLAB, Octave and scipy.io.loadmat read: a MAT-file of level 5, without compression.

The format: https://www.mathworks.com/help/pdf_doc/matlab/matfile_format.pdf
"""

from __future__ import annotations

import struct
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

Value = str | NDArray[np.float64]

# Kinds of data elements, and classes of arrays.
_INT8, _UINT16, _INT32, _UINT32, _DOUBLE, _MATRIX = 1, 4, 5, 6, 9, 14
_CELLS, _CHARACTERS, _DOUBLES = 1, 4, 6


def write_mat(filename: str, variables: Mapping[str, Sequence[Value]]) -> None:
    """Write each variable, whose values are along its first dimension.

    Where they are not all strings, or arrays of the same shape, they become the cells of a row.
    """
    header = b"MATLAB 5.0 MAT-file, written by sas_datalogger".ljust(124) + struct.pack("<H2s", 0x0100, b"IM")
    content = b"".join(_variable(name, values) for name, values in variables.items())
    Path(filename).write_bytes(header + content)


def _variable(name: str, values: Sequence[Value]) -> bytes:
    texts = [value for value in values if isinstance(value, str)]
    if len(texts) == len(values):
        return _text(name, texts)
    if not texts and len({np.shape(value) for value in values}) == 1:
        return _numbers(name, np.array(values))
    return _matrix(name, _CELLS, (1, len(values)), b"".join(_cell(value) for value in values))


def _cell(value: Value) -> bytes:
    return _text("", [value]) if isinstance(value, str) else _numbers("", np.atleast_2d(value))


def _numbers(name: str, values: NDArray[np.float64]) -> bytes:
    return _matrix(name, _DOUBLES, values.shape, _element(_DOUBLE, values.astype("<f8").tobytes("F")))


def _text(name: str, lines: Sequence[str]) -> bytes:
    """A row for each line, filled up with spaces. Characters have two bytes."""
    width = max(map(len, lines))
    units = np.array([[min(ord(letter), 0xFFFF) for letter in line.ljust(width)] for line in lines], "<u2")
    return _matrix(name, _CHARACTERS, (len(lines), width), _element(_UINT16, units.tobytes("F")))


def _matrix(name: str, kind: int, shape: Sequence[int], content: bytes) -> bytes:
    described = [
        _element(_UINT32, struct.pack("<II", kind, 0)),
        _element(_INT32, struct.pack(f"<{len(shape)}i", *shape)),
        _element(_INT8, name.encode("ascii", "replace")),
    ]
    return _element(_MATRIX, b"".join(described) + content)


def _element(kind: int, content: bytes) -> bytes:
    """Its kind, its size, and its content up to a multiple of 8 bytes."""
    return struct.pack("<II", kind, len(content)) + content + bytes(-len(content) % 8)
