"""Messages from what Python has for vectors, and back to arrays of numpy."""

from __future__ import annotations

from array import array

import numpy as np
from numpy.typing import ArrayLike, NDArray
from std_msgs.msg import Float64MultiArray, Int32MultiArray

Doubles = NDArray[np.float64]
Integers = NDArray[np.int32]


def doubles(values: ArrayLike) -> array[float]:
    """As a message contains them. Raise TypeError for anything but a vector."""
    return array("d", _vector(np.asarray(values, dtype=np.float64)).tobytes())


def double_message(values: ArrayLike) -> Float64MultiArray:
    return Float64MultiArray(data=doubles(values))


def integer_message(values: ArrayLike) -> Int32MultiArray:
    return Int32MultiArray(data=array("i", _vector(np.asarray(values, dtype=np.int32)).tobytes()))


def to_doubles(values: array[float]) -> Doubles:
    return np.array(values, dtype=np.float64)


def to_integers(values: array[int]) -> Integers:
    return np.array(values, dtype=np.int32)


def _vector(values: NDArray[np.generic]) -> NDArray[np.generic]:
    """As it is, or a column as a vector."""
    if values.ndim == 1:
        return values
    if values.ndim == 2 and values.shape[1] == 1:
        return values[:, 0]
    raise TypeError(f"A vector is needed, one number per joint; this has the shape {values.shape}.")
